//! The files of a run, read back into the units and axes of the draft.

use super::classes::{Case, Side};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// A contact point.
#[derive(Clone, Debug)]
pub struct Point {
    /// Pair.
    pub pair: usize,
    /// Node of the draft.
    pub node: usize,
    /// `open`, `stick` or `slip`.
    pub status: String,
    /// Gap, pressure, shear.
    pub open: f64,
    /// Pressure.
    pub pressure: f64,
    /// Shear traction.
    pub shear: f64,
}

/// What the energies of an increment are.
#[derive(Clone, Copy, Debug, Default)]
pub struct Energy {
    /// Work of supports and loads.
    pub work: f64,
    /// Of the elements.
    pub strain: f64,
    /// Dissipated by sliding.
    pub dissipation: f64,
    /// What is left.
    pub balance: f64,
}

/// A converged increment.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// Step from 0, increment from 1.
    pub step: usize,
    /// Increment.
    pub increment: usize,
    /// Total time in periods.
    pub time: f64,
    /// Displacements and rotation of every node.
    pub motion: Vec<[f64; 3]>,
    /// Reactions of every node.
    pub reaction: Vec<[f64; 3]>,
    /// Contact points.
    pub points: Vec<Point>,
    /// Energies.
    pub energy: Energy,
    /// Imbalances that the pairs own up to [1].
    pub pair_imbalance: f64,
}

/// All of a run.
#[derive(Clone, Debug, Default)]
pub struct Files {
    /// `completed` or not.
    pub status: String,
    /// Converged increments.
    pub states: Vec<State>,
    /// Codes and messages of warnings, in one text.
    pub warnings: String,
    /// Code and message of the diagnosis.
    pub diagnosis: Option<(String, String)>,
}

/// A table with a header.
pub(super) struct Rows {
    columns: HashMap<String, usize>,
    /// Its rows.
    pub cells: Vec<Vec<String>>,
}

impl Rows {
    /// Reads a file; none where there is no table.
    pub fn read(path: &Path) -> Option<Self> {
        let text = std::fs::read_to_string(path).ok()?;
        let mut lines = text.lines();
        let split = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let columns = split(lines.next()?).into_iter().enumerate().map(|(k, c)| (c, k)).collect();
        Some(Self { columns, cells: lines.map(split).collect() })
    }

    /// What stands in a row.
    pub fn text(&self, row: usize, column: &str) -> &str {
        self.columns.get(column).map_or("", |&at| self.cells[row][at].as_str())
    }

    /// A number of a row, NaN where there is none.
    pub fn number(&self, row: usize, column: &str) -> f64 {
        self.text(row, column).parse().unwrap_or(f64::NAN)
    }

    /// A whole number of a row, 0 where there is none.
    pub fn whole(&self, row: usize, column: &str) -> usize {
        self.text(row, column).parse().unwrap_or(0)
    }

    /// Step and increment of a row.
    pub fn key(&self, row: usize) -> (usize, usize) {
        (self.whole(row, "step"), self.whole(row, "increment"))
    }
}

/// Reads the files of a job; `None` where one is missing.
pub fn read(case: &Case, folder: &Path, job: &str) -> Option<Files> {
    let path = |ending: &str| folder.join(format!("{job}{ending}"));
    let mut states = BTreeMap::new();
    history(case, &Rows::read(&path(".history.csv"))?, &mut states);
    contact(case, &Rows::read(&path(".contact.csv"))?, &mut states);
    let energy = Rows::read(&path(".energy.csv"))?;
    let unit = case.placed.force * case.placed.length;
    for row in 0..energy.cells.len() {
        let of = |column| energy.number(row, column) / unit;
        if let Some(state) = states.get_mut(&energy.key(row)) {
            state.energy = Energy {
                work: of("external_work"),
                strain: of("strain_energy"),
                dissipation: of("friction_dissipation"),
                balance: of("balance"),
            };
        }
    }
    let pairs = Rows::read(&path(".pair.csv"))?;
    for row in 0..pairs.cells.len() {
        if let Some(state) = states.get_mut(&pairs.key(row)) {
            // of moments that nearly vanish about the origin little is certain
            let [force, moment] =
                ["force_imbalance", "moment_imbalance"].map(|column| pairs.number(row, column));
            state.pair_imbalance = state.pair_imbalance.max(force).max(1e-6 * moment);
        }
    }
    let json = std::fs::read_to_string(path(".json")).ok()?;
    let warnings = json.split("\"warnings\":[").nth(1)?.split("\"peaks\":").next()?;
    let diagnosis = json
        .split("\"diagnosis\":{")
        .nth(1)
        .map(|text| (member(text, "code").to_owned(), member(text, "message").to_owned()));
    Some(Files {
        status: member(&json, "status").to_owned(),
        states: states.into_values().collect(),
        warnings: warnings.to_owned(),
        diagnosis,
    })
}

/// The first text member of that name.
pub(super) fn member<'a>(json: &'a str, name: &str) -> &'a str {
    let mark = format!("\"{name}\":\"");
    json.split(mark.as_str()).nth(1).and_then(|rest| rest.split('"').next()).unwrap_or("")
}

fn numbers(case: &Case) -> HashMap<u64, usize> {
    case.placed.numbers.iter().enumerate().map(|(node, &number)| (number, node)).collect()
}

fn history(case: &Case, rows: &Rows, states: &mut BTreeMap<(usize, usize), State>) {
    let (numbers, placed) = (numbers(case), &case.placed);
    let count = numbers.len();
    for row in 0..rows.cells.len() {
        let state = states.entry(rows.key(row)).or_insert_with(|| State {
            step: rows.whole(row, "step").saturating_sub(1),
            increment: rows.whole(row, "increment"),
            time: rows.number(row, "time") / placed.time,
            motion: vec![[0.0; 3]; count],
            reaction: vec![[0.0; 3]; count],
            ..State::default()
        });
        let Some(&node) = numbers.get(&(rows.whole(row, "node") as u64)) else { continue };
        let vector = |x, y, unit: f64| {
            let [x, y] = placed.back([rows.number(row, x), rows.number(row, y)]);
            [x / unit, y / unit]
        };
        let [x, y] = vector("U1", "U2", placed.length);
        state.motion[node] = [x, y, rows.number(row, "UR3") * placed.sense()];
        let [x, y] = vector("RF1", "RF2", placed.force);
        let unit = placed.force * placed.length * placed.sense();
        state.reaction[node] = [x, y, rows.number(row, "RM3") / unit];
    }
}

fn contact(case: &Case, rows: &Rows, states: &mut BTreeMap<(usize, usize), State>) {
    let (numbers, placed) = (numbers(case), &case.placed);
    let pressure = placed.force / (placed.length * placed.length);
    for row in 0..rows.cells.len() {
        let Some(state) = states.get_mut(&rows.key(row)) else { continue };
        let name = rows.text(row, "pair").trim_start_matches("SL").split('/').next();
        let pair = name.and_then(|digits| digits.parse().ok()).unwrap_or(0);
        let Some(&node) = numbers.get(&(rows.whole(row, "node") as u64)) else { continue };
        state.points.push(Point {
            pair,
            node,
            status: rows.text(row, "status").to_owned(),
            open: rows.number(row, "COPEN") / placed.length,
            pressure: rows.number(row, "CPRESS") / pressure,
            shear: rows.number(row, "CSHEAR1") / pressure,
        });
    }
}

/// Nodes of a side.
pub fn side_nodes<'a>(case: &'a Case, side: &'a Side) -> &'a [usize] {
    match side {
        Side::Chain(chain) => &case.draft.chains[*chain].nodes,
        Side::Nodes(nodes) => nodes,
        Side::Body(_) => &[],
    }
}
