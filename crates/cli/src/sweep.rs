//! `slideline sweep`: a study of one deck with many values.

use crate::exit::Exit;
use crate::{interrupt, render, screen};
use clap::{Args, ValueHint};
use slideline::diag::Sources;
use slideline_sweep::{Failure, Outcome, StudyFile, SweepOptions, read_study, sweep as run};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Time between two lines of progress.
const PAUSE: Duration = Duration::from_secs(1);

/// `slideline sweep`.
#[derive(Args, Debug)]
pub(crate) struct SweepArguments {
    /// The study, a TOML file; its deck is named in it.
    #[arg(value_name = "STUDY.toml", value_hint = ValueHint::FilePath)]
    study: PathBuf,
    /// Folder of the results, made if missing [default: beside the study, named as it is].
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    out: Option<PathBuf>,
    /// Run only the shards k with k mod n = i.
    #[arg(long, value_name = "I/N", default_value = "0/1", value_parser = part)]
    shard: (u64, u64),
    /// Threads; results do not depend on their number.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = crate::threads::count)]
    threads: usize,
    /// Join the shards as DIR/study.csv, in the order of the cases.
    #[arg(long)]
    csv: bool,
    /// No progress; errors and warnings still go to standard error.
    #[arg(long, short)]
    quiet: bool,
}

fn part(text: &str) -> Result<(u64, u64), String> {
    let parts =
        text.split_once('/').and_then(|(own, of)| Some((own.parse().ok()?, of.parse().ok()?)));
    match parts {
        Some((own, of)) if own < of => Ok((own, of)),
        _ => Err("two whole numbers I/N, I from 0 to N - 1".to_owned()),
    }
}

/// Runs a study and says how it went.
pub(crate) fn sweep(arguments: &SweepArguments) -> Exit {
    let mut sources = Sources::default();
    let study = match read_study(&arguments.study, &mut sources) {
        Ok(study) => study,
        Err(said) => {
            render::to_standard_error(&said, &sources);
            return Exit::Input;
        }
    };
    interrupt::listen();
    let options = SweepOptions {
        folder: arguments.out.clone().unwrap_or_else(|| beside(&arguments.study)),
        threads: arguments.threads,
        part: arguments.shard,
        csv: arguments.csv,
    };
    let (began, last) = (Instant::now(), Mutex::new(Instant::now()));
    let told = |done: u64, all: u64| {
        let Ok(mut last) = last.try_lock() else { return };
        if !arguments.quiet && last.elapsed() >= PAUSE {
            *last = Instant::now();
            screen::print(&line(done, all, began.elapsed()));
        }
    };
    match run(&study, &mut sources, &options, &told, &interrupt::asked) {
        Ok(outcome) => {
            render::to_standard_error(&outcome.said, &sources);
            if !arguments.quiet {
                screen::print(&summary(&study, &outcome, &options.folder));
            }
            if outcome.interrupted { Exit::Interrupted } else { Exit::Completed }
        }
        Err(Failure::Input(said)) => {
            render::to_standard_error(&said, &sources);
            Exit::Input
        }
        Err(Failure::Output(said)) => {
            render::to_standard_error([&*said], &sources);
            Exit::Output
        }
    }
}

/// The folder that has the name of the study, without its ending.
fn beside(study: &Path) -> PathBuf {
    match study.extension() {
        Some(_) => study.with_extension(""),
        None => study.with_extension("study"),
    }
}

/// How far a study is, how fast, and how long it still takes.
#[allow(clippy::cast_precision_loss)] // for people
fn line(done: u64, all: u64, taken: Duration) -> String {
    let rate = done as f64 / taken.as_secs_f64();
    let left = (all - done) as f64 / rate;
    format!("{done} of {all} cases, {rate:.0} a second, {left:.0} s left\n")
}

fn summary(study: &StudyFile, outcome: &Outcome, folder: &Path) -> String {
    let Outcome { done, failed, kept, .. } = outcome;
    let all = study.study.cases();
    let word = if outcome.interrupted { "interrupted" } else { "completed" };
    let files = outcome.csv.iter().chain(&outcome.indices);
    let files: String = files.map(|file| format!(", {}", file.display())).collect();
    format!(
        "study {word}: {done} cases run, {failed} of them failed, {kept} were there before, of {all}; \
         results in {}{files}\n",
        folder.display()
    )
}
