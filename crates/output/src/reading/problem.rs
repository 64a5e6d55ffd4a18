//! Why a report cannot be made.

use crate::file::WriteError;
use std::path::{Path, PathBuf};

/// Why results could not be read, or a report not be written.
#[derive(Debug)]
pub enum Problem {
    /// There is no such result file.
    Missing(PathBuf),
    /// A file is no result of this program, or ends before its time.
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A process runs the job.
    Running(PathBuf),
    /// The summary says that the job runs, but no process does.
    Killed(PathBuf),
    /// The deck had errors, so there are no results.
    NothingSolved(PathBuf),
    /// The question does not fit the results: a column or a node they lack.
    Question(String),
    /// The answer could not be written.
    Write(WriteError),
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Missing(path) => write!(f, "there is no result file {}", path.display()),
            Self::Unreadable { path, reason } => {
                write!(f, "{} cannot be read: {reason}", path.display())
            }
            Self::Running(path) => {
                write!(f, "{} says that the job is still running, and it is", path.display())
            }
            Self::Killed(path) => {
                let path = path.display();
                write!(
                    f,
                    "{path} says that the job is running, but no process runs it: it was killed"
                )
            }
            Self::NothingSolved(path) => {
                write!(f, "{} says that the deck has errors: nothing was solved", path.display())
            }
            Self::Question(reason) => f.write_str(reason),
            Self::Write(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for Problem {}

impl From<WriteError> for Problem {
    fn from(error: WriteError) -> Self {
        Self::Write(error)
    }
}

/// A file that is not what it should be.
pub(crate) fn unreadable(path: &Path, reason: impl Into<String>) -> Problem {
    Problem::Unreadable { path: path.to_owned(), reason: reason.into() }
}

/// The bytes of a result file.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    crate::file::read(path).map_err(|reason| match reason.kind() {
        std::io::ErrorKind::NotFound => Problem::Missing(path.to_owned()),
        _ => unreadable(path, reason.to_string()),
    })
}

/// The text of a result file.
pub(crate) fn text(path: &Path) -> Result<String, Problem> {
    String::from_utf8(bytes(path)?).map_err(|_| unreadable(path, "it is not UTF-8 text"))
}
