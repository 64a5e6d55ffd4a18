//! Points of contact that nothing moves: where supports hold both sides, or where one follows the other.
//!
//! ```text
//!   ###o###      o slave and master are one node, by an equation, a link or a rigid body: what is
//!   ---o---        left of the gap there is that of the nodes beside it
//! ```
//!
//! docs/theory.md section 8.3. (derived)

use super::Problem;
use crate::constraints::{Role, Rows};
use crate::contact::PointRows;

/// Part of a gap's change with its own nodes that unknowns must reach for contact to hold it [1]: less is the
/// turning of normals, or rounding. (choice)
const LEAST_LEVER: f64 = 1e-6;

/// Part of what a point's own node does to its gap that constraints may leave of it for the node to be one with the master [1].
/// (choice)
const JOINED: f64 = 1e-2;

/// Part of the largest factor of a gap from which on a dof of its node counts [1]. (choice)
const ALONG: f64 = 0.1;

/// Part of a slave face by which held surfaces may overlap where the normals beside them turn [1]. (choice)
const LITTLE: f64 = 0.01;

impl Problem<'_> {
    /// Whether some unknown moves a point towards or from its master. Where slave and master are both held, or one follows
    /// the other, what is left is how the normal turns about a gap that is there already, and no force closes that.
    pub fn contact_yields(&self, kinematics: &PointRows<'_>, rows: &Rows) -> bool {
        let (unknowns, normal) = (kinematics.rows.unknowns, kinematics.rows.normal());
        let least = LEAST_LEVER * normal.iter().fold(0.0_f64, |whole, g| whole.max(g.abs()));
        let own = || unknowns.iter().copied().zip(normal.iter().copied());
        let is_free = |dof: usize| matches!(self.constraints.roles[dof], Role::Free(_));
        let follows = own().any(|(dof, g)| g != 0.0 && !is_free(dof));
        own().any(|(dof, g)| {
            let mut yields = false;
            self.constraints.for_each_equation(rows, dof, &mut |equation: usize, a: f64| {
                let lever = |x: f64| (x * self.units[equation]).abs();
                // what follows an unknown may move along with another one that is that unknown, or follows it
                yields |= lever(a * g) > least
                    && (!follows || lever(self.moved_by(own(), rows, equation)) > least);
            });
            yields
        })
    }

    /// What an equation moves of dofs by these factors.
    fn moved_by(
        &self,
        factors: impl Iterator<Item = (usize, f64)>,
        rows: &Rows,
        equation: usize,
    ) -> f64 {
        let mut sum = 0.0;
        for (dof, g) in factors {
            self.constraints.for_each_equation(rows, dof, &mut |other: usize, a: f64| {
                sum += if other == equation { a * g } else { 0.0 };
            });
        }
        sum
    }

    /// Whether the own node of a point is one with its master there already, as constraints have it: what is left of its gap is
    /// that of nodes beside it, which are held by themselves.
    pub fn is_joined(&self, place: usize, kinematics: &PointRows<'_>, rows: &Rows) -> bool {
        let (unknowns, normal) = (kinematics.rows.unknowns, kinematics.rows.normal());
        let node = self.contact.points[place].node;
        let all = || unknowns.iter().copied().zip(normal.iter().copied());
        let follows = |(dof, _)| matches!(self.constraints.roles[dof], Role::Dependent(_));
        if !all().any(follows) {
            return false;
        }
        let (mut whole, mut left) = (0.0, 0.0);
        for (dof, g) in all().filter(|own| self.dofs.name(own.0).0 == node) {
            self.constraints.for_each_equation(rows, dof, &mut |equation: usize, a: f64| {
                let lever = |x: f64| (x * self.units[equation]).abs();
                whole += lever(a * g);
                left += lever(self.moved_by(all(), rows, equation));
            });
        }
        left < JOINED * whole || self.follows_master(node, (all, rows))
    }

    /// Whether a node follows nodes on the other side of the gap with these factors alone, a dof each.
    fn follows_master<I: Iterator<Item = (usize, f64)>>(
        &self,
        node: usize,
        (all, rows): (impl Fn() -> I, &Rows),
    ) -> bool {
        let most = all().fold(0.0_f64, |most, own| most.max(own.1.abs()));
        let mut followed = 0;
        for (dof, g) in all().filter(|own| own.1.abs() > ALONG * most) {
            if self.dofs.name(dof).0 != node {
                continue;
            }
            let mut all_across = matches!(self.constraints.roles[dof], Role::Dependent(_));
            self.constraints.for_each_equation(rows, dof, &mut |equation: usize, a: f64| {
                let leader = self.constraints.dof_of_equation[equation];
                let is_across = all().any(|(other, factor)| other == leader && factor * g < 0.0);
                all_across &= is_across || a.abs() < LEAST_LEVER;
                followed += 1;
            });
            if !all_across {
                return false;
            }
        }
        followed > 0
    }

    /// Whether a point and its master are held where they are: what little it overlaps by is of normals that turn
    /// beside it, and nothing can part them. What a prescribed motion brings closer is not, nor what overlaps by
    /// more.
    pub fn stands_held(
        &self,
        place: usize,
        (kinematics, rows): (&PointRows<'_>, &Rows),
        (u, from): (&[f64], &[f64]),
    ) -> bool {
        if self.touches_held_node(place, kinematics, (u, from))
            || self.is_joined(place, kinematics, rows)
        {
            return true;
        }
        let little = LITTLE * self.contact.spacing[self.contact.points[place].pair];
        if kinematics.overclosure > little || self.contact_yields(kinematics, rows) {
            return false;
        }
        let unknowns = kinematics.rows.unknowns.iter().zip(kinematics.rows.normal());
        let closer: f64 = unknowns
            .filter(|(dof, _)| !matches!(self.constraints.roles[**dof], Role::Free(_)))
            .map(|(&dof, g)| g * (u[dof] - from[dof]))
            .sum();
        closer <= LEAST_LEVER * little
    }

    /// Whether a slave node stands at a node of its master, as far as their surfaces are away, and both are held
    /// where they are: between them nothing gives way, whatever the faces beside them do.
    pub fn touches_held_node(
        &self,
        place: usize,
        kinematics: &PointRows<'_>,
        (u, from): (&[f64], &[f64]),
    ) -> bool {
        let point = &self.contact.points[place];
        if !point.is_node() || !self.is_held(point.node) {
            return false;
        }
        let little = LITTLE * self.contact.spacing[point.pair];
        let of = |u: &[f64], node: usize| self.dofs.translation(u, node);
        let apart = |node: usize, u: &[f64]| -> f64 {
            let [x, y] =
                [point.node, node].map(|node| (self.model.nodes.position(node), of(u, node)));
            let along = |k: usize| (x.0[k] + x.1[k]) - (y.0[k] + y.1[k]);
            (0..3).map(|k| along(k) * along(k)).sum::<f64>().sqrt()
        };
        let moves_alike = |node: usize| {
            let way = |node: usize, k: usize| of(u, node)[k] - of(from, node)[k];
            (0..3).all(|k| (way(node, k) - way(point.node, k)).abs() <= LEAST_LEVER * little)
        };
        let thick = self.contact.offset_of(point.pair);
        let nodes = kinematics.rows.unknowns.iter().map(|&dof| self.dofs.name(dof).0);
        nodes.filter(|&node| node != point.node).any(|node| {
            (apart(node, u) - thick).abs() <= little && self.is_held(node) && moves_alike(node)
        })
    }

    /// Whether supports hold a node along all axes.
    fn is_held(&self, node: usize) -> bool {
        self.dofs.of_node(node).all(|dof| {
            let is_held =
                matches!(self.constraints.roles[dof], Role::Prescribed(_) | Role::Inactive);
            is_held || self.dofs.is_rotation(dof)
        })
    }
}
