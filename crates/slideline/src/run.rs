//! A run with its files.

use crate::read::Read;
use crate::sensitivities::Chosen;
use crate::version::VERSION;
use slideline_advice::Noise;
use slideline_diag::{Code, Diagnostic, Severity};
use slideline_model::{Model, Onset};
use slideline_output::restart::{self, Saved};
use slideline_output::{
    Facts, Formats, JobFiles, Past, Status, WriteError, Writers, dropped_friction,
    remove_stale_lock,
};
use slideline_solve::observe::{Ending, Event, Frame, Observer, Stop, Totals};
use std::ops::ControlFlow;
use std::path::PathBuf;

/// How a run is made.
#[derive(Clone, Debug, Default)]
pub struct RunOptions {
    /// Folder of the result files; beside the deck unless said.
    pub folder: Option<PathBuf>,
    /// Go on from `JOB.rst` instead of beginning anew.
    pub restart: bool,
    /// Write `JOB.sensitivity.csv`: how the histories follow the parameters of the deck.
    pub sensitivities: bool,
    /// Whose formats the files have that more than one program writes.
    pub formats: Formats,
    /// How the solver works.
    pub solve: slideline_solve::Options,
}

/// What came of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// In one word.
    pub status: Status,
    /// Counts.
    pub totals: Totals,
    /// What was said during the run and about its end; what reading said
    /// stays with [`Read`].
    pub diagnostics: Vec<Diagnostic>,
    /// Where the files are.
    pub files: JobFiles,
    /// Why results are incomplete, where they are.
    pub output_failure: Option<String>,
}

/// An observer that does nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Quiet;

impl Observer for Quiet {
    fn event(&mut self, _: Event<'_>) -> ControlFlow<Stop> {
        ControlFlow::Continue(())
    }
}

/// Runs every step of a deck that was read, writes its files and tells
/// `observer`. A deck with errors only leaves a summary that says so, one
/// without any text leaves nothing.
pub fn run(read: &Read, options: &RunOptions, observer: &mut dyn Observer) -> Outcome {
    let files = read.job.files(options.folder.as_deref());
    let by = (&options.solve, options.restart);
    let mut chosen = match Chosen::wanted(read, options.sensitivities, by) {
        Ok(chosen) => chosen,
        Err(said) => return ended(Status::InputError, files, vec![*said], None),
    };
    let differentiated = chosen.run.take();
    let facts = facts(read, options, &chosen);
    if let Some(said) = would_destroy(read, &files).or_else(|| runs_already(&files)) {
        return ended(Status::InputError, files, vec![said], None);
    }
    let Some(model) = &read.model else {
        let failure = if read.has_text && !options.restart && !misses_files(read) {
            slideline_output::write_input_error(&files, facts).err()
        } else {
            None
        };
        return ended(Status::InputError, files, Vec::new(), failure);
    };
    let missing = options.solve.user_frictions.missing(model);
    if options.restart {
        return go_on((read, model), files, facts, (options, missing), observer);
    }
    if !missing.is_empty() {
        let failure = slideline_output::write_input_error(&files, facts).err();
        return ended(Status::InputError, files, missing, failure);
    }
    let from = match read.from.as_ref().map_or(Ok(None), |from| from.first_state(model)) {
        Ok(from) => from,
        Err(said) => return ended(Status::InputError, files, vec![*said], None),
    };
    let writers = match Writers::create(files.clone(), facts) {
        Ok(writers) => writers,
        Err(error) => return ended(Status::OutputError, files, Vec::new(), Some(error)),
    };
    let dropped_work = from.map_or(0.0, |from| from.energy().dropped_friction);
    let mut watch = Watch::new(writers, observer, model, dropped_work);
    watch.tell_all(&chosen.said);
    let ending = match (from, differentiated) {
        (None, Some(own)) => own.run((model, &chosen.names), &mut watch),
        (None, None) => Some(slideline_solve::run(model, &options.solve, &mut watch)),
        (Some(from), _) => slideline_solve::run_from(model, &options.solve, from, &mut watch),
    };
    match ending {
        Some(ending) => watch.outcome(&ending),
        // the state was held against the model before
        None => ended(Status::InternalError, files, Vec::new(), None),
    }
}

/// What writers need to know of a deck and of how it is run.
fn facts<'a>(read: &'a Read, options: &RunOptions, chosen: &'a Chosen) -> Facts<'a> {
    Facts {
        version: VERSION,
        deck_hash: &read.deck_hash,
        sources: &read.sources,
        diagnostics: &read.diagnostics,
        dialect: read.model.as_ref().map(|model| model.dialect).or(read.options.dialect),
        friction_onset: match &read.model {
            Some(model) => Some(model.friction_onset),
            None => read.options.friction_onset,
        },
        own_texts: read.deck.files.len(),
        parameters: &read.options.parameters,
        sensitivities: &chosen.names,
        earlier: read.from.as_ref().map(|from| &from.earlier),
        formats: options.formats,
    }
}

/// Goes on from the saved state of the job. Where that cannot be done the
/// files stay as they are.
fn go_on(
    (read, model): (&Read, &Model),
    files: JobFiles,
    facts: Facts<'_>,
    (options, missing): (&RunOptions, Vec<Diagnostic>),
    observer: &mut dyn Observer,
) -> Outcome {
    if !missing.is_empty() {
        return ended(Status::InputError, files, missing, None);
    }
    let saved = match usable(model, &files, &facts) {
        Ok(saved) => saved,
        Err(said) => return ended(Status::InputError, files, vec![*said], None),
    };
    let checkpoint = saved.checkpoint.clone();
    if checkpoint.finishes(model) && restart::is_completed(&files) {
        remove_stale_lock(&files); // killed after its last file was whole
        let message = format!("the job {} is complete: nothing is left to do", files.name());
        let origin = read.from.as_ref().map(|from| &from.earlier.origin);
        let said = Diagnostic::note(Code("SL0591"), message).help(format!(
            "To run it again from the beginning: slideline run {}{}",
            read.job.deck.display(),
            origin.map_or_else(String::new, |origin| format!(" --oldjob {}", origin.job))
        ));
        let outcome = ended(Status::Completed, files, vec![said], None);
        return Outcome { totals: checkpoint.totals, ..outcome };
    }
    let past = match Past::read(&files, model, checkpoint.totals.increments) {
        Ok(past) => past,
        Err(problem) => {
            let said = damaged(&problem.to_string());
            return ended(Status::InputError, files, vec![said], None);
        }
    };
    let writers = match Writers::resume(&files, facts, saved) {
        Ok(writers) => writers,
        Err(error) => return ended(Status::OutputError, files, Vec::new(), Some(error)),
    };
    let dropped_work = checkpoint.energy().dropped_friction;
    let mut watch = Watch::new(writers, observer, model, dropped_work);
    let curve = |node, dof| past.curve(model, node, dof);
    watch.noise.recall(model, curve, &past.pairs, &past.carriers);
    match slideline_solve::resume(model, &options.solve, checkpoint, &mut watch) {
        Some(ending) => watch.outcome(&ending),
        // the state was held against the model before
        None => ended(Status::InternalError, files, Vec::new(), None),
    }
}

/// The saved state, if this run can go on from it.
fn usable(model: &Model, files: &JobFiles, facts: &Facts<'_>) -> Result<Saved, Box<Diagnostic>> {
    let saved = restart::read(files)?;
    if let Some(said) = saved.objection(files, facts) {
        return Err(Box::new(said));
    }
    if !saved.checkpoint.fits(model) {
        let path = files.path(".rst");
        let message = format!("the saved state {} is not one of this model", path.display());
        let said = Diagnostic::error(Code("SL0708"), message);
        return Err(Box::new(said.help("Run the job from the beginning.")));
    }
    Ok(saved)
}

/// Result files that cannot be read back.
fn damaged(reason: &str) -> Diagnostic {
    let message = format!("the results up to the saved state cannot be read back: {reason}");
    Diagnostic::error(Code("SL0710"), message)
        .help("Restore the result files, or run the job from the beginning.")
}

fn ended(
    status: Status,
    files: JobFiles,
    diagnostics: Vec<Diagnostic>,
    failure: Option<WriteError>,
) -> Outcome {
    let output_failure = failure.map(|error| error.to_string());
    Outcome { status, totals: Totals::default(), diagnostics, files, output_failure }
}

/// Whether an earlier job or its states are what is wrong: the deck may be
/// right, and results that it has are not lost for a word on the command line.
fn misses_files(read: &Read) -> bool {
    let mut errors = read.diagnostics.iter().filter(|said| said.severity == Severity::Error);
    errors.any(|said| said.code.0.starts_with("SL07"))
}

/// Two processes must not write the same files.
fn runs_already(files: &JobFiles) -> Option<Diagnostic> {
    slideline_output::is_running(files).then(|| {
        let message = format!(
            "another process is running the job {} in {}",
            files.name(),
            files.folder().display()
        );
        Diagnostic::error(Code("SL0705"), message)
            .help("Wait for its end, or write the results elsewhere (--out).")
    })
}

/// A file that the deck was read from must not be taken for an old result.
fn would_destroy(read: &Read, files: &JobFiles) -> Option<Diagnostic> {
    let folder = std::fs::canonicalize(files.folder()).ok()?;
    let begins = read.from.as_ref().filter(|from| from.checkpoint.is_some());
    let own = std::fs::canonicalize(files.path(".rst")).ok();
    if let Some(from) = begins.filter(|from| std::fs::canonicalize(&from.states).ok() == own) {
        let message = format!(
            "the job continues from {}, which this run would replace by its own states",
            from.states.display()
        );
        let help = "Give the new deck another name, or write the results elsewhere (--out).";
        return Some(Diagnostic::error(Code("SL0711"), message).help(help));
    }
    let read_from = read.sources.files().iter().find(|source| {
        let path = std::fs::canonicalize(&source.name).ok();
        path.is_some_and(|path| {
            path.parent() == Some(&folder) && path.file_name().is_some_and(|name| files.owns(name))
        })
    })?;
    let message = format!(
        "the deck reads {}, which this run would replace by a result of that name",
        read_from.name
    );
    Some(
        Diagnostic::error(Code("SL0703"), message)
            .help("Give the included file another name, or write the results elsewhere (--out)."),
    )
}

/// Files first, then the embedding program; keeps the ledger.
struct Watch<'a> {
    writers: Writers<'a>,
    observer: &'a mut dyn Observer,
    onset: Onset,
    dropped_work: f64,
    noise: Noise,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Watch<'a> {
    fn new(
        writers: Writers<'a>,
        observer: &'a mut dyn Observer,
        model: &Model,
        dropped_work: f64,
    ) -> Self {
        let (noise, diagnostics) = (Noise::of(model), Vec::new());
        let onset = model.friction_onset;
        Self { writers, observer, onset, dropped_work, noise, diagnostics }
    }

    /// What is said before the run.
    fn tell_all(&mut self, said: &[Diagnostic]) {
        for said in said {
            let _ = self.event(Event::Diagnosed(said)); // it has not begun: there is nothing to stop
        }
    }

    /// The event reaches both even where the first one asks to stop; being
    /// unable to write weighs more than a wish to stop.
    fn tell(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        let written = self.writers.write(&event);
        let watched = self.observer.event(event);
        match written {
            ControlFlow::Break(stop) => ControlFlow::Break(stop),
            ControlFlow::Continue(()) => watched,
        }
    }

    /// Says where the state stands in which the run gave up.
    fn name_failed(&mut self, frame: &Frame<'_>) -> ControlFlow<Stop> {
        let path = self.writers.job().failed_state();
        let message = format!(
            "the state of the last attempt (increment {}, total time {:.6}), with its unbalanced \
             forces, is in {}",
            frame.increment,
            frame.total_time,
            path.display()
        );
        let said = Diagnostic::note(Code("SL0592"), message)
            .help("open it in ParaView and colour it by residual_force");
        self.diagnostics.push(said.clone());
        self.tell(Event::Diagnosed(&said))
    }

    /// What the ledger has to say goes before the end.
    fn close_ledger(&mut self, ending: &Ending) {
        let points = totals(ending).dropped_points;
        if let Some(said) = dropped_friction(self.onset, points, self.dropped_work) {
            let _ = self.tell(Event::Diagnosed(&said)); // the run is over: there is nothing to stop
            self.diagnostics.push(said);
        }
    }

    /// The noise of the run in numbers, and what it asks to be said.
    fn judge_noise(&mut self) {
        let measured = self.noise.summary();
        self.writers.measured(&measured);
        for said in self.noise.findings(&measured) {
            let _ = self.tell(Event::Diagnosed(&said)); // the run is over: there is nothing to stop
            self.diagnostics.push(said);
        }
    }

    fn outcome(self, ending: &Ending) -> Outcome {
        let failure = self.writers.failure().map(ToString::to_string);
        let status = if failure.is_some() { Status::OutputError } else { Status::of(ending) };
        Outcome {
            status,
            totals: totals(ending),
            diagnostics: self.diagnostics,
            files: self.writers.job().clone(),
            output_failure: failure,
        }
    }
}

impl Observer for Watch<'_> {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        self.noise.watch(&event);
        match event {
            Event::Committed(frame) => self.dropped_work = frame.energy.dropped_friction,
            Event::Diagnosed(said) => self.diagnostics.push(said.clone()),
            Event::Unconverged(state) => {
                self.tell(event)?;
                return self.name_failed(&state.frame);
            }
            Event::End(ending) => {
                self.close_ledger(ending);
                self.judge_noise();
            }
            _ => {}
        }
        self.tell(event)
    }
}

fn totals(ending: &Ending) -> Totals {
    match ending {
        Ending::Completed(totals)
        | Ending::NotConverged(totals, _)
        | Ending::Stopped(totals, _) => *totals,
    }
}
