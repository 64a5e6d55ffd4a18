//! `slideline report`: JOB.html from the result files.

use crate::exit::Exit;
use crate::{render, screen};
use clap::{Args, ValueHint};
use slideline::diag::{Code, Diagnostic, Sources};
use slideline::output::report::{CHANGED, Options, Problem, deck_hash as ran_deck_hash, write};
use slideline::output::{JobFiles, without_ending};
use slideline::{Job, Outcome, ReadOptions, Status};
use slideline_workbench::markdown::fragment;
use std::path::{Path, PathBuf};

/// `slideline report`.
#[derive(Args, Debug)]
pub(crate) struct ReportArguments {
    /// The job: its deck, or any of its result files without the ending.
    #[arg(value_name = "JOB", value_hint = ValueHint::FilePath)]
    pub job: PathBuf,
    /// Folder of the result files [default: that of JOB].
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// A second curve: the columns of `slideline theory`, or a history.csv.
    #[arg(long, value_name = "CSV", value_hint = ValueHint::FilePath)]
    pub overlay: Option<PathBuf>,
    /// Show a job that is running, or was killed, as far as it came.
    #[arg(long)]
    pub unfinished: bool,
}

/// Makes the report and says the verdict.
pub(crate) fn report(arguments: &ReportArguments) -> Exit {
    let (job, files) = named(&arguments.job, arguments.out.as_deref());
    let now = deck_hash(&job);
    let options = Options {
        overlay: arguments.overlay.as_deref(),
        unfinished: arguments.unfinished,
        deck_hash: now.as_deref(),
        page: page_of,
    };
    match write(&files, &options) {
        Ok(report) => {
            if report.deck_changed {
                tell(&Diagnostic::warning(Code("SL0706"), CHANGED));
            }
            screen::print(&format!("{}\n{}\n", report.verdict.join(". "), report.path.display()));
            Exit::Completed
        }
        Err(problem) => refused(&problem),
    }
}

/// The page of a code as a part of the report.
fn page_of(code: &str) -> Option<String> {
    slideline::code_page(code).map(fragment)
}

/// The job that a user means by a deck or by a result file, and its files.
pub(crate) fn named(path: &Path, folder: Option<&Path>) -> (Job, JobFiles) {
    let stripped = path.to_str().and_then(without_ending);
    let job = Job::named(stripped.map_or(path, Path::new));
    let files = job.files(folder);
    (job, files)
}

/// Says so where the deck is another one than the job ran.
pub(crate) fn warn_of_change(job: &Job, files: &JobFiles) {
    if let (Some(ran), Some(now)) = (ran_deck_hash(files), deck_hash(job))
        && ran != now
    {
        tell(&Diagnostic::warning(Code("SL0706"), CHANGED));
    }
}

/// Hash of the deck as it is now; `None` where it is not to be found.
fn deck_hash(job: &Job) -> Option<String> {
    let there = job.deck.is_file();
    there.then(|| Job::read(&job.deck, &ReadOptions::default()).deck_hash)
}

/// Says why there is no answer; nothing was overwritten.
pub(crate) fn refused(problem: &Problem) -> Exit {
    let (code, help, exit) = match problem {
        Problem::Missing(_) => (
            "SL0704",
            "Run the job first (slideline run JOB), or name the folder of its results with --out.",
            Exit::Input,
        ),
        Problem::Unreadable { .. } => (
            "SL0704",
            "Run the job again: results must be complete and written by this version of the \
             program.",
            Exit::Input,
        ),
        Problem::Running(_) => {
            ("SL0705", "Wait for its end; --unfinished shows the increments so far.", Exit::Input)
        }
        Problem::Killed(_) => (
            "SL0705",
            "--unfinished shows the increments so far; a deck with *RESTART, WRITE can be \
             continued (slideline run JOB --restart).",
            Exit::Input,
        ),
        Problem::NothingSolved(_) => {
            ("SL0704", "Correct the deck (slideline check JOB) and run it.", Exit::Input)
        }
        Problem::Question(_) => {
            ("SL0704", "Choose columns and nodes that the history has.", Exit::Input)
        }
        Problem::Write(_) => {
            ("SL0702", "Free disk space, or write to another folder.", Exit::Output)
        }
    };
    tell(&Diagnostic::error(Code(code), problem.to_string()).help(help));
    exit
}

fn tell(said: &Diagnostic) {
    render::to_standard_error([said], &Sources::default());
}

/// The report that ends a run. A run whose other results are there but whose
/// report could not be written says so like any other missing result.
pub(crate) fn after_run(outcome: &mut Outcome) {
    if outcome.status == Status::InputError || outcome.output_failure.is_some() {
        return;
    }
    let options = Options { page: page_of, ..Options::default() };
    if let Err(problem) = write(&outcome.files, &options) {
        outcome.output_failure = Some(problem.to_string());
        if outcome.status == Status::Completed {
            outcome.status = Status::OutputError;
        }
    }
}
