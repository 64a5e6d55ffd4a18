//! Iterations, attempts, the tangent and the counts of a run, as they are told.

use serde::{Deserialize, Serialize};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_model::{Dof, NodeIndex};

/// One Newton iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct IterationReport {
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1.
    pub increment: usize,
    /// Attempt number from 1.
    pub attempt: usize,
    /// Iteration number from 1 within the attempt.
    pub iteration: usize,
    /// Whether contact changed in it (a severe discontinuity iteration).
    pub severe: bool,
    /// Equilibrium iterations so far (severe ones not counted).
    pub equilibrium: usize,
    /// Points whose contact changed: pair, node, now closed.
    pub contact_changes: Vec<ContactChange>,
    /// Points closed now.
    pub closed: usize,
    /// Force field.
    pub force: FieldReport,
    /// Moment field.
    pub moment: FieldReport,
    /// Largest disagreement between multiplier and law, as an overclosure [L].
    pub contact_defect: f64,
    /// Fraction of the correction that was taken [1].
    pub step_length: f64,
    /// How contact was solved in it.
    pub enforcement: Enforcement,
    /// Solutions with the factored stiffness that this took, where contact was
    /// solved without its matrix.
    pub solutions: usize,
    /// How often the attempt has moved its multipliers, where laws are inserted about them.
    pub moves: usize,
    /// Whether everything has converged.
    pub converged: bool,
}

/// A change of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContactChange {
    /// Place of the pair in the model.
    pub pair: usize,
    /// The slave node.
    pub node: NodeIndex,
    /// Whether it is closed now.
    pub closed: bool,
}

/// Convergence measures of one field (forces or moments).
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct FieldReport {
    /// Largest nodal residual [F or F L].
    pub residual: f64,
    /// Where.
    pub residual_at: Option<(NodeIndex, Dof)>,
    /// Time-averaged flux [F or F L].
    pub average: f64,
    /// What the residual is held against [F or F L].
    pub allowed: f64,
    /// Largest nodal correction of this iteration [L or 1].
    pub correction: f64,
    /// Where.
    pub correction_at: Option<(NodeIndex, Dof)>,
    /// Largest nodal increment so far [L or 1].
    pub increment: f64,
    /// Whether the field has converged.
    pub converged: bool,
}

/// An attempt that was given up.
#[derive(Clone, Debug, PartialEq)]
pub struct AttemptReport {
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1.
    pub increment: usize,
    /// Attempt number from 1.
    pub attempt: usize,
    /// Severe discontinuity iterations made.
    pub severe_iterations: usize,
    /// Equilibrium iterations made.
    pub equilibrium_iterations: usize,
    /// Total time that was aimed at [T].
    pub total_time: f64,
    /// Time in the step that was aimed at [T].
    pub step_time: f64,
    /// The increment [T].
    pub time_increment: f64,
    /// Why, in a few words.
    pub reason: String,
    /// The next increment to be tried [T]; `None`: the run ends here.
    pub next: Option<f64>,
}

/// Counts of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Totals {
    /// Converged increments of all steps.
    pub increments: usize,
    /// Failed attempts.
    pub cutbacks: usize,
    /// Newton iterations, failed attempts included.
    pub iterations: usize,
    /// Closed points whose friction was not called, summed over increments.
    pub dropped_points: usize,
}

/// The assembled tangent of a converged increment against differences of the
/// residual.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct TangentReport {
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1.
    pub increment: usize,
    /// Number of equations.
    pub equations: usize,
    /// Largest disagreement, in largest entries of its kind [1].
    pub off: f64,
    /// Row and column where it is; `None` without equations.
    pub at: Option<((NodeIndex, Dof), (NodeIndex, Dof))>,
    /// Label of an element that couples them.
    pub element: Option<u64>,
    /// Pair and slave node of a closed contact point that couples them.
    pub contact: Option<(usize, NodeIndex)>,
    /// The assembled entry [F/L and the like].
    pub assembled: f64,
    /// The same by differences.
    pub difference: f64,
}

impl TangentReport {
    /// The entry in words: nodes, dofs, and what couples them. `labels` are
    /// those of the nodes, `pairs` the names of the contact pairs.
    pub fn entry(&self, labels: &[u64], pairs: &[String]) -> String {
        let Some(((row, by_row), (column, by_column))) = self.at else {
            return "no entry".to_owned();
        };
        let label = |node: NodeIndex| labels.get(node).copied().unwrap_or_default();
        let (row, column) = (label(row), label(column));
        let mut text =
            format!("node {row} {} by node {column} {}", by_row.reaction_name(), by_column.name());
        if let Some(element) = self.element {
            text.push_str(&format!(", element {element}"));
        }
        if let Some((pair, node)) = self.contact {
            let name = pairs.get(pair).map_or("", String::as_str);
            text.push_str(&format!(", contact {name} node {}", label(node)));
        }
        text
    }
}
