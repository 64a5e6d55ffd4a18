//! The command line of slideline.
//!
//! ```text
//!   slideline run | check | sweep | dakota | report | plot | reproduce | theory | explain | docs |
//!   completions | new | workbench | import | ccx
//!        |
//!   standard output: progress or JSON      standard error: what is to be said
//! ```

mod arguments;
mod ccx;
mod check;
mod dakota;
mod docs;
mod exit;
mod explain;
mod fresh_file;
mod import;
mod interrupt;
mod live;
mod new;
mod plot;
mod progress;
mod render;
mod report;
mod reproduce;
mod run;
mod screen;
mod several;
mod sweep;
mod theory;
mod threads;
mod workbench;

use arguments::{Arguments, Command};
use clap::{CommandFactory as _, Parser as _};
use exit::Exit;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

fn main() -> ExitCode {
    interrupt::outlive_file_limits();
    std::panic::set_hook(Box::new(|fault| screen::error(&internal_error(&fault.to_string()))));
    catch_unwind(AssertUnwindSafe(command)).unwrap_or(Exit::Internal).into()
}

/// What a fault of ours says; nothing about it is the user's.
fn internal_error(fault: &str) -> String {
    format!(
        "error[SL0901]: internal error: {}\n  = help: this is a fault of slideline {}, not of \
         the deck; please report it together with the deck\n",
        fault.replace('\n', ": "),
        slideline::VERSION
    )
}

fn command() -> Exit {
    let mut words = std::env::args_os();
    if words.next().is_some_and(|program| ccx::is_name(&program)) {
        return ccx::ccx(&words.collect::<Vec<_>>());
    }
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(answer) => return usage(&answer),
    };
    match arguments.command {
        Command::Run(arguments) => several::run(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Dakota(arguments) => dakota::dakota(&arguments),
        Command::Reproduce(arguments) => reproduce::reproduce(&arguments),
        Command::Theory(arguments) => theory::theory(&arguments),
        Command::Report(arguments) => report::report(&arguments),
        Command::Plot(arguments) => plot::plot(&arguments),
        Command::Explain { name } => explain::explain(&name.join(" ")),
        Command::Import(arguments) => import::import(&arguments),
        Command::New(arguments) => new::new(&arguments),
        Command::Workbench(arguments) => workbench::workbench(&arguments),
        Command::Ccx { arguments } => ccx::ccx(&arguments),
        Command::Docs(arguments) => docs::docs(&arguments),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "slideline", &mut script);
            screen::print(&String::from_utf8_lossy(&script));
            Exit::Completed
        }
    }
}

/// `--help` and `--version` were asked for; everything else is a wrong
/// command line.
fn usage(answer: &clap::Error) -> Exit {
    let _ = answer.print(); // a closed stream has nobody to be told
    match answer.kind() {
        clap::error::ErrorKind::DisplayHelp | clap::error::ErrorKind::DisplayVersion => {
            Exit::Completed
        }
        _ => Exit::Usage,
    }
}
