//! Derivatives of a deck held against differences of whole runs, whatever the deck has in it.
//!
//! ```text
//!    p - 2h   p - h   p   p + h   p + 2h     whole runs
//!      o        o     x     o       o        x: the run with its derivative
//! ```
//!
//! Numbers of a deck become parameters: the first modulus, coefficient of friction, yield stress,
//! coefficient of expansion, load and motion, and others.

use slideline::model::Dof;
use slideline::observe::{Ending, Frame};
use slideline::{
    Event, Job, Observer, Parameter, Parametric, Plan, ReadOptions, SolveOptions, Stop, Workspace,
    keywords::Setting,
};
use std::ops::ControlFlow;
use std::sync::Arc;

/// Part of a response that a parameter changes by its own size, below which it counts as
/// independent [1].
const LEAST: f64 = 1e-3;
/// How far apart they may be [1].
const ENOUGH: f64 = 1e-6;
/// Steps of the differences, in values of the parameter [1]: where they disagree, neither is known
/// better than that.
const STEPS: [f64; 2] = [1e-4, 2e-5];
/// Responses of one kind share what counts as large.
const KINDS: [&str; 6] =
    ["motion", "rotation", "reaction", "moment", "strain energy", "dissipation"];

const DOFS: [[Dof; 3]; 2] = [[Dof::U1, Dof::U2, Dof::U3], [Dof::UR1, Dof::UR2, Dof::UR3]];

/// All responses of a frame, kind by kind.
fn responses(frame: &Frame<'_>) -> Vec<Vec<f64>> {
    let model = frame.model;
    let nodes = || 0..model.nodes.len();
    let all = |of: &dyn Fn(slideline::model::NodeIndex, Dof) -> f64, dofs: [Dof; 3]| {
        nodes().flat_map(|node| dofs.map(|dof| of(node, dof))).collect::<Vec<f64>>()
    };
    let moved = |node, dof| frame.nodal.displacement(node, dof);
    let held = |node, dof| frame.nodal.reaction(node, dof);
    vec![
        all(&moved, DOFS[0]),
        all(&moved, DOFS[1]),
        all(&held, DOFS[0]),
        all(&held, DOFS[1]),
        vec![frame.energy.strain_energy],
        vec![frame.energy.friction_dissipation + frame.energy.material_dissipation],
    ]
}

#[derive(Default)]
struct Seen {
    times: Vec<f64>,
    rows: Vec<Vec<Vec<f64>>>,
    /// An increment each: the derivative, and whether it is of one side.
    rates: Vec<(Vec<Vec<f64>>, bool)>,
}

impl Observer for Seen {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => {
                self.times.push(frame.total_time);
                self.rows.push(responses(frame));
            }
            Event::Sensitivity(told) => {
                let shape = self.rows.last().map(|row| row.iter().map(Vec::len));
                let rate = shape.into_iter().flatten().enumerate().map(|(kind, count)| {
                    (0..count).map(|k| told.of(|frame| responses(frame)[kind][k])).collect()
                });
                self.rates.push((rate.collect(), told.one_sided));
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// The first number of the line behind a card becomes a parameter.
fn name_number(deck: &str, card: &str, column: usize, name: &str) -> Option<(String, f64)> {
    let mut lines: Vec<String> = deck.lines().map(str::to_owned).collect();
    let is_card = |line: &str| {
        let line = line.trim().to_ascii_uppercase();
        line == card || line.starts_with(&format!("{card},"))
    };
    for at in 0..lines.len() {
        if !is_card(&lines[at]) || at + 1 == lines.len() {
            continue;
        }
        let mut parts: Vec<&str> = lines[at + 1].split(',').collect();
        let found = parts.get(column).and_then(|part| part.trim().parse::<f64>().ok());
        let Some(value) = found.filter(|value| *value != 0.0) else { continue };
        let named = format!("<{name}>");
        parts[column] = &named;
        lines[at + 1] = parts.join(", ");
        return Some((lines.join("\n") + "\n", value));
    }
    None
}

/// Every number that the deck may be differentiated by, with the deck that has it.
fn numbers(deck: &str) -> Vec<(&'static str, String, f64)> {
    let places = [
        ("*ELASTIC", 0, "modulus"),
        ("*HYPERELASTIC", 0, "rubber"),
        ("*PLASTIC", 0, "yield"),
        ("*EXPANSION", 0, "expansion"),
        ("*CONDUCTIVITY", 0, "conductivity"),
        ("*FRICTION", 0, "mu"),
        ("*SURFACE BEHAVIOR", 0, "law"),
        ("*BEAM SECTION", 0, "section"),
        ("*SOLID SECTION", 0, "section"),
        ("*GAP", 0, "clearance"),
        ("*BOUNDARY", 3, "motion"),
        ("*CLOAD", 2, "load"),
        ("*DLOAD", 2, "pressure"),
        ("*TEMPERATURE", 1, "temperature"),
    ];
    let found = places.into_iter().filter_map(|(card, column, name)| {
        let (deck, value) = name_number(deck, card, column, name)?;
        let first = format!("*PARAMETER\n{name} = {value:e}\n");
        let at = deck.lines().position(|line| line.starts_with('*') && !line.starts_with("**"))?;
        let is_heading = deck.lines().nth(at)?.to_ascii_uppercase().starts_with("*HEADING");
        let mut lines: Vec<&str> = deck.lines().collect();
        // a heading has its lines behind it
        let next = |from: usize| (from..lines.len()).find(|&k| lines[k].starts_with('*'));
        let at = if is_heading { next(at + 1)? } else { at };
        lines.insert(at, first.trim_end());
        Some((name, lines.join("\n") + "\n", value))
    });
    found.collect()
}

/// Every step is solved to rounding.
fn solved_exactly(deck: &str) -> String {
    let controls = "*CONTROLS, PARAMETERS=FIELD\n1e-11, 1e-8\n";
    let mut text = String::new();
    for line in deck.lines() {
        if line.trim().to_ascii_uppercase().starts_with("*END STEP") {
            text += controls;
        }
        text += line;
        text.push('\n');
    }
    text
}

fn plain(deck: &Parametric, name: &str, value: f64) -> Option<Seen> {
    let setting = Setting { name: name.to_owned(), value: format!("{value:e}"), span: None };
    let model = deck.model(&[setting]).ok()?;
    let mut seen = Seen::default();
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut seen);
    matches!(ending, Ending::Completed(_)).then_some(seen)
}

/// The run of a deck with its derivative by a parameter, and the runs beside it: four with the
/// first step, four with the second; what stands in the way.
fn runs(name: &str, text: &str, value: f64) -> Result<(Seen, Vec<Seen>), String> {
    let read = Job::read_text("deck", text, &ReadOptions::default());
    let said = || read.diagnostics.first().map(|own| own.message.clone()).unwrap_or_default();
    let model = read.model.as_ref().ok_or_else(|| format!("not read: {}", said()))?;
    let deck = Arc::new(Parametric::of(&read).map_err(|own| own.message)?);
    let parameters: Vec<Parameter> = deck.varied(&[], &deck.numbers(&[]));
    let mut workspace = Workspace::new(&Plan::of(model), &SolveOptions::default());
    let mut seen = Seen::default();
    let own: Vec<Parameter> = parameters.into_iter().filter(|own| own.name == name).collect();
    let ending =
        workspace.run_differentiated(model, &own, &mut seen).map_err(|own| own.to_string())?;
    if !matches!(ending, Ok(Ending::Completed(_))) {
        return Err("does not run".to_owned());
    }
    let mut near = Vec::new();
    for step in STEPS {
        for k in [-2.0, -1.0, 1.0, 2.0] {
            let at = value + k * step * value;
            near.push(plain(&deck, name, at).ok_or("a neighbour does not run")?);
        }
    }
    if near.iter().any(|own| own.times != seen.times) {
        return Err("other increments beside it".to_owned());
    }
    Ok((seen, near))
}

/// How far apart derivatives and differences of one parameter are.
#[derive(Clone, Debug)]
pub struct Held {
    /// What the parameter stands for.
    pub name: &'static str,
    /// The largest difference, in the largest derivative of its kind of response [1].
    pub apart: f64,
    /// Increments without a derivative.
    pub lost: usize,
    /// All of it in words.
    pub told: String,
}

impl Held {
    /// Whether they are the same.
    pub fn is_same(&self) -> bool {
        self.apart <= ENOUGH && self.lost == 0
    }
}

/// A row for every number that a deck has and may be differentiated by; what stands in the way of
/// some.
pub fn derivatives(deck: &str) -> Vec<(&'static str, Result<Held, String>)> {
    let all = numbers(&solved_exactly(deck)).into_iter();
    all.map(|(name, deck, value)| (name, compare(name, &deck, value))).collect()
}

/// How far apart derivatives and differences are; what stands in the way.
fn compare(name: &'static str, text: &str, value: f64) -> Result<Held, String> {
    let (seen, near) = runs(name, text, value)?;
    let lost = seen.rows.len() - seen.rates.len();
    let sides = seen.rates.iter().filter(|(_, one)| *one).count();
    let mut line = format!("{lost} lost, {sides} one-sided of {};", seen.rows.len());
    let mut worst = 0.0_f64;
    for (kind, of) in KINDS.iter().enumerate() {
        let with = |step: usize, row: usize, k: usize| {
            let of = |side: usize| near[4 * step + side].rows[row][kind][k];
            (of(0) - 8.0 * of(1) + 8.0 * of(2) - of(3)) / (12.0 * STEPS[step] * value)
        };
        let by = |row: usize, k: usize| with(0, row, k);
        let each = || {
            (0..seen.rates.len())
                .flat_map(|row| (0..seen.rows[row][kind].len()).map(move |k| (row, k)))
        };
        let largest = each().map(|(row, k)| by(row, k).abs()).fold(0.0, f64::max);
        let size = each().map(|(row, k)| seen.rows[row][kind][k].abs()).fold(0.0, f64::max);
        let scale = largest.max(LEAST * size / value.abs());
        if scale == 0.0 {
            continue;
        }
        let mut off = (0.0, 0, String::new());
        for (row, k) in each().filter(|(row, _)| !seen.rates[*row].1) {
            let doubt = (with(0, row, k) - with(1, row, k)).abs();
            let apart = ((seen.rates[row].0[kind][k] - by(row, k)).abs() - doubt) / scale;
            if apart > off.0 || apart.is_nan() {
                let (own, by) = (seen.rates[row].0[kind][k], by(row, k));
                let said = format!("{own:.9e} and {by:.9e} +- {doubt:.0e} of {scale:.1e}");
                off = (apart, row + 1, said);
            }
        }
        worst = if off.0.is_nan() { f64::INFINITY } else { worst.max(off.0) };
        line += &format!(" {of} {:.1e}", off.0);
        if off.0 > ENOUGH || off.0.is_nan() {
            line += &format!(" (increment {}: {})", off.1, off.2);
        }
    }
    Ok(Held { name, apart: worst, lost, told: line })
}
