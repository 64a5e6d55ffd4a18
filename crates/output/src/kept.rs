//! What a run that goes on finds of its job.

use crate::file::Growing;
use crate::state_numbers::StateNumbers;
use serde::{Deserialize, Serialize};

/// What a run that goes on has to find.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Kept {
    /// Ending and length of the files that grow.
    pub(crate) lengths: Vec<(String, u64)>,
    /// Converged increments of the job.
    pub(crate) increments: usize,
    /// Numbers of the deformed states.
    pub(crate) states: StateNumbers,
    /// Time of the start as it is written.
    pub(crate) first_time: String,
}

impl Kept {
    /// Notes a file that grows, if it is open.
    pub(crate) fn file(&mut self, ending: &str, file: Option<&Growing>) {
        self.lengths.extend(file.map(|file| (ending.to_owned(), file.length())));
    }
}
