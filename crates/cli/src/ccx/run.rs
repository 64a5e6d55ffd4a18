//! A call of ccx from its arguments to its exit code.

use super::arguments::{Asked, threads};
use super::observer::Told;
use super::words;
use crate::exit::Exit;
use crate::{interrupt, report, screen};
use slideline::diag::{Code, Diagnostic};
use slideline::{
    Dialect, Formats, Job, Outcome, Read, ReadOptions, RunOptions, SolveOptions, Status, run,
};
use std::ffi::OsString;
use std::path::Path;
use std::time::Instant;

/// Answers a call of ccx.
pub(crate) fn ccx(arguments: &[OsString]) -> Exit {
    match Asked::read(arguments) {
        Asked::Usage => {
            screen::print(words::USAGE);
            Exit::Answered
        }
        Asked::Version => {
            screen::print(&words::version());
            Exit::Answered
        }
        Asked::Job(job, ignored) => run_job(&job, &ignored),
    }
}

/// Runs a job; everything that is said goes to standard output, where callers look for it.
fn run_job(job: &Path, ignored: &[String]) -> Exit {
    let began = Instant::now();
    screen::print(&words::head());
    let options = ReadOptions { dialect: Some(Dialect::Calculix), ..ReadOptions::default() };
    let mut read = Job::read(job, &options);
    read.diagnostics.extend(slideline::advise(&read));
    read.diagnostics.extend(ignored.iter().map(|argument| without_effect(argument)));
    say(&read.diagnostics, &read);
    if read.model.is_some() {
        interrupt::listen();
    }
    let options = RunOptions {
        formats: Formats::Ccx,
        solve: SolveOptions {
            threads: threads(std::env::var("OMP_NUM_THREADS").ok().as_deref()),
            ..SolveOptions::default()
        },
        ..RunOptions::default()
    };
    let mut outcome = run(&read, &options, &mut Told::default());
    let report = add_report(&mut outcome);
    say(&outcome.diagnostics, &read);
    say(report.as_slice(), &read);
    say(last_word(&outcome).as_slice(), &read);
    if outcome.status == Status::Completed {
        screen::print(&words::finished(began.elapsed().as_secs_f64()));
    }
    outcome.status.into()
}

/// Makes the report. ccx has none: where it cannot be made, the results that callers read are not
/// lost for it.
fn add_report(outcome: &mut Outcome) -> Option<Diagnostic> {
    let status = outcome.status;
    report::after_run(outcome);
    if status != Status::Completed || outcome.status == status {
        return None;
    }
    outcome.status = status;
    let reason = outcome.output_failure.take()?;
    Some(Diagnostic::warning(Code("SL0702"), format!("the report could not be made: {reason}")))
}

fn without_effect(argument: &str) -> Diagnostic {
    let message = format!("the argument {argument} of ccx has no effect here");
    Diagnostic::note(Code("SL0257"), message)
}

fn say(all: &[Diagnostic], read: &Read) {
    let text: String = all.iter().map(|said| words::said(said, &read.sources)).collect();
    screen::print(&text);
}

/// What only the end can say.
fn last_word(outcome: &Outcome) -> Option<Diagnostic> {
    if let Some(failure) = &outcome.output_failure {
        let message = format!("results could not be written: {failure}");
        return Some(Diagnostic::error(Code("SL0702"), message));
    }
    (outcome.status == Status::Interrupted).then(|| {
        let message = "interrupted; what converged is written";
        Diagnostic::warning(Code("SL0590"), message)
    })
}
