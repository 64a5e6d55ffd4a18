//! Stresses of the elements as the iteration estimates them.
//!
//! ```text
//!   first guess:  committed stresses, extrapolated as the displacements are
//!   every step:   D (eps + B du), where the linear solution arrives
//! ```
//!
//! They make the geometric stiffness of the tangent, docs/theory.md section 3.3, and nothing else:
//! what is judged are forces of the law at the strains.

use super::scratch::Scratch;
use crate::problem::Problem;
use crate::state::State;
use crate::structure::Ambient;
use slideline_model::Extrapolation;

impl Scratch {
    /// The first guess of an increment: docs/theory.md eq. (3.29). Stresses are functions of the
    /// displacements, so that history needs none of its own.
    pub(super) fn first_stresses(&mut self, plan: &Problem<'_>, committed: &State, dt: f64) {
        let ambient =
            Ambient { temperatures: &self.temperatures, turns: &self.turns, clock: self.clock };
        let still = &mut self.correction_dofs;
        let last = committed.increment_time.0;
        if last == 0.0 {
            // What is prescribed was spread linearly: this is where that arrives.
            for (dof, change) in still.iter_mut().enumerate() {
                *change = self.u[dof] - committed.displacement[dof];
            }
            plan.structure.stresses_after(
                &committed.displacement,
                still,
                &ambient,
                &mut self.stresses,
            );
            still.fill(0.0);
            return;
        }
        still.fill(0.0);
        plan.structure.stresses_after(&committed.displacement, still, &ambient, &mut self.stresses);
        if plan.step.extrapolation == Extrapolation::None {
            return;
        }
        for (dof, before) in self.residual.iter_mut().enumerate() {
            *before = committed.displacement[dof] - committed.increment[dof];
        }
        plan.structure.stresses_after(&self.residual, still, &ambient, &mut self.arrived);
        for (stress, before) in self.stresses.iter_mut().zip(&self.arrived) {
            *stress += dt / last * (*stress - before);
        }
    }

    /// Takes the stresses of the law at the strains: what a line search needs,
    /// whose residuals are those of the law too.
    pub(super) fn follow_law(&mut self, plan: &Problem<'_>) {
        let ambient =
            Ambient { temperatures: &self.temperatures, turns: &self.turns, clock: self.clock };
        plan.structure.stresses_after(&self.u, &self.still, &ambient, &mut self.stresses);
    }

    /// Moves the estimates by a fraction of the way to where the linear solution arrives; before
    /// the displacements move.
    pub(super) fn move_stresses(&mut self, plan: &Problem<'_>, length: f64) {
        let ambient =
            Ambient { temperatures: &self.temperatures, turns: &self.turns, clock: self.clock };
        plan.structure.stresses_after(&self.u, &self.correction_dofs, &ambient, &mut self.arrived);
        for (stress, arrived) in self.stresses.iter_mut().zip(&self.arrived) {
            *stress += length * (arrived - *stress);
        }
        plan.structure.tighten(plan.reach, &mut self.stresses);
    }
}
