//! Multipliers that are held while laws are inserted about them.
//!
//! ```text
//!   lambda held:  Newton on r(u) + sum A P(h(u) + lambda/kappa) a = 0
//!                      |
//!                      v   what is unbalanced is less than what lambda would change
//!   lambda := p   ... until p is what the law says at the overclosure itself
//! ```
//!
//! docs/theory.md section 8.15. Penalty is the same without multipliers: nothing stands between
//! trial and law, and nothing is moved.

use super::scratch::{Scratch, solver};
use crate::convergence::largest_nodal;
use crate::linearised::{LawContext, Stiffness};
use crate::problem::Problem;
use crate::state::State;
use slideline_linalg::{FactorReport, SolveError};
use slideline_mech::contact::enforcement::{Enforcement, HeldMultiplier};

/// Part of the last change of the multipliers that the next one should not exceed [1]; where it
/// does, they are brought nearer to their laws,
const SLOW: f64 = 0.25;
/// by this factor.
const STIFFER: f64 = 10.0;
/// How often the multipliers of an attempt may be moved.
pub(super) const MOST_MOVES: usize = 100;

impl Scratch {
    /// Holds the multipliers of the committed state; those of integration points, which move along
    /// their elements, nowhere.
    pub(super) fn hold_multipliers(&mut self, plan: &Problem<'_>) {
        (self.moves, self.last_move) = (0, 0.0);
        if !plan.inserts_laws() {
            return self.held.hold(std::iter::empty());
        }
        let augmented = plan.enforcement == Some(Enforcement::Augmented);
        let points = plan.contact.points.iter().zip(&self.pressures).zip(&self.tractions);
        let multipliers = points.map(|((point, &pressure), &traction)| {
            match augmented && !point.is_integration_point() {
                true => HeldMultiplier {
                    pressure,
                    traction,
                    // those of the structure, once its stiffness is known
                    normal_stiffness: 0.0,
                    tangential_stiffness: 0.0,
                },
                false => HeldMultiplier::NONE,
            }
        });
        self.held.hold(multipliers);
    }

    /// Takes the pressures and tractions of the evaluation as estimates: the tangent is that of the
    /// trial itself.
    pub(super) fn follow_inserted_laws(&mut self) {
        for (place, &(pressure, traction)) in self.evaluation.estimates.iter().enumerate() {
            if !self.evaluation.look.idle[place] {
                (self.pressures[place], self.tractions[place]) = (pressure, traction);
            }
        }
    }

    /// Factors the tangent with the slopes of the laws in it.
    pub(super) fn factor_inserted(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
    ) -> Result<FactorReport, SolveError> {
        let context = context(plan, committed, self.dt);
        let Self { contact, values, augmented, systems, points, held, .. } = self;
        let (pattern, symmetrised, solver) = (plan.pattern, plan.symmetrised(), solver(systems));
        let mut stiffness = Stiffness { pattern, values, augmented, solver, symmetrised };
        contact.insert(points, &context, held, &mut stiffness)
    }

    /// Moves the multipliers to the pressures and tractions found, once less is unbalanced than
    /// that changes, or than is `allowed` [F]. Says whether they moved.
    pub(super) fn move_multipliers(&mut self, plan: &Problem<'_>, allowed: f64) -> bool {
        if plan.enforcement != Some(Enforcement::Augmented) {
            return false;
        }
        let change = self.change_of_multipliers();
        if change == 0.0 || self.unbalanced_by_estimates(plan) > change.max(allowed) {
            return false;
        }
        for (place, held) in self.held.of.iter_mut().enumerate() {
            (held.pressure, held.traction) = (self.pressures[place], self.tractions[place]);
        }
        if self.moves > 0 && change > SLOW * self.last_move {
            self.held.stiffen(STIFFER);
        }
        self.last_move = change;
        self.moves += 1;
        true
    }

    /// Largest change of a contact force if the multipliers moved [F].
    fn change_of_multipliers(&self) -> f64 {
        let points = self.held.of.iter().zip(self.evaluation.kinematics.points());
        let estimates = self.pressures.iter().zip(&self.tractions);
        let change = points.zip(estimates).map(|((held, point), (pressure, &traction))| {
            // a multiplier without a stiffness counts for nothing
            let by = |kappa: f64, change: f64| if kappa.is_finite() { change } else { 0.0 };
            let normal = by(held.normal_stiffness, pressure - held.pressure);
            let tangential = (traction - held.traction).size();
            point.area * normal.hypot(by(held.tangential_stiffness, tangential))
        });
        change.fold(0.0, f64::max)
    }

    /// Largest nodal force that is unbalanced under the estimated pressures and tractions [F]: the
    /// residual that Newton's method works on, which for a soft law is not that of the law.
    fn unbalanced_by_estimates(&mut self, plan: &Problem<'_>) -> f64 {
        let Self { evaluation, residual, pressures, tractions, .. } = self;
        residual.fill(0.0);
        for (place, kinematics) in evaluation.kinematics.iter().enumerate() {
            if kinematics.faces && !evaluation.look.idle[place] {
                let area = kinematics.area;
                kinematics.push(area * pressures[place], area * tractions[place], residual);
            }
        }
        plan.constraints.carry(&evaluation.rows, residual);
        for (dof, force) in residual.iter_mut().enumerate() {
            *force += evaluation.structure[dof] + evaluation.damping[dof];
        }
        let free = |dof: usize| plan.constraints.equation(dof).map(|_| residual[dof]);
        let [(force, _), _] = largest_nodal(plan.dofs, free);
        force
    }
}

/// What the laws of contact are asked with at an increment of that length [T].
pub(super) fn context<'a>(plan: &Problem<'a>, committed: &'a State, dt: f64) -> LawContext<'a> {
    LawContext {
        laws: &plan.contact.laws,
        time: committed.total_time + dt,
        dt,
        committed: &committed.state_variables,
        symmetrised: plan.symmetrised(),
        rounding: 8.0 * f64::EPSILON * plan.reach,
        units: plan.units,
    }
}

#[cfg(test)]
mod tests;
