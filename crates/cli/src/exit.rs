//! Exit codes: the contract's.

use slideline::Status;
use std::process::ExitCode;

/// How the program ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Done.
    Completed = 0,
    /// The input is wrong; nothing was solved.
    Input = 1,
    /// An increment could not be found.
    NotConverged = 2,
    /// Our fault.
    Internal = 3,
    /// Results could not be written.
    Output = 4,
    /// Wrong command line (sysexits' EX_USAGE).
    Usage = 64,
    /// Interrupted (128 + SIGINT).
    Interrupted = 130,
    /// In place of ccx: a question about the program itself was answered, as ccx does.
    Answered = 201,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}

impl From<Status> for Exit {
    fn from(status: Status) -> Self {
        match status {
            Status::Completed => Self::Completed,
            Status::InputError => Self::Input,
            Status::NotConverged => Self::NotConverged,
            Status::Running | Status::InternalError => Self::Internal,
            Status::OutputError => Self::Output,
            Status::Interrupted => Self::Interrupted,
        }
    }
}
