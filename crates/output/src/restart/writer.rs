//! Adds states to `JOB.rst`.

use super::preface::Preface;
use super::states::{
    Content, HEAD, Place, head, mark, mark_at, section_of_preface, section_of_state,
};
use crate::facts::Facts;
use crate::file::{WriteError, at, replace};
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::summary::Summary;
use slideline_model::SavedStates;
use slideline_solve::Checkpoint;
use slideline_solve::observe::StepReport;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::Path;

/// Writes `JOB.rst`.
pub(crate) struct Writer<'a> {
    facts: Facts<'a>,
    /// What the step asks for; `None`: nothing.
    asked: Option<SavedStates>,
    /// The last state of the file; `None`: there is no file yet.
    last: Option<Place>,
    /// The mark to write next.
    next_mark: usize,
    /// The file, kept open between its states.
    file: Option<File>,
}

impl<'a> Writer<'a> {
    /// For a file that goes on behind a state, or for a new one.
    pub fn new(facts: Facts<'a>, last: Option<Place>) -> Self {
        Self { facts, asked: None, last, next_mark: 0, file: None }
    }

    /// Learns what a step asks for.
    pub fn begin(&mut self, report: &StepReport<'_>) {
        let step = report.step.checked_sub(1).and_then(|place| report.model.steps.get(place));
        self.asked = step.and_then(|step| step.output.restart);
    }

    /// Whether a state is to be saved: in the increments asked for, at the end
    /// of a step, and when the run is stopped.
    pub fn is_due(&self, checkpoint: &Checkpoint<'_>) -> bool {
        self.asked.is_some_and(|SavedStates { every, .. }| {
            let asked = checkpoint.increment.is_multiple_of(every);
            every > 0 && (asked || checkpoint.last_of_step() || checkpoint.stopping)
        })
    }

    pub fn write(
        &mut self,
        job: &JobFiles,
        checkpoint: &Checkpoint<'_>,
        kept: Kept,
        summary: &Summary<'_>,
    ) -> Result<(), WriteError> {
        let (step, increment) = (checkpoint.step, checkpoint.increment);
        let content = Content { kept, memory: summary.memory(), checkpoint: checkpoint.borrowed() };
        let state = section_of_state(&content);
        let path = job.path(".rst");
        let overlay = self.asked.is_some_and(|asked| asked.overlay);
        let start = match self.last {
            None => self.create(&path, &state)?,
            Some(last) if overlay && last.step == step => {
                self.file = None;
                put_instead(&path, last.start, &state).map_err(at(&path))??
            }
            Some(last) => {
                self.append(&path, last.end, &state).map_err(at(&path))?;
                self.next_mark += 1;
                last.end
            }
        };
        let end = start + state.len() as u64;
        self.last = Some(Place { step, increment, start, end });
        Ok(())
    }

    /// The file with its first state; returns where that begins.
    fn create(&self, path: &Path, state: &[u8]) -> Result<u64, WriteError> {
        let preface = section_of_preface(&Preface::of(&self.facts));
        let start = (HEAD + preface.len()) as u64;
        let head = head(start + state.len() as u64);
        replace(path, &[&head, &preface, state].concat())?;
        Ok(start)
    }

    /// Appends a state behind `end`, then makes it count. Where that fails the
    /// states before it are what counts.
    fn append(&mut self, path: &Path, end: u64, state: &[u8]) -> io::Result<()> {
        let mut file = match self.file.take() {
            Some(file) => file,
            None => open(path)?,
        };
        is_whole(&file, end)?;
        file.seek(SeekFrom::Start(end))?;
        if let Err(reason) = file.write_all(state) {
            let _ = file.set_len(end); // the first error is the one to tell
            return Err(reason);
        }
        file.seek(SeekFrom::Start(mark_at(self.next_mark)))?;
        file.write_all(&mark(end + state.len() as u64))?;
        self.file = Some(file);
        Ok(())
    }
}

/// The file with a state in place of what begins at `start`, written beside
/// and renamed.
fn put_instead(path: &Path, start: u64, state: &[u8]) -> io::Result<Result<u64, WriteError>> {
    let mut bytes = Vec::new();
    let file = open(path)?;
    is_whole(&file, start)?;
    file.take(start).read_to_end(&mut bytes)?;
    bytes[..HEAD].copy_from_slice(&head(start + state.len() as u64));
    bytes.extend(state);
    Ok(replace(path, &bytes).map(|()| start))
}

fn open(path: &Path) -> io::Result<File> {
    File::options().read(true).write(true).open(path)
}

/// Refuses a file that has not so many bytes any more, or no name.
fn is_whole(file: &File, length: u64) -> io::Result<()> {
    let found = file.metadata()?;
    #[cfg(unix)]
    if std::os::unix::fs::MetadataExt::nlink(&found) == 0 {
        let message = "No such file any more: somebody removed it while the job was running";
        return Err(io::Error::new(io::ErrorKind::NotFound, message));
    }
    if found.len() < length {
        let message = "somebody made the file shorter while the job was running";
        return Err(io::Error::new(io::ErrorKind::UnexpectedEof, message));
    }
    Ok(())
}

/// Makes a state the last one of its file, whatever a bad end left behind it.
/// Afterwards both marks say so.
pub(super) fn end_at(path: &Path, last: Place, number: usize) -> Result<(), WriteError> {
    let end = || {
        let mut file = open(path)?;
        is_whole(&file, last.end)?;
        file.seek(SeekFrom::Start(mark_at(number)))?;
        file.write_all(&mark(last.end))?;
        file.set_len(last.end)
    };
    end().map_err(at(path))
}
