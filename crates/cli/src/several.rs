//! `slideline run --set NAME=A,B`: a deck with several values, one table and one plot.
//!
//! ```text
//!   --set mu=0.1,0.2 --set t=1,2  -->  JOB-1, JOB-2, JOB-3, JOB-4  -->  JOB.study.csv, JOB.study.svg
//! ```

use crate::arguments::RunArguments;
use crate::exit::Exit;
use crate::progress::Mode;
use crate::run::{mode, read_options, run_read};
use crate::{interrupt, render, screen};
use slideline::diag::{Code, Diagnostic};
use slideline::output::number::push_shortest;
use slideline::output::plot::{Curve, Question, curve, curves};
use slideline::output::{JobFiles, KEY_FIGURES, KeyFigures, WriteError, key_figures, write_file};
use slideline::{Job, ReadOptions, Status};

/// Most runs with files; a study keeps a row of each instead.
const MOST: usize = 1000;

/// Names and values of a run.
type Values = Vec<(String, String)>;

/// Runs a deck, with all values that its parameters are given.
pub(crate) fn run(arguments: &RunArguments) -> Exit {
    let options = read_options(arguments);
    match grid(&options.parameters) {
        Some(cases) => run_all(arguments, cases),
        None => run_read(Job::read(&arguments.deck.job, &options), arguments).status.into(),
    }
}

/// The values of every run; `None` where no setting has more than one. The last setting changes
/// first.
fn grid(settings: &[(String, String)]) -> Option<Vec<Values>> {
    let lists: Vec<Vec<&str>> = settings.iter().map(|(_, values)| split(values)).collect();
    if lists.iter().all(|list| list.len() == 1) {
        return None;
    }
    let mut all: Vec<Values> = vec![Vec::new()];
    for ((name, _), list) in settings.iter().zip(&lists) {
        let with = |earlier: &Values| {
            let earlier = earlier.clone();
            list.iter().map(move |&value| {
                let mut own = earlier.clone();
                own.push((name.clone(), value.to_owned()));
                own
            })
        };
        all = all.iter().flat_map(with).take(MOST + 1).collect();
    }
    Some(all)
}

/// Parts between commas that stand in no brackets and no quotation marks.
fn split(values: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut begin) = (0_usize, false, 0);
    let mut parts = Vec::new();
    for (at, letter) in values.char_indices() {
        match letter {
            '\'' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth = depth.saturating_sub(1),
            ',' if !quoted && depth == 0 => {
                parts.push(values[begin..at].trim());
                begin = at + 1;
            }
            _ => {}
        }
    }
    parts.push(values[begin..].trim());
    parts
}

/// A run that is over.
struct Done {
    job: JobFiles,
    values: Values,
    figures: KeyFigures,
}

/// Runs a deck with all values, one after the other.
fn run_all(arguments: &RunArguments, cases: Vec<Values>) -> Exit {
    if let Some(said) = refused(arguments, &cases) {
        render::to_standard_error([&said], &slideline::diag::Sources::default());
        return Exit::Input;
    }
    let is_heard = !matches!(mode(arguments), Mode::Silent | Mode::Json);
    let (mut worst, mut done) = (Exit::Completed, Vec::new());
    let together = Job::named(&arguments.deck.job).files(arguments.out.as_deref());
    for (place, values) in cases.into_iter().enumerate() {
        let options = ReadOptions { parameters: values.clone(), ..read_options(arguments) };
        let mut read = Job::read(&arguments.deck.job, &options);
        read.job.stem.push(format!("-{}", place + 1));
        if is_heard {
            screen::print(&format!("{}: {}\n", read.job.stem.display(), words(&values)));
        }
        let outcome = run_read(read, arguments);
        let stopped = outcome.status == Status::Interrupted || interrupt::asked();
        let exit = Exit::from(outcome.status);
        worst = if (exit as usize) > worst as usize { exit } else { worst };
        let figures = key_figures(&outcome.files).unwrap_or_default();
        done.push(Done { job: outcome.files, values, figures });
        if stopped {
            break;
        }
    }
    match write(&together, &done) {
        Ok(files) => {
            if is_heard {
                screen::print(&(table(&done) + &files));
            }
            worst
        }
        Err(error) => {
            let said =
                Diagnostic::error(Code("SL0702"), format!("results could not be written: {error}"));
            let said = said.help("Free disk space or choose another folder with --out.");
            render::to_standard_error([&said], &slideline::diag::Sources::default());
            Exit::Output
        }
    }
}

/// Why these runs cannot be.
fn refused(arguments: &RunArguments, cases: &[Values]) -> Option<Diagnostic> {
    let (message, help) = if cases.len() > MOST {
        (
            format!("--set asks for more than {MOST} runs, each with its files"),
            "Write a study, which keeps one row a case: slideline explain SL0803.",
        )
    } else if arguments.restart {
        (
            "--restart continues one run, but --set has several values".to_owned(),
            "Run the values again without --restart, or continue the deck with one value of each.",
        )
    } else {
        return None;
    };
    Some(Diagnostic::error(Code("SL0803"), message).help(help))
}

fn words(values: &Values) -> String {
    let words: Vec<String> =
        values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    words.join(", ")
}

/// Writes table and plot; the line that names them.
fn write(job: &JobFiles, done: &[Done]) -> Result<String, WriteError> {
    let path = job.path(".study.csv");
    write_file(&path, csv(done).as_bytes())?;
    let mut files = path.display().to_string();
    if let Some((question, curves_of_all)) = shown(done) {
        let path = job.path(".study.svg");
        write_file(&path, curves(&question, &curves_of_all).svg().as_bytes())?;
        files.push_str(&format!(", {}", path.display()));
    }
    Ok(format!("{} runs in {files}\n", done.len()))
}

/// Reaction against motion of what is driven, a curve a run.
fn shown(done: &[Done]) -> Option<(Question, Vec<Curve>)> {
    let (node, motion, reaction) = done.iter().find_map(|own| own.figures.driven.clone())?;
    let question = Question { x: motion, y: reaction, node: Some(node), unfinished: true };
    let named = |own: &Done| {
        let found = curve(&own.job, &question).ok()?;
        Some(Curve { name: words(&own.values), ..found })
    };
    let all: Vec<Curve> = done.iter().filter_map(named).collect();
    (!all.is_empty()).then_some((question, all))
}

/// Columns of the table: the job, the parameters, how it ended, its numbers.
fn columns(done: &[Done]) -> Vec<String> {
    let names = done.first().into_iter().flat_map(|own| &own.values).map(|(name, _)| name.as_str());
    let names = std::iter::once("job").chain(names).chain(["status", "verdict"]);
    names.chain(KEY_FIGURES).map(str::to_owned).collect()
}

fn cells(own: &Done, number: impl Fn(f64) -> String) -> Vec<String> {
    let values = own.values.iter().map(|(_, value)| value.clone());
    let words = [own.figures.status.clone(), own.figures.verdict.clone()];
    let numbers = own.figures.values.iter().map(|value| value.map_or_else(String::new, &number));
    std::iter::once(own.job.name()).chain(values).chain(words).chain(numbers).collect()
}

fn csv(done: &[Done]) -> String {
    let shortest = |value| {
        let mut text = String::new();
        push_shortest(&mut text, value);
        text
    };
    let quoted = |cell: String| match cell.contains([',', '"', '\n']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell,
    };
    let line = |cells: Vec<String>| {
        let cells: Vec<String> = cells.into_iter().map(quoted).collect();
        cells.join(",") + "\n"
    };
    std::iter::once(columns(done))
        .chain(done.iter().map(|own| cells(own, shortest)))
        .map(line)
        .collect()
}

/// The table for people: columns of one width, without those that are empty.
fn table(done: &[Done]) -> String {
    let short = |value: f64| format!("{value:.4e}");
    let rows: Vec<Vec<String>> =
        std::iter::once(columns(done)).chain(done.iter().map(|own| cells(own, short))).collect();
    let count = rows.first().map_or(0, Vec::len);
    let is_used = |&column: &usize| rows.iter().skip(1).any(|row| !row[column].is_empty());
    let used: Vec<usize> = (0..count).filter(is_used).collect();
    let width =
        |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..count).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells: Vec<String> =
            used.iter().map(|&at| format!("{:>width$}", row[at], width = widths[at])).collect();
        cells.join("  ") + "\n"
    };
    rows.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(all: &[(&str, &str)]) -> Vec<(String, String)> {
        all.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
    }

    #[test]
    fn values_are_parted_by_commas_outside_brackets_and_quotation_marks() {
        assert_eq!(split("0.1, 0.2"), ["0.1", "0.2"]);
        assert_eq!(split("max(1,2),3"), ["max(1,2)", "3"]);
        assert_eq!(split("'a,b'"), ["'a,b'"]);
        assert_eq!(split("1,"), ["1", ""]);
        assert_eq!(grid(&set(&[("mu", "0.1"), ("f", "max(1,2)")])), None);
    }

    #[test]
    fn settings_make_a_grid() {
        let found = grid(&set(&[("a", "1,2"), ("b", "5"), ("c", "6,7")])).unwrap();
        let lines: Vec<String> = found.iter().map(words).collect();
        let expected = [("1", "6"), ("1", "7"), ("2", "6"), ("2", "7")];
        let expected = expected.map(|(a, c)| format!("a = {a}, b = 5, c = {c}"));
        assert_eq!(lines, expected);
        let list = "1,".repeat(40) + "1";
        assert_eq!(grid(&set(&[("a", &list), ("b", &list)])).unwrap().len(), MOST + 1);
    }
}
