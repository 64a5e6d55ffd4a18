//! `JOB.pair.csv`: what each contact pair carries and whether it balances, a
//! row per pair and converged increment.

use crate::rows::{Rows, Sheet};
use slideline_model::Model;
use slideline_solve::observe::{Frame, PairRow, StepReport};

/// A quantity of a contact pair.
pub type PairQuantity = fn(&PairRow) -> f64;

/// Columns that hold the number of a node, or nothing.
const DEEPEST: &str = "deepest_node";
const UNSEEN: &str = "unseen_node";

#[allow(clippy::cast_precision_loss)] // counts of points
/// All other columns.
const QUANTITIES: [(&str, PairQuantity); 23] = [
    ("closed", |row| row.closed as f64),
    ("changes", |row| row.changes as f64),
    ("penetration", |row| row.penetration),
    ("force_x", |row| row.force[0]),
    ("force_y", |row| row.force[1]),
    ("force_z", |row| row.force[2]),
    ("moment", |row| row.moment[2]),
    ("moment_x", |row| row.moment[0]),
    ("moment_y", |row| row.moment[1]),
    ("moment_z", |row| row.moment[2]),
    ("force_imbalance", |row| row.force_imbalance),
    ("moment_imbalance", |row| row.moment_imbalance),
    ("area", |row| row.area),
    ("normal_x", |row| row.of_pressure.force[0]),
    ("normal_y", |row| row.of_pressure.force[1]),
    ("normal_z", |row| row.of_pressure.force[2]),
    ("friction_x", |row| row.of_friction.force[0]),
    ("friction_y", |row| row.of_friction.force[1]),
    ("friction_z", |row| row.of_friction.force[2]),
    ("unseen_depth", |row| row.unseen_depth),
    ("falls_away", |row| row.falls_away),
    ("smoothed_away", |row| row.smoothed_away),
    ("approach", |row| row.approach),
];

/// The quantity of a column of `JOB.pair.csv`.
pub fn pair_quantity(name: &str) -> Option<PairQuantity> {
    QUANTITIES.iter().find(|(known, _)| *known == name).map(|(_, quantity)| *quantity)
}

/// Columns behind step, increment, time and pair, of a model in the plane or in space.
pub(crate) fn columns(model: &Model) -> Vec<&'static str> {
    let in_space = model.is_in_space();
    let is_there = |name: &&str| match *name {
        "moment" => !in_space,
        "moment_x" | "moment_y" => in_space,
        name => in_space || !name.ends_with("_z"),
    };
    let mut names: Vec<&str> = QUANTITIES.iter().map(|own| own.0).filter(is_there).collect();
    names.insert(3, DEEPEST);
    names.insert(names.len() - 3, UNSEEN);
    names
}

/// `JOB.pair.csv`.
#[derive(Default)]
pub(crate) struct Pairs(Vec<&'static str>);

impl Rows for Pairs {
    fn ending(&self) -> &'static str {
        ".pair.csv"
    }

    fn columns(&mut self, step: &StepReport<'_>) -> Option<String> {
        self.0 = columns(step.model);
        Some(format!("pair,{}", self.0.join(",")))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for (pair, row) in frame.model.contact_pairs.iter().zip(frame.pairs) {
            sheet.row().name(&pair.name);
            for column in &self.0 {
                let node = if *column == UNSEEN { row.unseen } else { row.deepest };
                match (pair_quantity(column), node) {
                    (Some(quantity), _) => sheet.numbers([quantity(row)]),
                    (None, Some(node)) => sheet.cell(frame.model.nodes.label(node)),
                    (None, None) => sheet.cell(""),
                };
            }
            sheet.end();
        }
    }
}
