//! All result files of a job, read back and held against one another.

use super::contact::{self, Contacts};
use super::frames::{self, Frames};
use super::iterations::{Attempt, attempts};
use crate::job::JobFiles;
use crate::json::{Members as _, Value};
use crate::reading::history::{Energies, History};
use crate::reading::problem::{self, Problem, unreadable};
use crate::reading::summary::{self, Driven, driven, loaded};
use crate::reading::table::Table;
use std::collections::HashMap;

/// What the files of a job say.
#[derive(Clone, Debug, Default)]
pub(crate) struct Results {
    /// `JOB.json`.
    pub summary: Value,
    /// What is driven.
    pub driven: Vec<Driven>,
    /// What is loaded: the first node, what all of them are called, column of its motion.
    pub loaded: Vec<(u64, String, String)>,
    /// Motions and reactions of driven and loaded nodes.
    pub history: History,
    /// Energies, times.
    pub energies: Energies,
    /// Points that touched.
    pub contacts: Contacts,
    /// Shapes.
    pub frames: Frames,
    /// How it converged.
    pub attempts: Vec<Attempt>,
    /// The model as it was understood.
    pub echo: String,
}

impl Results {
    /// Reads everything. With `unfinished` a job may still run; what it has
    /// written whole counts.
    ///
    /// # Errors
    /// A file that is missing, foreign or truncated; a job that still runs.
    pub fn read(job: &JobFiles, unfinished: bool) -> Result<Self, Problem> {
        let summary = summary::read(job, unfinished)?;
        let status = summary.text("status").unwrap_or_default();
        // those that stopped while they wrote have no complete files
        let lenient = matches!(status, "running" | "output_error" | "internal_error");
        let energies = Energies::read(&job.path(".energy.csv"))?;
        let count = energies.times.len();
        let expected = summary.count("increments").unwrap_or_default();
        if !lenient && count != expected {
            return Err(length_fault(job, ".energy.csv", count, expected));
        }
        let driven = driven(&summary);
        let loaded = loaded(&summary);
        let mut history = History::read(&job.path(".history.csv"), |node| {
            driven.iter().any(|d| d.nodes.contains(&node))
                || loaded.iter().any(|load| load.0 == node)
        })?;
        for node in &history.nodes {
            let length = node.values.first().map_or(0, Vec::len);
            if length < count || (!lenient && length != count) {
                return Err(length_fault(job, ".history.csv", length, count));
            }
        }
        history.shorten(count);
        let closed = closed_until(job, &energies.numbers, lenient)?;
        let contacts = contact::read(&job.path(".contact.csv"), &energies.numbers)?;
        // a pair that is removed has no rows any more
        let is_closed = |pair: &str, end: usize| closed.get(pair).is_none_or(|&last| last > end);
        let has_none = |(pair, &last): (&String, &usize)| last > 0 && !contacts.has_rows(pair);
        let without = closed.iter().any(has_none).then_some(0);
        let missing = without.or_else(|| contacts.missing_from(is_closed));
        if let Some(length) = missing.filter(|_| !lenient) {
            return Err(length_fault(job, ".contact.csv", length, count));
        }
        // earlier layouts have no number of states: one for each increment
        let expected = summary.count("states").unwrap_or(count + 1);
        let written = frames::written(job, count, (!lenient).then_some(expected))?;
        // forces can be drawn where contact has numbers
        let drawable = |state: usize| state == 0 || contacts.has_numbers(state - 1);
        let frames = Frames::read(job, written, drawable)?;
        let attempts = attempts(&problem::text(&job.path(".msg"))?);
        let echo = echo(job, lenient)?;
        Ok(Self { summary, driven, loaded, history, energies, contacts, frames, attempts, echo })
    }
}

fn length_fault(job: &JobFiles, ending: &str, found: usize, expected: usize) -> Problem {
    let what = if found < expected { "it is truncated" } else { "it belongs to another run" };
    unreadable(&job.path(ending), format!("{what}: {found} increments instead of {expected}"))
}

/// In how many increments, from the first one on, each pair is closed at the last.
///
/// Holds `JOB.pair.csv` against the increments: the same pairs in each. A file that was cut is not
/// passed over.
fn closed_until(
    job: &JobFiles,
    increments: &[[usize; 2]],
    lenient: bool,
) -> Result<HashMap<String, usize>, Problem> {
    let path = job.path(".pair.csv");
    let mut table = match Table::open(&path, &["step", "increment", "time", "pair"]) {
        // earlier versions did not write it
        Err(Problem::Missing(_)) => return Ok(HashMap::new()),
        other => other?,
    };
    let mut rows: Vec<usize> = Vec::new();
    let (mut last, mut closed) = (None, HashMap::new());
    let column = table.index("closed");
    while table.row()?.is_some() {
        let now = Some((table.number::<usize>(0)?, table.number::<usize>(1)?));
        if now != last {
            rows.push(0);
            last = now;
        }
        if let Some(count) = rows.last_mut() {
            *count += 1;
        }
        if column.is_some_and(|own| table.cell(own) != "0") {
            closed.insert(table.cell(3).to_owned(), rows.len());
        } else {
            closed.entry(table.cell(3).to_owned()).or_default();
        }
    }
    if lenient {
        return Ok(closed);
    }
    if table.is_cut() {
        return Err(unreadable(&path, "it is truncated: it ends within a line"));
    }
    let pairs = rows.first().copied().unwrap_or_default();
    if pairs > 0 && rows.len() != increments.len() {
        return Err(length_fault(job, ".pair.csv", rows.len(), increments.len()));
    }
    match rows.last() {
        Some(&count) if count != pairs => Err(unreadable(
            &path,
            format!("it is truncated: its last increment has {count} pairs instead of {pairs}"),
        )),
        _ => Ok(closed),
    }
}

/// The opening of `JOB.dat`, without its tables.
fn echo(job: &JobFiles, lenient: bool) -> Result<String, Problem> {
    let text = match problem::text(&job.path(".dat")) {
        Err(Problem::Missing(_)) if lenient => return Ok(String::new()),
        other => other?,
    };
    let is_table = |line: &str| {
        let rest = line.strip_prefix("STEP ");
        let own = rest
            .is_some_and(|rest| rest.contains("  INCREMENT ") && rest.contains("  TOTAL TIME "));
        own || line.contains("for set ") && line.contains(" and time ")
    };
    let lines: Vec<&str> = text.lines().take_while(|line| !is_table(line)).collect();
    Ok(lines.join("\n").trim_end().to_owned())
}
