//! Where a job's files go and what they are called.

use crate::file::{self, Growing, PART, WriteError, at};
use crate::kept::Kept;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Ending of the state in which a run gave up.
pub(crate) const FAILED: &str = ".failed.vtu";

/// Ending of the file that says that a process runs the job.
pub(crate) const LOCK: &str = ".lck";

/// Endings of the files of a job, beside its numbered `_0001.vtu` files.
const ENDINGS: &[&str] = &[
    ".sta",
    ".msg",
    ".dat",
    ".cvg",
    ".history.csv",
    ".contact.csv",
    ".pair.csv",
    ".energy.csv",
    ".element.csv",
    ".beam.csv",
    ".sensitivity.csv",
    ".json",
    ".pvd",
    ".frd",
    ".html",
    ".rst",
    FAILED,
    LOCK,
];

/// How many wait for the disk at once.
const WAITING: usize = 4;

/// Folder and name of a job's files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JobFiles {
    folder: PathBuf,
    stem: OsString,
    /// What a run that goes on finds there.
    kept: Option<Arc<Kept>>,
}

impl JobFiles {
    /// Files called `stem` and an ending, in `folder`.
    pub fn new(folder: impl Into<PathBuf>, stem: impl Into<OsString>) -> Self {
        Self { folder: folder.into(), stem: stem.into(), kept: None }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The job's name as shown.
    pub fn name(&self) -> String {
        self.stem.to_string_lossy().into_owned()
    }

    /// The file with that ending, such as `.sta`.
    pub fn path(&self, ending: &str) -> PathBuf {
        let mut name = self.stem.clone();
        name.push(ending);
        self.folder.join(name)
    }

    /// Name of the deformed state of that number, without its folder.
    pub fn state_name(&self, number: usize) -> String {
        format!("{}_{number:04}.vtu", self.name())
    }

    /// The state in which a run gave up.
    pub fn failed_state(&self) -> PathBuf {
        self.path(FAILED)
    }

    /// The files of this job that exist, temporary ones too, in no order.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn existing(&self) -> Result<Vec<PathBuf>, WriteError> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir(&self.folder).map_err(at(&self.folder))? {
            let entry = entry.map_err(at(&self.folder))?;
            if self.owns(&entry.file_name()) {
                found.push(entry.path());
            }
        }
        Ok(found)
    }

    /// Numbers of the deformed states that exist, ascending.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn states(&self) -> Result<Vec<usize>, WriteError> {
        let existing = self.existing()?;
        let names = existing.iter().filter_map(|path| path.file_name());
        let mut numbers: Vec<usize> = names
            .filter_map(|name| name.as_encoded_bytes().strip_prefix(self.stem.as_encoded_bytes()))
            .filter_map(state_number)
            .collect();
        numbers.sort_unstable();
        Ok(numbers)
    }

    /// The same files for a run that goes on.
    pub(crate) fn going_on(&self, kept: Kept) -> Self {
        Self { kept: Some(Arc::new(kept)), ..self.clone() }
    }

    /// What a run that goes on finds.
    pub(crate) fn kept(&self) -> Option<&Kept> {
        self.kept.as_deref()
    }

    /// Length of a file at the saved state that the run goes on from.
    pub(crate) fn kept_length(&self, ending: &str) -> Option<u64> {
        let lengths = &self.kept()?.lengths;
        lengths.iter().find(|(own, _)| own == ending).map(|&(_, length)| length)
    }

    /// Creates a file that grows with its first lines; in a run that goes on,
    /// opens it where the saved state left it, cut back to there.
    pub(crate) fn begin(&self, ending: &str, heading: &str) -> Result<Growing, WriteError> {
        if let Some(length) = self.kept_length(ending) {
            return Growing::reopen(self.path(ending), length);
        }
        let mut file = Growing::create(self.path(ending))?;
        file.text.push_str(heading);
        file.flush()?;
        Ok(file)
    }

    /// Creates the folder where it is missing and removes every file of an
    /// earlier run.
    ///
    /// # Errors
    /// When the folder cannot be made or read, or a file cannot be removed.
    pub fn clear(&self) -> Result<(), WriteError> {
        std::fs::create_dir_all(&self.folder).map_err(at(&self.folder))?;
        let mut existing = self.existing()?;
        // Without its files a saved state is worth nothing: it goes first.
        existing.sort_by_key(|path| path != &self.path(".rst"));
        for path in existing {
            std::fs::remove_file(&path).map_err(at(&path))?;
        }
        Ok(())
    }

    /// Waits until the result files are on the disk, the numbered states but
    /// the last excepted: they are many, and nothing goes on from them. A few
    /// at once, so that the file system can take them together.
    pub(crate) fn synchronise(&self) -> Result<(), WriteError> {
        let last = self.states()?.pop().map(|number| self.folder.join(self.state_name(number)));
        let kept = ENDINGS.iter().filter(|ending| **ending != LOCK).map(|ending| self.path(ending));
        let paths: Vec<PathBuf> = kept.chain(last).collect();
        let each = |paths: &[PathBuf]| paths.iter().try_for_each(|path| file::synchronise(path));
        std::thread::scope(|threads| {
            let (own, others) = paths.split_at(paths.len() / WAITING);
            let waiting = others.chunks(paths.len().div_ceil(WAITING)).map(|paths| {
                let begun = std::thread::Builder::new().spawn_scoped(threads, move || each(paths));
                begun.map_err(|_| each(paths)) // no more threads are to be had
            });
            let waiting: Vec<_> = waiting.collect();
            let ended = waiting.into_iter().map(|waiting| match waiting {
                Ok(thread) => thread.join().unwrap_or(Ok(())),
                Err(done) => done,
            });
            ended.fold(each(own), Result::and)
        })?;
        file::synchronise(&self.folder)
    }

    /// Whether a file of that name belongs to this job's results.
    pub fn owns(&self, name: &OsStr) -> bool {
        let name = name.as_encoded_bytes();
        let name = name.strip_suffix(PART.as_bytes()).unwrap_or(name);
        let Some(ending) = name.strip_prefix(self.stem.as_encoded_bytes()) else {
            return false;
        };
        ENDINGS.iter().any(|own| own.as_bytes() == ending) || state_number(ending).is_some()
    }
}

/// The path of a job's files without the ending of one of them.
pub fn without_ending(path: &str) -> Option<&str> {
    ENDINGS.iter().find_map(|ending| path.strip_suffix(ending))
}

/// Whether a result file of one of our kinds ends so.
pub(crate) fn is_ending(ending: &str) -> bool {
    ENDINGS.contains(&ending)
}

/// Number of `_0001.vtu`, with four digits or more.
fn state_number(ending: &[u8]) -> Option<usize> {
    let digits = ending.strip_prefix(b"_")?.strip_suffix(b".vtu")?;
    let whole = digits.len() >= 4 && digits.iter().all(u8::is_ascii_digit);
    whole.then(|| std::str::from_utf8(digits).ok()?.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_owns_its_results_and_nothing_else() {
        let job = JobFiles::new("out", "beam");
        let owned =
            ["beam.sta", "beam.json.part", "beam_0001.vtu", "beam_12345.vtu", "beam.failed.vtu"];
        let strange = [
            "beam.inp",
            "beam2.sta",
            "beam_01.vtu",
            "beam_000a.vtu",
            "beam",
            "xbeam.sta",
            "beam_0001.vtu.bak",
        ];
        assert!(owned.iter().all(|name| job.owns(OsStr::new(name))));
        assert!(!strange.iter().any(|name| job.owns(OsStr::new(name))));
    }
}
