//! `JOB.contact.csv`: a row per slave point that is or was in contact.

use crate::rows::{Rows, Sheet};
use slideline_results::{ContactComponent, contact_component};
use slideline_solve::observe::{Frame, StepReport};

/// Columns of numbers before the word on friction, and behind it.
const BEFORE: [&str; 4] = ["COPEN", "CPRESS", "CSHEAR1", "CSLIP1"];
const BEHIND: [&str; 5] = ["x", "y", "normal_x", "normal_y", "area"];
/// Further columns before that word in space, and all those behind it.
const IN_SPACE: [&str; 8] = ["CSHEAR2", "CSLIP2", "t1_x", "t1_y", "t1_z", "t2_x", "t2_y", "t2_z"];
const BEHIND_IN_SPACE: [&str; 7] = ["x", "y", "z", "normal_x", "normal_y", "normal_z", "area"];

/// Columns of numbers before the word on friction, and those behind it.
pub fn columns(in_space: bool) -> [Vec<&'static ContactComponent>; 2] {
    let (further, behind): (&[_], &[_]) = match in_space {
        true => (&IN_SPACE, &BEHIND_IN_SPACE),
        false => (&[], &BEHIND),
    };
    let before = BEFORE.iter().chain(further).filter_map(|name| contact_component(name)).collect();
    [before, behind.iter().filter_map(|name| contact_component(name)).collect()]
}

/// `JOB.contact.csv`.
#[derive(Default)]
pub(crate) struct Contact {
    before: Vec<&'static ContactComponent>,
    behind: Vec<&'static ContactComponent>,
}

impl Rows for Contact {
    fn ending(&self) -> &'static str {
        ".contact.csv"
    }

    fn columns(&mut self, step: &StepReport<'_>) -> Option<String> {
        [self.before, self.behind] = columns(step.model.is_in_space());
        let names = |list: &[&'static ContactComponent]| {
            list.iter().map(|column| column.name).collect::<Vec<_>>().join(",")
        };
        let (before, behind) = (names(&self.before), names(&self.behind));
        Some(format!("pair,node,status,{before},friction,{behind}"))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for row in frame.contact.iter().filter(|row| row.ever_closed) {
            sheet.row().name(&frame.model.contact_pairs[row.pair].name);
            sheet.cell(frame.model.nodes.label(row.node)).cell(row.status.word());
            sheet.numbers(self.before.iter().map(|column| (column.value)(row)));
            sheet.cell(row.friction.word());
            sheet.numbers(self.behind.iter().map(|column| (column.value)(row))).end();
        }
    }
}
