//! What holds unknowns: springs from where a step began, where it is relaxed, and springs on loose bodies from where an
//! iteration begins.

use super::scratch::Scratch;
use crate::constraints::Rows;
use crate::problem::Problem;

/// Stiffness that holds loose bodies where an iteration begins, in that of their own elements [1]: small against the softest
/// way in which a part bends, and large against rounding. From attempt to attempt firmer: contact without friction leaves bodies that it
/// presses on next to no stiffness along it, of either sign. (choice)
pub(super) const HOLD: [f64; 3] = [1e-9, 1e-8, 1e-6];
/// Part of that where laws are inserted: multipliers that are moved from round to round would follow late [1]. (choice)
pub(super) const OF_INSERTED: f64 = 1e-3;

impl Scratch {
    /// Whether springs hold loose bodies: not where dashpots do, nor where all points lend stiffness, so that what falls goes as far
    /// as contact lets it.
    pub(super) fn holds_loose(&self, plan: &Problem<'_>) -> bool {
        !plan.loose.is_empty() && self.dashpots.is_empty() && !self.augment_all
    }

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

/// The springs that hold loose bodies where they are, with so much of their own stiffness: dofs and stiffnesses [F/L or F L]. What is
/// unbalanced knows nothing of them, and of all places that contact leaves they take the one next to it. docs/theory.md eq. (8.37).
pub(super) fn springs_on_loose<'a>(
    plan: &'a Problem<'_>,
    part: f64,
) -> impl Iterator<Item = (usize, f64)> + 'a {
    plan.loose.iter().zip(plan.firmness).flat_map(move |(body, own)| {
        let turning = own.length * own.length;
        let of = move |dof| if plan.dofs.is_rotation(dof) { turning } else { 1.0 };
        body.dofs().map(move |dof| (dof, part * own.stiffness * of(dof)))
    })
}

/// Adds them to matrix values.
pub(super) fn hold_loose(plan: &Problem<'_>, (rows, part): (&Rows, f64), values: &mut [f64]) {
    for (dof, stiffness) in springs_on_loose(plan, part) {
        plan.scatter(rows, &[dof], |_, _| stiffness, values);
    }
}
