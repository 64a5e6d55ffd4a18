//! `JOB.rst`: states to go on from.
//!
//! A state is saved after everything that belongs to its increment was handed
//! to the system: whenever a process is killed, the result files are at least
//! as long as the state says. Reading is bounded by the bytes there are, and a
//! changed byte is found by a checksum.

mod preface;
mod states;
mod writer;

pub use crate::facts::{Earlier, Origin, Part};
pub use crate::reading::summary::is_completed;
pub use states::Saved;
pub(crate) use writer::Writer;

use crate::facts::Facts;
use crate::file::{PART, WriteError, at, beside};
use crate::job::JobFiles;
use slideline_diag::{Code, Diagnostic};
use states::{Place, States};
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufReader, Cursor, ErrorKind};
use std::path::PathBuf;

/// The states of a job.
pub struct SavedStates {
    job: JobFiles,
    states: States<BufReader<File>>,
}

impl SavedStates {
    /// Opens the states of a job.
    ///
    /// # Errors
    /// A diagnostic: there are none (SL0707), or they cannot be used (SL0708).
    pub fn open(job: &JobFiles) -> Result<Self, Box<Diagnostic>> {
        let path = job.path(".rst");
        let file = crate::file::open(&path).map_err(|reason| {
            Box::new(if reason.kind() == ErrorKind::NotFound {
                let message =
                    format!("there is no saved state {} to continue from", path.display());
                Diagnostic::error(Code("SL0707"), message).help(
                    "Run the job from the beginning. To save states, write *RESTART, WRITE into \
                     the deck; the first one exists after the first increment.",
                )
            } else {
                unusable(job, &reason.to_string())
            })
        })?;
        let states = States::open(BufReader::new(file));
        let states = states.map_err(|reason| Box::new(unusable(job, &reason)))?;
        Ok(Self { job: job.clone(), states })
    }

    /// Steps and increments of the states, in the order in which they were
    /// saved.
    pub fn list(&self) -> impl Iterator<Item = (usize, usize)> {
        self.states.places.iter().map(|place| (place.step, place.increment))
    }

    /// The jobs that this one goes on from.
    pub fn earlier(&self) -> Option<&Earlier> {
        self.states.preface.earlier.as_ref()
    }

    /// Name and text of the job's own deck, then of what it includes.
    pub fn texts(&self) -> &[(String, String)] {
        &self.states.preface.texts
    }

    /// Values that the parameters of its deck were given from outside.
    pub fn parameters(&self) -> &[(String, String)] {
        &self.states.preface.circumstances.parameters
    }

    /// Dialect and friction onset of the model, as words.
    pub fn reading(&self) -> [&str; 2] {
        let circumstances = &self.states.preface.circumstances;
        [&circumstances.dialect, &circumstances.friction_onset]
    }

    /// Why a new job cannot go on from these states: another program, or
    /// options that contradict the model they belong to.
    pub fn objection(
        &self,
        version: &str,
        dialect: Option<&str>,
        onset: Option<&str>,
    ) -> Option<Diagnostic> {
        self.states.preface.objection_of_new(version, dialect, onset)
    }

    /// Reads the last state, or that of a step, or of an increment in it.
    ///
    /// # Errors
    /// A diagnostic: it was not saved (SL0712), or cannot be used (SL0708).
    pub fn load(
        &mut self,
        step: Option<usize>,
        increment: Option<usize>,
    ) -> Result<Saved, Box<Diagnostic>> {
        let place = self.states.find(step, increment);
        let place = place.ok_or_else(|| Box::new(self.not_saved(step, increment)))?;
        self.states.load(place).map_err(|reason| Box::new(self.damaged(place, &reason)))
    }

    /// A state that cannot be used, with the one before it as the way out.
    fn damaged(&self, place: Place, reason: &str) -> Diagnostic {
        let said = unusable(&self.job, reason);
        let before = self.states.places.iter().rev().find(|other| other.end == place.start);
        match before {
            None => said,
            Some(Place { step, increment, .. }) => said.help(format!(
                "Run the job from the beginning, or continue from an earlier state with a new \
                 deck: *RESTART, READ, STEP={step}, INC={increment}. Nothing was changed so far."
            )),
        }
    }

    fn not_saved(&self, step: Option<usize>, increment: Option<usize>) -> Diagnostic {
        let path = self.job.path(".rst");
        let asked = match (step, increment) {
            (Some(step), Some(increment)) => format!("step {step}, increment {increment}"),
            (Some(step), None) => format!("step {step}"),
            _ => "any increment".to_owned(),
        };
        let message = format!("{} has no state of {asked}", path.display());
        let mut there: Vec<(usize, usize, usize)> = Vec::new(); // step, first, last increment
        for (step, increment) in self.list() {
            match there.last_mut().filter(|last| last.0 == step) {
                Some(last) => last.2 = increment,
                None => there.push((step, increment, increment)),
            }
        }
        let there = there.iter().map(|(step, first, last)| match first == last {
            true => format!("step {step}: increment {last}"),
            false => format!("step {step}: increments from {first} to {last}"),
        });
        let there: Vec<String> = there.take(10).collect();
        let help = if there.is_empty() {
            "Run that job again.".to_owned()
        } else {
            format!(
                "There are states of {}. *RESTART, WRITE, FREQUENCY=N in the previous deck sets \
                 which increments are saved.",
                there.join("; ")
            )
        };
        Diagnostic::error(Code("SL0712"), message).help(help)
    }
}

/// Reads the last saved state of a job.
///
/// # Errors
/// A diagnostic: there is none (SL0707), or it cannot be used (SL0708).
pub fn read(job: &JobFiles) -> Result<Saved, Box<Diagnostic>> {
    let mut states = SavedStates::open(job)?;
    states.load(None, None)
}

fn unusable(job: &JobFiles, reason: &str) -> Diagnostic {
    let path = job.path(".rst");
    let message = format!("the saved state {} cannot be used: {reason}", path.display());
    Diagnostic::error(Code("SL0708"), message)
        .help("Run the job from the beginning; nothing was changed so far.")
}

/// Reads the last state of the bytes of a `JOB.rst`.
///
/// # Errors
/// Why there is none, in words.
pub fn unpack(bytes: &[u8]) -> Result<Saved, String> {
    let mut states = States::open(Cursor::new(bytes))?;
    let place = states.find(None, None).ok_or("it has no state")?;
    states.load(place)
}

impl Saved {
    /// Why the run described by `facts` cannot go on from here: another deck,
    /// other options, another program, or result files that do not fit.
    pub fn objection(&self, job: &JobFiles, facts: &Facts<'_>) -> Option<Diagnostic> {
        if let Some(said) = self.preface.objection(facts) {
            return Some(said);
        }
        let short = self.kept.lengths.iter().find_map(|(ending, length)| {
            let path = found(job, ending);
            let there = std::fs::metadata(&path).map(|data| data.len()).unwrap_or_default();
            let message = || {
                let path = path.display();
                format!("{path} has {there} bytes; it had {length} when the state was saved")
            };
            (there < *length).then(message)
        });
        // One after the other, so that no number is too large.
        let lost = || {
            let mut states = self.kept.states.iter().map(|number| job.state_name(number));
            let lost = states.find(|state| !job.folder().join(state).exists())?;
            Some(format!("{lost} is missing; it was there when the state was saved"))
        };
        let message = short.or_else(lost)?;
        Some(
            Diagnostic::error(Code("SL0710"), message)
                .help("Restore the result files, or run the job from the beginning."),
        )
    }
}

/// Files that wait beside their own name until the run ends.
const WAITING: [&str; 2] = [".dat", ".frd"];

/// Where a file that grows is.
fn found(job: &JobFiles, ending: &str) -> PathBuf {
    let path = job.path(ending);
    let part = beside(&path);
    if WAITING.contains(&ending) && part.exists() { part } else { path }
}

/// Removes what came after a saved state. Files that grow are cut when they
/// are opened. May be interrupted and done again.
pub(crate) fn cut_back(job: &JobFiles, saved: &Saved) -> Result<(), WriteError> {
    // First, for later states would ask for more than will be there.
    writer::end_at(&job.path(".rst"), saved.place, saved.next_mark)?;
    let kept = &saved.kept;
    let waits = |ending: &&str| kept.lengths.iter().any(|(own, _)| own == ending);
    let waiting: Vec<PathBuf> =
        WAITING.into_iter().filter(waits).map(|ending| job.path(ending)).collect();
    for path in &waiting {
        if !beside(path).exists() {
            std::fs::rename(path, beside(path)).map_err(at(path))?;
        }
    }
    let waiting: Vec<PathBuf> = waiting.iter().map(|path| beside(path)).collect();
    let states: BTreeSet<String> =
        kept.states.iter().map(|number| job.state_name(number)).collect();
    for path in job.existing()? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let unfinished = name.ends_with(PART) && !waiting.contains(&path);
        let later = name.ends_with(".vtu") && !states.contains(&*name);
        if unfinished || later || path == job.path(".html") {
            std::fs::remove_file(&path).map_err(at(&path))?;
        }
    }
    Ok(())
}
