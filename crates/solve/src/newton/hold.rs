//! What holds unknowns: springs from where a step began, where it is relaxed, and springs on loose bodies from where an
//! iteration begins.

use super::scratch::Scratch;
use crate::constraints::Rows;
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

/// Adds springs that hold loose bodies where they are, with so much of the stiffness of the stiffest element, to matrix values: what
/// is unbalanced knows nothing of them, and of all places that contact leaves they take the one next to it. docs/theory.md eq. (8.37).
pub(super) fn hold_loose(plan: &Problem<'_>, (rows, part): (&Rows, f64), values: &mut [f64]) {
    for dof in plan.loose.dofs() {
        let own = stiffness_on_loose(plan, part, dof);
        plan.scatter(rows, &[dof], |_, _| own, values);
    }
}

/// That of the spring on a dof of a loose body [F/L or F L].
pub(super) fn stiffness_on_loose(plan: &Problem<'_>, part: f64, dof: usize) -> f64 {
    let length = if plan.dofs.is_rotation(dof) { plan.structure.stiffest_length } else { 1.0 };
    part * plan.structure.stiffest * length * length
}
