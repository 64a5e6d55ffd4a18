//! Curves of a job as figures and tables.
//!
//! ```text
//!   RF2 |      .-'   job            the files of one job, or of two
//!       |   .-' --   other          laid over each other
//!       +-----------> U2
//!    dY |  ~~~~~                    other minus job, at equal times
//! ```

mod curve;
mod figure;

pub use curve::{Curve, Question, csv, curve, difference};
pub use figure::{curves, figure};
pub use slideline_figures::{Axis, Mark, Panel, Series, chart};
