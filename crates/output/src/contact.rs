//! `JOB.contact.csv`: a row per slave point that is or was in contact.

use crate::rows::{Rows, Sheet};
use slideline_solve::observe::{Frame, StepReport};

/// `JOB.contact.csv`.
#[derive(Default)]
pub(crate) struct Contact;

impl Rows for Contact {
    const ENDING: &'static str = ".contact.csv";

    fn columns(&mut self, _: &StepReport<'_>) -> Option<String> {
        let columns = "pair,node,status,COPEN,CPRESS,CSHEAR1,CSLIP1,friction,\
                       x,y,normal_x,normal_y,area";
        Some(columns.to_owned())
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for row in frame.contact.iter().filter(|row| row.ever_closed) {
            sheet.row().name(&frame.model.contact_pairs[row.pair].name);
            sheet.cell(frame.model.nodes.label(row.node)).cell(row.status.word());
            sheet.numbers([row.opening, row.pressure, row.shear, row.slip]);
            sheet.cell(row.friction.word()).numbers(row.position).numbers(row.normal);
            sheet.numbers([row.area]).end();
        }
    }
}
