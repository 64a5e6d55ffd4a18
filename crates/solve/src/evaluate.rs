//! The pure evaluation of a trial state.
//!
//! ```text
//!   (plan, committed state, trial) --> forces, tangents, contact, trial history
//! ```
//!
//! The result depends on the arguments alone.

mod encounter;

use crate::constraints::Rows;
use crate::contact::{Before, ContactKinematics, Look, MasterPositions};
use crate::moments::turn_moments;
use crate::observe::results::Status;
use crate::problem::Problem;
use crate::stabilise::Dashpots;
use crate::state::{PointState, State};
use crate::structure::{Ambient, Configuration, Contributions, FailedElement, Flux};
use encounter::Encounter;
use slideline_mech::contact::enforcement::HeldMultiplier;
use slideline_mech::contact::friction::UserFrictionError;
use slideline_mech::contact::pair::UserState;
use slideline_mech::contact::tangential::Tangential;

/// A trial state.
#[derive(Clone, Copy, Debug)]
pub struct Trial<'a> {
    /// Displacements and rotations, a dof each [L or 1].
    pub u: &'a [f64],
    /// Applied loads, a dof each [F or F L].
    pub load: &'a [f64],
    /// Pressures on faces [F/L2].
    pub faces: &'a [f64],
    /// Stresses of every element as the iteration estimates them [F, F, F L].
    pub stresses: &'a [f64],
    /// Pressure of every contact point as the iteration estimates it [F/L2].
    pub pressures: &'a [f64],
    /// Traction of every contact point likewise [F/L2].
    pub tractions: &'a [Tangential],
    /// Face of its master on which every contact point stood in the last iteration, which holds it;
    /// empty: that of the last commit does.
    pub standing: &'a [Option<usize>],
    /// Multipliers about which laws are inserted, a contact point each; empty: they are not.
    pub held: &'a [HeldMultiplier],
    /// Dashpots of the increment, where contact is stabilised.
    pub dashpots: &'a Dashpots,
    /// Temperatures, and time of the materials.
    pub ambient: Ambient<'a>,
    /// Total time at the end of the increment [T].
    pub time: f64,
    /// Increment [T].
    pub dt: f64,
}

/// What an evaluation yields; every field is written, none is read.
#[derive(Clone, Debug, Default)]
pub struct Evaluation {
    /// Forces of the elements, each for itself.
    pub contributions: Contributions,
    /// Their tangents, summed: matrix values [F/L and the like].
    pub tangent: Vec<f64>,
    /// How dependent dofs follow the others here.
    pub rows: Rows,
    /// Internal forces of the elements less the loads, a dof each, those on
    /// dependent dofs handed to the ones that they follow [F or F L].
    pub structure: Vec<f64>,
    /// Forces of pressures on faces, a dof each [F]; empty where there are none.
    pub pressed: Vec<f64>,
    /// Contact forces likewise, with pressures of the law, and those of
    /// stabilisation [F or F L].
    pub contact: Vec<f64>,
    /// Forces of stabilisation alone [F or F L].
    pub damping: Vec<f64>,
    /// Where the contact points stand.
    pub kinematics: ContactKinematics,
    /// Their history, were this state committed.
    pub points: Vec<PointState>,
    /// Pressure and traction of every contact point that a law without a function takes as they
    /// are: the estimates of the trial, or what laws inserted about held multipliers say [F/L2].
    pub estimates: Vec<(f64, Tangential)>,
    /// Strain energy [F L].
    pub strain_energy: f64,
    /// Energy of the normal laws [F L].
    pub contact_energy: f64,
    /// Energy in elastic slip [F L].
    pub elastic_slip_energy: f64,
    /// Mean nodal forces.
    pub flux: Flux,
    /// Largest penetration of a hard contact [L].
    pub penetration: f64,
    /// Largest slip of a point that must not slip [L].
    pub stick_slip: f64,
    /// State values of user friction laws, were this state committed.
    pub state_variables: Vec<f64>,
    /// What a user friction law complained of.
    pub fault: Option<UserFrictionError>,
    /// An element that has no answer here; forces and tangent are those of the others.
    pub failed: Option<FailedElement>,
    /// What was seen of the points that iterations leave alone.
    pub look: Look,
    positions: MasterPositions,
}

impl Evaluation {
    /// Where the masters stand.
    pub fn positions(&self) -> &MasterPositions {
        &self.positions
    }

    /// Room for a problem, as if nothing had been evaluated before.
    pub fn fit(&mut self, plan: &Problem<'_>) {
        let (dofs, points) = (plan.dofs.len(), plan.contact.points.len());
        self.contributions.fit(plan.structure.numbering);
        zero(&mut self.tangent, plan.pattern.entries());
        for forces in [&mut self.structure, &mut self.contact, &mut self.damping] {
            zero(forces, dofs);
        }
        zero(&mut self.pressed, if plan.faces.is_empty() { 0 } else { dofs });
        plan.contact.forget(&mut self.kinematics);
        self.points.clear();
        self.points.resize(points, PointState::default());
        self.estimates.clear();
        self.estimates.resize(points, (0.0, Tangential::ZERO));
        zero(&mut self.state_variables, plan.contact.state_size);
        self.fault = None;
        self.failed = None;
        self.look.forget();
    }

    /// What nothing balances at a dof: forces of elements and of contact less
    /// the loads, those of dependent nodes with their masters; at a support its
    /// reaction. The one residual of convergence, line search, reactions and
    /// diagnosis [F or F L].
    pub fn unbalanced(&self, dof: usize) -> f64 {
        self.structure[dof] + self.contact[dof]
    }
}

/// So many zeros.
pub fn zero(list: &mut Vec<f64>, count: usize) {
    list.clear();
    list.resize(count, 0.0);
}

/// Evaluates a trial state against the committed one.
pub fn evaluate(plan: &Problem<'_>, committed: &State, trial: &Trial<'_>, into: &mut Evaluation) {
    evaluate_tangent(plan, committed, trial, into);
    balance(plan, committed, trial, into);
}

/// The same but for the tangents of the elements, which stay those of another state: where
/// nothing is asked but how well a trial is balanced. All else has the bits of [`evaluate`].
pub fn evaluate_forces(
    plan: &Problem<'_>,
    committed: &State,
    trial: &Trial<'_>,
    into: &mut Evaluation,
) {
    let at = configuration(committed, trial);
    plan.constraints.linearise((trial.u, trial.ambient.turns), &mut into.rows);
    plan.structure.evaluate_forces(&at, &mut into.contributions, plan.means.pool);
    into.failed = plan.structure.failed(&into.contributions);
    balance(plan, committed, trial, into);
}

/// What [`evaluate_forces`] leaves out.
pub fn evaluate_tangent(
    plan: &Problem<'_>,
    committed: &State,
    trial: &Trial<'_>,
    into: &mut Evaluation,
) {
    let at = configuration(committed, trial);
    plan.constraints.linearise((trial.u, trial.ambient.turns), &mut into.rows);
    let gather = plan.gather(&into.rows, &mut into.tangent);
    plan.structure.evaluate(&at, &mut into.contributions, gather, plan.means.pool);
    into.failed = plan.structure.failed(&into.contributions);
}

/// What the elements respond to.
fn configuration<'a>(committed: &'a State, trial: &Trial<'a>) -> Configuration<'a> {
    let (stresses, state) = (Some(trial.stresses), &committed.elements[..]);
    Configuration { u: trial.u, stresses, state, ambient: trial.ambient }
}

/// Forces of all that acts, those of the elements being there.
fn balance(plan: &Problem<'_>, committed: &State, trial: &Trial<'_>, into: &mut Evaluation) {
    into.structure.fill(0.0);
    into.strain_energy = plan.structure.gather_force(&into.contributions, &mut into.structure);
    into.flux = plan.structure.flux(&into.contributions);
    into.structure.iter_mut().zip(trial.load).for_each(|(force, load)| *force -= load);
    let at = (trial.u, trial.ambient.turns);
    turn_moments(plan, trial.load, at, |dof, beyond| into.structure[dof] -= beyond);
    if !plan.faces.is_empty() {
        into.pressed.fill(0.0);
        plan.faces.press(trial.faces, at, &mut into.pressed);
        into.structure.iter_mut().zip(&into.pressed).for_each(|(force, load)| *force -= load);
    }
    plan.constraints.carry(&into.rows, &mut into.structure);
    let Evaluation { kinematics, positions, look, .. } = into;
    plan.contact.find_idle(kinematics, (trial.u, trial.pressures), look);
    let before = Before::of(committed).held_by(trial.standing);
    plan.contact.locate((trial.u, before), &look.idle, positions, kinematics);
    let start = (&committed.displacement[..], &committed.points[..]);
    plan.contact.turn_away_from_behind(start, trial.u, kinematics);
    if !look.idle.contains(&true) {
        look.note(trial.u);
    }
    evaluate_contact(plan, committed, trial, into);
    into.damping.fill(0.0);
    let Evaluation { damping, flux, .. } = into;
    trial.dashpots.press(trial.u, &committed.displacement, damping, |force| flux.force(force));
    plan.constraints.carry(&into.rows, &mut into.contact);
    if !trial.dashpots.is_empty() {
        plan.constraints.carry(&into.rows, &mut into.damping);
        into.contact.iter_mut().zip(&into.damping).for_each(|(force, own)| *force += own);
    }
}

/// Looks at all points of a committed state, where they were last looked at
/// elsewhere: what an attempt leaves alone depends on that state only, however it
/// was reached.
pub fn look_at(plan: &Problem<'_>, committed: &State, into: &mut Evaluation) {
    let u = &committed.displacement[..];
    if into.look.is_at(u) {
        return;
    }
    let Evaluation { kinematics, positions, look, .. } = into;
    plan.contact.locate((u, Before::of(committed)), &[], positions, kinematics);
    plan.contact.turn_away_from_behind((u, &committed.points), u, kinematics);
    look.note(u);
}

/// Looks at the points that the evaluation left alone, at the same trial; says
/// whether none of them touches after all. If one does, all points are looked at
/// next.
pub fn complete(
    plan: &Problem<'_>,
    committed: &State,
    trial: &Trial<'_>,
    into: &mut Evaluation,
) -> bool {
    if !into.look.idle.contains(&true) {
        return true;
    }
    let Evaluation { kinematics, positions, look, .. } = into;
    let before = Before::of(committed).held_by(trial.standing);
    plan.contact.locate_idle((trial.u, before), &look.idle, positions, kinematics);
    let start = (&committed.displacement[..], &committed.points[..]);
    plan.contact.turn_away_from_behind(start, trial.u, kinematics);
    let mut open = true;
    for place in 0..plan.contact.points.len() {
        if into.look.idle[place] {
            let now = evaluate_point(plan, (committed, trial), place, into);
            // of a hard law the pressure is an estimate: the overclosure decides
            let pair = plan.contact.points[place].pair;
            let law = &plan.contact.laws_of(pair, &committed.points[place]).normal;
            open &= now.along.is_none() || -now.opening <= law.contact_begins();
            into.points[place] = now;
        }
    }
    match open {
        true => into.look.note(trial.u),
        false => into.look.forget(),
    }
    into.look.idle.fill(false);
    open
}

/// What the laws of a point make of kinematics that are there already, and of a slip that may be
/// known: its history, were the trial committed.
pub fn follow_laws(
    plan: &Problem<'_>,
    at: (&State, &Trial<'_>),
    (place, slip): (usize, Option<Tangential>),
    into: &mut Evaluation,
) {
    let slip = slip.unwrap_or_else(|| slip_of(plan, at.0, place, into));
    into.points[place] = evaluate_slipped(plan, at, (place, slip), into);
}

/// The slip of a point that has friction in a trial [L]. Without friction it is only told, and found at the
/// commit.
fn slip_of(plan: &Problem<'_>, committed: &State, place: usize, at: &Evaluation) -> Tangential {
    let (point, kinematics) = (&plan.contact.points[place], &at.kinematics.points()[place]);
    let before = &committed.points[place];
    match kinematics.faces && plan.contact.laws_of(point.pair, before).has_friction() {
        true => plan.contact.slip(place, &before.history(), kinematics, &committed.displacement),
        false => Tangential::ZERO,
    }
}

/// What a point does in a trial; writes its state variables of a user law.
fn evaluate_point(
    plan: &Problem<'_>,
    (committed, trial): (&State, &Trial<'_>),
    place: usize,
    into: &mut Evaluation,
) -> PointState {
    let slip = slip_of(plan, committed, place, into);
    evaluate_slipped(plan, (committed, trial), (place, slip), into)
}

/// The same with a slip that is known.
fn evaluate_slipped(
    plan: &Problem<'_>,
    (committed, trial): (&State, &Trial<'_>),
    (place, slip): (usize, Tangential),
    into: &mut Evaluation,
) -> PointState {
    let (point, kinematics) = (&plan.contact.points[place], &into.kinematics.points()[place]);
    let before = &committed.points[place];
    let laws = plan.contact.laws_of(point.pair, before);
    let estimate = (trial.pressures[place], trial.tractions[place]);
    let mut encounter = Encounter { plan, laws, before, kinematics, estimate, slip, dt: trial.dt };
    let range = point.state_variables..point.state_variables + point.state_size;
    let mut state_variables = UserState {
        time: trial.time,
        committed: &committed.state_variables[range.clone()],
        state: &mut into.state_variables[range],
        fault: &mut into.fault,
    };
    if let Some(held) = trial.held.get(place) {
        encounter.estimate = encounter.inserted(held, &mut state_variables);
    }
    into.estimates[place] = encounter.estimate;
    let now = encounter.follow(&mut state_variables);
    if laws.friction.needs_multiplier() && now.status == Status::Stick {
        into.stick_slip = into.stick_slip.max(slip.size());
    }
    now
}

fn evaluate_contact(
    plan: &Problem<'_>,
    committed: &State,
    trial: &Trial<'_>,
    into: &mut Evaluation,
) {
    into.contact.fill(0.0);
    into.contact_energy = 0.0;
    into.elastic_slip_energy = 0.0;
    into.penetration = 0.0;
    into.stick_slip = 0.0;
    into.fault = None;
    for (place, point) in plan.contact.points.iter().enumerate() {
        if into.look.idle[place] {
            continue;
        }
        if point.is_integration_point() && !into.kinematics.points()[place].faces {
            let (now, before) = (&mut into.points[place], &committed.points[place]);
            if !now.is_untouched() || before.ever_closed {
                now.open_from(before);
            }
            into.estimates[place] = (0.0, Tangential::ZERO);
            continue;
        }
        let now = evaluate_point(plan, (committed, trial), place, into);
        let laws = plan.contact.laws_of(point.pair, &committed.points[place]);
        let kinematics = into.kinematics.at(place);
        let (normal, tangential) = (now.area * now.pressure, now.area * now.traction);
        if now.closed {
            kinematics.push(normal, tangential, &mut into.contact);
            into.flux.force(normal.hypot(tangential.size()));
            into.contact_energy += now.area * laws.normal.energy(kinematics.overclosure);
            into.elastic_slip_energy += 0.5 * tangential.dot(now.elastic_slip);
        }
        if laws.normal.pressure(kinematics.overclosure).is_none() && kinematics.faces {
            let h = kinematics.overclosure;
            let defect = if now.closed { h.abs() } else { h.max(0.0) };
            let ways = (trial.u, &committed.displacement[..]);
            if h <= 0.0 || !plan.stands_held(place, (&kinematics, &into.rows), ways) {
                into.penetration = into.penetration.max(defect);
            }
        }
        into.points[place] = now;
    }
}
