//! `slideline reproduce`: the whole 1995 study.

use crate::exit::Exit;
use crate::screen;
use clap::{Args, ValueHint};
use slideline_reproduce::{Failure, Progress, Report, reproduce as make};
use std::path::PathBuf;
use std::time::Instant;

/// `slideline reproduce`.
#[derive(Args, Debug)]
pub(crate) struct ReproduceArguments {
    /// Folder of figures, tables and page, made if missing.
    #[arg(long, value_name = "DIR", default_value = "diehl1995", value_hint = ValueHint::DirPath)]
    out: PathBuf,
    /// No progress.
    #[arg(long, short)]
    quiet: bool,
}

/// Makes the study and says where it lies.
pub(crate) fn reproduce(arguments: &ReproduceArguments) -> Exit {
    let began = Instant::now();
    let tell = |piece: &Progress| {
        if !arguments.quiet {
            let width = piece.total.to_string().len();
            let Progress { done, total, what } = piece;
            screen::print(&format!("[{done:>width$}/{total}] {what}\n"));
        }
    };
    match make(&arguments.out, &tell) {
        Ok(report) => {
            if !arguments.quiet {
                screen::print(&summary(arguments, &report, began.elapsed().as_secs_f64()));
            }
            Exit::Completed
        }
        Err(failure) => {
            screen::error(&format!("error: {failure}\n"));
            match failure {
                Failure::Run { .. } => Exit::NotConverged,
                Failure::Write { .. } => Exit::Output,
                Failure::Theory(_) | Failure::Figure(_) => Exit::Internal,
            }
        }
    }
}

fn summary(arguments: &ReproduceArguments, report: &Report, seconds: f64) -> String {
    let runs = report.rows.len();
    let page = arguments.out.join("diehl1995.html");
    format!(
        "{runs} runs, {} files in {seconds:.1} s; begin with {}\n",
        report.files.len(),
        page.display()
    )
}
