//! `slideline theory`: closed forms and exact references of the 1995 paper's
//! problems, as CSV.

use crate::exit::Exit;
use crate::screen;
use clap::{Args, ValueEnum};
use slideline::output::number::push_shortest;
use slideline_theory::{FirstProblem, Reference, SecondProblem, Stroke, TheoryError};

/// `slideline theory`.
#[derive(Args, Debug)]
pub(crate) struct TheoryArguments {
    /// Which problem.
    #[arg(value_name = "PROBLEM")]
    problem: Problem,
    /// Coefficient of friction.
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    mu: f64,
    /// Equal increments; a row is printed for each, and one for the start.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = increments)]
    increments: usize,
    /// An exact reference instead of the paper's linear theory [alone: reissner].
    #[arg(long, value_name = "MODEL", num_args = 0..=1, default_missing_value = "reissner")]
    exact: Option<Exact>,
    /// Area of the contact point of `--exact softened` [default: the interior
    /// slave node of the ISL deck].
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    area: Option<f64>,
    /// Another dimension than the paper's, in its units (m, N, rad), again and
    /// again if need be; `--set list` tells the names.
    #[arg(long = "set", value_name = "NAME=VALUE", allow_negative_numbers = true)]
    dimensions: Vec<String>,
    /// Which way the circle slides; rows of the return are at the positions
    /// of the push.
    #[arg(long, value_name = "WAY", default_value = "push")]
    stroke: Way,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Problem {
    /// A circle pushed along a cantilever; columns RF1, RF2, U2.
    #[value(name = "diehl-1")]
    First,
    /// A cam turned into a cantilever, with the project's dimensions; columns
    /// RM3, UR3.
    #[value(name = "diehl-2")]
    Second,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Exact {
    /// Large deflections, no shear, hard contact.
    Elastica,
    /// And shear and stretching.
    Reissner,
    /// And softened contact at one point.
    Softened,
    /// And pressure spread along the beam.
    Continuum,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Way {
    /// As the problem says.
    Push,
    /// Back again, friction reversed.
    Return,
}

fn increments(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(count @ 1..=1_000_000) => Ok(count),
        _ => Err("a whole number from 1 to 1000000".to_owned()),
    }
}

/// Prints the rows, or says why there are none.
pub(crate) fn theory(arguments: &TheoryArguments) -> Exit {
    if arguments.area.is_some() && arguments.exact != Some(Exact::Softened) {
        screen::error("error: --area belongs to --exact softened\n");
        return Exit::Usage;
    }
    let table = match arguments.problem {
        Problem::First => first_problem(arguments).map(|problem| first_table(arguments, &problem)),
        Problem::Second => {
            second_problem(arguments).map(|problem| second_table(arguments, &problem))
        }
    };
    match table {
        Ok(Ok(text)) => {
            screen::print(&text);
            Exit::Completed
        }
        Ok(Err(reason)) => {
            screen::error(&format!("error: no reference: {reason}\n"));
            Exit::Input
        }
        Err(wrong) => {
            screen::error(&format!("error: {wrong}\n"));
            Exit::Usage
        }
    }
}

fn first_problem(arguments: &TheoryArguments) -> Result<FirstProblem, String> {
    let mut problem = FirstProblem::diehl();
    let set = |name: &str, value| problem.dimension(name).map(|dimension| *dimension = value);
    set_dimensions(&arguments.dimensions, &FirstProblem::dimensions(), set)?;
    Ok(problem)
}

fn second_problem(arguments: &TheoryArguments) -> Result<SecondProblem, String> {
    let mut problem = SecondProblem::project();
    let set = |name: &str, value| problem.dimension(name).map(|dimension| *dimension = value);
    set_dimensions(&arguments.dimensions, &SecondProblem::dimensions(), set)?;
    Ok(problem)
}

/// Each `NAME=VALUE` to the dimension of that name.
fn set_dimensions(
    given: &[String],
    names: &[&str],
    mut set: impl FnMut(&str, f64) -> Option<()>,
) -> Result<(), String> {
    for text in given {
        let (name, value) = text.split_once('=').unwrap_or((text, ""));
        let unknown = || format!("--set {text}: the dimensions are {}", names.join(", "));
        if !names.contains(&name) {
            return Err(unknown());
        }
        let value: Option<f64> = value.trim().parse().ok().filter(|value: &f64| value.is_finite());
        let value = value.ok_or_else(|| format!("--set {text}: {name} needs a number"))?;
        set(name, value).ok_or_else(unknown)?;
    }
    Ok(())
}

fn stroke(arguments: &TheoryArguments) -> Stroke {
    match arguments.stroke {
        Way::Push => Stroke::Push,
        Way::Return => Stroke::Return,
    }
}

fn first_table(arguments: &TheoryArguments, problem: &FirstProblem) -> Result<String, TheoryError> {
    let reference = reference(arguments, problem.slave_area(4f64.to_radians()));
    let (mu, count) = (arguments.mu, arguments.increments);
    let rows = problem.stroke_rows(mu, count, reference, stroke(arguments))?;
    let values = |r: &slideline_theory::FirstRow| {
        vec![r.time, r.rf1, r.rf2, r.u2, length(r.contact_length), r.force]
    };
    let rows = rows.iter().map(|row| (row.increment, values(row)));
    Ok(csv("increment,time,RF1,RF2,U2,xi_L,F\n", rows))
}

fn second_table(
    arguments: &TheoryArguments,
    problem: &SecondProblem,
) -> Result<String, TheoryError> {
    let reference = reference(arguments, problem.slave_area(3f64.to_radians()));
    let (mu, count) = (arguments.mu, arguments.increments);
    let rows = problem.stroke_rows(mu, count, reference, stroke(arguments))?;
    let values = |r: &slideline_theory::SecondRow| {
        vec![r.time, r.rm3, r.ur3, length(r.contact_length), r.force]
    };
    let rows = rows.iter().map(|row| (row.increment, values(row)));
    Ok(csv("increment,time,RM3,UR3,xi_L,F\n", rows))
}

/// Without contact there is no contact length: `nan`, which reads back as a number.
fn length(found: Option<f64>) -> f64 {
    found.unwrap_or(f64::NAN)
}

fn reference(arguments: &TheoryArguments, default_area: f64) -> Reference {
    let area = arguments.area.unwrap_or(default_area);
    match arguments.exact {
        None => Reference::Linear,
        Some(Exact::Elastica) => Reference::Elastica,
        Some(Exact::Reissner) => Reference::Reissner,
        Some(Exact::Softened) => Reference::Softened { area },
        Some(Exact::Continuum) => Reference::Continuum,
    }
}

fn csv(header: &str, rows: impl Iterator<Item = (usize, Vec<f64>)>) -> String {
    let mut text = header.to_owned();
    for (increment, values) in rows {
        text.push_str(&increment.to_string());
        for value in values {
            text.push(',');
            push_number(&mut text, value);
        }
        text.push('\n');
    }
    text
}

fn push_number(text: &mut String, value: f64) {
    if value.is_nan() {
        text.push_str("nan");
    } else {
        push_shortest(text, value + 0.0); // no minus before a zero
    }
}
