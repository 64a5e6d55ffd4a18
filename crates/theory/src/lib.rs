//! Closed forms and exact references of sliding contact.
//!
//! The references answer for the two problems of Diehl (1995) with any
//! dimensions: the paper's linear theory, the elastica, the shear-flexible
//! (Reissner) beam with hard or softened contact at one point, and the same
//! beam with softened pressure spread along it. Nothing here shares code with
//! the solver that is checked against it.
//!
//! ```
//! use slideline_theory::{FirstProblem, Reference};
//!
//! let rows = FirstProblem::diehl().rows(0.3, 20, Reference::Linear)?;
//! assert!((rows[20].rf2 + 36.07584).abs() < 1e-5);
//! # Ok::<(), slideline_theory::TheoryError>(())
//! ```
//!
//! Where a reference does not exist the answer is a [`TheoryError`] that says
//! why; a circle that is clear of the beam gives rows of zeros.

// dimension tags such as [L] are not links
#![allow(rustdoc::broken_intra_doc_links)]

mod cantilever;
pub mod closed;
mod dimensions;
mod error;
mod frame;
mod numerics;
mod problem;
mod references;
mod softened_law;

pub use cantilever::Cantilever;
pub use error::TheoryError;
pub use problem::{FirstProblem, FirstRow, SecondProblem, SecondRow};
pub use references::Reference;
pub use references::equilibrium::{Equilibrium, Stroke};
pub use references::linear::{self, LinearContact};
pub use softened_law::{ExponentialLaw, LawValue};
