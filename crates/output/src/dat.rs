//! `JOB.dat`: the echo of what was understood, then the printed tables; in the formats of ccx the
//! tables alone, as there.

use crate::echo::model_echo;
use crate::facts::{Facts, Formats, Origin};
use crate::file::{Growing, WriteError, beside};
use crate::job::JobFiles;
use crate::kept::Kept;
use crate::tables::{push_contact, push_elements, push_nodes};
use crate::writer::Writer;
use slideline_model::{OutputRequests, PrintTarget, Request};
use slideline_solve::observe::{Event, Frame, StepReport};
use std::fmt::Write as _;

/// The first line: who wrote it, of which job.
pub(crate) fn heading(version: &str, job: &str) -> String {
    format!("slideline {version}   job {job}")
}

/// Writes `JOB.dat`. Tables wait in a file beside it until the run is over;
/// a deck without tables has its file at once.
pub(crate) struct Dat {
    job: JobFiles,
    version: String,
    formats: Formats,
    /// The state that the job goes on from, if it does.
    origin: Option<Origin>,
    file: Option<Growing>,
    begun: bool,
}

impl Dat {
    pub fn new(job: &JobFiles, facts: &Facts<'_>) -> Self {
        let origin = facts.earlier.map(|earlier| earlier.origin.clone());
        let version = facts.version.to_owned();
        let formats = facts.formats;
        Self { job: job.clone(), version, formats, origin, file: None, begun: false }
    }

    fn begin(&mut self, report: &StepReport<'_>) -> Result<(), WriteError> {
        if self.begun {
            return Ok(());
        }
        self.begun = true;
        let path = self.job.path(".dat");
        if report.resumed {
            // A file without tables was finished before the saved state.
            if let Some(length) = self.job.kept_length(".dat") {
                self.file = Some(Growing::reopen(beside(&path), length)?);
            }
            return Ok(());
        }
        let mut file = Growing::create(beside(&path))?;
        if self.formats == Formats::Own {
            self.push_echo(&mut file.text, report);
        }
        self.file = Some(file);
        if report.model.steps.iter().any(|step| has_tables(&step.output)) {
            return Ok(());
        }
        self.finish()
    }

    /// What was understood, and of which job. A String takes any text.
    fn push_echo(&self, text: &mut String, report: &StepReport<'_>) {
        let _ = writeln!(text, "{}\n", heading(&self.version, &self.job.name()));
        if let Some(Origin { job, step, increment }) = &self.origin {
            let _ = writeln!(
                text,
                "goes on from job {job}, step {step}, increment {increment}; gaps and energies \
                 below are those of that state\n"
            );
        }
        text.push_str(&model_echo(report.model, &report.start));
    }

    fn tables(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return Ok(()) };
        let due = |request: &Request| {
            request.is_due(PrintTarget::is_table, frame.increment, frame.last_of_step)
        };
        let output = &step.output;
        for print in output.node_prints.iter().filter(|print| due(&print.request)) {
            push_nodes(&mut file.text, frame, print);
        }
        for print in output.element_prints.iter().filter(|print| due(&print.request)) {
            push_elements(&mut file.text, frame, print);
        }
        for print in output.contact_prints.iter().filter(|print| due(&print.request)) {
            push_contact(&mut file.text, frame, print);
        }
        file.flush()
    }

    fn finish(&mut self) -> Result<(), WriteError> {
        match self.file.take() {
            Some(file) => file.rename(&self.job.path(".dat")),
            None => Ok(()),
        }
    }
}

/// Whether anything is to be printed.
fn has_tables(output: &OutputRequests) -> bool {
    let nodes = output.node_prints.iter().map(|print| &print.request);
    let elements = output.element_prints.iter().map(|print| &print.request);
    let contact = output.contact_prints.iter().map(|print| &print.request);
    let mut all = nodes.chain(elements).chain(contact);
    all.any(|request| request.target.is_table() && request.frequency > 0)
}

impl Writer for Dat {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match event {
            Event::StepBegin(report) => self.begin(report),
            Event::Committed(frame) => self.tables(frame),
            Event::End(_) => self.finish(),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".dat", self.file.as_ref());
    }
}
