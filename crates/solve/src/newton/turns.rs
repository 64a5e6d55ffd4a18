//! How far one iteration may turn what it moves.
//!
//! ```text
//!   a row of elements may turn by any angle     what contact looks at may not: it would be
//!   as long as each bends but a little          looked at where it never stands
//! ```

use super::scratch::Scratch;
use crate::problem::Problem;

/// The largest turn that one iteration may add: of the ends of an element against each other, and
/// of any node where there is contact [1].
const LARGEST_ROTATION: f64 = 0.5;

impl Scratch {
    /// Fraction of the correction at which nothing turns too far.
    pub(super) fn limit_turns(&self, plan: &Problem<'_>) -> f64 {
        let of = |dof: usize| plan.constraints.equation(dof).map_or(0.0, |e| self.correction[e]);
        let turn = if plan.contact.points.is_empty() {
            plan.structure.largest_bend(of)
        } else {
            let free = plan.constraints.dof_of_equation.iter();
            let rotations = free.filter(|&&dof| plan.dofs.name(dof).1.is_rotation());
            rotations.fold(0.0_f64, |largest, &dof| largest.max(of(dof).abs()))
        };
        if turn > LARGEST_ROTATION { LARGEST_ROTATION / turn } else { 1.0 }
    }
}
