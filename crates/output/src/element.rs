//! `JOB.element.csv`: section forces and stresses of the beams that
//! `*EL FILE` or `*ELEMENT OUTPUT` name, a row per beam and increment.

use crate::file::{Growing, WriteError};
use crate::history::push_time;
use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::section::{axial_stresses, beams, outer_mises};
use crate::writers::Writer;
use slideline_model::{BeamSection, ElementPrint, Model, PrintTarget};
use slideline_solve::observe::{BeamRow, Event, Frame};
use std::fmt::Write as _;

const HEADER: &str = "step,increment,time,element,SF1,SF2,SM1,SE1,SE2,SK1,\
                      S11_1,S11_2,S11_3,S11_4,S11_5,MISES\n";

/// Writes `JOB.element.csv` where the deck asks for it.
pub(crate) struct Elements {
    job: JobFiles,
    file: Option<Growing>,
}

impl Elements {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), file: None }
    }

    fn begin(&mut self, model: &Model) -> Result<(), WriteError> {
        let mut prints = model.steps.iter().flat_map(|step| &step.output.element_prints);
        let asked = prints.any(|p| p.request.target.is_file() && p.request.frequency > 0);
        if !asked || self.file.is_some() {
            return Ok(());
        }
        self.file = Some(Growing::begin(&self.job, ".element.csv", HEADER)?);
        Ok(())
    }

    fn rows(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return Ok(()) };
        let (increment, last) = (frame.increment, frame.last_of_step);
        let due =
            |print: &&ElementPrint| print.request.is_due(PrintTarget::is_file, increment, last);
        let due: Vec<&ElementPrint> = step.output.element_prints.iter().filter(due).collect();
        for (row, _, section) in beams(frame) {
            if due.iter().any(|print| print.elements.binary_search(&row.label).is_ok()) {
                push_row(&mut file.text, frame, row, section);
            }
        }
        file.flush()
    }
}

fn push_row(text: &mut String, frame: &Frame<'_>, row: &BeamRow, section: &BeamSection) {
    push_time(text, frame);
    let _ = write!(text, "{}", row.label); // a String takes any text
    let stresses = axial_stresses(row, section);
    let forces = [row.axial_force, row.shear_force, row.bending_moment];
    let last = [outer_mises(&stresses)];
    for value in forces.iter().chain(&row.strains).chain(&stresses).chain(&last) {
        text.push(',');
        push_shortest(text, *value);
    }
    text.push('\n');
}

impl Writer for Elements {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(step) => self.begin(step.model),
            Event::Committed(frame) => self.rows(frame),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".element.csv", self.file.as_ref());
    }
}
