//! How a report is made.

use std::path::Path;

/// How a report is made.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// A CSV file with a second curve: the columns of `slideline theory`, or
    /// a `JOB.history.csv`.
    pub overlay: Option<&'a Path>,
    /// Whether a job that still runs, or was killed, is shown as far as it
    /// came.
    pub unfinished: bool,
    /// Hash of the deck as it is now, where it is known: a report of results
    /// that belong to another text says so.
    pub deck_hash: Option<&'a str>,
    /// The page of a code, as HTML that may stand below a heading.
    pub page: fn(&str) -> Option<String>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { overlay: None, unfinished: false, deck_hash: None, page: |_| None }
    }
}
