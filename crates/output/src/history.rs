//! `JOB.history.csv`: motion and reaction of the nodes that drive the model
//! or that the deck names, a row per node and converged increment.

use crate::rows::{Rows, Sheet};
use slideline_model::{Dof, NodeIndex};
use slideline_results::{NodeComponent, NodeField};
use slideline_solve::observe::{Frame, StepReport};

/// Motions and reactions of the plane; those of space follow where the model
/// has them, so that the first columns never change.
pub fn columns(dofs: &[Dof]) -> Vec<NodeComponent> {
    let in_space = dofs.iter().any(|dof| !dof.is_plane());
    let space = if in_space { &[Dof::U3, Dof::UR1, Dof::UR2][..] } else { &[] };
    let of = |dofs: &[Dof]| -> Vec<NodeComponent> {
        let fields = [NodeField::Motion, NodeField::Reaction];
        fields.into_iter().flat_map(|field| field.components(dofs)).collect()
    };
    [of(&Dof::PLANE), of(space)].concat()
}

/// `JOB.history.csv`.
#[derive(Default)]
pub(crate) struct History {
    nodes: Vec<NodeIndex>,
    columns: Vec<NodeComponent>,
}

impl Rows for History {
    fn ending(&self) -> &'static str {
        ".history.csv"
    }

    fn columns(&mut self, report: &StepReport<'_>) -> Option<String> {
        self.nodes = report.model.history_nodes();
        self.columns = columns(report.start.nodal.dofs());
        let names: Vec<&str> = self.columns.iter().map(|column| column.name()).collect();
        Some(format!("node,{}", names.join(",")))
    }

    fn rows(&self, sheet: &mut Sheet<'_>, frame: &Frame<'_>) {
        for &node in &self.nodes {
            let values = self.columns.iter().map(|column| column.value(frame, node));
            sheet.row().cell(frame.model.nodes.label(node)).numbers(values).end();
        }
    }
}
