//! Committed frames to files.
//!
//! ```text
//!                     +-> JOB.sta  JOB.msg  JOB.dat
//!   run -> Writers ---+-> JOB.history.csv  JOB.contact.csv  JOB.pair.csv  JOB.energy.csv  JOB.element.csv  JOB.beam.csv
//!                     |   JOB.sensitivity.csv
//!                     +-> JOB_0001.vtu ...  JOB.pvd
//!                     +-> JOB.json
//!   these files -> report -> JOB.html      these files -> plot -> svg, png, csv
//! ```
//!
//! One writer per kind of file, one line each in [`Writers`]' registry. A
//! run first removes the files of an earlier run of the same job. Files
//! appear whole or not at all, except `.sta`, `.msg` and the CSV files, which
//! grow by whole lines at every commit and are valid whenever the program
//! ends.

/// Appends a line; a String takes any text.
macro_rules! line {
    ($text:expr, $($content:tt)*) => {{
        let _ = writeln!($text, $($content)*);
    }};
}

mod bars;
mod ccx;
mod clock;
mod contact;
mod dat;
mod date;
pub mod echo;
mod element;
mod energy;
mod facts;
mod file;
pub mod fixed;
mod fortran;
mod frd;
mod history;
mod job;
pub mod json;
mod kept;
mod key_figures;
mod ledger;
mod lock;
mod model_object;
mod msg;
pub mod number;
mod outline;
mod pair;
mod past;
mod picture;
pub mod plot;
mod reading;
mod record;
mod records;
pub mod report;
pub mod restart;
mod rows;
mod section;
mod sensitivity;
mod sta;
mod state_numbers;
mod summary;
mod tables;
mod test_charts;
mod verdict;
mod vtu;
mod writer;
mod writers;

pub use bars::{BarRows, add_error_bars, add_warning};
pub use contact::columns as contact_columns;
pub use energy::{Column as EnergyColumn, EnergyOf, columns as energy_columns, energy_named};
pub use facts::{Facts, Formats, Status};
pub use file::{WriteError, replace as write_file};
pub use history::columns as history_columns;
pub use job::{JobFiles, without_ending};
pub use key_figures::{KEY_FIGURES, KeyFigures, figures_of, key_figures};
pub use ledger::{dropped_friction, onset_word};
pub use lock::{is_running, remove_stale_lock};
pub use outline::profile;
pub use pair::{PairQuantity, pair_quantity};
pub use past::Past;
pub use picture::{picture, picture_page};
pub use reading::summary::SCHEMA;
pub use record::{card, columns, record};
pub use records::Records;
pub use slideline_figures::Scene;
pub use summary::write_input_error;
pub use test_charts::test_charts;
pub use verdict::verdict_of;
pub use writers::{Writers, kinds};
