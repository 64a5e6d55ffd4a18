//! The room of a step's iterations, and the linear systems that are kept.

use super::outcome::Outcome;
use super::relaxation::Relaxation;
use super::secants::Secants;
use crate::contact::{
    Candidates, Contact, ContactKinematics, GeometryScratch, MasterPositions, Reached, SweepScratch,
};
use crate::evaluate::{Evaluation, zero};
use crate::iteration_history::IterationHistory;
use crate::linear_systems::LinearSystems;
use crate::linearised::{HeldMultipliers, LinearPoints, LinearisedContact};
use crate::memory;
use crate::observe::reports::ContactChange;
use crate::plan::{Coupling, Numbering};
use crate::problem::Problem;
use crate::stabilise::Dashpots;
use crate::state::{PointState, State};
use crate::values::Values;
use slideline_diag::Diagnostic;
use slideline_linalg::{Interface, Kind, Solver, Use};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::element::Temperature;
use slideline_mech::material::Clock;
use slideline_mech::turn::Turn;
use slideline_model::Dof;

const TRANSLATIONS: [Dof; 3] = [Dof::U1, Dof::U2, Dof::U3];
const ROTATIONS: [Dof; 3] = [Dof::UR1, Dof::UR2, Dof::UR3];

/// Equations of a contact point that room is kept for.
const ROWS: usize = 18;

/// A linear system with the part of a plan that it is of.
pub(super) struct System {
    /// Index of the step's numbering.
    pub(super) step: usize,
    /// Its kind, and whether one that is unsymmetric is nearly symmetric.
    pub(super) kind: (Kind, bool),
    pub(super) coupling: Coupling,
    pub(super) solver: Solver,
    /// Why it is too large, if it is.
    pub(super) objection: Option<Diagnostic>,
}

/// The most linear systems that are kept, where memory holds them: contact that comes back
/// finds its own again.
const MOST_SYSTEMS: usize = 16;

/// Equations from which on a system is told the rigid motions of its unknowns.
const LARGE: usize = 50_000;

/// Scratch of a step's iterations.
#[derive(Default)]
pub struct Scratch {
    /// Trial displacements.
    pub u: Vec<f64>,
    /// Trial loads.
    pub load: Vec<f64>,
    /// The evaluation of the trial state.
    pub evaluation: Evaluation,
    /// Linear systems that were analysed; the one at hand is the last.
    pub(super) systems: Vec<System>,
    /// Parts of their masters that points may touch.
    pub(super) near: Vec<Candidates>,
    /// Positions of deforming masters.
    pub(super) positions: MasterPositions,
    /// The tangent without augmentation: without contact the room of the elements' tangents, which
    /// goes back to the evaluation.
    pub(super) values: Vec<f64>,
    /// The same with it; empty where there is none and the symmetric part is not asked for.
    pub(super) augmented: Vec<f64>,
    /// The dofs of every point that couples what the pattern does not hold.
    pub met: Vec<Vec<usize>>,
    /// How the condensed contact problem of the iteration is solved.
    pub(super) enforcement: Enforcement,
    /// Whether the rest of the attempt goes the dense way.
    pub(super) only_dense: bool,
    /// Pairs that the solution of the iteration opens: their geometry goes with their pressures.
    pub(super) opened: Vec<bool>,
    /// The increment [T].
    pub(super) dt: f64,
    pub(super) correction: Vec<f64>,
    pub(super) correction_dofs: Vec<f64>,
    pub(super) residual: Vec<f64>,
    /// Forces on dependent dofs with which the tangent turns, a dof each.
    pub(super) turning: Vec<f64>,
    /// Temperatures, a node each; empty: there are none.
    pub temperatures: Vec<Temperature>,
    /// What rotations in space count from, a node each; empty: all from rest.
    pub turns: Vec<Turn>,
    /// What the clock shows to the materials.
    pub clock: Clock,
    /// Pressures on faces [F/L2].
    pub(super) faces: Vec<f64>,
    /// Stresses of the elements as the linear solutions arrive at them.
    pub(super) stresses: Vec<f64>,
    pub(super) still: Vec<f64>,
    pub(super) arrived: Vec<f64>,
    pub(super) pressures: Vec<f64>,
    pub(super) tractions: Vec<Tangential>,
    /// Face of its master on which every contact point stood where the iteration began.
    pub(super) standing: Vec<Option<usize>>,
    /// Multipliers about which laws are inserted, a contact point each; none where they are not.
    pub(super) held: HeldMultipliers,
    /// How often they were moved in this attempt.
    pub(super) moves: usize,
    /// Largest change of a contact force when they were moved last [F].
    pub(super) last_move: f64,
    pub(super) points: LinearPoints,
    pub(super) contact: LinearisedContact,
    pub(super) geometry: GeometryScratch,
    pub(super) sweep: SweepScratch,
    pub(super) dashpots: Dashpots,
    /// What closed points pressed with at the last iteration, at the start the last commit [F].
    pub(super) pressed: Vec<Option<f64>>,
    /// Most negative pivots of a symmetric factorisation in this attempt:
    /// directions in which the structure gives way.
    pub negative_pivots: usize,
    /// Stiffness that holds loose bodies in an attempt, and in an iteration of it, in that of their own elements [1].
    pub(super) least_hold: f64,
    pub(super) hold: f64,
    /// Whether the last correction went along a motion that nothing holds.
    pub(super) thrown: bool,
    /// Whether the last iteration left so little that the next one is expected to find equilibrium.
    pub(super) nearly_there: bool,
    /// Whether the tangents of the elements are those of another trial.
    pub(super) tangent_is_behind: bool,
    /// Whether the factors at hand are of an iteration of this attempt.
    pub(super) factored: bool,
    /// What the iterations of this attempt showed of every contact point.
    pub iteration_history: IterationHistory,
    /// Whether corrections are shortened until they lessen the residual.
    pub line_search: bool,
    /// Fraction of the last correction that was taken [1].
    pub(super) step_length: f64,
    /// Whether every facing point augments its stiffness in this attempt.
    pub(super) augment_all: bool,
    /// The last iterations of this attempt.
    pub(super) secants: Secants,
    /// What holds the state back on its way downhill.
    pub(super) relaxation: Relaxation,
    /// The list of changes of the last report, to be used again.
    pub(super) changes: Vec<ContactChange>,
    /// Lists of changes, and states, that are no longer needed.
    pub(super) spare_changes: Vec<Vec<ContactChange>>,
    pub(super) spare: Vec<State>,
}

impl Scratch {
    /// Finds which contact is near in these states.
    pub fn find_near(&mut self, contact: &Contact, states: (&[f64], &[Reached], &[PointState])) {
        contact.candidates(states, &mut self.positions, &mut self.near);
    }

    /// Takes up the contact that was near where a run was left.
    pub fn recall_near(&mut self, candidates: &[Candidates]) {
        self.near.clear();
        self.near.extend_from_slice(candidates);
    }

    /// Finds the linear system of a step of the plan with the contact that is near, or analyses it:
    /// of a kind, and where that is unsymmetric nearly symmetric or not. Gives the coupling of its
    /// unknowns.
    pub fn couple(
        &mut self,
        (plan, own): (&Numbering, usize),
        (values, contact): (&Values, &Contact),
        kind: (Kind, bool),
        linear_systems: &LinearSystems,
    ) -> Coupling {
        let (systems, near) = (&mut self.systems, &self.near[..]);
        let fits = |system: &System| {
            (system.step, system.kind) == (own, kind) && *system.coupling.near == *near
        };
        match systems.iter().position(fits) {
            // the one at hand is the last
            Some(known) => systems[known..].rotate_left(1),
            None => {
                let step = &plan.steps[own];
                let constraints = &step.constraints;
                let coupling = step.coupling.clone().unwrap_or_else(|| {
                    let contact = (contact, near);
                    Coupling::new(&plan.elements, &step.dependent, constraints, contact)
                });
                let (symmetry, nearly_symmetric) = kind;
                let interface = Interface { equations: &coupling.interface, nearly_symmetric };
                let of = (&coupling.pattern, symmetry);
                let solver = Solver::analyse_for(of, linear_systems.factory(), &interface);
                let needed = memory::bytes(&solver.description());
                let kept = systems.iter().map(|system| memory::bytes(&system.solver.description()));
                let surplus = memory::to_drop(kept, needed);
                let first = surplus.max((systems.len() + 1).saturating_sub(MOST_SYSTEMS));
                systems.drain(..first);
                let objection = memory::factors_objection(&solver.description());
                systems.push(System { step: own, kind, coupling, solver, objection });
            }
        }
        let last = systems.len() - 1;
        let system = &mut systems[last];
        system.solver.set_units(&values.units[own]);
        system.coupling.clone()
    }

    /// Tells the linear system whether few solutions of every matrix are wanted, that it may be
    /// solved by iteration: not where contact asks for many. A large one is then told the rigid
    /// motions of its unknowns too.
    pub fn tell_use(&mut self, plan: &Problem<'_>) {
        let Some(system) = self.systems.last_mut() else { return };
        let few = plan.contact.points.is_empty();
        system.solver.set_use(if few { Use::Few } else { Use::Many });
        if plan.constraints.equations() < LARGE || !few {
            return;
        }
        system.solver.set_motions(&rigid_motions(plan));
        system.objection = memory::factors_objection(&system.solver.description());
    }

    /// The linear system of the problem at hand.
    pub fn solver(&mut self) -> &mut Solver {
        solver(&mut self.systems)
    }

    /// Why that system is too large, if it is.
    pub fn objection(&self) -> Option<Diagnostic> {
        self.systems.last().and_then(|system| system.objection.clone())
    }

    /// Positions of deforming masters, as scratch, and where contact points stand.
    pub fn places(&mut self) -> (&mut MasterPositions, &mut ContactKinematics) {
        (&mut self.positions, &mut self.evaluation.kinematics)
    }

    /// Gives the room of tangents that became the matrix back to the evaluation.
    pub(super) fn give_back(&mut self) {
        if self.evaluation.tangent.is_empty() {
            self.evaluation.tangent = std::mem::take(&mut self.values);
        }
    }

    /// Makes room for a problem, as if nothing had been solved before; the coupling must be
    /// that of [`Scratch::couple`].
    pub fn fit(&mut self, plan: &Problem<'_>) {
        let (dofs, equations) = (plan.dofs.len(), plan.constraints.equations());
        let (points, entries) = (plan.contact.points.len(), plan.pattern.entries());
        self.give_back();
        self.evaluation.fit(plan);
        let by_dof = [
            &mut self.u,
            &mut self.load,
            &mut self.correction_dofs,
            &mut self.residual,
            &mut self.turning,
            &mut self.still,
        ];
        by_dof.into_iter().for_each(|list| zero(list, dofs));
        let is_changed = points > 0 || plan.symmetrised();
        zero(&mut self.values, if points > 0 { entries } else { 0 });
        zero(&mut self.augmented, if is_changed { entries } else { 0 });
        for list in [&mut self.stresses, &mut self.arrived] {
            zero(list, plan.structure.stress_room());
        }
        zero(&mut self.pressures, points);
        self.tractions.clear();
        self.tractions.resize(points, Tangential::ZERO);
        self.standing.clear();
        self.standing.resize(points, None);
        self.held.fit(points);
        zero(&mut self.correction, equations);
        self.points.clear(plan.contact.directions);
        self.points.reserve(points, ROWS);
        self.contact.reserve(points, equations);
        self.pressed.clear();
        self.pressed.resize(points, None);
        self.opened.clear();
        self.opened.resize(plan.contact.slave_nodes.len(), false);
        self.iteration_history.fit(points);
        self.dashpots.forget(plan.contact);
        self.met.clear();
        (self.only_dense, self.augment_all) = (false, false);
        (self.line_search, self.negative_pivots) = (false, 0);
        (self.step_length, self.dt, self.clock) = (1.0, 0.0, Clock::default());
        self.enforcement = Enforcement::default();
        self.relaxation.stiffness = 0.0;
    }

    /// A copy of a state, in the room of one that is no longer needed.
    pub fn copy(&mut self, state: &State) -> State {
        let mut copy = self.spare.pop().unwrap_or_default();
        copy.copy_from(state);
        copy
    }

    /// Keeps the room of a state that is no longer needed.
    pub fn spare(&mut self, state: State) {
        self.spare.push(state);
    }

    /// Takes the room of an attempt back, that the next one allocates nothing.
    pub fn take_back(&mut self, outcome: Outcome) {
        self.spare_changes.extend(outcome.last.map(|last| last.contact_changes));
    }
}

/// Rigid motions of the unknowns where the step begins, column after column: translations along
/// and turns about the axes that the model has.
fn rigid_motions(plan: &Problem<'_>) -> Vec<f64> {
    let moved: Vec<(Dof, [f64; 3])> = plan
        .constraints
        .dof_of_equation
        .iter()
        .map(|&dof| {
            let (node, kind) = plan.dofs.name(dof);
            let from = plan.model.nodes.position(node);
            let way = plan.dofs.translation(&plan.start.displacement, node);
            (kind, std::array::from_fn(|axis| from[axis] + way[axis]))
        })
        .collect();
    let mut motions = Vec::with_capacity(6 * moved.len());
    let mut add = |of: &dyn Fn(Dof, [f64; 3]) -> f64| {
        let begin = motions.len();
        motions.extend(moved.iter().map(|&(kind, place)| of(kind, place)));
        if motions[begin..].iter().all(|&value| value == 0.0) {
            motions.truncate(begin);
        }
    };
    for own in TRANSLATIONS {
        add(&|kind, _| f64::from(u8::from(kind == own)));
    }
    for (axis, own) in ROTATIONS.into_iter().enumerate() {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        add(&|kind, place| match kind {
            kind if kind == TRANSLATIONS[next] => -place[last],
            kind if kind == TRANSLATIONS[last] => place[next],
            kind => f64::from(u8::from(kind == own)),
        });
    }
    motions
}

/// The linear system that was found last.
pub(super) fn solver(systems: &mut [System]) -> &mut Solver {
    let last = systems.len() - 1;
    &mut systems[last].solver
}
