//! `slideline run`.

use crate::arguments::RunArguments;
use crate::exit::Exit;
use crate::progress::{Mode, Progress, diagnosis};
use crate::{interrupt, render, report, screen};
use slideline::diag::{Code, Diagnostic, Severity};
use slideline::output::json::{self, json};
use slideline::output::{add_warning, onset_word, verdict_of};
use slideline::{
    ErrorBars, Event, Formats, Job, Observer, OldJob, Outcome, Reactions, Read, ReadOptions,
    RunOptions, SolveOptions, Status, Stop, TangentCheck, VERSION, error_bars, run as run_job,
    time_error_bars, write_error_bars,
};
use std::ops::ControlFlow;
use std::time::Instant;

/// Runs a deck that was read and says how it went.
pub(crate) fn run_read(mut read: Read, arguments: &RunArguments) -> Outcome {
    let began = Instant::now();
    read.diagnostics.extend(slideline::advise(&read));
    // what is trivial goes below
    read.diagnostics.sort_by_key(|said| said.severity == Severity::Note);
    let mode = mode(arguments);
    if mode == Mode::Json {
        screen::print(&start_lines(&read));
    } else {
        let heard = read.diagnostics.iter().filter(|said| is_heard(said, mode));
        render::to_standard_error(heard, &read.sources);
    }
    if read.model.is_some() {
        interrupt::listen();
    }
    let options = RunOptions {
        folder: arguments.out.clone(),
        restart: arguments.restart,
        sensitivities: arguments.sensitivities,
        formats: Formats::Own,
        solve: SolveOptions {
            threads: arguments.threads,
            check_tangent: match arguments.check_tangent {
                None => TangentCheck::Never,
                Some(None) => TangentCheck::Every,
                Some(Some(increment)) => TangentCheck::Increment(increment),
            },
            ..SolveOptions::default()
        },
    };
    let mut found = read.model.as_ref().map(Reactions::of).unwrap_or_default();
    let mut progress = Progress::new(mode, &read.sources);
    let mut outcome = run_job(&read, &options, &mut found.watch(&mut progress));
    if arguments.error_bars {
        let said = add_error_bars(&read, &found, &options.solve, &mut outcome);
        if mode == Mode::Json {
            said.iter().for_each(|said| screen::print(&diagnosis_line(said, &read)));
        }
        outcome.diagnostics.extend(said);
    }
    if !arguments.no_html {
        report::after_run(&mut outcome);
    }
    tell(&read, &outcome, mode, began);
    outcome
}

/// A job that goes on after an interruption knows where it came from.
pub(crate) fn read_options(arguments: &RunArguments) -> ReadOptions {
    let options = arguments.deck.options();
    if arguments.restart {
        return ReadOptions { old_job: OldJob::Begun(arguments.out.clone()), ..options };
    }
    options
}

/// Estimates errors of a run that came to its end and adds them to its files.
/// What stands against them is added as well, and returned.
fn add_error_bars(
    read: &Read,
    found: &Reactions,
    options: &SolveOptions,
    outcome: &mut Outcome,
) -> Vec<Diagnostic> {
    let (Some(model), Status::Completed) = (&read.model, outcome.status) else { return Vec::new() };
    let (mesh, time) = if read.from.is_some() {
        (Err(Box::new(from_another_job())), None)
    } else if found.count() != outcome.totals.increments {
        (Err(Box::new(begun_elsewhere())), None)
    } else {
        let mesh = error_bars(model, found, options, &mut Interruptible);
        (mesh, Some(time_error_bars(model, found, options, &mut Interruptible)))
    };
    let (mesh, against_mesh) = halves(Some(mesh));
    let (time, against_time) = halves(time);
    let said: Vec<Diagnostic> = against_mesh.into_iter().chain(against_time).collect();
    let write = || {
        if mesh.is_some() || time.is_some() {
            write_error_bars(&outcome.files, mesh.as_ref(), time.as_ref())?;
        }
        // a job that was complete before keeps its files as they are
        let mut told = said.iter().filter(|_| found.count() > 0);
        told.try_for_each(|said| add_warning(&outcome.files, said, &read.sources))
    };
    if let Err(failure) = write() {
        outcome.output_failure = Some(failure.to_string());
        outcome.status = Status::OutputError;
    }
    said
}

/// What was found, and what stood against it.
fn halves(
    estimated: Option<Result<ErrorBars, Box<Diagnostic>>>,
) -> (Option<ErrorBars>, Option<Diagnostic>) {
    match estimated {
        None => (None, None),
        Some(Ok(bars)) => (Some(bars), None),
        Some(Err(said)) => (None, Some(*said)),
    }
}

/// Steps that begin in the state of an earlier job have the history of its mesh.
fn from_another_job() -> Diagnostic {
    let message = "no error bars: the job continues from a state of another job";
    Diagnostic::warning(Code("SL0602"), message)
        .help("Put all steps into one deck to get error bars.")
}

/// A run that goes on from a saved state knows only its own increments.
fn begun_elsewhere() -> Diagnostic {
    let message = "no error bars: this run continued from a saved state, and the reactions before \
                   it are not available";
    Diagnostic::warning(Code("SL0602"), message)
        .help("Run the deck from the beginning, without --restart.")
}

/// Stops a run when the user asks for it, and says nothing.
pub(crate) struct Interruptible;

impl Observer for Interruptible {
    fn event(&mut self, _: Event<'_>) -> ControlFlow<Stop> {
        if interrupt::asked() {
            return ControlFlow::Break(Stop::Interrupted);
        }
        ControlFlow::Continue(())
    }
}

pub(crate) fn mode(arguments: &RunArguments) -> Mode {
    match (arguments.quiet, arguments.json, screen::output_is_terminal()) {
        (true, _, _) => Mode::Silent,
        (_, true, _) => Mode::Json,
        (_, _, true) => Mode::Live,
        _ => Mode::Lines,
    }
}

/// `--quiet` silences progress, notes and advice with it, never errors and
/// warnings.
fn is_heard(said: &Diagnostic, mode: Mode) -> bool {
    mode != Mode::Silent || said.severity >= Severity::Warning
}

/// The event that opens the stream, and what reading had to say.
fn start_lines(read: &Read) -> String {
    let model = read.model.as_ref();
    let start = json!({
        "event": "start",
        "job": read.job.stem.to_string_lossy(),
        "deck": read.job.deck.display().to_string(),
        "deck_hash": read.deck_hash,
        "program_version": VERSION,
        "dialect": model.map(|model| model.dialect.word()),
        "friction_onset": model.map(|model| onset_word(model.friction_onset)),
        "steps": model.map_or(0, |model| model.steps.len()),
    });
    let mut text = json::text(&start) + "\n";
    for said in &read.diagnostics {
        text.push_str(&diagnosis_line(said, read));
    }
    text
}

fn diagnosis_line(said: &Diagnostic, read: &Read) -> String {
    json::text(&diagnosis(said, &read.sources)) + "\n"
}

/// The end: what was said, what is kept, how to go on.
fn tell(read: &Read, outcome: &Outcome, mode: Mode, began: Instant) {
    let mut said = outcome.diagnostics.clone();
    let after = said.len();
    said.extend(last_words(read, outcome));
    if mode == Mode::Json {
        // The run itself has told the others as events, but one that never began.
        let untold = if outcome.status == Status::InputError { 0 } else { after };
        let mut text: String = said[untold..].iter().map(|s| diagnosis_line(s, read)).collect();
        text.push_str(&end_line(outcome, began));
        screen::print(&text);
        return;
    }
    render::to_standard_error(said.iter().filter(|said| is_heard(said, mode)), &read.sources);
    if mode != Mode::Silent {
        screen::print(&closing_line(read, outcome, began));
    }
}

/// What only the end can say.
fn last_words(read: &Read, outcome: &Outcome) -> Option<Diagnostic> {
    let kept = outcome.totals.increments;
    if let Some(failure) = &outcome.output_failure {
        let message = format!("results could not be written: {failure}");
        let said = if outcome.status == Status::OutputError {
            Diagnostic::error(Code("SL0702"), message)
        } else {
            Diagnostic::warning(Code("SL0702"), message)
        };
        return Some(said.help(kept_files(read, outcome)));
    }
    match outcome.status {
        Status::Interrupted => Some(
            Diagnostic::note(
                Code("SL0590"),
                format!("interrupted after {kept} converged increments; everything up to there is written"),
            )
            .help(how_to_go_on(read, outcome)),
        ),
        _ => None,
    }
}

fn how_to_go_on(read: &Read, outcome: &Outcome) -> String {
    restart_command(read, outcome).map_or_else(
        || {
            let deck = read.job.deck.display();
            format!("To continue, run the job again from the beginning: slideline run {deck}")
        },
        |command| format!("To continue from there: {command}"),
    )
}

/// The command that goes on from the last saved state, if there is one.
fn restart_command(read: &Read, outcome: &Outcome) -> Option<String> {
    // one of several runs of a deck has another name than the deck
    let is_of_the_deck = Job::named(&read.job.deck).stem == read.job.stem;
    if !is_of_the_deck || !outcome.files.path(".rst").exists() {
        return None;
    }
    let deck = read.job.deck.display();
    let beside = read.job.files(None);
    let elsewhere = beside.folder() != outcome.files.folder();
    let out = if elsewhere {
        format!(" --out {}", outcome.files.folder().display())
    } else {
        String::new()
    };
    let set = read.options.parameters.iter();
    let set: String = set.map(|(name, value)| format!(" --set '{name}={value}'")).collect();
    Some(format!("slideline run {deck} --restart{out}{set}"))
}

fn kept_files(read: &Read, outcome: &Outcome) -> String {
    let names: Vec<String> = outcome
        .files
        .existing()
        .unwrap_or_default()
        .iter()
        .filter_map(|path| path.file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .filter(|name| !name.ends_with(".part"))
        .collect();
    let folder = outcome.files.folder().display();
    if names.is_empty() {
        return format!(
            "Nothing was written to {folder}. Free disk space or choose another folder with \
             --out."
        );
    }
    let states = names.iter().filter(|name| name.ends_with(".vtu")).count();
    let mut others: Vec<String> =
        names.into_iter().filter(|name| !name.ends_with(".vtu")).collect();
    others.sort();
    let again = match restart_command(read, outcome) {
        Some(command) => format!(
            "Free disk space and continue from the last saved state: \
                                  {command}"
        ),
        None => "Free disk space or choose another folder with --out, and run again.".to_owned(),
    };
    format!(
        "Written to {folder} and valid up to the last complete line: {} and {states} .vtu files. \
         {again}",
        others.join(", ")
    )
}

fn closing_line(read: &Read, outcome: &Outcome, began: Instant) -> String {
    let name = read.job.stem.to_string_lossy();
    if name.is_empty() {
        return "input error, nothing was solved\n".to_owned();
    }
    if outcome.status == Status::InputError {
        return format!("{name}: input error, nothing was solved\n");
    }
    let totals = &outcome.totals;
    let line = format!(
        "{name}: {} after {} increments, {} iterations, {} cutbacks in {:.3} s; results in {}\n",
        outcome.status.word().replace('_', " "),
        totals.increments,
        totals.iterations,
        totals.cutbacks,
        began.elapsed().as_secs_f64(),
        outcome.files.folder().display()
    );
    verdict_line(outcome) + &line
}

/// Colour and reasons, as the report has them on its top.
fn verdict_line(outcome: &Outcome) -> String {
    match verdict_of(&outcome.files) {
        Some((colour, reasons)) if reasons.is_empty() => format!("verdict: {colour}\n"),
        Some((colour, reasons)) => format!("verdict: {colour} ({})\n", reasons.join("; ")),
        None => String::new(),
    }
}

fn end_line(outcome: &Outcome, began: Instant) -> String {
    let totals = &outcome.totals;
    let verdict = verdict_of(&outcome.files).map(|(colour, _)| colour);
    let end = json!({
        "event": "end",
        "status": outcome.status.word(),
        "exit_code": Exit::from(outcome.status) as usize,
        "increments": totals.increments,
        "cutbacks": totals.cutbacks,
        "iterations": totals.iterations,
        "wall_seconds": began.elapsed().as_secs_f64(),
        "folder": outcome.files.folder().display().to_string(),
        "verdict": verdict,
    });
    json::text(&end) + "\n"
}
