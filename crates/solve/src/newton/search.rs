//! Line search: a correction is shortened until it lessens the residual.
//!
//! ```text
//!   residual |\        full step: worse
//!            | \__  /
//!            |    \/   <-- half of it: better, taken
//!            +-----------> fraction of the correction
//! ```
//!
//! Only the last attempt at an increment searches, when shorter increments are
//! used up: a full step is the better one wherever Newton converges at all.

use super::relaxation::Estimates;
use super::scratch::Scratch;
use crate::evaluate::evaluate_forces;
use crate::problem::Problem;
use crate::state::State;
use slideline_model::TimeIncrementation;

/// Fractions that are tried.
const FRACTIONS: [f64; 6] = [1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125];
/// Part of the residual that a step must take away, for its length [1]
/// (Armijo's rule).
const GAIN: f64 = 1e-4;
/// Shorter steps need more iterations.
const PATIENCE: u32 = 4;

/// Limits of an attempt that searches: more iterations, and a residual that
/// grows ends nothing.
pub fn limits(of: &TimeIncrementation) -> TimeIncrementation {
    let (i_c, i_s) = (of.i_c.saturating_mul(PATIENCE), of.i_s.saturating_mul(PATIENCE));
    TimeIncrementation { i_0: u32::MAX, i_r: u32::MAX, i_c, i_s, ..*of }
}

impl Scratch {
    /// Moves by the fraction, of at most `longest`, that lessens the residual
    /// enough, or else by the one that leaves least of it.
    pub(super) fn search(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        (dt, longest): (f64, f64),
    ) {
        let (from, estimates) = (self.u.clone(), self.estimates());
        let before = self.merit(plan);
        let mut best = (f64::INFINITY, longest);
        let mut taken = 0.0;
        for fraction in FRACTIONS {
            taken = fraction * longest;
            self.go_back(&from, &estimates);
            self.advance(plan, taken);
            self.follow_law(plan);
            self.evaluate_by(plan, committed, dt, evaluate_forces);
            let now = self.merit(plan);
            if now < best.0 {
                best = (now, taken);
            }
            if now <= before * (1.0 - GAIN * fraction) {
                return self.evaluate_tangents(plan, committed, dt);
            }
        }
        if best.1 != taken {
            self.go_back(&from, &estimates);
            self.advance(plan, best.1);
            return self.evaluate(plan, committed, dt);
        }
        self.evaluate_tangents(plan, committed, dt);
    }

    /// Goes back to displacements with their estimates.
    pub(super) fn go_back(&mut self, u: &[f64], estimates: &Estimates) {
        self.u.copy_from_slice(u);
        self.pressures.copy_from_slice(&estimates.pressures);
        self.tractions.copy_from_slice(&estimates.tractions);
        self.stresses.copy_from_slice(&estimates.stresses);
        self.standing.copy_from_slice(&estimates.standing);
    }

    /// The estimates that belong to the trial.
    pub(super) fn estimates(&self) -> Estimates {
        Estimates {
            pressures: self.pressures.clone(),
            tractions: self.tractions.clone(),
            stresses: self.stresses.clone(),
            standing: self.standing.clone(),
        }
    }

    /// Size of what is not balanced: forces, moments over the length of the
    /// stiffest element, and what hard contact and exact stick miss, times the
    /// stiffness augmentation to them [F].
    fn merit(&self, plan: &Problem<'_>) -> f64 {
        if self.evaluation.failed.is_some() {
            return f64::MAX;
        }
        let length = plan.structure.stiffest_length;
        let lever = if length > 0.0 { length } else { plan.reach.max(f64::MIN_POSITIVE) };
        let mut sum = 0.0;
        for &dof in &plan.constraints.dof_of_equation {
            let force = self.evaluation.unbalanced(dof);
            let force = if plan.dofs.name(dof).1.is_rotation() { force / lever } else { force };
            sum += force * force;
        }
        let missed = self.evaluation.penetration + self.evaluation.stick_slip;
        let missed = super::assembly::AUGMENTATION * plan.structure.stiffest * missed;
        let all = (sum + missed * missed).sqrt();
        if all.is_finite() { all } else { f64::MAX }
    }
}
