//! Runs models of the classes, files and all, and judges what they left.

pub use super::label::Label;

use super::classes::{Case, Class};
use super::files::{self, Files};
use super::{passing, physics};
use slideline::observe::{Event, Observer, Stop};
use slideline::{Job, ReadOptions, RunOptions, run};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

/// Share of the energy whose absence must shrink with the increments [1].
const NOTABLE: f64 = 0.05;

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// All steps.
    Completed,
    /// A diagnosis: code and message.
    Diagnosed(String, String),
    /// The time was up.
    TimeUp,
    /// It cannot be read, or left no files: what was said.
    Unreadable(String),
    /// It panicked.
    Panic,
}

/// What came of a model.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Its ending.
    pub ending: Ending,
    /// What a completed run breaks: kind and where.
    pub violations: Vec<(&'static str, String)>,
    /// Time taken.
    pub seconds: f64,
    /// Converged increments, iterations.
    pub work: [usize; 2],
}

/// Stops a run when its time is up.
struct Clock {
    end: Instant,
    stopped: bool,
    work: [usize; 2],
}

impl Observer for Clock {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(_) => self.work[0] += 1,
            Event::Iteration(_) => self.work[1] += 1,
            _ => {}
        }
        if Instant::now() > self.end {
            self.stopped = true;
            return ControlFlow::Break(Stop::Interrupted);
        }
        ControlFlow::Continue(())
    }
}

/// Runs a model in a folder and judges its files.
pub fn attempt(case: &Case, folder: &Path, limit: Duration) -> Verdict {
    let (mut verdict, files) = once(case, folder, limit);
    let completed = verdict.ending == Ending::Completed;
    if case.class == "units" {
        let natural = Case { placed: case.placed.unscaled(), ..case.clone() };
        let other = once(&natural, folder, limit).0;
        if (other.ending == Ending::Completed) != completed {
            let why = format!("completed {completed}, in natural units {:?}", other.ending);
            verdict.violations.push(("units", why));
        } else if completed && other.work != verdict.work {
            let why = format!("work {:?}, in natural units {:?}", verdict.work, other.work);
            verdict.violations.push(("units", why));
        }
    }
    if let (true, Some(files)) = (completed, files)
        && (case.draft.reversible || physics::missing(&files) > NOTABLE)
    {
        let finer = Case { draft: case.draft.finer(), ..case.clone() };
        let fine = once(&finer, folder, limit).1;
        verdict.violations.extend(fine.and_then(|fine| held_against(case, &files, &fine)));
    }
    verdict
}

/// A run of the job "model", before its files are read.
#[derive(Debug)]
pub struct Ran {
    /// What was said; none after a panic.
    said: Option<Vec<String>>,
    stopped: bool,
    seconds: f64,
    work: [usize; 2],
}

impl Ran {
    /// Its ending, with status and diagnosis of its files where there are.
    pub fn verdict(self, told: Option<(&str, Option<(String, String)>)>) -> Verdict {
        let ending = match (self.said, told) {
            (None, _) => Ending::Panic,
            _ if self.stopped => Ending::TimeUp,
            (Some(said), None) => Ending::Unreadable(said.concat()),
            (_, Some(("completed", _))) => Ending::Completed,
            (_, Some((_, diagnosis))) => {
                let (code, why) = diagnosis.unwrap_or_default();
                Ending::Diagnosed(code, why)
            }
        };
        Verdict { ending, violations: Vec::new(), seconds: self.seconds, work: self.work }
    }
}

/// Runs a deck in a folder as the job "model", no longer than the limit.
pub fn run_text(text: &str, folder: &Path, limit: Duration) -> Ran {
    let began = Instant::now();
    let mut clock = Clock { end: began + limit, stopped: false, work: [0; 2] };
    let ran = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        let read = Job::read_text("model", text, &ReadOptions::default());
        let options = RunOptions { folder: Some(folder.to_owned()), ..RunOptions::default() };
        let outcome = run(&read, &options, &mut clock);
        let said = read.diagnostics.into_iter().chain(outcome.diagnostics);
        said.map(|said| format!("{}: {}", said.code.0, said.message)).collect()
    }));
    let seconds = began.elapsed().as_secs_f64();
    Ran { said: ran.ok(), stopped: clock.stopped, seconds, work: clock.work }
}

/// Runs once; files as well, where there are.
fn once(case: &Case, folder: &Path, limit: Duration) -> (Verdict, Option<Files>) {
    let ran = run_text(&case.text(), folder, limit);
    let files = files::read(case, folder, "model");
    let told = files.as_ref().map(|files| (files.status.as_str(), files.diagnosis.clone()));
    let mut verdict = ran.verdict(told);
    if let (Ending::Completed, Some(files)) = (&verdict.ending, &files) {
        verdict.violations = physics::violations(case, files);
        let crossed = passing::violations(case, files);
        verdict.violations.extend(crossed);
    }
    (verdict, files)
}

/// What does not shrink with the increments: reactions that depend on them
/// without friction, energy that is missing.
fn held_against(case: &Case, coarse: &Files, fine: &Files) -> Option<(&'static str, String)> {
    if fine.status != "completed" {
        return Some(("finer", format!("finer increments do not complete: {:?}", fine.diagnosis)));
    }
    let missing = [coarse, fine].map(physics::missing);
    let said = fine.warnings.contains("energ");
    if !said && missing[1] > NOTABLE && missing[1] > 0.6 * missing[0] {
        let [a, b] = missing.map(|part| 100.0 * part);
        return Some(("energy stays", format!("{a:.1} % missing, finer {b:.1} %")));
    }
    let size = |reactions: &[[f64; 3]]| {
        reactions.iter().map(|r| r[0].abs() + r[1].abs()).fold(0.0, f64::max)
    };
    let all = fine.states.iter().map(|state| size(&state.reaction)).fold(0.0, f64::max);
    for step in 0..case.draft.steps.len().min(if case.draft.reversible { usize::MAX } else { 0 }) {
        let last = |files: &Files| {
            let state = files.states.iter().rev().find(|state| state.step == step);
            state.map(|state| state.reaction.clone())
        };
        let (a, b) = (last(coarse)?, last(fine)?);
        let apart = a.iter().zip(&b).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        let apart = apart.fold(0.0, f64::max);
        if apart > 1e-3 * all {
            return Some(("path", format!("step {}: {apart:.2e} apart of {all:.2e}", step + 1)));
        }
    }
    None
}

/// Counts of a class.
#[derive(Clone, Debug, Default)]
pub struct Counts {
    /// Models, well-posed ones, well-posed completed.
    pub models: [usize; 3],
    /// Endings other than completed, of well-posed models, and of others.
    pub failed: [BTreeMap<String, usize>; 2],
    /// Violations by kind.
    pub violations: BTreeMap<&'static str, usize>,
    /// Slowest: seconds and number.
    pub slowest: (f64, u64),
    /// Increments, iterations.
    pub work: [usize; 2],
}

impl Counts {
    /// Takes a verdict in.
    pub fn add(&mut self, Label { number, well_posed, .. }: Label, verdict: &Verdict) {
        self.models[0] += 1;
        self.models[1] += usize::from(well_posed);
        match failure(verdict) {
            None => self.models[2] += usize::from(well_posed),
            Some(code) => *self.failed[usize::from(!well_posed)].entry(code).or_default() += 1,
        }
        for (kind, _) in &verdict.violations {
            *self.violations.entry(kind).or_default() += 1;
        }
        if verdict.seconds > self.slowest.0 {
            self.slowest = (verdict.seconds, number);
        }
        (0..2).for_each(|k| self.work[k] += verdict.work[k]);
    }
}

/// The word for an ending that is not completed.
pub fn failure(verdict: &Verdict) -> Option<String> {
    match &verdict.ending {
        Ending::Completed => None,
        Ending::Diagnosed(code, _) => Some(code.clone()),
        Ending::TimeUp => Some("TIME".to_owned()),
        Ending::Unreadable(_) => Some("UNREAD".to_owned()),
        Ending::Panic => Some("PANIC".to_owned()),
    }
}

/// Counts by class, as a table.
#[derive(Clone, Debug, Default)]
pub struct Table(pub BTreeMap<&'static str, Counts>);

impl Table {
    /// Takes a verdict in.
    pub fn add(&mut self, label: Label, verdict: &Verdict) {
        self.0.entry(label.class).or_default().add(label, verdict);
    }

    /// Well-posed models, and those that completed.
    pub fn well_posed(&self) -> [usize; 2] {
        let sum = |k: usize| self.0.values().map(|counts| counts.models[k]).sum();
        [sum(1), sum(2)]
    }

    /// Violations by kind.
    pub fn violations(&self) -> BTreeMap<&'static str, usize> {
        let mut all = BTreeMap::new();
        for (kind, count) in self.0.values().flat_map(|counts| &counts.violations) {
            *all.entry(*kind).or_default() += count;
        }
        all
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "class      models  well-posed  completed  slowest [s] (number)  iterations")?;
        for (class, counts) in &self.0 {
            let [models, well, completed] = counts.models;
            let (seconds, number) = counts.slowest;
            let part = 100.0 * completed as f64 / well.max(1) as f64;
            writeln!(
                f,
                "{class:10} {models:6} {well:11} {completed:6} {part:5.1} % {seconds:7.2} ({number}) {}",
                counts.work[1]
            )?;
            let join = |map: &BTreeMap<String, usize>| {
                map.iter().map(|(code, n)| format!("{code} {n}")).collect::<Vec<_>>().join(", ")
            };
            if !counts.failed[0].is_empty() {
                writeln!(f, "           failed: {}", join(&counts.failed[0]))?;
            }
            if !counts.failed[1].is_empty() {
                writeln!(f, "           not well-posed: {}", join(&counts.failed[1]))?;
            }
            if !counts.violations.is_empty() {
                writeln!(f, "           broken: {:?}", counts.violations)?;
            }
        }
        let [well, completed] = self.well_posed();
        write!(
            f,
            "well-posed {well}, completed {completed} ({:.2} %), broken {:?}",
            100.0 * completed as f64 / well.max(1) as f64,
            self.violations()
        )
    }
}

/// Draws and runs models of a class.
pub fn sweep(
    class: &Class,
    numbers: impl Iterator<Item = u64>,
    (folder, limit): (&Path, Duration),
    mut each: impl FnMut(&Case, &Verdict),
) {
    for number in numbers {
        let case = Case::drawn(class, number);
        let verdict = attempt(&case, folder, limit);
        each(&case, &verdict);
    }
}
