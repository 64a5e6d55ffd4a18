//! The solids behind a side of a pair, and whether a node of the other side stands in them.
//!
//! ```text
//!     +---+---+---+
//!     |   | x |   |     x: deep in an element of the part, by the height of that element
//!     +---+---+---+
//! ```

use super::parts::joined;
use crate::problem::Problem;
use crate::state::State;
use slideline_mech::contact::search::tree::{Bounds, BoxTree};
use slideline_mech::element::cell::{Cell, within};
use slideline_mech::vector::{Vector, add, cross, dot, scale, size};
use slideline_model::{Element, Kinematics, NodeIndex};
use std::cmp::Ordering;

/// Part of the height of the element in which a node stands by which it may stand behind the other side unsaid [1]. (choice)
const DEEP: f64 = 0.1;
/// Distance from an element at which a node is inside, in sizes of the element: far above rounding [1]. (choice)
const UPON: f64 = 1e-6;

/// A node behind the other side, and the outward normal of what it would face there.
pub(super) struct Behind {
    pub(super) node: NodeIndex,
    /// How far behind [L].
    pub(super) depth: f64,
    pub(super) normal: Vector,
}

impl Behind {
    /// Whether it comes before another one: the deeper one does, of two alike the first node.
    pub(super) fn deeper_first(&self, other: &Self) -> Ordering {
        other.depth.total_cmp(&self.depth).then(self.node.cmp(&other.node))
    }
}

/// The solids of the part that a side of a pair belongs to, where they stand.
pub(super) struct SolidsOfSide<'a> {
    plan: &'a Problem<'a>,
    committed: &'a State,
    solids: Vec<(&'static Cell, Element<'a>)>,
    tree: BoxTree<3>,
}

impl<'a> SolidsOfSide<'a> {
    /// Those of the part of these nodes of a side; `None` where they belong to no solid.
    pub(super) fn new(
        plan: &'a Problem<'a>,
        committed: &'a State,
        of_side: &[NodeIndex],
    ) -> Option<Self> {
        let model = plan.model;
        let root = joined(model);
        let mut own: Vec<NodeIndex> = of_side.iter().map(|&node| root[node]).collect();
        own.sort_unstable();
        own.dedup();
        let all = plan.step.presence.elements(&model.blocks);
        let solids: Vec<_> = all
            .filter(|(block, _)| matches!(block.kind.kinematics, Kinematics::Solid { .. }))
            .filter(|(_, element)| own.binary_search(&root[element.nodes[0]]).is_ok())
            .map(|(block, element)| (block.kind.cell, element))
            .collect();
        if solids.is_empty() {
            return None;
        }
        let mut new = Self { plan, committed, solids, tree: BoxTree::default() };
        let bounds = |solid: usize| -> Bounds<3> {
            let all = || new.solids[solid].1.nodes.iter().map(|&node| new.place(node));
            let fold = |from: f64, take: fn(f64, f64) -> f64| {
                all().fold([from; 3], |so_far, at| std::array::from_fn(|k| take(so_far[k], at[k])))
            };
            (fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max))
        };
        new.tree = BoxTree::new(new.solids.len(), bounds);
        Some(new)
    }

    /// Whether places beside a node, by a tenth of its depth, are inside as well: those of one upon a side of the part are
    /// not.
    pub(super) fn surrounds(&self, behind: &Behind) -> bool {
        let &Behind { node, depth, normal } = behind;
        let (at, way) = (self.place(node), DEEP * depth);
        let in_space = self.solids.first().is_some_and(|(cell, _)| cell.dimension == 3);
        let least =
            (0..3).min_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[if in_space { least } else { 2 }] = 1.0;
        let first = cross(normal, axis);
        let first = scale(first, 1.0 / size(first));
        let second = in_space.then(|| cross(normal, first));
        let ways = [Some(first), second].into_iter().flatten();
        let mut beside = ways.flat_map(|own| [way, -way].map(|way| add(at, scale(own, way))));
        beside.all(|at| self.contains(at))
    }

    /// Whether a place is inside an element.
    fn contains(&self, at: Vector) -> bool {
        let mut found = false;
        self.tree.overlapping((at, at), |solid| {
            found = found || is_within(self.solids[solid].0, &self.places(solid), at);
        });
        found
    }

    /// Where the nodes of a solid stand [L].
    fn places(&self, solid: usize) -> Vec<Vector> {
        self.solids[solid].1.nodes.iter().map(|&node| self.place(node)).collect()
    }

    /// Where a node stands [L].
    fn place(&self, node: NodeIndex) -> Vector {
        let moved = self.plan.dofs.translation(&self.committed.displacement, node);
        add(self.plan.model.nodes.position(node), moved)
    }

    /// The number of the element in which a node stands, where it is deep in it by the height of that.
    pub(super) fn holds(&self, behind: &Behind) -> Option<u64> {
        let &Behind { node, depth, normal } = behind;
        let at = self.place(node);
        let mut found = None;
        self.tree.overlapping((at, at), |solid| {
            let (cell, element) = &self.solids[solid];
            if found.is_some() || element.nodes.contains(&node) {
                return;
            }
            let places = self.places(solid);
            if is_within(cell, &places, at) && depth > DEEP * reach(&places, normal) {
                found = Some(element.label);
            }
        });
        found
    }
}

/// Whether a place is inside a cell whose nodes stand at these places, or upon its surface.
fn is_within(cell: &Cell, places: &[Vector], at: Vector) -> bool {
    let size = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|way| reach(places, way));
    let near = UPON * size.into_iter().fold(0.0, f64::max);
    within(cell, places, at).is_some_and(|inside| inside.distance <= near)
}

/// How far places reach along a direction [L].
fn reach(places: &[Vector], way: Vector) -> f64 {
    let along = places.iter().map(|&place| dot(place, way));
    let (low, high) = along
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), own| (low.min(own), high.max(own)));
    high - low
}
