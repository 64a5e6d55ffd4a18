//! Studies: one deck, many values of its parameters, one row of responses a case.
//!
//! ```text
//!   Study --case number--> values --Parametric--> model --Workspace--> curves --> responses
//! ```
//!
//! A case depends on its number alone: rows have the same bits on any number of threads and in any
//! order. A case that fails is a row with the code of what stands against it.

// dimension tags such as [L] are not links
#![allow(rustdoc::broken_intra_doc_links)]

mod case;
mod checks;
mod curve;
mod design;
mod expression;
mod folder;
mod history;
mod indices;
mod layout;
mod mixing;
mod normal;
mod places;
mod response;
mod run;
mod shard;
mod sobol;
mod spread;
mod study;
mod study_file;
mod sweep;

pub use case::Row;
pub use design::Kind;
pub use folder::Failure;
pub use layout::{Layout, MOST_CASES, Parameter};
pub use run::run;
pub use spread::{Number, Spread};
pub use study::Study;
pub use study_file::{StudyFile, read_study};
pub use sweep::{Outcome, SweepOptions, sweep};
