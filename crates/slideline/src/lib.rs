//! Sliding contact of flexible and rigid bodies, as a library.
//!
//! ```text
//!   deck text -> Job::read -> Read { model, diagnostics } -> run -> files
//!                                      |                      \---> observer
//!                                      '-> solve: the model alone, no files
//! ```
//!
//! Reading a deck never fails halfway: everything there is to say about it is
//! in [`Read::diagnostics`]. A run tells an [`Observer`] what happens and may
//! be stopped by it.
//!
//! ```no_run
//! use slideline::{Job, Quiet, ReadOptions, RunOptions, run};
//!
//! let read = Job::read("snapfit.inp".as_ref(), &ReadOptions::default());
//! let outcome = run(&read, &RunOptions::default(), &mut Quiet);
//! println!("{}", outcome.status.word());
//! ```

mod advice;
mod check;
mod error_bars;
mod further;
mod job;
mod judge;
mod lost_sensitivities;
mod mend;
mod pages;
mod parametric;
mod read;
mod run;
mod sensitivities;
mod version;

pub use advice::{advise, mended};
pub use check::{InitialGaps, initial_gaps};
pub use error_bars::{
    ErrorBars, Reactions, Recorder, error_bars, time_error_bars, write_error_bars,
};
pub use further::From;
pub use job::{Job, OldJob, ReadOptions};
pub use judge::{Judge, objections};
pub use mend::{Mend, try_mends};
pub use pages::{CODE_PAGES, code_page, page};
pub use parametric::Parametric;
pub use read::Read;
pub use run::{Outcome, Quiet, RunOptions, run};

pub use slideline_advice::Noise;
pub use slideline_deck as deck;
pub use slideline_diag as diag;
pub use slideline_keywords as keywords;
pub use slideline_mech as mech;
pub use slideline_model as model;
pub use slideline_output as output;
pub use slideline_solve::{Checkpoint, resume, run as solve, run_from};
pub use slideline_solve::{Enforcement, Options as SolveOptions, TangentCheck, observe};
pub use slideline_solve::{LinearSystems, linalg};
pub use slideline_solve::{Parameter, SensitivityFault, Varied};
pub use slideline_solve::{Part, Plan, PlanMismatch, Workspace};
pub use slideline_solve::{UserFrictions, friction};

pub use slideline_diag::{Diagnostic, Severity};
pub use slideline_measures::{Colour, MeshNoise, NoiseSummary, PairNoise, ReactionNoise};
pub use slideline_model::{Dialect, Model, Onset};
pub use slideline_output::{Formats, Status};
pub use slideline_solve::observe::{Event, Observer, Stop};
pub use version::VERSION;
