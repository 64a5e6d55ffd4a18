//! The file, begun with its mesh, and a state for each increment that is asked for.

use super::mesh::{push_heading, push_mesh};
use super::results::Results;
use crate::facts::{Facts, Formats};
use crate::file::{Growing, WriteError, beside};
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::outline::Drawing;
use crate::writer::Writer;
use slideline_model::Model;
use slideline_solve::observe::{Event, Frame};
use std::collections::HashSet;

/// Writes `JOB.frd`; it takes its name when the run is over.
pub(crate) struct Frd {
    job: JobFiles,
    version: String,
    formats: Formats,
    file: Option<Growing>,
    drawing: Drawing,
    /// Numbers of nodes that are not in the file.
    left_out: HashSet<u64>,
    /// Converged increments of all steps, which number the results.
    increments: usize,
}

impl Frd {
    pub fn new(job: &JobFiles, facts: &Facts<'_>) -> Self {
        Self {
            job: job.clone(),
            version: facts.version.to_owned(),
            formats: facts.formats,
            file: None,
            drawing: Drawing::default(),
            left_out: HashSet::new(),
            increments: 0,
        }
    }

    fn begin(&mut self, model: &Model) -> Result<(), WriteError> {
        // ccx leaves the mesh at least
        let asked = self.formats == Formats::Ccx
            || model.steps.iter().any(|step| step.output.states_are_asked_for(1, true));
        if !asked || self.file.is_some() {
            return Ok(());
        }
        self.drawing = Drawing::of(model);
        if self.formats == Formats::Ccx {
            self.left_out = alone(&self.drawing);
        }
        let waiting = beside(&self.job.path(".frd"));
        if let Some(kept) = self.job.kept() {
            self.increments = kept.increments;
        }
        if let Some(length) = self.job.kept_length(".frd") {
            self.file = Some(Growing::reopen(waiting, length)?);
            return Ok(());
        }
        let mut file = Growing::create(waiting)?;
        push_heading(&mut file.text, model, &self.job.name(), &self.version, self.formats);
        push_mesh(&mut file.text, &self.drawing, &self.left_out, model);
        file.flush()?;
        self.file = Some(file);
        Ok(())
    }

    fn state(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        self.increments += 1;
        let Some(file) = &mut self.file else { return Ok(()) };
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return Ok(()) };
        if !step.output.states_are_asked_for(frame.increment, frame.last_of_step) {
            return Ok(());
        }
        let left_out = &self.left_out;
        let mut results =
            Results { text: &mut file.text, frame, left_out, number: self.increments };
        results.push_motion(&self.drawing);
        results.push_sections();
        results.push_contact();
        file.flush()
    }

    fn finish(&mut self) -> Result<(), WriteError> {
        let Some(mut file) = self.file.take() else { return Ok(()) };
        file.text.push_str(" 9999\n");
        file.rename(&self.job.path(".frd"))
    }
}

/// Numbers of the points that nothing is drawn with, such as reference nodes: ccx has none of them
/// in its file.
fn alone(drawing: &Drawing) -> HashSet<u64> {
    let mut alone: HashSet<u64> = drawing.labels.iter().copied().collect();
    for piece in &drawing.pieces {
        for &point in &piece.frd.1 {
            alone.remove(&drawing.labels[point]);
        }
    }
    alone
}

impl Writer for Frd {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(report) => self.begin(report.model),
            Event::Committed(frame) => self.state(frame),
            Event::End(_) => self.finish(),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".frd", self.file.as_ref());
    }
}
