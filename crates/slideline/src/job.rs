//! A deck, where its results go, and what is said about reading it.

use slideline_model::{Dialect, Onset};
use slideline_output::JobFiles;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// What overrides a deck, and what it goes on from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// Whose reading of a keyword counts; Abaqus's unless said.
    pub dialect: Option<Dialect>,
    /// When friction is called, whatever the deck says.
    pub friction_onset: Option<Onset>,
    /// Values for names that the deck defines by `*PARAMETER`, each in place of the first one that
    /// the deck gives: a name and an expression of numbers, such as `("mu", "0.2")`.
    pub parameters: Vec<(String, String)>,
    /// Whose states a deck with `*RESTART, READ` goes on from.
    pub old_job: OldJob,
}

/// Where the states are that a deck with `*RESTART, READ` goes on from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum OldJob {
    /// None is named: such a deck is an error.
    #[default]
    None,
    /// An earlier job by its path, with or without ending.
    Named(PathBuf),
    /// The job has begun already and goes on itself: its own saved states in
    /// this folder, or beside the deck, know where they came from.
    Begun(Option<PathBuf>),
}

/// A deck and where its results go unless another folder is named.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Job {
    /// The deck.
    pub deck: PathBuf,
    /// Its name without `.inp`: the beginning of every result file.
    pub stem: OsString,
}

impl Job {
    /// The job that a user means by `path`: with or without `.inp`.
    pub fn named(path: &Path) -> Self {
        let is_deck = |path: &Path| {
            path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("inp"))
        };
        let mut with_ending = OsString::from(path);
        with_ending.push(".inp");
        let with_ending = PathBuf::from(with_ending);
        let deck = if !is_deck(path) && (with_ending.is_file() || !path.exists()) {
            with_ending
        } else {
            path.to_owned()
        };
        let stem = if is_deck(&deck) { deck.file_stem() } else { deck.file_name() };
        let stem = stem.unwrap_or_default().to_owned();
        Self { deck, stem }
    }

    /// The job's files in `folder`, or beside the deck.
    pub fn files(&self, folder: Option<&Path>) -> JobFiles {
        let beside = match self.deck.parent() {
            Some(parent) if parent != Path::new("") => parent,
            _ => Path::new("."),
        };
        JobFiles::new(folder.unwrap_or(beside), self.stem.clone())
    }
}
