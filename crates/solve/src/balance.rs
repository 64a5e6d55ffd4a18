//! What a contact pair carries, and whether it acts as much as it reacts.
//!
//! ```text
//!   slave   f   --->      sum of f over slave, masters and reference node = 0,
//!   master  -f  <---      and so for moments about any place
//! ```

use crate::contact::PointRows;
use crate::newton::Scratch;
use crate::observe::results::{ContactRow, PairRow, Status};
use crate::problem::Problem;
use crate::state::{PointState, State};
use slideline_mech::vector::{cross, size};
use slideline_model::{Dof, NodeIndex};

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
    rows.resize(plan.contact.own_pairs(), PairRow::default());
    for (place, row) in contact.iter().enumerate() {
        let is_closed = row.status != Status::Open;
        let was_closed = closed.get(place).is_some_and(|&closed| closed);
        rows[row.pair].closed += usize::from(is_closed);
        // an edge changes with the faces that meet in it
        let counts = is_closed != was_closed && !plan.contact.is_edge(place);
        rows[row.pair].changes += usize::from(counts);
    }
    let points = plan.contact.points.iter().zip(&state.points).enumerate();
    sums.clear();
    sums.resize(rows.len(), Sum::default());
    for (place, (point, now)) in points.filter(|(_, (_, now))| now.closed) {
        let pair = plan.contact.parent(point.pair);
        let row = &mut rows[pair];
        let kinematics = work.evaluation.kinematics.at(place);
        let standoff = plan.contact.standoff_of(point);
        match point.is_spread() {
            true => {
                row.press_nodes(plan, state, (point.pair, now), &kinematics);
                row.cover(now);
            }
            false if plan.contact.is_crossing(place) => {
                row.press_nodes(plan, state, (point.pair, now), &kinematics);
            }
            false if plan.contact.is_edge(place) => row.press_edge(plan, place, now, &kinematics),
            false if point.is_node() => {
                row.press_node(plan, (point.node, standoff), now, &kinematics);
            }
            false => row.press(now, standoff),
        }
        let law = &plan.contact.laws_of(point.pair, now).normal;
        row.energy += now.area * law.energy(-now.opening);
        if -now.opening > row.penetration {
            (row.penetration, row.deepest) = (-now.opening, Some(plan.contact.node_of(place, now)));
        }
        sums[pair].add(plan, state, now, &kinematics);
    }
    for own in plan.contact.unseen(&work.evaluation.kinematics) {
        (rows[own.pair].unseen_depth, rows[own.pair].unseen) = (own.depth, Some(own.node));
    }
    for (pair, (row, sum)) in rows.iter_mut().zip(sums).enumerate() {
        row.take_means();
        sum.moment = plan.contact.balanced(pair, sum.moment);
        (row.force_imbalance, row.moment_imbalance) = sum.imbalance();
    }
}

impl PairRow {
    /// Adds the force of a closed point on its slave: pressure along the
    /// master's normal, friction against the slip. [semantics: forces]
    fn press(&mut self, point: &PointState, standoff: f64) {
        let (p, tau) = (point.area * point.pressure, point.area * point.traction);
        let [first, second] = point.directions();
        let pressed = point.normal.map(|normal| p * normal);
        let rubbed = |k: usize| -tau[0] * first[k] - tau[1] * second[k];
        self.act(surface_of(point, standoff), [pressed, std::array::from_fn(rubbed)]);
        self.cover(point);
    }

    /// The same of a slave node.
    fn press_node(
        &mut self,
        plan: &Problem<'_>,
        (slave, standoff): (NodeIndex, f64),
        point: &PointState,
        kinematics: &PointRows<'_>,
    ) {
        let forces = forces_at(plan, slave, point, kinematics);
        self.act(surface_of(point, standoff), forces);
        self.cover(point);
    }

    /// The same of a sharp edge, which has no area. That of the master is pressed by the slave.
    fn press_edge(
        &mut self,
        plan: &Problem<'_>,
        place: usize,
        point: &PointState,
        kinematics: &PointRows<'_>,
    ) {
        let own = &plan.contact.points[place];
        let sign = if plan.contact.is_reversed(own.pair) { -1.0 } else { 1.0 };
        let forces = forces_at(plan, own.node, point, kinematics);
        self.act(point.position, forces.map(|force| force.map(|own| sign * own)));
    }

    /// The same of a point that acts on many nodes, spread over faces or at a crossing of edges: forces as they act on the nodes of the slave,
    /// which where faces lie askew are not quite along its normals. docs/theory.md eq. (5.26)
    fn press_nodes(
        &mut self,
        plan: &Problem<'_>,
        state: &State,
        (pair, point): (usize, &PointState),
        kinematics: &PointRows<'_>,
    ) {
        let (normal, tangential) = (point.area * point.pressure, point.area * point.traction);
        let rows = kinematics.rows;
        for (k, &own) in rows.unknowns.iter().enumerate() {
            let (node, dof) = plan.dofs.name(own);
            if dof.is_rotation() || plan.contact.is_spread_slave(pair, node) != Some(true) {
                continue;
            }
            let mut forces = [[0.0; 3]; 2];
            let axis = dof as usize % 3;
            // rows are by overclosure, which falls along the force
            forces[0][axis] = -normal * rows.normal()[k];
            let rubbed = (0..rows.directions()).map(|way| tangential[way] * rows.force(way)[k]);
            forces[1][axis] = -rubbed.sum::<f64>();
            let (at, moved) = (
                plan.model.nodes.get(node).position,
                plan.dofs.translation(&state.displacement, node),
            );
            self.act(std::array::from_fn(|c| at[c] + moved[c]), forces);
        }
    }

    /// Adds forces of pressure and of friction at a place.
    fn act(&mut self, at: [f64; 3], [pressed, rubbed]: [[f64; 3]; 2]) {
        let force: [f64; 3] = std::array::from_fn(|k| pressed[k] + rubbed[k]);
        for (sum, own) in self.force.iter_mut().zip(force) {
            *sum += own;
        }
        for (sum, own) in self.moment.iter_mut().zip(cross(at, force)) {
            *sum += own;
        }
        self.of_pressure.add(pressed, at);
        self.of_friction.add(rubbed, at);
    }

    /// Adds the area of a closed point.
    fn cover(&mut self, point: &PointState) {
        self.area += point.area;
        for k in 0..3 {
            self.centre[k] += point.area * point.position[k];
            self.mean_normal[k] += point.area * point.normal[k];
        }
    }

    /// Turns sums over the area into means.
    fn take_means(&mut self) {
        if self.area > 0.0 {
            self.centre = self.centre.map(|sum| sum / self.area);
            self.mean_normal = self.mean_normal.map(|sum| sum / self.area);
        }
    }
}

/// Forces of pressure and of friction on the node of a point as they are assembled at it, which on a master
/// whose corners are smoothed are not quite along its normal and its tangents [F].
fn forces_at(
    plan: &Problem<'_>,
    slave: NodeIndex,
    point: &PointState,
    kinematics: &PointRows<'_>,
) -> [[f64; 3]; 2] {
    let (normal, tangential) = (point.area * point.pressure, point.area * point.traction);
    let rows = kinematics.rows;
    let mut forces = [[0.0; 3]; 2];
    for (k, &own) in rows.unknowns.iter().enumerate() {
        let (node, dof) = plan.dofs.name(own);
        if node != slave || dof.is_rotation() {
            continue;
        }
        let axis = dof as usize % 3;
        // rows are by overclosure, which falls along the force
        forces[0][axis] -= normal * rows.normal()[k];
        let rubbed = (0..rows.directions()).map(|way| tangential[way] * rows.force(way)[k]);
        forces[1][axis] -= rubbed.sum::<f64>();
    }
    forces
}

/// Sums over the dofs that closed points act on, as the solver assembles
/// them; moments about the first closed point, so that no distant origin
/// blows up their rounding.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    about: Option<[f64; 3]>,
    force: [f64; 3],
    moment: [f64; 3],
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
        kinematics: &PointRows<'_>,
    ) {
        let about = *self.about.get_or_insert(now.position);
        let (normal, tangential) = (now.area * now.pressure, now.area * now.traction);
        let rows = kinematics.rows;
        for (k, &own) in rows.unknowns.iter().enumerate() {
            let along = |direction: usize| tangential[direction] * rows.force(direction)[k];
            let value = (0..rows.directions())
                .map(along)
                .fold(normal * rows.normal()[k], |sum, own| sum + own);
            let (node, dof) = plan.dofs.name(own);
            let position = plan.model.nodes.get(node).position;
            let moved = plan.dofs.translation(&state.displacement, node);
            let arm: [f64; 3] = std::array::from_fn(|c| position[c] + moved[c] - about[c]);
            let far = |c: usize| (arm[c] + about[c]).abs();
            self.size = self.size.max(far(0)).max(far(1)).max(far(2));
            self.take(dof, value, arm);
        }
    }

    /// Takes in a force or moment `value` on a dof of a node, `arm` away from
    /// the place of the moments.
    fn take(&mut self, dof: Dof, value: f64, arm: [f64; 3]) {
        let axis = dof as usize % 3;
        if dof.is_rotation() {
            self.moment[axis] += value;
            self.moments += value.abs();
            return;
        }
        let mut force = [0.0; 3];
        force[axis] = value;
        self.force[axis] += value;
        for (sum, own) in self.moment.iter_mut().zip(cross(arm, force)) {
            *sum += own;
        }
        self.forces += value.abs();
        // The whole arm: a force along it has a moment of rounding alone.
        self.moments += value.abs() * size(arm);
    }

    /// What is left of forces and of moments, relative to what was summed [1].
    fn imbalance(&self) -> (f64, f64) {
        let relative = |left: f64, of: f64| if of > 0.0 { left / of } else { 0.0 };
        // A contact at the reference node itself has arms of rounding alone.
        let rounding = ROUNDINGS * f64::EPSILON * self.size * self.forces;
        let moment = size(self.moment);
        let moment = if moment <= rounding { 0.0 } else { moment };
        (relative(size(self.force), self.forces), relative(moment, self.moments))
    }
}

/// Where a force acts on the slave of a point: at its surface, which may stand off the point [L].
fn surface_of(point: &PointState, standoff: f64) -> [f64; 3] {
    std::array::from_fn(|k| point.position[k] - standoff * point.normal[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A force of 2 on a slave at (1, 0) and its reaction on a body whose
    /// reference node stands at (1, -3), with the moment of its arm.
    fn balanced() -> Sum {
        let mut sum = Sum::default();
        sum.take(Dof::U1, 2.0, [1.0, 0.0, 0.0]);
        sum.take(Dof::U1, -2.0, [1.0, -3.0, 0.0]);
        sum.take(Dof::UR3, 6.0, [1.0, -3.0, 0.0]);
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
        more.take(Dof::U2, 4e-3, [0.0, 0.0, 0.0]);
        assert_eq!(more.imbalance().0, 4e-3 / 4.004);
        let mut bare = Sum::default();
        bare.take(Dof::U1, 2.0, [1.0, 0.0, 0.0]);
        bare.take(Dof::U1, -2.0, [1.0, -3.0, 0.0]);
        let (force, moment) = bare.imbalance();
        assert_eq!(force, 0.0);
        assert!((moment - 6.0 / (2.0 + 2.0 * 10f64.sqrt())).abs() < 1e-15, "{moment}");
    }

    /// Requirement: a contact at its reference node, far from the origin, is
    /// balanced; a moment above the rounding of its position is still seen.
    #[test]
    fn a_contact_at_its_reference_node_is_balanced() {
        let mut sum = Sum { size: 1e3, ..Sum::default() };
        sum.take(Dof::U2, 5.0, [0.0, 0.0, 0.0]);
        sum.take(Dof::U2, -5.0, [1e-13, 0.0, 0.0]);
        assert_eq!(sum.imbalance(), (0.0, 0.0));
        let mut off = Sum { size: 1e3, ..Sum::default() };
        off.take(Dof::U2, 5.0, [0.0, 0.0, 0.0]);
        off.take(Dof::U2, -5.0, [1e-9, 0.0, 0.0]);
        assert_eq!(off.imbalance(), (0.0, 1.0));
    }

    /// Requirement: what rounding leaves of a contact straight above its
    /// reference node is no imbalance.
    #[test]
    fn a_contact_without_lever_is_balanced() {
        let mut sum = Sum::default();
        sum.take(Dof::U2, 5.0, [0.0, 0.0, 0.0]);
        sum.take(Dof::U2, -5.0, [1e-17, -1.0, 0.0]);
        assert!(sum.imbalance().1 <= 1e-16, "{:?}", sum.imbalance());
    }
}
