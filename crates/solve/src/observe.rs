//! What a run tells those who watch it.
//!
//! ```text
//!   run --> StepBegin --> Iteration, Iteration ... --> Committed(frame)
//!                     \-> Iteration ... --> AttemptFailed --> (again, shorter)
//!       --> Checkpoint --> ... --> Unconverged --> Diagnosed --> End
//! ```
//!
//! Observers borrow; nothing here owns a result. Files, tables, progress and
//! embedding programs are observers. Any of them may stop the run.

mod frame;
pub(crate) mod reports;
pub(crate) mod results;
mod sensitivity;

use crate::checkpoint::Checkpoint;
use crate::stabilise::may_stabilise;
pub use frame::{Frame, Nodal, Unconverged};
pub use reports::{
    AttemptReport, ContactChange, FieldReport, IterationReport, TangentReport, Totals,
};
pub use results::{
    BeamRow, BlockResults, ContactRow, Energies, FrictionCall, PairRow, Resultant, SectionRow,
    Status,
};
pub(crate) use sensitivity::Near;
pub use sensitivity::Sensitivity;
use slideline_diag::Diagnostic;
use slideline_linalg::Description;
use slideline_model::Model;
use std::ops::ControlFlow;

/// Watches a run.
pub trait Observer {
    /// Takes note of an event; `Break` ends the run after it. What was
    /// committed stays valid.
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop>;
}

/// Why an observer stops a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The user asked for it.
    Interrupted,
    /// Results can no longer be written; the reason.
    OutputFailed(String),
}

/// What happens during a run.
#[derive(Debug)]
pub enum Event<'a> {
    /// A step begins; equations and how they are solved.
    StepBegin(&'a StepReport<'a>),
    /// An iteration was made and judged.
    Iteration(&'a IterationReport),
    /// An attempt at an increment was given up.
    AttemptFailed(&'a AttemptReport),
    /// An increment has converged.
    Committed(&'a Frame<'a>),
    /// How the increment that was committed follows a parameter; where a run is differentiated.
    Sensitivity(&'a Sensitivity<'a>),
    /// The tangent of a converged increment was held against differences.
    Tangent(&'a TangentReport),
    /// An increment was told in full; the run could go on from here.
    Checkpoint(&'a Checkpoint<'a>),
    /// The last state of an increment that was not found, before its cause is
    /// told.
    Unconverged(&'a Unconverged<'a>),
    /// Something to be said about the run.
    Diagnosed(&'a Diagnostic),
    /// The run is over.
    End(&'a Ending),
}

/// The beginning of a step.
#[derive(Debug)]
pub struct StepReport<'a> {
    /// The model.
    pub model: &'a Model,
    /// Step number from 1.
    pub step: usize,
    /// Number of equations.
    pub equations: usize,
    /// Entries of the sparsity pattern.
    pub entries: usize,
    /// How the linear equations are solved; it says so in words.
    pub linear_solver: Description,
    /// Whether the tangent is treated as unsymmetric.
    pub unsymmetric: bool,
    /// Total time at the beginning [T].
    pub total_time: f64,
    /// The committed state at the beginning of the step (positions, initial
    /// contact); increment 0.
    pub start: Frame<'a>,
    /// Whether the run goes on in the step from a saved state: then `start`
    /// is that state, with its increment.
    pub resumed: bool,
}

impl StepReport<'_> {
    /// Whether contact may be stabilised in any step of the model.
    pub fn may_stabilise(&self) -> bool {
        may_stabilise(self.model)
    }
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// Every step was walked to its end.
    Completed(Totals),
    /// An increment could not be found; what was committed stays.
    NotConverged(Totals, Diagnostic),
    /// An observer stopped it.
    Stopped(Totals, Stop),
}
