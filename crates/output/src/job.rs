//! Where a job's files go and what they are called.

use crate::file::{PART, WriteError, at};
use crate::restart::Kept;
use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Ending of the state in which a run gave up.
pub(crate) const FAILED: &str = ".failed.vtu";

/// Endings of the files of a job, beside its numbered `_0001.vtu` files.
const ENDINGS: &[&str] = &[
    ".sta",
    ".msg",
    ".dat",
    ".history.csv",
    ".contact.csv",
    ".pair.csv",
    ".energy.csv",
    ".element.csv",
    ".json",
    ".pvd",
    ".frd",
    ".html",
    ".rst",
    FAILED,
];

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

    /// Whether a file of that name belongs to this job's results.
    pub fn owns(&self, name: &OsStr) -> bool {
        let name = name.as_encoded_bytes();
        let name = name.strip_suffix(PART.as_bytes()).unwrap_or(name);
        let Some(ending) = name.strip_prefix(self.stem.as_encoded_bytes()) else {
            return false;
        };
        ENDINGS.iter().any(|own| own.as_bytes() == ending) || is_state(ending)
    }
}

/// Whether a result file of one of our kinds ends so.
pub(crate) fn is_ending(ending: &str) -> bool {
    ENDINGS.contains(&ending)
}

/// `_0001.vtu` with four digits or more.
fn is_state(ending: &[u8]) -> bool {
    let number = ending.strip_prefix(b"_").and_then(|rest| rest.strip_suffix(b".vtu"));
    number.is_some_and(|digits| digits.len() >= 4 && digits.iter().all(u8::is_ascii_digit))
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
