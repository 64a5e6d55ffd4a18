//! What is known of a job before it runs, and how it stands.

use serde::{Deserialize, Serialize};
use slideline_diag::{Diagnostic, Sources};
use slideline_model::{Dialect, Onset};
use slideline_solve::observe::{Ending, Stop};

/// What is known of a job before it runs.
#[derive(Clone, Debug)]
pub struct Facts<'a> {
    /// Version of the program.
    pub version: &'a str,
    /// Hash of the deck's text, included files too.
    pub deck_hash: &'a str,
    /// Texts, to say where something stands.
    pub sources: &'a Sources,
    /// What reading had to say.
    pub diagnostics: &'a [Diagnostic],
    /// Dialect of the deck, where known.
    pub dialect: Option<Dialect>,
    /// Friction onset that rules, where known.
    pub friction_onset: Option<Onset>,
    /// How many of the texts, from the first on, are those of the job's own
    /// deck.
    pub own_texts: usize,
    /// Values that parameters of the deck were given from outside.
    pub parameters: &'a [(String, String)],
    /// Names of the parameters that the run is differentiated by.
    pub sensitivities: &'a [String],
    /// The jobs that this one goes on from.
    pub earlier: Option<&'a Earlier>,
    /// Whose formats the files have that more than one program writes.
    pub formats: Formats,
}

/// Whose formats the files have that more than one program writes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Formats {
    /// Those of this program (docs/files.md).
    #[default]
    Own,
    /// Those of ccx, for programs that start this one in its place: `.sta` and `.cvg`, `.dat`
    /// without an echo, `.frd` in any case (docs/ccx.md).
    Ccx,
}

/// The texts of a deck.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    /// Name and text of the deck, then of what it includes.
    pub texts: Vec<(String, String)>,
    /// Values that its parameters were given from outside.
    pub parameters: Vec<(String, String)>,
    /// How many steps there are after it, those of parts before it included;
    /// what it says behind them does not count.
    pub steps: usize,
}

/// Where the history of a job begins.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// Name of the earlier job.
    pub job: String,
    /// Step of the state that was read.
    pub step: usize,
    /// Increment of the state that was read.
    pub increment: usize,
}

/// The jobs that a job goes on from.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Earlier {
    /// Their decks, the first one first.
    pub parts: Vec<Part>,
    /// The state that was read.
    pub origin: Origin,
}

/// How a job stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It runs, or its process was killed.
    Running,
    /// Every step was walked to its end.
    Completed,
    /// An increment could not be found; what converged is kept.
    NotConverged,
    /// The deck has errors; nothing was solved.
    InputError,
    /// Results could not be written.
    OutputError,
    /// Stopped on request after a converged increment.
    Interrupted,
    /// Our fault.
    InternalError,
}

impl Status {
    /// The word of `JOB.json`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Completed => "completed",
            Self::NotConverged => "not_converged",
            Self::InputError => "input_error",
            Self::OutputError => "output_error",
            Self::Interrupted => "interrupted",
            Self::InternalError => "internal_error",
        }
    }

    /// What an ending amounts to; a diagnosis SL09xx is our fault.
    pub fn of(ending: &Ending) -> Self {
        match ending {
            Ending::Completed(_) => Self::Completed,
            Ending::NotConverged(_, why) if why.code.0.starts_with("SL09") => Self::InternalError,
            Ending::NotConverged(..) => Self::NotConverged,
            Ending::Stopped(_, Stop::Interrupted) => Self::Interrupted,
            Ending::Stopped(_, Stop::OutputFailed(_)) => Self::OutputError,
        }
    }
}
