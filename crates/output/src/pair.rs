//! `JOB.pair.csv`: what each contact pair carries and whether it balances, a
//! row per pair and converged increment.

use crate::rows::{Rows, Sheet};
use slideline_solve::observe::{Frame, StepReport};

/// Columns behind step, increment, time and pair.
pub(crate) const COLUMNS: [&str; 9] = [
    "closed",
    "changes",
    "penetration",
    "deepest_node",
    "force_x",
    "force_y",
    "moment",
    "force_imbalance",
    "moment_imbalance",
];

/// `JOB.pair.csv`.
#[derive(Default)]
pub(crate) struct Pairs;

impl Rows for Pairs {
    const ENDING: &'static str = ".pair.csv";

    fn columns(&mut self, _: &StepReport<'_>) -> Option<String> {
        Some(format!("pair,{}", COLUMNS.join(",")))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for (pair, row) in frame.model.contact_pairs.iter().zip(frame.pairs) {
            sheet.row().name(&pair.name).cell(row.closed).cell(row.changes);
            sheet.numbers([row.penetration]);
            match row.deepest {
                Some(node) => sheet.cell(frame.model.nodes.label(node)),
                None => sheet.cell(""),
            };
            let imbalance = [row.force_imbalance, row.moment_imbalance];
            let [x, y, _] = row.force;
            sheet.numbers([x, y, row.moment[2]]).numbers(imbalance).end();
        }
    }
}
