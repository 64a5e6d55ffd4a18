//! What a contact pair carries, and whether it acts as much as it reacts.
//!
//! ```text
//!   slave   f   --->      sum of f over slave, masters and reference node = 0,
//!   master  -f  <---      and so for moments about any place
//! ```

use crate::contact::ContactKinematics;
use crate::newton::Scratch;
use crate::observe::{ContactRow, PairRow, Status};
use crate::problem::Problem;
use crate::state::{PointState, State};
use slideline_model::Dof;

/// Fills a row for every pair of a state that was just committed; `closed`
/// says which contact rows were closed before; `sums` is scratch.
pub fn pair_rows(
    plan: &Problem<'_>,
    state: &State,
    work: &Scratch,
    (contact, closed): (&[ContactRow], &[bool]),
    (rows, sums): (&mut Vec<PairRow>, &mut Vec<Sum>),
) {
    rows.clear();
    rows.resize(plan.contact.laws.len(), PairRow::default());
    for (place, row) in contact.iter().enumerate() {
        let is_closed = row.status != Status::Open;
        let was_closed = closed.get(place).is_some_and(|&closed| closed);
        rows[row.pair].closed += usize::from(is_closed);
        rows[row.pair].changes += usize::from(is_closed != was_closed);
    }
    let points = plan.contact.points.iter().zip(&state.points).enumerate();
    sums.clear();
    sums.resize(rows.len(), Sum::default());
    for (place, (point, now)) in points.filter(|(_, (_, now))| now.closed) {
        let row = &mut rows[point.pair];
        row.press(now);
        if -now.opening > row.penetration {
            (row.penetration, row.deepest) = (-now.opening, Some(point.node));
        }
        sums[point.pair].add(plan, state, now, &work.evaluation.kinematics[place]);
    }
    for (row, sum) in rows.iter_mut().zip(sums) {
        (row.force_imbalance, row.moment_imbalance) = sum.imbalance();
    }
}

impl PairRow {
    /// Adds the force of a closed point on its slave: pressure along the
    /// master's normal, friction against the slip. [semantics: forces]
    fn press(&mut self, point: &PointState) {
        let [nx, ny] = point.normal;
        let (p, tau) = (point.area * point.pressure, point.area * point.traction);
        let force = [p * nx - tau * ny, p * ny + tau * nx];
        self.force[0] += force[0];
        self.force[1] += force[1];
        self.moment += point.position[0] * force[1] - point.position[1] * force[0];
    }
}

/// Sums over the dofs that closed points act on, as the solver assembles
/// them; moments about the first closed point, so that no distant origin
/// blows up their rounding.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    about: Option<[f64; 2]>,
    force: [f64; 2],
    moment: f64,
    forces: f64,
    moments: f64,
    /// Largest coordinate of a node that takes part [L]: arms are rounded as it is.
    size: f64,
}

/// Roundings of a position that an arm may be off by [1].
const ROUNDINGS: f64 = 8.0;

impl Sum {
    /// Takes in all dofs that a closed point acts on.
    fn add(
        &mut self,
        plan: &Problem<'_>,
        state: &State,
        now: &PointState,
        kinematics: &ContactKinematics,
    ) {
        let about = *self.about.get_or_insert(now.position);
        let (normal, tangential) = (now.area * now.pressure, now.area * now.traction);
        for k in 0..kinematics.width {
            let value = normal * kinematics.gradient[k] + tangential * kinematics.direction[k];
            let (node, dof) = plan.dofs.name(kinematics.dofs[k]);
            let [x, y] = plan.model.nodes.plane(node);
            let [u, v] = plan.dofs.translation(&state.displacement, node);
            let arm = [x + u - about[0], y + v - about[1]];
            self.size = self.size.max((arm[0] + about[0]).abs()).max((arm[1] + about[1]).abs());
            self.take(dof, value, arm);
        }
    }

    /// Takes in a force or moment `value` on a dof of a node, `arm` away from
    /// the place of the moments.
    fn take(&mut self, dof: Dof, value: f64, arm: [f64; 2]) {
        let moment = match dof {
            Dof::U1 => {
                self.force[0] += value;
                -arm[1] * value
            }
            Dof::U2 => {
                self.force[1] += value;
                arm[0] * value
            }
            _ => value,
        };
        self.moment += moment;
        if dof.is_rotation() {
            self.moments += value.abs();
        } else {
            self.forces += value.abs();
            // The whole arm: a force along it has a moment of rounding alone.
            self.moments += value.abs() * arm[0].hypot(arm[1]);
        }
    }

    /// What is left of forces and of moments, relative to what was summed [1].
    fn imbalance(&self) -> (f64, f64) {
        let relative = |left: f64, of: f64| if of > 0.0 { left / of } else { 0.0 };
        let force = self.force[0].hypot(self.force[1]);
        // A contact at the reference node itself has arms of rounding alone.
        let rounding = ROUNDINGS * f64::EPSILON * self.size * self.forces;
        let moment = if self.moment.abs() <= rounding { 0.0 } else { self.moment.abs() };
        (relative(force, self.forces), relative(moment, self.moments))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A force of 2 on a slave at (1, 0) and its reaction on a body whose
    /// reference node stands at (1, -3), with the moment of its arm.
    fn balanced() -> Sum {
        let mut sum = Sum::default();
        sum.take(Dof::U1, 2.0, [1.0, 0.0]);
        sum.take(Dof::U1, -2.0, [1.0, -3.0]);
        sum.take(Dof::UR3, 6.0, [1.0, -3.0]);
        sum
    }

    #[test]
    fn action_and_reaction_leave_nothing() {
        assert_eq!(balanced().imbalance(), (0.0, 0.0));
        assert_eq!(Sum::default().imbalance(), (0.0, 0.0));
    }

    /// Requirement: a force handed over a thousandth too large, or without
    /// the moment of its arm, is seen. The numbers are sums by hand.
    #[test]
    fn what_is_lost_between_the_sides_is_found() {
        let mut more = balanced();
        more.take(Dof::U2, 4e-3, [0.0, 0.0]);
        assert_eq!(more.imbalance().0, 4e-3 / 4.004);
        let mut bare = Sum::default();
        bare.take(Dof::U1, 2.0, [1.0, 0.0]);
        bare.take(Dof::U1, -2.0, [1.0, -3.0]);
        let (force, moment) = bare.imbalance();
        assert_eq!(force, 0.0);
        assert!((moment - 6.0 / (2.0 + 2.0 * 10f64.sqrt())).abs() < 1e-15, "{moment}");
    }

    /// Requirement: a contact at its reference node, far from the origin, is
    /// balanced; a moment above the rounding of its position is still seen.
    #[test]
    fn a_contact_at_its_reference_node_is_balanced() {
        let mut sum = Sum { size: 1e3, ..Sum::default() };
        sum.take(Dof::U2, 5.0, [0.0, 0.0]);
        sum.take(Dof::U2, -5.0, [1e-13, 0.0]);
        assert_eq!(sum.imbalance(), (0.0, 0.0));
        let mut off = Sum { size: 1e3, ..Sum::default() };
        off.take(Dof::U2, 5.0, [0.0, 0.0]);
        off.take(Dof::U2, -5.0, [1e-9, 0.0]);
        assert_eq!(off.imbalance(), (0.0, 1.0));
    }

    /// Requirement: what rounding leaves of a contact straight above its
    /// reference node is no imbalance.
    #[test]
    fn a_contact_without_lever_is_balanced() {
        let mut sum = Sum::default();
        sum.take(Dof::U2, 5.0, [0.0, 0.0]);
        sum.take(Dof::U2, -5.0, [1e-17, -1.0]);
        assert!(sum.imbalance().1 <= 1e-16, "{:?}", sum.imbalance());
    }
}
