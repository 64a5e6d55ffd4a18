//! Decks that go on from a saved state of an earlier job.
//!
//! ```text
//!   OLD.rst: texts of its deck, states ---+--> cards of both decks -> model
//!   NEW.inp: *RESTART, READ, *STEP ... ---'    state of OLD        -> run
//! ```
//!
//! The model comes from the texts that the states were saved with, so that it
//! does not matter what has become of the earlier deck.

use crate::job::{Job, OldJob, ReadOptions};
use crate::version::VERSION;
use slideline_deck::{Parsed, Texts};
use slideline_diag::{Code, Diagnostic, Sources};
use slideline_keywords::{Interpreted, ReadRequest, Setting, interpret_after, read_request};
use slideline_model::{Dialect, Model, Onset};
use slideline_output::restart::{Earlier, Origin, Part, SavedStates};
use slideline_output::{JobFiles, onset_word};
use slideline_solve::Checkpoint;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// What a deck with `*RESTART, READ` goes on from.
#[derive(Clone, Debug)]
pub struct From {
    /// The earlier decks, and which state was read.
    pub earlier: Earlier,
    /// The state; `None` where the job has begun and goes on from its own.
    pub checkpoint: Option<Checkpoint<'static>>,
    /// The file of states.
    pub states: PathBuf,
    pub(crate) dialect: Dialect,
    pub(crate) onset: Onset,
}

/// Finds what a deck goes on from; `None`: it stands for itself, or names no
/// earlier job, which its interpretation tells.
pub(crate) fn find(
    job: &Job,
    parsed: &Parsed,
    options: &ReadOptions,
) -> Result<Option<From>, Box<Diagnostic>> {
    match (read_request(parsed), &options.old_job) {
        (None, OldJob::Named(old)) => {
            let message = format!(
                "the job should continue from {}, but its deck has no *RESTART, READ",
                old.display()
            );
            let help = "Write *RESTART, READ into the deck, before its first *STEP, or leave out \
                        --oldjob.";
            Err(Box::new(Diagnostic::error(Code("SL0711"), message).help(help)))
        }
        (None, _) | (Some(_), OldJob::None) => Ok(None),
        (Some(request), OldJob::Named(old)) => {
            let at_card = |said: Box<Diagnostic>| Box::new(said.at(request.span));
            named(old, &request, options).map(Some).map_err(at_card)
        }
        (Some(_), OldJob::Begun(folder)) => begun(&job.files(folder.as_deref())).map(Some),
    }
}

/// The state of an earlier job that a card asks for.
fn named(
    old: &Path,
    request: &ReadRequest,
    options: &ReadOptions,
) -> Result<From, Box<Diagnostic>> {
    let files = files(old);
    let mut states = SavedStates::open(&files).map_err(|said| {
        let help = "Run the previous job first, with *RESTART, WRITE in its deck, and name it \
                    with the folder of its results: --oldjob DIR/OLD.";
        Box::new(said.help(help))
    })?;
    let dialect = options.dialect.map(Dialect::word);
    let onset = options.friction_onset.map(onset_word);
    if let Some(said) = states.objection(VERSION, dialect, onset) {
        let help = "The model and its states belong to the previous job: leave out the option, or \
                    run that job again with this program.";
        return Err(Box::new(said.help(help)));
    }
    let saved = states.load(request.step, request.increment)?;
    let (step, increment) = (saved.checkpoint.step, saved.checkpoint.increment);
    let mut parts = states.earlier().map_or(Vec::new(), |earlier| earlier.parts.clone());
    parts.retain(|part| part.steps < step);
    let (texts, parameters) = (states.texts().to_vec(), states.parameters().to_vec());
    let own = Part { texts, parameters, steps: step };
    match states.earlier().and_then(|earlier| earlier.parts.get(parts.len())) {
        // the state is one of a step that an earlier deck describes
        Some(part) => parts.push(Part { steps: step, ..part.clone() }),
        None => parts.push(own),
    }
    let origin = Origin { job: files.name(), step, increment };
    let earlier = Earlier { parts, origin };
    from(&states, earlier, Some(saved.checkpoint), files.path(".rst"))
}

/// What a job that has begun went on from.
fn begun(files: &JobFiles) -> Result<From, Box<Diagnostic>> {
    let states = SavedStates::open(files)?;
    let Some(earlier) = states.earlier().cloned() else {
        let message =
            "the deck was changed since the state was saved: *RESTART, READ was not in it";
        let help = "Continue with the deck and options of the saved state, or run the job from \
                    the beginning.";
        return Err(Box::new(Diagnostic::error(Code("SL0709"), message).help(help)));
    };
    from(&states, earlier, None, files.path(".rst"))
}

fn from(
    states: &SavedStates,
    earlier: Earlier,
    checkpoint: Option<Checkpoint<'static>>,
    path: PathBuf,
) -> Result<From, Box<Diagnostic>> {
    let [dialect, onset] = states.reading();
    let dialects = [Dialect::Abaqus, Dialect::Calculix];
    let onsets = [Onset::Immediate, Onset::Delayed, Onset::Matfru];
    let dialect = dialects.into_iter().find(|known| known.word() == dialect);
    let onset = onsets.into_iter().find(|known| onset_word(*known) == onset);
    let Some((dialect, onset)) = dialect.zip(onset) else {
        let message =
            format!("the saved state {} cannot be used: an unknown option", path.display());
        return Err(Box::new(Diagnostic::error(Code("SL0708"), message)));
    };
    Ok(From { earlier, checkpoint, states: path, dialect, onset })
}

/// The files of a job named by its path, with or without an ending.
fn files(old: &Path) -> JobFiles {
    let folder = old.parent().filter(|parent| *parent != Path::new(""));
    let is_ending = old
        .extension()
        .is_some_and(|end| ["inp", "rst"].iter().any(|own| end.eq_ignore_ascii_case(own)));
    let stem = if is_ending { old.file_stem() } else { old.file_name() };
    JobFiles::new(folder.unwrap_or(Path::new(".")), stem.map_or(OsString::new(), ToOwned::to_owned))
}

impl From {
    /// The state that a deck with `*RESTART, READ` begins with.
    pub(crate) fn first_state(
        &self,
        model: &Model,
    ) -> Result<Option<&Checkpoint<'static>>, Box<Diagnostic>> {
        match &self.checkpoint {
            Some(checkpoint) if checkpoint.fits(model) => Ok(Some(checkpoint)),
            Some(_) => {
                let states = self.states.display();
                let message = format!("the saved state {states} is not one of this model");
                let said = Diagnostic::error(Code("SL0708"), message);
                // other dofs follow then, some of them along axes that turn
                let help = "Its nodes, elements, constraints or contact pairs differ, or what *DISTRIBUTING and *TIE \
                            follow does: prescribed dofs of a reference node that were free, or steps without \
                            NLGEOM behind a job with it. Take the deck of the previous job up to its last step, or \
                            write both as one deck and run it from the beginning.";
                Err(Box::new(said.help(help)))
            }
            None => {
                let message = "this deck continues a previous job, and none is named";
                Err(Box::new(Diagnostic::error(Code("SL0711"), message)))
            }
        }
    }

    /// The meaning of the deck behind the earlier ones.
    pub(crate) fn interpret(
        &self,
        settings: &[Setting],
        parsed: &Parsed,
        sources: &mut Sources,
    ) -> Interpreted {
        let parts = self.earlier.parts.iter();
        let earlier: Vec<(Parsed, usize, Vec<Setting>)> = parts
            .map(|part| {
                let (name, text) = part.texts.first().map_or(("", ""), |(n, t)| (n, t));
                let loader = Texts(&part.texts);
                let parsed = slideline_deck::parse(sources, name, text.as_bytes(), &loader);
                (parsed, part.steps, settings_of(part))
            })
            .collect();
        let earlier: Vec<_> = earlier
            .iter()
            .map(|(parsed, steps, settings)| slideline_keywords::Earlier {
                parsed,
                steps: *steps,
                settings,
            })
            .collect();
        interpret_after(&earlier, settings, parsed, self.dialect)
    }
}

/// The settings that an earlier deck was read with; they were accepted then.
fn settings_of(part: &Part) -> Vec<Setting> {
    let parameters = part.parameters.iter();
    parameters
        .map(|(name, value)| Setting { name: name.clone(), value: value.clone(), span: None })
        .collect()
}

/// A deck whose meaning cannot be told, and what stands against it.
pub(crate) fn without_meaning(parsed: &Parsed, said: Diagnostic) -> Interpreted {
    let mut diagnostics = parsed.diagnostics.clone();
    diagnostics.push(said);
    Interpreted { model: Model::default(), diagnostics, numbers: Vec::new() }
}
