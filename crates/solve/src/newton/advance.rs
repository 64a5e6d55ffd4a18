//! The trial state moved by a correction.

use super::scratch::Scratch;
use crate::problem::Problem;

impl Scratch {
    /// Moves by a fraction of the correction.
    pub(super) fn advance(&mut self, plan: &Problem<'_>, length: f64) {
        self.step_length = length;
        self.expand_correction(plan);
        self.move_stresses(plan, length);
        for (dof, change) in self.correction_dofs.iter_mut().enumerate() {
            *change *= length;
            self.u[dof] += *change;
        }
        for linear in self.points.iter() {
            let place = linear.place;
            let pressure = &mut self.pressures[place];
            *pressure += length * (linear.pressure - *pressure);
            let old = &mut self.tractions[place];
            *old += length * (linear.traction() - *old);
        }
        plan.constraints.enforce(&self.turns, &mut self.u);
    }

    /// The correction of all dofs.
    pub(super) fn expand_correction(&mut self, plan: &Problem<'_>) {
        self.correction_dofs.fill(0.0);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.correction_dofs[dof] = self.correction[equation];
        }
        plan.constraints.expand(&self.evaluation.rows, &mut self.correction_dofs);
    }
}
