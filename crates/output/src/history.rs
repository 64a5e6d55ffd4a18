//! `JOB.history.csv`: motion and reaction of the nodes that drive the model
//! or that the deck names, a row per node and converged increment.

use crate::file::{Growing, WriteError};
use crate::job::JobFiles;
use crate::number::push_shortest;
use crate::restart::Kept;
use crate::writers::Writer;
use slideline_model::{Dof, Model, NodeIndex};
use slideline_solve::observe::{Event, Frame, Nodal};
use std::fmt::Write as _;

/// A column of nodal values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Column {
    Motion(Dof),
    Reaction(Dof),
}

impl Column {
    /// `U2`, `RF2` ...
    pub fn name(self) -> &'static str {
        match self {
            Self::Motion(dof) => dof.name(),
            Self::Reaction(dof) => dof.reaction_name(),
        }
    }

    /// Its value at a node.
    pub fn value(self, nodal: &Nodal<'_>, node: NodeIndex) -> f64 {
        match self {
            Self::Motion(dof) => nodal.displacement(node, dof),
            Self::Reaction(dof) => nodal.reaction(node, dof),
        }
    }
}

/// Motions and reactions of the plane; those of space follow where the model
/// has them, so that the first columns never change.
pub(crate) fn columns(dofs: &[Dof]) -> Vec<Column> {
    let of = |dofs: Vec<Dof>| {
        let motions: Vec<Column> = dofs.iter().copied().map(Column::Motion).collect();
        motions.into_iter().chain(dofs.into_iter().map(Column::Reaction))
    };
    let space = dofs.iter().copied().filter(|dof| !dof.is_plane()).collect();
    of(Dof::PLANE.to_vec()).chain(of(space)).collect()
}

/// Writes `JOB.history.csv`.
pub(crate) struct History {
    job: JobFiles,
    open: Option<Open>,
}

struct Open {
    file: Growing,
    nodes: Vec<NodeIndex>,
    columns: Vec<Column>,
}

impl History {
    pub fn new(job: &JobFiles) -> Self {
        Self { job: job.clone(), open: None }
    }

    fn begin(&mut self, model: &Model, dofs: &[Dof]) -> Result<(), WriteError> {
        if self.open.is_some() {
            return Ok(());
        }
        let columns = columns(dofs);
        let mut heading = String::from("step,increment,time,node");
        for column in &columns {
            heading.push(',');
            heading.push_str(column.name());
        }
        heading.push('\n');
        let file = Growing::begin(&self.job, ".history.csv", &heading)?;
        self.open = Some(Open { file, nodes: model.history_nodes(), columns });
        Ok(())
    }
}

impl Open {
    fn rows(&mut self, frame: &Frame<'_>) -> Result<(), WriteError> {
        let text = &mut self.file.text;
        for &node in &self.nodes {
            push_time(text, frame);
            let _ = write!(text, "{}", frame.model.nodes.label(node)); // a String takes any text
            for column in &self.columns {
                text.push(',');
                push_shortest(text, column.value(&frame.nodal, node));
            }
            text.push('\n');
        }
        self.file.flush()
    }
}

/// `step,increment,time,` as every CSV row begins.
pub(crate) fn push_time(text: &mut String, frame: &Frame<'_>) {
    let _ = write!(text, "{},{},", frame.step, frame.increment); // a String takes any text
    push_shortest(text, frame.total_time);
    text.push(',');
}

impl Writer for History {
    fn event(&mut self, event: &Event<'_>) -> Result<(), WriteError> {
        match (event, &mut self.open) {
            (Event::StepBegin(step), _) => self.begin(step.model, step.start.nodal.dofs()),
            (Event::Committed(frame), Some(open)) => open.rows(frame),
            _ => Ok(()),
        }
    }

    fn keep(&self, kept: &mut Kept) {
        kept.file(".history.csv", self.open.as_ref().map(|open| &open.file));
    }
}
