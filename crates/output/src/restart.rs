//! `JOB.rst`: the state to go on from.
//!
//! ```text
//!   "slideline.rst\n"  format  length  checksum | program, deck, options
//!                                              | lengths of the result files
//!                                              | summary so far | checkpoint
//! ```
//!
//! It is written beside and renamed, after everything that belongs to the
//! increment was handed to the system: whenever a process is killed, the
//! result files are at least as long as the file says. Reading is bounded by
//! the bytes there are, and a changed byte is found by the checksum.

use crate::file::{Growing, PART, WriteError, at, beside, replace};
use crate::job::{JobFiles, is_ending};
use crate::ledger::onset_word;
use crate::report::value::Value;
use crate::summary::{Facts, Memory, Summary};
use slideline_diag::{Code, Diagnostic};
use slideline_model::Dialect;
use slideline_solve::Checkpoint;
use slideline_solve::bytes::{Packed, Unpacking};
use slideline_solve::observe::StepReport;
use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::PathBuf;

/// How every such file begins.
const MAGIC: &[u8; 14] = b"slideline.rst\n";
/// Version of the layout.
const FORMAT: usize = 2;

/// What a run that goes on has to find.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// Ending and length of the files that grow.
    pub(crate) lengths: Vec<(String, u64)>,
    /// Number of deformed states.
    pub(crate) states: usize,
}

impl Kept {
    /// Notes a file that grows, if it is open.
    pub(crate) fn file(&mut self, ending: &str, file: Option<&Growing>) {
        self.lengths.extend(file.map(|file| (ending.to_owned(), file.length())));
    }
}

/// A saved state that was read.
#[derive(Clone, Debug)]
pub struct Saved {
    /// Where the run goes on.
    pub checkpoint: Checkpoint<'static>,
    circumstances: Circumstances,
    pub(crate) kept: Kept,
    pub(crate) memory: Memory,
}

/// What must be the same in the run that goes on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Circumstances {
    version: String,
    deck_hash: String,
    dialect: String,
    friction_onset: String,
}

impl Circumstances {
    fn of(facts: &Facts<'_>) -> Self {
        Self {
            version: facts.version.to_owned(),
            deck_hash: facts.deck_hash.to_owned(),
            dialect: facts.dialect.map(Dialect::word).unwrap_or_default().to_owned(),
            friction_onset: facts.friction_onset.map(onset_word).unwrap_or_default().to_owned(),
        }
    }

    fn fields(&self) -> [&str; 4] {
        [&self.version, &self.deck_hash, &self.dialect, &self.friction_onset]
    }
}

/// Reads the saved state of a job.
///
/// # Errors
/// A diagnostic: there is none (SL0707), or it cannot be used (SL0708).
pub fn read(job: &JobFiles) -> Result<Saved, Box<Diagnostic>> {
    let path = job.path(".rst");
    let bytes = std::fs::read(&path).map_err(|reason| {
        Box::new(if reason.kind() == ErrorKind::NotFound {
            let message = format!("there is no saved state {} to go on from", path.display());
            Diagnostic::error(Code("SL0707"), message).help(
                "Run the job from its beginning. To save states, write *RESTART, WRITE into the \
                 deck; the first is there after the first increment.",
            )
        } else {
            unusable(&path.display().to_string(), &reason.to_string())
        })
    })?;
    unpack(&bytes).map_err(|reason| Box::new(unusable(&path.display().to_string(), reason)))
}

fn unusable(path: &str, reason: &str) -> Diagnostic {
    let message = format!("the saved state {path} cannot be used: {reason}");
    Diagnostic::error(Code("SL0708"), message)
        .help("Run the job from its beginning; nothing was changed so far.")
}

/// Reads the bytes of a saved state.
///
/// # Errors
/// Why they are none.
pub fn unpack(bytes: &[u8]) -> Result<Saved, &'static str> {
    let rest = bytes.strip_prefix(MAGIC).ok_or("it was not written by this program")?;
    let mut head = Unpacking(rest);
    match head.count() {
        Some(FORMAT) => {}
        Some(_) => return Err("it was written by another version of this program"),
        None => return Err("it is shorter than its own heading"),
    }
    let length = head.count().ok_or("it is shorter than its own heading")?;
    let checksum = head.number().ok_or("it is shorter than its own heading")?;
    if head.0.len() != length {
        return Err("it is shorter or longer than it says");
    }
    if sum(head.0) != checksum.to_bits() {
        return Err("its checksum is wrong: it was damaged or changed");
    }
    let mut body = head;
    let saved = unpack_body(&mut body).filter(|_| body.is_done());
    saved.ok_or("its content makes no sense")
}

fn unpack_body(bytes: &mut Unpacking<'_>) -> Option<Saved> {
    let circumstances = Circumstances {
        version: bytes.text()?,
        deck_hash: bytes.text()?,
        dialect: bytes.text()?,
        friction_onset: bytes.text()?,
    };
    let files = bytes.length(16)?;
    let lengths = (0..files).map(|_| Some((bytes.text()?, bytes.count()? as u64)));
    let lengths = lengths.collect::<Option<Vec<(String, u64)>>>()?;
    if lengths.iter().any(|(ending, _)| !is_ending(ending)) {
        return None;
    }
    let kept = Kept { lengths, states: bytes.count()? };
    let memory = Memory::unpack(bytes)?;
    let checkpoint = Checkpoint::unpack(bytes)?;
    Some(Saved { checkpoint, circumstances, kept, memory })
}

/// FNV-1a, 64 bits: any single changed byte changes it. [manual]
fn sum(bytes: &[u8]) -> u64 {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

impl Saved {
    /// Why the run described by `facts` cannot go on from here: another deck,
    /// other options, another program, or result files that do not fit.
    pub fn objection(&self, job: &JobFiles, facts: &Facts<'_>) -> Option<Diagnostic> {
        let now = Circumstances::of(facts);
        let was = &self.circumstances;
        let pairs = was.fields().into_iter().zip(now.fields());
        let names = ["the program", "the deck", "the dialect", "the friction onset"];
        let changed = names.into_iter().zip(pairs).find(|(_, (was, now))| was != now);
        if let Some((what, (was, now))) = changed {
            let message = format!(
                "{what} was changed since the state was saved: it was {was} and is {now} now"
            );
            return Some(Diagnostic::error(Code("SL0709"), message).help(
                "Go on with what the state was saved with, or run the job from its beginning.",
            ));
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
            let mut states = (0..self.kept.states).map(|number| job.state_name(number));
            let lost = states.find(|state| !job.folder().join(state).exists())?;
            Some(format!("{lost} is missing; it was there when the state was saved"))
        };
        let message = short.or_else(lost)?;
        Some(
            Diagnostic::error(Code("SL0710"), message)
                .help("Put the result files back as they were, or run the job from its beginning."),
        )
    }
}

/// Where a file that grows is: printed tables wait beside their file until
/// the run ends.
fn found(job: &JobFiles, ending: &str) -> PathBuf {
    let path = job.path(ending);
    let part = beside(&path);
    if ending == ".dat" && part.exists() { part } else { path }
}

/// Whether the job's own summary says that it is complete.
pub fn is_completed(job: &JobFiles) -> bool {
    let text = std::fs::read_to_string(job.path(".json")).unwrap_or_default();
    let summary = Value::read(&text).ok();
    summary.is_some_and(|summary| summary.text("status") == Some("completed"))
}

/// Removes what came after a saved state. Files that grow are cut when they
/// are opened. May be interrupted and done again.
pub(crate) fn cut_back(job: &JobFiles, kept: &Kept) -> Result<(), WriteError> {
    let dat = job.path(".dat");
    let tables = beside(&dat);
    let waits = kept.lengths.iter().any(|(ending, _)| ending == ".dat");
    if waits && !tables.exists() {
        std::fs::rename(&dat, &tables).map_err(at(&dat))?;
    }
    let states: BTreeSet<String> = (0..kept.states).map(|number| job.state_name(number)).collect();
    for path in job.existing()? {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let unfinished = name.ends_with(PART) && !(waits && path == tables);
        let later = name.ends_with(".vtu") && !states.contains(&*name);
        if unfinished || later || path == job.path(".html") {
            std::fs::remove_file(&path).map_err(at(&path))?;
        }
    }
    Ok(())
}

/// Writes `JOB.rst`.
#[derive(Debug)]
pub(crate) struct Writer {
    circumstances: Circumstances,
    /// Every how many increments; `None`: never.
    every: Option<usize>,
}

impl Writer {
    pub fn new(facts: &Facts<'_>) -> Self {
        Self { circumstances: Circumstances::of(facts), every: None }
    }

    /// Learns what a step asks for.
    pub fn begin(&mut self, report: &StepReport<'_>) {
        let step = report.step.checked_sub(1).and_then(|place| report.model.steps.get(place));
        self.every = step.and_then(|step| step.output.restart_every);
    }

    /// Whether a state is to be saved: in the increments asked for, at the end
    /// of a step, and when the run is stopped.
    pub fn is_due(&self, checkpoint: &Checkpoint<'_>) -> bool {
        self.every.is_some_and(|every| {
            let asked = checkpoint.increment.is_multiple_of(every.max(1));
            asked || checkpoint.last_of_step() || checkpoint.stopping
        })
    }

    pub fn write(
        &self,
        job: &JobFiles,
        checkpoint: &Checkpoint<'_>,
        kept: &Kept,
        summary: &Summary<'_>,
    ) -> Result<(), WriteError> {
        let mut body = Packed::default();
        self.circumstances.fields().into_iter().for_each(|field| body.text(field));
        body.count(kept.lengths.len());
        for (ending, length) in &kept.lengths {
            body.text(ending);
            body.0.extend(length.to_le_bytes());
        }
        body.count(kept.states);
        summary.pack(&mut body);
        checkpoint.pack(&mut body);
        let mut file = Packed(MAGIC.to_vec());
        file.count(FORMAT);
        file.count(body.0.len());
        file.number(f64::from_bits(sum(&body.0)));
        file.0.extend(&body.0);
        replace(&job.path(".rst"), &file.0)
    }
}
