//! `slideline plot`: a curve of a job as a figure or as numbers.

use crate::exit::Exit;
use crate::report::{named, refused, warn_of_change};
use crate::screen;
use clap::{Args, ValueHint};
use slideline::output::plot::{Curve, Question, csv, curve, difference, figure};
use slideline::output::report::Problem;
use slideline::output::write_file;
use std::path::PathBuf;

/// `slideline plot`.
#[derive(Args, Debug)]
pub(crate) struct PlotArguments {
    /// The job: its deck, or any of its result files without the ending.
    #[arg(value_name = "JOB", value_hint = ValueHint::FilePath)]
    job: PathBuf,
    /// Folder of the result files [default: that of JOB].
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    dir: Option<PathBuf>,
    /// Along the horizontal axis: U2, RF2, time, increment, external_work ...
    #[arg(long, value_name = "COLUMN")]
    x: String,
    /// Along the vertical axis.
    #[arg(long, value_name = "COLUMN")]
    y: String,
    /// The node [default: the driven one, if there is one].
    #[arg(long)]
    node: Option<u64>,
    /// A second job, laid over the first, with the difference at equal times.
    #[arg(long, value_name = "OTHER", value_hint = ValueHint::FilePath)]
    compare: Option<PathBuf>,
    /// The figure, ending in .svg, .png or .csv [default: CSV on standard output].
    #[arg(long, short, value_name = "FILE", value_parser = answer, value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,
    /// Show a job that is running, or was killed, as far as it came.
    #[arg(long)]
    unfinished: bool,
}

/// A file whose ending says what is wanted.
fn answer(text: &str) -> Result<PathBuf, String> {
    let known = [".svg", ".png", ".csv"].iter().any(|ending| text.ends_with(ending));
    if known { Ok(text.into()) } else { Err("it must end in .svg, .png or .csv".to_owned()) }
}

/// Draws it.
pub(crate) fn plot(arguments: &PlotArguments) -> Exit {
    match drawn(arguments) {
        Ok(said) => {
            screen::print(&said);
            Exit::Completed
        }
        Err(problem) => refused(&problem),
    }
}

fn drawn(arguments: &PlotArguments) -> Result<String, Problem> {
    let question = Question {
        x: arguments.x.clone(),
        y: arguments.y.clone(),
        node: arguments.node,
        unfinished: arguments.unfinished,
    };
    let (job, files) = named(&arguments.job, arguments.dir.as_deref());
    let mut one = curve(&files, &question)?;
    warn_of_change(&job, &files);
    let mut other = None;
    if let Some(path) = &arguments.compare {
        let (job, files) = named(path, None);
        let mut second = curve(&files, &question)?;
        warn_of_change(&job, &files);
        if second.name == one.name {
            // two runs of one deck in two folders: the folders tell them apart
            one.name = arguments.job.display().to_string();
            second.name = path.display().to_string();
        }
        other = Some(second);
    }
    let Some(output) = &arguments.output else {
        return Ok(csv(&question, &one, other.as_ref()));
    };
    let figure = figure(&question, &one, other.as_ref());
    let content = match output.extension().and_then(|ending| ending.to_str()) {
        Some("svg") => figure.svg().into_bytes(),
        Some("png") => figure
            .png(192.0)
            .ok_or_else(|| Problem::Question("the figure cannot be encoded".to_owned()))?,
        _ => csv(&question, &one, other.as_ref()).into_bytes(),
    };
    write_file(output, &content)?;
    Ok(format!("{}{}\n", output.display(), largest(&one, other.as_ref())))
}

/// The largest difference in words.
fn largest(one: &Curve, other: Option<&Curve>) -> String {
    let Some(other) = other else { return String::new() };
    let values = difference(one, other);
    let compared = values.iter().filter(|value| value.is_finite()).count();
    let largest = values.iter().filter(|v| v.is_finite()).fold(0.0, |m: f64, v| m.max(v.abs()));
    format!(": largest difference {largest:e} at {compared} equal times")
}
