//! Why the study could not be made.

use std::fmt;
use std::path::PathBuf;

/// Why the study could not be made.
#[derive(Debug)]
pub enum Failure {
    /// A model did not come to its end.
    Run {
        /// Which.
        what: String,
        /// Why, in the words of the diagnosis.
        reason: String,
    },
    /// A reference does not exist.
    Theory(slideline_theory::TheoryError),
    /// A file could not be written.
    Write {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        reason: std::io::Error,
    },
    /// A figure could not be drawn.
    Figure(&'static str),
}

impl From<slideline_theory::TheoryError> for Failure {
    fn from(reason: slideline_theory::TheoryError) -> Self {
        Self::Theory(reason)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Run { what, reason } => write!(f, "{what}: {reason}"),
            Self::Theory(reason) => write!(f, "theory: {reason}"),
            Self::Write { path, reason } => write!(f, "{}: {reason}", path.display()),
            Self::Figure(name) => write!(f, "{name} could not be drawn"),
        }
    }
}

impl std::error::Error for Failure {}
