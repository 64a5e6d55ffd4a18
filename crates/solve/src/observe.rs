//! What a run tells those who watch it.
//!
//! ```text
//!   run --> StepBegin --> Iteration, Iteration ... --> Committed(frame)
//!                     \-> Iteration ... --> AttemptFailed --> (again, shorter)
//!       --> Checkpoint --> ... --> Unconverged --> Diagnosed --> End
//! ```
//!
//! Observers borrow; nothing here owns a result. Files, tables, progress and
//! embedding programs are observers. Any of them may stop the run.

mod results;

use crate::checkpoint::Checkpoint;
use crate::dofs::DofMap;
use crate::stabilise::may_stabilise;
pub use results::{BeamRow, BlockResults, ContactRow, Energies, FrictionCall, PairRow, Status};
use serde::{Deserialize, Serialize};
use slideline_diag::Diagnostic;
use slideline_linalg::Description;
use slideline_mech::axes::{self, Axes};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::element::Temperature;
use slideline_model::{Dof, Model, NodeIndex};
use std::ops::ControlFlow;

/// Watches a run.
pub trait Observer {
    /// Takes note of an event; `Break` ends the run after it. What was
    /// committed stays valid.
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop>;
}

/// Why an observer stops a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The user asked for it.
    Interrupted,
    /// Results can no longer be written; the reason.
    OutputFailed(String),
}

/// What happens during a run.
#[derive(Debug)]
pub enum Event<'a> {
    /// A step begins; equations and how they are solved.
    StepBegin(&'a StepReport<'a>),
    /// An iteration was made and judged.
    Iteration(&'a IterationReport),
    /// An attempt at an increment was given up.
    AttemptFailed(&'a AttemptReport),
    /// An increment has converged.
    Committed(&'a Frame<'a>),
    /// The tangent of a converged increment was held against differences.
    Tangent(&'a TangentReport),
    /// An increment was told in full; the run could go on from here.
    Checkpoint(&'a Checkpoint<'a>),
    /// The last state of an increment that was not found, before its cause is
    /// told.
    Unconverged(&'a Unconverged<'a>),
    /// Something to be said about the run.
    Diagnosed(&'a Diagnostic),
    /// The run is over.
    End(&'a Ending),
}

/// The beginning of a step.
#[derive(Debug)]
pub struct StepReport<'a> {
    /// The model.
    pub model: &'a Model,
    /// Step number from 1.
    pub step: usize,
    /// Number of equations.
    pub equations: usize,
    /// Entries of the sparsity pattern.
    pub entries: usize,
    /// How the linear equations are solved; it says so in words.
    pub linear_solver: Description,
    /// Whether the tangent is treated as unsymmetric.
    pub unsymmetric: bool,
    /// Total time at the beginning [T].
    pub total_time: f64,
    /// The committed state at the beginning of the step (positions, initial
    /// contact); increment 0.
    pub start: Frame<'a>,
    /// Whether the run goes on in the step from a saved state: then `start`
    /// is that state, with its increment.
    pub resumed: bool,
}

impl StepReport<'_> {
    /// Whether contact may be stabilised in any step of the model.
    pub fn may_stabilise(&self) -> bool {
        may_stabilise(self.model)
    }
}

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

/// A committed state, borrowed.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The model.
    pub model: &'a Model,
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1; 0 for the start of a step.
    pub increment: usize,
    /// Attempts that were needed.
    pub attempt: usize,
    /// Severe discontinuity iterations.
    pub severe_iterations: usize,
    /// Equilibrium iterations.
    pub equilibrium_iterations: usize,
    /// Total time [T].
    pub total_time: f64,
    /// Time in the step [T].
    pub step_time: f64,
    /// The increment [T].
    pub time_increment: f64,
    /// Whether the step ends with it.
    pub last_of_step: bool,
    /// Nodal values.
    pub nodal: Nodal<'a>,
    /// One row per contact point of every pair, in order.
    pub contact: &'a [ContactRow],
    /// One row per contact pair; none at the start of a step.
    pub pairs: &'a [PairRow],
    /// Section results of the beams, block by block in element order.
    pub beams: &'a [BeamRow],
    /// Results of the elements of every block, as the fields of its type.
    pub elements: &'a [BlockResults],
    /// Energies.
    pub energy: Energies,
}

/// The state in which an attempt was given up, for viewing: no equilibrium.
#[derive(Clone, Copy, Debug)]
pub struct Unconverged<'a> {
    /// The state, as if it were one; energies count up to it.
    pub frame: Frame<'a>,
    pub(crate) residual: &'a [f64],
}

impl Unconverged<'_> {
    /// Force or moment at a node that nothing balances [F or F L].
    pub fn residual(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.frame.nodal.force(self.residual, node, dof)
    }

    /// The state with what is missing to equilibrium in place of its reactions.
    pub fn missing(&self) -> Frame<'_> {
        Frame { nodal: Nodal { reaction: self.residual, ..self.frame.nodal }, ..self.frame }
    }
}

/// Nodal vectors of a frame; dofs that a model does not have read zero.
#[derive(Clone, Copy, Debug)]
pub struct Nodal<'a> {
    pub(crate) dofs: &'a DofMap,
    /// Axes of the nodes that have their own.
    pub(crate) axes: &'a [Axes],
    pub(crate) displacement: &'a [f64],
    pub(crate) reaction: &'a [f64],
    pub(crate) load: &'a [f64],
    pub(crate) temperatures: &'a [Temperature],
}

impl Nodal<'_> {
    /// A force at a node along an axis of the model: what acts there and what acts along the own
    /// axes of the node.
    fn force(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        let plain = self.dofs.read(vector, node, dof);
        let Some((axes, own)) = self.own(vector, node, dof) else { return plain };
        let component = dof as usize % 3;
        plain + own.iter().zip(axes).map(|(own, axis)| own * axis[component]).sum::<f64>()
    }

    /// The same along an axis in which the dofs of the node are named.
    fn named_force(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        let Some((axes, own)) = self.own(vector, node, dof) else {
            return self.dofs.read(vector, node, dof);
        };
        let first = dof as usize - dof as usize % 3;
        let plain = std::array::from_fn(|k| self.dofs.read(vector, node, Dof::ALL[first + k]));
        own[dof as usize % 3] + axes::along(axes, plain)[dof as usize % 3]
    }

    /// Own axes of a node and the components along them of the vector that a dof belongs to.
    fn own(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> Option<(&Axes, [f64; 3])> {
        let axes = self.axes.get(self.dofs.place_of_turned(node)?)?;
        let first = dof as usize - dof as usize % 3;
        let read = |k: usize| {
            let own = self.dofs.named(node, Dof::ALL[first + k]);
            own.map_or(0.0, |own| vector[own])
        };
        Some((axes, std::array::from_fn(read)))
    }

    /// Displacement or rotation along an axis of the model [L or 1].
    pub fn displacement(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.dofs.read(self.displacement, node, dof)
    }

    /// Force or moment of the support on the model, along an axis of the model [F or F L]; zero
    /// where nothing is prescribed.
    pub fn reaction(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.force(self.reaction, node, dof)
    }

    /// Applied load along an axis of the model [F or F L].
    pub fn load(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.force(self.load, node, dof)
    }

    /// Temperature [theta].
    pub fn temperature(&self, node: NodeIndex) -> f64 {
        self.temperatures.get(node).map_or(0.0, |own| own.value)
    }

    /// Displacement, reaction and load along the axis in which the deck names the dof: that of
    /// the node where it has axes of its own.
    pub fn named(&self, node: NodeIndex, dof: Dof) -> [f64; 3] {
        let moved = self.dofs.named(node, dof).map_or(0.0, |own| self.displacement[own]);
        let [reaction, load] =
            [self.reaction, self.load].map(|list| self.named_force(list, node, dof));
        [moved, reaction, load]
    }

    /// Node, direction, displacement, reaction and load of every dof there is, along the axes of
    /// the model.
    pub fn all(&self) -> impl Iterator<Item = (NodeIndex, Dof, [f64; 3])> {
        let names = self.dofs.names().iter().take(self.dofs.plain()).enumerate();
        names.map(|(place, &(node, dof))| {
            let forces = match self.dofs.place_of_turned(node) {
                Some(_) => [self.reaction(node, dof), self.load(node, dof)],
                None => [self.reaction[place], self.load[place]],
            };
            (node, dof, [self.displacement[place], forces[0], forces[1]])
        })
    }

    /// Whether some node has a rotation.
    pub fn has_rotations(&self) -> bool {
        !self.dofs.rotations().is_empty()
    }

    /// The dofs that nodes of this model have.
    pub fn dofs(&self) -> &[Dof] {
        self.dofs.kinds()
    }
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// Every step was walked to its end.
    Completed(Totals),
    /// An increment could not be found; what was committed stays.
    NotConverged(Totals, Diagnostic),
    /// An observer stopped it.
    Stopped(Totals, Stop),
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
