//! Contact stabilisation: dashpots between slave points and their master that
//! fade to nothing by the end of the step.
//!
//! ```text
//!   slave o        p = c phi dh/dt           phi 1 |\
//!         #        tau = f c phi dsigma/dt         |  \
//!   ______#____                                    |____\ t
//!      master      along the committed a, b        0     T
//! ```
//!
//! docs/theory.md eqs (8.21) to (8.24). The directions are those of the
//! committed state, so that within an increment the dashpots are linear: their
//! tangent is exact, symmetric and never negative.

use crate::constraints::Rows;
use crate::contact::{Contact, ContactKinematics, MasterPositions, PointRows};
use crate::problem::Problem;
use crate::restraint::Restraint;
use crate::restraint::unopposed::{Opposing, Unopposed};
use crate::state::{PointState, State};
use slideline_mech::contact::tangential::Tangential;
use slideline_model::{Model, NodeIndex, Stabilisation};

/// Stiffness of all dashpots of a pair, walked in one increment as long as
/// the step, in stiffnesses EA/l of the stiffest element [1]. Bending is
/// softer than that by the square of the slenderness: about 1e-5.
const SHARE: f64 = 1e-7;

/// The dashpots of an increment.
#[derive(Clone, Debug, Default)]
pub struct Dashpots {
    each: Vec<Dashpot>,
    /// Where all points stand in the committed state.
    kinematics: ContactKinematics,
    positions: MasterPositions,
}

/// The dashpots of a point.
#[derive(Clone, Copy, Debug)]
struct Dashpot {
    place: usize,
    /// Force by the motion of the increment along the normal [F/L].
    normal: f64,
    /// And along the tangents [F/L].
    tangential: f64,
}

impl Dashpots {
    /// Forgets all, in the room they have.
    pub fn forget(&mut self, contact: &Contact) {
        self.each.clear();
        if !self.kinematics.points().is_empty() {
            contact.forget(&mut self.kinematics);
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.each.is_empty()
    }

    /// Adds the forces of having moved from `committed` to `u`, a dof each;
    /// says of each point how large they are together [F].
    pub fn press(&self, u: &[f64], committed: &[f64], into: &mut [f64], mut size: impl FnMut(f64)) {
        for dashpot in &self.each {
            let rows = self.kinematics.at(dashpot.place).rows;
            let along = |row: &[f64]| -> f64 {
                let each = rows.unknowns.iter().zip(row);
                each.map(|(&dof, g)| g * (u[dof] - committed[dof])).sum()
            };
            let mut push = |row: &[f64], force: f64| {
                rows.unknowns.iter().zip(row).for_each(|(&dof, g)| into[dof] += force * g);
            };
            let normal = dashpot.normal * along(rows.normal());
            push(rows.normal(), normal);
            let mut tangential = Tangential::ZERO;
            for direction in 0..rows.directions() {
                tangential.0[direction] = dashpot.tangential * along(rows.slip(direction));
                push(rows.slip(direction), tangential[direction]);
            }
            size(normal.hypot(tangential.size()));
        }
    }

    /// Sets all stiffnesses [F/L].
    #[cfg(test)]
    pub fn scale_to(&mut self, stiffness: f64) {
        for dashpot in &mut self.each {
            (dashpot.normal, dashpot.tangential) = (stiffness, stiffness);
        }
    }

    /// Adds their stiffness to the values of the pattern.
    pub fn stiffen(&self, plan: &Problem<'_>, rows: &Rows, values: &mut [f64]) {
        for dashpot in &self.each {
            let own = self.kinematics.at(dashpot.place).rows;
            let at = |i: usize, j: usize| {
                let along = |k: usize| dashpot.tangential * own.slip(k)[i] * own.slip(k)[j];
                let normal = dashpot.normal * own.normal()[i] * own.normal()[j];
                (0..own.directions()).map(along).fold(normal, |sum, along| sum + along)
            };
            plan.scatter(rows, own.unknowns, at, values);
        }
    }
}

/// What stabilises contact in a step: the deck's word, or the program's own
/// where it had to be switched on.
pub fn settings(plan: &Problem<'_>, committed: &State) -> Option<Stabilisation> {
    let own = committed.stabilised.then(|| Stabilisation::automatic(plan.step.origin));
    plan.step.stabilisation.or(own)
}

/// The dashpots of an increment of length `dt` that ends at `step_time`.
pub fn fill(
    plan: &Problem<'_>,
    committed: &State,
    (step_time, dt): (f64, f64),
    into: &mut Dashpots,
) {
    into.each.clear();
    let Some(settings) = settings(plan, committed) else { return };
    let fading = 1.0 - step_time / plan.step.procedure.period;
    if fading <= 0.0 || dt <= 0.0 {
        return;
    }
    let Dashpots { each, kinematics, positions } = into;
    if kinematics.points().len() != plan.contact.points.len() {
        *kinematics = plan.contact.nowhere();
    }
    plan.contact.stand(&committed.displacement, positions, kinematics);
    for (place, point) in kinematics.points().iter().enumerate() {
        let near = nearness(&settings, -point.overclosure);
        if !point.faces || near == 0.0 {
            continue;
        }
        let own = settings.coefficient;
        let coefficient = own.unwrap_or_else(|| automatic(plan, place, settings.factor));
        let normal = near * point.area * coefficient * fading / dt;
        each.push(Dashpot { place, normal, tangential: settings.tangent_fraction * normal });
    }
}

/// Within the range all, beyond it nothing, linear from its half on. (choice)
fn nearness(settings: &Stabilisation, gap: f64) -> f64 {
    match settings.range {
        Some(range) => (2.0 - 2.0 * gap / range).clamp(0.0, 1.0),
        None => 1.0,
    }
}

/// c of a pair [F T/L3]: soft against the stiffest element, yet stiff enough
/// that the loads of the step move a body that nothing else holds by no more
/// than the size of the model. (choice)
fn automatic(plan: &Problem<'_>, place: usize, factor: f64) -> f64 {
    let pair = plan.contact.points[place].pair;
    let own = plan.contact.points.iter().filter(|point| point.pair == pair);
    let area: f64 = own.map(|point| point.area).sum();
    let by_load = if plan.reach > 0.0 { plan.largest_load / plan.reach } else { 0.0 };
    let stiffness = (SHARE * plan.structure.stiffest).max(by_load);
    factor * stiffness * plan.step.procedure.period / area.max(f64::MIN_POSITIVE)
}

/// Force of a point that touches without pressing, in forces of the stiffest element stretched by
/// the size of the model: what rounding of its gap leaves, with a reserve [1].
const TOUCH: f64 = 4096.0 * f64::EPSILON;

/// Whether contact that was open at the last commit, or touched without pressing, would oppose a
/// motion if its points had dashpots; and no contact that pressed. Friction holds nothing where
/// nothing presses (7.1), yet will as soon as something does.
pub fn would_hold(plan: &Problem<'_>, committed: &State, mode: &[f64]) -> bool {
    let u = &committed.displacement;
    let mut kinematics = plan.contact.nowhere();
    plan.contact.stand(u, &mut MasterPositions::default(), &mut kinematics);
    let mut motion = vec![0.0; plan.dofs.len()];
    let mut rows = Rows::default();
    for (&dof, value) in plan.constraints.dof_of_equation.iter().zip(mode) {
        motion[dof] = *value;
    }
    plan.constraints.linearise((u, &committed.turns), &mut rows);
    plan.constraints.expand(&rows, &mut motion);
    let touch = TOUCH * plan.structure.stiffest * plan.reach;
    let mut holds = false;
    for (place, before) in committed.points.iter().enumerate() {
        if !moves(&kinematics.at(place), &motion) {
            continue;
        }
        if before.closed && before.pressure.abs() * before.area > touch {
            return false;
        }
        holds = true;
    }
    holds
}

/// A rigid motion of a body that neither supports nor contact oppose: contact without friction presses on it, or is open.
/// `now`: the points of an attempt that found no equilibrium.
pub fn unopposed(plan: &Problem<'_>, committed: &State, now: &[PointState]) -> Option<Unopposed> {
    let (u, mut kinematics) = (&committed.displacement, plan.contact.nowhere());
    plan.contact.stand(u, &mut MasterPositions::default(), &mut kinematics);
    let opposing = |(place, (before, now)): (usize, (&PointState, &PointState))| {
        let own = kinematics.at(place);
        let presses = before.closed || now.closed;
        if !own.faces && !presses {
            return None;
        }
        let terms = own.rows.unknowns.iter().zip(own.rows.normal()).map(|(&dof, &factor)| {
            let (node, way) = plan.dofs.name(dof);
            (node, way, factor)
        });
        let pair = plan.contact.parent(plan.contact.points[place].pair);
        let rubs = plan.contact.laws_of(pair, before).has_friction();
        Some(Opposing { terms: terms.collect(), presses, rubs })
    };
    let states = committed.points.iter().zip(now).enumerate();
    let points: Vec<Opposing> = states.filter_map(opposing).collect();
    if points.is_empty() {
        return None;
    }
    let place = |node: NodeIndex| {
        let (from, moved) = (plan.model.nodes.position(node), plan.dofs.translation(u, node));
        std::array::from_fn(|axis| from[axis] + moved[axis])
    };
    Restraint::of(plan.model, plan.step).unopposed((plan.model, plan.step), &points, place)
}

/// Whether a motion closes, opens or slides a point.
fn moves(kinematics: &PointRows<'_>, motion: &[f64]) -> bool {
    let rows = kinematics.rows;
    let slips = (0..rows.directions()).map(|direction| rows.slip(direction));
    let (mut most, mut sizes) = (0.0_f64, vec![0.0; rows.width()]);
    for row in std::iter::once(rows.normal()).chain(slips) {
        let moved: f64 = rows.unknowns.iter().zip(row).map(|(&dof, g)| g * motion[dof]).sum();
        most = most.max(moved.abs());
        sizes.iter_mut().zip(row).for_each(|(size, g)| *size += g.abs());
    }
    kinematics.faces && most > 1e-6 * sizes.into_iter().fold(0.0, f64::max)
}

/// Whether contact may be stabilised in some step: because the deck asks for
/// it, or because supports and springs to ground leave a body of a model with
/// contact some rigid motion.
pub fn may_stabilise(model: &Model) -> bool {
    model.steps.iter().any(|step| {
        let floats = !model.contact_pairs.is_empty() && Restraint::of(model, step).has_loose_body();
        step.stabilisation.is_some() || floats
    })
}
