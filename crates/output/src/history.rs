//! `JOB.history.csv`: motion and reaction of the nodes that drive the model
//! or that the deck names, a row per node and converged increment.

use crate::rows::{Rows, Sheet};
use slideline_model::{Dof, NodeIndex};
use slideline_solve::observe::{Frame, Nodal, StepReport};

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

/// `JOB.history.csv`.
#[derive(Default)]
pub(crate) struct History {
    nodes: Vec<NodeIndex>,
    columns: Vec<Column>,
}

impl Rows for History {
    const ENDING: &'static str = ".history.csv";

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        self.nodes = report.model.history_nodes();
        self.columns = columns(report.start.nodal.dofs());
        let names: Vec<&str> = self.columns.iter().map(|column| column.name()).collect();
        Some(format!("node,{}", names.join(",")))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for &node in &self.nodes {
            let values = self.columns.iter().map(|column| column.value(&frame.nodal, node));
            sheet.row().cell(frame.model.nodes.label(node)).numbers(values).end();
        }
    }
}
