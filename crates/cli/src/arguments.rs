//! What may stand on the command line.

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};
use slideline::{Dialect, OldJob, Onset};
use std::ffi::OsString;
use std::path::PathBuf;

/// Sliding contact of flexible and rigid bodies: runs Abaqus-style decks.
#[derive(Debug, Parser)]
#[command(name = "slideline", version, arg_required_else_help = true)]
#[command(
    after_help = "Exit codes: 0 completed, 1 input error, 2 not converged, 3 internal error, \
    4 results could not be written, 64 wrong command line, 130 interrupted."
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run every step of a deck and write the result files.
    Run(RunArguments),
    /// Read, check and explain a deck without solving it.
    Check(CheckArguments),
    /// Run one deck with many values of its parameters.
    Sweep(crate::sweep::SweepArguments),
    /// Answer one question of Dakota: a driver for its fork interface.
    Dakota(crate::dakota::DakotaArguments),
    /// Write a commented deck with parameters, to begin with.
    New(crate::new::NewArguments),
    /// Open a deck in the browser: sliders, and a curve that follows them.
    Workbench(crate::workbench::WorkbenchArguments),
    /// Turn a mesh of gmsh into a deck.
    Import(crate::import::ImportArguments),
    /// Repeat the 1995 study: models, theory, figures, error table, one page.
    Reproduce(crate::reproduce::ReproduceArguments),
    /// Print closed-form and exact reference solutions as CSV.
    Theory(crate::theory::TheoryArguments),
    /// Make JOB.html from the result files of a job.
    Report(crate::report::ReportArguments),
    /// Draw a curve of a job, or of two jobs with their difference.
    Plot(crate::plot::PlotArguments),
    /// Explain a diagnostic code or a deck keyword, or list them all.
    Explain {
        /// A code such as SL0601, or a keyword such as "SLIDE LINE" [default: a list of all].
        #[arg(value_name = "CODE|KEYWORD")]
        name: Vec<String>,
    },
    /// Write the documentation as pages that need no network.
    Docs(crate::docs::DocsArguments),
    /// Behave as ccx, the solver of CalculiX, for programs that start one.
    Ccx {
        /// As for ccx: -i JOB, JOB or -v.
        #[arg(value_name = "ARGUMENTS", trailing_var_arg = true, allow_hyphen_values = true)]
        arguments: Vec<OsString>,
    },
    /// Print completions for a shell.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
}

/// `slideline run`.
#[derive(Args, Debug)]
pub(crate) struct RunArguments {
    #[command(flatten)]
    pub deck: DeckArguments,
    /// Folder of the result files, made if missing [default: beside the deck].
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub out: Option<PathBuf>,
    /// Threads; results do not depend on their number.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = crate::threads::count)]
    pub threads: usize,
    /// Machine-readable progress: one JSON object a line on standard output.
    #[arg(long)]
    pub json: bool,
    /// No progress; errors and warnings still go to standard error.
    #[arg(long, short)]
    pub quiet: bool,
    /// Compare the tangent of every converged increment, or of that one in each
    /// step, with finite differences of the residual.
    #[arg(long, value_name = "INCREMENT", num_args = 0..=1, require_equals = true)]
    pub check_tangent: Option<Option<usize>>,
    /// Continue from JOB.rst, which a deck with *RESTART, WRITE writes.
    #[arg(long)]
    pub restart: bool,
    /// Estimate the discretisation error of every reaction, by running the same
    /// model on meshes of half and a quarter of the width.
    #[arg(long)]
    pub error_bars: bool,
    /// Write JOB.sensitivity.csv: the derivatives of all histories by the numbers that
    /// *PARAMETER names.
    #[arg(long, conflicts_with = "restart")]
    pub sensitivities: bool,
    /// Write the report JOB.html (the default).
    #[arg(long, overrides_with = "no_html")]
    pub html: bool,
    /// Do not write the report.
    #[arg(long, overrides_with = "html")]
    pub no_html: bool,
}

/// `slideline check`.
#[derive(Args, Debug)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub deck: DeckArguments,
    /// One JSON object a line on standard output.
    #[arg(long)]
    pub json: bool,
    /// Write JOB.fixed.inp beside the deck, with every suggested card that was
    /// tried and helps.
    #[arg(long)]
    pub fix: bool,
    /// Draw the undeformed model with outward normals and gaps, and rubber
    /// with its test data; the file ends in .svg, .html or .png.
    #[arg(long, value_name = "FILE", value_parser = picture, value_hint = ValueHint::FilePath)]
    pub picture: Option<PathBuf>,
}

/// A file whose ending says how a model is drawn.
fn picture(text: &str) -> Result<PathBuf, String> {
    let known = [".svg", ".html", ".png"].iter().any(|ending| text.ends_with(ending));
    if known { Ok(text.into()) } else { Err("it must end in .svg, .html or .png".to_owned()) }
}

/// The deck and what overrides it.
#[derive(Args, Debug)]
pub(crate) struct DeckArguments {
    /// The deck; the ending .inp may be left out.
    #[arg(value_name = "JOB", value_hint = ValueHint::FilePath)]
    pub job: PathBuf,
    /// When friction acts after a change of contact [default: as the deck says].
    #[arg(long, value_name = "RULE")]
    friction_onset: Option<OnsetArgument>,
    /// The previous job, for a deck with *RESTART, READ: its states are in
    /// OLDJOB.rst.
    #[arg(long, value_name = "OLDJOB", value_hint = ValueHint::FilePath)]
    oldjob: Option<PathBuf>,
    /// A value for a parameter that the deck defines by *PARAMETER, in place
    /// of its first value there; may be given for several parameters. `run`
    /// takes lists, NAME=A,B: all values with all others, a table, a plot.
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    set: Vec<(String, String)>,
    /// Which program's meaning applies where two differ [default: abaqus].
    #[arg(long, value_name = "PROGRAM")]
    dialect: Option<DialectArgument>,
}

impl DeckArguments {
    /// As the library takes them.
    pub fn options(&self) -> slideline::ReadOptions {
        slideline::ReadOptions {
            dialect: self.dialect.map(|dialect| match dialect {
                DialectArgument::Abaqus => Dialect::Abaqus,
                DialectArgument::Calculix => Dialect::Calculix,
            }),
            friction_onset: self.friction_onset.map(|onset| match onset {
                OnsetArgument::Immediate => Onset::Immediate,
                OnsetArgument::Delayed => Onset::Delayed,
                OnsetArgument::Matfru => Onset::Matfru,
            }),
            parameters: self.set.clone(),
            old_job: self.oldjob.clone().map_or(OldJob::None, OldJob::Named),
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum OnsetArgument {
    /// Whenever a point is closed.
    Immediate,
    /// Not in the increment in which a point closes.
    Delayed,
    /// The logic of subroutine MATFRU in 1995.
    Matfru,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum DialectArgument {
    /// Abaqus/Standard.
    Abaqus,
    /// CalculiX.
    Calculix,
}

fn setting(text: &str) -> Result<(String, String), String> {
    match text.split_once('=').map(|(name, value)| (name.trim(), value.trim())) {
        Some((name, value)) if !name.is_empty() && !value.is_empty() => {
            Ok((name.to_owned(), value.to_owned()))
        }
        _ => Err("a parameter is set by NAME=VALUE".to_owned()),
    }
}
