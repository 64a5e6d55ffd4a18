//! `JOB.element.csv`: section forces and stresses of the beams that
//! `*EL FILE` or `*ELEMENT OUTPUT` name, a row per beam and increment. In a model without plane beams
//! those of beams in space.

use crate::rows::{Rows, Sheet};
use crate::section::{axial_stresses, beams, outer_mises};
use slideline_model::{ElementPrint, ElementType, PrintTarget, types};
use slideline_solve::observe::{Frame, StepReport};

/// `JOB.element.csv`, where the deck asks for it.
#[derive(Default)]
pub(crate) struct Elements {
    /// Whether it tells of beams in space.
    in_space: bool,
}

impl Rows for Elements {
    const ENDING: &'static str = ".element.csv";

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        let mut prints = report.model.steps.iter().flat_map(|step| &step.output.element_prints);
        let asked = prints.any(|p| p.request.target.is_file() && p.request.frequency > 0);
        let some = |is: fn(&ElementType) -> bool| {
            report.model.blocks.iter().any(|block| is(block.kind) && !block.elements.is_empty())
        };
        self.in_space = some(ElementType::is_space_beam) && !some(ElementType::is_beam);
        if self.in_space {
            let fields = types::B31.fields.iter().flat_map(|field| field.components);
            let columns = fields.fold("element".to_owned(), |all, name| all + "," + name);
            return asked.then_some(columns);
        }
        let columns = "element,SF1,SF2,SM1,SE1,SE2,SK1,S11_1,S11_2,S11_3,S11_4,S11_5,MISES";
        asked.then(|| columns.to_owned())
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return };
        let (increment, last) = (frame.increment, frame.last_of_step);
        let due =
            |print: &&ElementPrint| print.request.is_due(PrintTarget::is_file, increment, last);
        let due: Vec<&ElementPrint> = step.output.element_prints.iter().filter(due).collect();
        let named = |label: &u64| due.iter().any(|own| own.elements.binary_search(label).is_ok());
        if self.in_space {
            for results in frame.elements {
                if !frame.model.blocks[results.block].kind.is_space_beam() {
                    continue;
                }
                let told = results.elements(frame.model);
                for (element, values) in told.filter(|(element, _)| named(&element.label)) {
                    sheet.row().cell(element.label);
                    sheet.numbers(values.iter().copied()).end();
                }
            }
            return;
        }
        for (row, _, section) in beams(frame) {
            if named(&row.label) {
                let stresses = axial_stresses([row.axial_force, row.bending_moment], section);
                sheet.row().cell(row.label);
                sheet.numbers([row.axial_force, row.shear_force, row.bending_moment]);
                sheet.numbers(row.strains).numbers(stresses);
                sheet.numbers([outer_mises(&stresses)]).end();
            }
        }
    }
}
