//! Relaxation: unknowns held back by springs from where a step began.

use super::scratch::Scratch;
use crate::problem::Problem;

impl Scratch {
    /// Stiffness that relaxation gives an unknown [F/L or F L].
    pub(super) fn held_by(&self, plan: &Problem<'_>, equation: usize) -> f64 {
        let unit = plan.units[equation];
        self.relaxation.stiffness * plan.structure.stiffest / (unit * unit)
    }

    /// Takes the forces of relaxation off a right-hand side.
    pub(super) fn hold_back(&mut self, plan: &Problem<'_>) {
        if self.relaxation.stiffness == 0.0 {
            return;
        }
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            let way = self.u[dof] - self.relaxation.anchor[dof];
            self.correction[equation] -= self.held_by(plan, equation) * way;
        }
    }

    /// Adds its stiffness to the tangent.
    pub(super) fn stiffen(&mut self, plan: &Problem<'_>) {
        if self.relaxation.stiffness == 0.0 {
            return;
        }
        for equation in 0..plan.constraints.equations() {
            if let Some(at) = plan.pattern.position(equation, equation) {
                self.values[at] += self.held_by(plan, equation);
            }
        }
    }
}
