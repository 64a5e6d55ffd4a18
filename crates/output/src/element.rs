//! `JOB.element.csv`: section forces and stresses of the beams that
//! `*EL FILE` or `*ELEMENT OUTPUT` name, a row per beam and increment.

use crate::rows::{Rows, Sheet};
use crate::section::{axial_stresses, beams, outer_mises};
use slideline_model::{ElementPrint, PrintTarget};
use slideline_solve::observe::{Frame, StepReport};

/// `JOB.element.csv`, where the deck asks for it.
#[derive(Default)]
pub(crate) struct Elements;

impl Rows for Elements {
    const ENDING: &'static str = ".element.csv";

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        let mut prints = report.model.steps.iter().flat_map(|step| &step.output.element_prints);
        let asked = prints.any(|p| p.request.target.is_file() && p.request.frequency > 0);
        let columns = "element,SF1,SF2,SM1,SE1,SE2,SK1,S11_1,S11_2,S11_3,S11_4,S11_5,MISES";
        asked.then(|| columns.to_owned())
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return };
        let (increment, last) = (frame.increment, frame.last_of_step);
        let due =
            |print: &&ElementPrint| print.request.is_due(PrintTarget::is_file, increment, last);
        let due: Vec<&ElementPrint> = step.output.element_prints.iter().filter(due).collect();
        for (row, _, section) in beams(frame) {
            if due.iter().any(|print| print.elements.binary_search(&row.label).is_ok()) {
                let stresses = axial_stresses([row.axial_force, row.bending_moment], section);
                sheet.row().cell(row.label);
                sheet.numbers([row.axial_force, row.shear_force, row.bending_moment]);
                sheet.numbers(row.strains).numbers(stresses);
                sheet.numbers([outer_mises(&stresses)]).end();
            }
        }
    }
}
