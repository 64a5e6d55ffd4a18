//! `JOB.pair.csv`: what each contact pair carries and whether it balances, a
//! row per pair and converged increment.

use crate::rows::{Rows, Sheet};
use slideline_model::Model;
use slideline_solve::observe::{Frame, StepReport};

/// Columns behind step, increment, time and pair, of a model in the plane or in space.
pub(crate) fn columns(model: &Model) -> Vec<&'static str> {
    let forces: &[_] = match model.is_in_space() {
        true => &["force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"],
        false => &["force_x", "force_y", "moment"],
    };
    let first = ["closed", "changes", "penetration", "deepest_node"];
    let sums = ["force_imbalance", "moment_imbalance", "area"];
    let parts: &[_] = match model.is_in_space() {
        true => &["normal_x", "normal_y", "normal_z", "friction_x", "friction_y", "friction_z"],
        false => &["normal_x", "normal_y", "friction_x", "friction_y"],
    };
    let last = sums.into_iter().chain(parts.iter().copied());
    first.into_iter().chain(forces.iter().copied()).chain(last).collect()
}

/// `JOB.pair.csv`.
#[derive(Default)]
pub(crate) struct Pairs;

impl Rows for Pairs {
    fn ending(&self) -> &'static str {
        ".pair.csv"
    }

    fn columns(&mut self, step: &StepReport<'_>) -> Option<String> {
        Some(format!("pair,{}", columns(step.model).join(",")))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for (pair, row) in frame.model.contact_pairs.iter().zip(frame.pairs) {
            sheet.row().name(&pair.name).cell(row.closed).cell(row.changes);
            sheet.numbers([row.penetration]);
            match row.deepest {
                Some(node) => sheet.cell(frame.model.nodes.label(node)),
                None => sheet.cell(""),
            };
            match frame.model.is_in_space() {
                true => sheet.numbers(row.force).numbers(row.moment),
                false => sheet.numbers([row.force[0], row.force[1], row.moment[2]]),
            };
            sheet.numbers([row.force_imbalance, row.moment_imbalance, row.area]);
            let components = if frame.model.is_in_space() { 3 } else { 2 };
            for sum in [row.of_pressure, row.of_friction] {
                sheet.numbers(sum.force.into_iter().take(components));
            }
            sheet.end();
        }
    }
}
