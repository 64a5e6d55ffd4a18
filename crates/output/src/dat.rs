//! `JOB.dat`: the echo of what was understood, then the printed tables.

use crate::echo::model_echo;
use crate::file::{Growing, WriteError, beside};
use crate::history::Column;
use crate::job::JobFiles;
use crate::restart::{Kept, Origin};
use crate::summary::Facts;
use crate::tables::{push_contact, push_elements, push_title};
use crate::writers::Writer;
use slideline_model::{Dof, NodeIndex, NodePrint, NodeVariable, OutputRequests, PrintTarget};
use slideline_solve::observe::{Event, Frame, StepReport};
use std::fmt::Write as _;

/// Writes `JOB.dat`. Tables wait in a file beside it until the run is over;
/// a deck without tables has its file at once.
pub(crate) struct Dat {
    job: JobFiles,
    version: String,
    /// The state that the job goes on from, if it does.
    origin: Option<Origin>,
    file: Option<Growing>,
    begun: bool,
}

impl Dat {
    pub fn new(job: &JobFiles, facts: &Facts<'_>) -> Self {
        let origin = facts.earlier.map(|earlier| earlier.origin.clone());
        let version = facts.version.to_owned();
        Self { job: job.clone(), version, origin, file: None, begun: false }
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
        // A String takes any text.
        let _ = writeln!(file.text, "slideline {}   job {}\n", self.version, self.job.name());
        if let Some(Origin { job, step, increment }) = &self.origin {
            let _ = writeln!(
                file.text,
                "goes on from job {job}, step {step}, increment {increment}; gaps and energies \
                 below are those of that state\n"
            );
        }
        file.text.push_str(&model_echo(report.model, &report.start));
        self.file = Some(file);
        if report.model.steps.iter().any(|step| has_tables(&step.output)) {
            return Ok(());
        }
        self.finish()
    }

    fn tables(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let Some(file) = &mut self.file else { return Ok(()) };
        let Some(step) = frame.model.steps.get(frame.step - 1) else { return Ok(()) };
        let due = |target, frequency: usize| {
            target == PrintTarget::Table
                && (frame.increment.is_multiple_of(frequency.max(1)) || frame.last_of_step)
        };
        let output = &step.output;
        for print in output.node_prints.iter().filter(|p| due(p.target, p.frequency)) {
            push_table(&mut file.text, frame, print);
        }
        for print in output.element_prints.iter().filter(|p| due(p.target, p.frequency)) {
            push_elements(&mut file.text, frame, print);
        }
        for print in output.contact_prints.iter().filter(|p| due(p.target, p.frequency)) {
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
    let nodes = output.node_prints.iter().map(|print| print.target);
    let elements = output.element_prints.iter().map(|print| print.target);
    let contact = output.contact_prints.iter().map(|print| print.target);
    nodes.chain(elements).chain(contact).any(|target| target == PrintTarget::Table)
}

/// A column of a printed table.
enum Printed {
    Nodal(Column),
    Load(Dof),
    Coordinate(Dof),
}

impl Printed {
    fn of(variable: NodeVariable, dofs: &[Dof]) -> Vec<Self> {
        let all = dofs.iter().copied();
        match variable {
            NodeVariable::U => all.map(|dof| Self::Nodal(Column::Motion(dof))).collect(),
            NodeVariable::RF => all.map(|dof| Self::Nodal(Column::Reaction(dof))).collect(),
            NodeVariable::CF => all.map(Self::Load).collect(),
            NodeVariable::COORD => {
                all.filter(|dof| !dof.is_rotation()).map(Self::Coordinate).collect()
            }
        }
    }

    fn name(&self) -> &'static str {
        match self {
            Self::Nodal(column) => column.name(),
            Self::Load(dof) => ["CF1", "CF2", "CF3", "CM1", "CM2", "CM3"][dof.number() - 1],
            Self::Coordinate(dof) => ["COOR1", "COOR2", "COOR3"][dof.number() - 1],
        }
    }

    fn value(&self, frame: &Frame<'_>, node: NodeIndex) -> f64 {
        match *self {
            Self::Nodal(column) => column.value(&frame.nodal, node),
            Self::Load(dof) => frame.nodal.load(node, dof),
            Self::Coordinate(dof) => {
                frame.model.nodes.get(node).position[dof.number() - 1]
                    + frame.nodal.displacement(node, dof)
            }
        }
    }
}

/// A String takes any text.
fn push_table(text: &mut String, frame: &Frame<'_>, print: &NodePrint) {
    let dofs = frame.nodal.dofs();
    let columns: Vec<Printed> =
        print.variables.iter().flat_map(|&variable| Printed::of(variable, dofs)).collect();
    let set = if print.set.is_empty() { "all nodes" } else { &print.set };
    push_title(text, frame, &format!("NODES {set}"));
    let _ = write!(text, "{:>10}", "NODE");
    for column in &columns {
        let _ = write!(text, " {:>15}", column.name());
    }
    text.push('\n');
    for &node in &print.nodes {
        let _ = write!(text, "{:>10}", frame.model.nodes.label(node));
        for column in &columns {
            let _ = write!(text, " {:>15.7e}", column.value(frame, node));
        }
        text.push('\n');
    }
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
