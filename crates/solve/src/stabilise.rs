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
use crate::contact::{ContactKinematics, MasterPositions};
use crate::linearised::MOST_DOFS;
use crate::problem::Problem;
use crate::restraint::Restraint;
use crate::state::State;
use slideline_model::{Model, Stabilisation};

/// Stiffness of all dashpots of a pair, walked in one increment as long as
/// the step, in stiffnesses EA/l of the stiffest element [1]. Bending is
/// softer than that by the square of the slenderness: about 1e-5.
const SHARE: f64 = 1e-7;

/// The dashpots of a point, within an increment.
#[derive(Clone, Copy, Debug)]
pub struct Dashpot {
    width: usize,
    dofs: [usize; MOST_DOFS],
    normal: [f64; MOST_DOFS],
    tangential: [f64; MOST_DOFS],
    /// Force by the motion of the increment, along the normal and along the
    /// tangent [F/L].
    stiffness: [f64; 2],
}

impl Dashpot {
    fn new(kinematics: &ContactKinematics, stiffness: [f64; 2]) -> Self {
        Self {
            width: kinematics.width,
            dofs: kinematics.dofs,
            normal: kinematics.gradient,
            tangential: kinematics.slip_gradient,
            stiffness,
        }
    }

    /// Adds the forces of having moved from `committed` to `u`, a dof each;
    /// says how large they are together [F].
    pub fn press(&self, u: &[f64], committed: &[f64], into: &mut [f64]) -> f64 {
        let (mut closing, mut sliding) = (0.0, 0.0);
        for (k, &dof) in self.dofs[..self.width].iter().enumerate() {
            let moved = u[dof] - committed[dof];
            closing += self.normal[k] * moved;
            sliding += self.tangential[k] * moved;
        }
        let (p, t) = (self.stiffness[0] * closing, self.stiffness[1] * sliding);
        for (k, &dof) in self.dofs[..self.width].iter().enumerate() {
            into[dof] += p * self.normal[k] + t * self.tangential[k];
        }
        p.hypot(t)
    }

    /// Sets both stiffnesses [F/L].
    #[cfg(test)]
    pub fn scale_to(&mut self, stiffness: f64) {
        self.stiffness = [stiffness; 2];
    }

    /// Adds its stiffness to the values of the pattern.
    pub fn stiffen(&self, plan: &Problem<'_>, rows: &Rows, values: &mut [f64]) {
        let at = |i: usize, j: usize| {
            self.stiffness[0] * self.normal[i] * self.normal[j]
                + self.stiffness[1] * self.tangential[i] * self.tangential[j]
        };
        plan.scatter(rows, &self.dofs[..self.width], at, values);
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
    positions: &mut MasterPositions,
    into: &mut Vec<Dashpot>,
) {
    into.clear();
    let Some(settings) = settings(plan, committed) else { return };
    let fading = 1.0 - step_time / plan.step.procedure.period;
    if fading <= 0.0 || dt <= 0.0 {
        return;
    }
    let u = &committed.displacement;
    plan.contact.place_chains(u, positions);
    for place in 0..plan.contact.points.len() {
        let kinematics = plan.contact.stand(place, u, positions);
        let near = nearness(&settings, -kinematics.overclosure);
        if !kinematics.faces || near == 0.0 {
            continue;
        }
        let own = settings.coefficient;
        let coefficient = own.unwrap_or_else(|| automatic(plan, place, settings.factor));
        let stiffness = near * kinematics.area * coefficient * fading / dt;
        into.push(Dashpot::new(&kinematics, [stiffness, settings.tangent_fraction * stiffness]));
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
    let load = plan.step.loads.iter().map(|load| load.value.abs()).fold(0.0, f64::max);
    let by_load = if plan.reach > 0.0 { load / plan.reach } else { 0.0 };
    let stiffness = (SHARE * plan.structure.stiffest).max(by_load);
    factor * stiffness * plan.step.procedure.period / area.max(f64::MIN_POSITIVE)
}

/// Whether contact that is open, and was so at the last commit, would oppose
/// a motion if its points had dashpots; and no contact that was closed.
pub fn would_hold(plan: &Problem<'_>, committed: &State, mode: &[f64]) -> bool {
    let mut positions = MasterPositions::default();
    let u = &committed.displacement;
    plan.contact.place_chains(u, &mut positions);
    let mut motion = vec![0.0; plan.dofs.len()];
    let mut rows = Rows::default();
    for (&dof, value) in plan.constraints.dof_of_equation.iter().zip(mode) {
        motion[dof] = *value;
    }
    plan.constraints.linearise(u, &mut rows);
    plan.constraints.expand(&rows, &mut motion);
    let mut holds = false;
    for (place, before) in committed.points.iter().enumerate() {
        let kinematics = plan.contact.stand(place, u, &positions);
        if !moves(&kinematics, &motion) {
            continue;
        }
        if before.closed {
            return false;
        }
        holds = true;
    }
    holds
}

/// Whether a motion closes, opens or slides a point.
fn moves(kinematics: &ContactKinematics, motion: &[f64]) -> bool {
    let (mut closing, mut sliding, mut size) = (0.0, 0.0, 0.0_f64);
    for k in 0..kinematics.width {
        closing += kinematics.gradient[k] * motion[kinematics.dofs[k]];
        sliding += kinematics.slip_gradient[k] * motion[kinematics.dofs[k]];
        size = size.max(kinematics.gradient[k].abs() + kinematics.slip_gradient[k].abs());
    }
    kinematics.faces && f64::max(closing.abs(), sliding.abs()) > 1e-6 * size
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
