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

use crate::checkpoint::Checkpoint;
use crate::dofs::DofMap;
use crate::stabilise::may_stabilise;
use serde::{Deserialize, Serialize};
use slideline_diag::Diagnostic;
use slideline_linalg::Description;
use slideline_mech::contact::enforcement::Enforcement;
use slideline_model::{BeamSection, Dof, Element, Model, NodeIndex};
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
        self.frame.nodal.read(self.residual, node, dof)
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
    pub(crate) displacement: &'a [f64],
    pub(crate) reaction: &'a [f64],
    pub(crate) load: &'a [f64],
}

impl Nodal<'_> {
    fn read(&self, vector: &[f64], node: NodeIndex, dof: Dof) -> f64 {
        self.dofs.read(vector, node, dof)
    }

    /// Displacement or rotation [L or 1].
    pub fn displacement(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.read(self.displacement, node, dof)
    }

    /// Force or moment of the support on the model [F or F L]; zero where
    /// nothing is prescribed.
    pub fn reaction(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.read(self.reaction, node, dof)
    }

    /// Applied load [F or F L].
    pub fn load(&self, node: NodeIndex, dof: Dof) -> f64 {
        self.read(self.load, node, dof)
    }

    /// Node, direction, displacement, reaction and load of every dof there is.
    pub fn all(&self) -> impl Iterator<Item = (NodeIndex, Dof, [f64; 3])> {
        let values = self.displacement.iter().zip(self.reaction).zip(self.load);
        let values =
            values.map(|((&displacement, &reaction), &load)| [displacement, reaction, load]);
        self.dofs.names().iter().zip(values).map(|(&(node, dof), values)| (node, dof, values))
    }

    /// The dofs that nodes of this model have.
    pub fn dofs(&self) -> &[Dof] {
        self.dofs.kinds()
    }
}

/// Contact status of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Status {
    /// No pressure.
    #[default]
    Open,
    /// Pressure, no sliding.
    Stick,
    /// Pressure, sliding (also a closed point without friction).
    Slip,
}

impl Status {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Stick => "stick",
            Self::Slip => "slip",
        }
    }
}

/// Whether friction acted at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum FrictionCall {
    /// Open, or frictionless.
    #[default]
    None,
    /// Called.
    Called,
    /// Closed with friction, but the onset did not call it.
    Dropped,
}

impl FrictionCall {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Called => "called",
            Self::Dropped => "dropped",
        }
    }
}

/// A contact point in a committed state.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ContactRow {
    /// Place of the pair in the model.
    pub pair: usize,
    /// The slave node.
    pub node: NodeIndex,
    /// Open, stick or slip.
    pub status: Status,
    /// Whether it is or ever was closed.
    pub ever_closed: bool,
    /// Gap, open positive [L]; infinite where the point faces no master.
    pub opening: f64,
    /// Contact pressure [F/L2].
    pub pressure: f64,
    /// Shear traction along the master's direction of travel [F/L2].
    pub shear: f64,
    /// Accumulated slip along it while closed [L].
    pub slip: f64,
    /// Tributary area [L2].
    pub area: f64,
    /// Whether friction was called.
    pub friction: FrictionCall,
    /// Current position of the point [L].
    pub position: [f64; 3],
    /// Outward normal of the master there [1].
    pub normal: [f64; 3],
    /// Place on the master along its direction of travel [L].
    pub along: f64,
    /// Friction work that this increment dropped [F L]; see the ledger.
    pub dropped_work: f64,
}

/// A contact pair in a committed state.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct PairRow {
    /// Rows of its points that are closed.
    pub closed: usize,
    /// Rows that opened or closed in the increment.
    pub changes: usize,
    /// Deepest overclosure of a closed point [L]; zero without.
    pub penetration: f64,
    /// Its node.
    pub deepest: Option<NodeIndex>,
    /// Sum of the forces on the slaves [F].
    pub force: [f64; 3],
    /// Their moment about the origin [F L].
    pub moment: [f64; 3],
    /// What is left of all forces on slaves, masters and reference nodes
    /// together, relative to the sum of their magnitudes [1]: rounding.
    pub force_imbalance: f64,
    /// The same of moments [1].
    pub moment_imbalance: f64,
}

/// Section results of a beam element at its middle.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct BeamRow {
    /// Element label.
    pub label: u64,
    /// Its nodes.
    pub nodes: [NodeIndex; 2],
    /// Axial force N [F].
    pub axial_force: f64,
    /// Shear force V [F].
    pub shear_force: f64,
    /// Bending moment M [F L].
    pub bending_moment: f64,
    /// Axial strain, shear strain [1], curvature [1/L].
    pub strains: [f64; 3],
    /// Largest fibre strain, |axial| + |curvature| height / 2 [1].
    pub fibre_strain: f64,
}

impl BeamRow {
    /// That of a beam of a section with its results, in the order of its fields.
    pub(crate) fn of(beam: Element<'_>, section: &BeamSection, values: &[f64]) -> Self {
        let at = |place: usize| values.get(place).copied().unwrap_or_default();
        let strains = [at(3), at(4), at(5)];
        Self {
            label: beam.label,
            nodes: beam.ends(),
            axial_force: at(0),
            shear_force: at(1),
            bending_moment: at(2),
            strains,
            fibre_strain: strains[0].abs() + strains[2].abs() * (0.5 * section.height),
        }
    }
}

/// Results of the elements of a block. Elements that belong to one rigid body have
/// none.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct BlockResults {
    /// Index of the block in the model.
    pub block: usize,
    /// Index in the block of each element that has results.
    pub members: Vec<usize>,
    /// Values, element by element, each in the order of the fields of its type.
    pub values: Vec<f64>,
}

impl BlockResults {
    /// The elements with all their values.
    pub fn elements<'a>(
        &'a self,
        model: &'a Model,
    ) -> impl Iterator<Item = (Element<'a>, &'a [f64])> {
        let block = model.blocks.get(self.block);
        let width = block.map_or(1, |block| block.kind.all_values().max(1));
        let values = self.values.chunks_exact(width);
        block.into_iter().flat_map(move |block| {
            let members = self.members.iter().map(|&member| block.elements.get(member));
            members.zip(values.clone())
        })
    }
}

/// Energies since time 0 [F L].
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Energies {
    /// Work of supports and loads, trapezoidal rule over each increment.
    pub external_work: f64,
    /// Strain energy of the elements.
    pub strain_energy: f64,
    /// Energy of the contact laws.
    pub contact_energy: f64,
    /// Dissipated by sliding.
    pub friction_dissipation: f64,
    /// Stored in elastic slip.
    pub friction_elastic: f64,
    /// Friction work that the onset dropped (the ledger).
    pub dropped_friction: f64,
    /// Dissipated by contact stabilisation.
    pub stabilisation: f64,
    /// Released where the structure jumped to another equilibrium.
    pub released_energy: f64,
    /// External work minus the change of everything else since the first
    /// converged state.
    pub balance: f64,
}

impl Energies {
    /// What is stored, dissipated or released: where the work went.
    pub fn taken(&self) -> f64 {
        self.strain_energy
            + self.contact_energy
            + self.friction_elastic
            + self.friction_dissipation
            + self.stabilisation
            + self.released_energy
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
