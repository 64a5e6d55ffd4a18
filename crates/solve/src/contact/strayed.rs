//! Slave nodes in the part of their master, that came in where the surface of the master ends.
//!
//! ```text
//!     +-----------+         the node went in through a face that is not of the master's surface: it faces the
//!     |   part    | <- x    surface from behind, is not taken for contact, and no force acts on it
//!     +-----------+
//!        master
//! ```
//!
//! docs/theory.md section 5.8

use super::kinematics::PointKinematics;
use super::pairs::Contact;
use super::parts::joined;
use crate::problem::Problem;
use crate::state::State;
use slideline_mech::contact::search::tree::{Bounds, BoxTree};
use slideline_mech::element::cell::{Cell, within};
use slideline_mech::vector::{Vector, add, dot};
use slideline_model::{Element, Kinematics, NodeIndex};

/// Part of the height of the element in which a node stands by which it may stand behind the master unsaid [1]. (choice)
const DEEP: f64 = 0.1;
/// Distance from an element at which a node is inside, in sizes of the element: far above rounding [1]. (choice)
const UPON: f64 = 1e-6;

/// A slave node in the part of its master.
#[derive(Debug, Clone)]
pub struct Strayed {
    /// The pair.
    pub pair: usize,
    /// The node.
    pub node: NodeIndex,
    /// How far behind the surface of the master [L].
    pub depth: f64,
    /// Number of the element in which it stands.
    pub element: u64,
}

/// A node behind its master, and the outward normal of what it would face there.
struct Behind {
    pair: usize,
    node: NodeIndex,
    depth: f64,
    normal: Vector,
}

impl Contact {
    /// The deepest slave node that stands in the part of its master, to which it came beyond an end of the surface; `None`:
    /// all that stand behind are beside the part, or held by another pair.
    pub fn strayed(
        &self,
        plan: &Problem<'_>,
        committed: &State,
        kinematics: &[PointKinematics],
    ) -> Option<Strayed> {
        let behind =
            kinematics.iter().enumerate().filter(|(_, own)| !own.faces && own.behind > 0.0);
        let mut found: Vec<Behind> = behind
            .map(|(place, now)| {
                let point = &self.points[place];
                let (pair, node) = (self.parent(point.pair), point.node);
                Behind { pair, node, depth: now.behind, normal: now.normal }
            })
            .collect();
        if found.is_empty() {
            return None;
        }
        let states = self.points.iter().zip(&committed.points);
        let mut held: Vec<NodeIndex> =
            states.filter(|(_, state)| state.closed).map(|(point, _)| point.node).collect();
        held.sort_unstable();
        found.retain(|behind| held.binary_search(&behind.node).is_err());
        found.sort_by(|a, b| {
            let of_pair = a.pair.cmp(&b.pair);
            of_pair.then(b.depth.total_cmp(&a.depth)).then(a.node.cmp(&b.node))
        });
        let parts = found.chunk_by(|a, b| a.pair == b.pair);
        parts.into_iter().find_map(|of_pair| {
            let part = Part::of_master(plan, committed, of_pair[0].pair)?;
            of_pair.iter().find_map(|behind| part.holds(behind))
        })
    }
}

/// The solids of the part of a master, where they stand.
struct Part<'a> {
    plan: &'a Problem<'a>,
    committed: &'a State,
    solids: Vec<(&'static Cell, Element<'a>)>,
    tree: BoxTree<3>,
}

impl<'a> Part<'a> {
    /// That of a pair; `None` where its master belongs to no solid.
    fn of_master(plan: &'a Problem<'a>, committed: &'a State, pair: usize) -> Option<Self> {
        let model = plan.model;
        let root = joined(model);
        let mut own: Vec<NodeIndex> = model.contact_pairs[pair]
            .master
            .deforming_nodes()
            .iter()
            .map(|&node| root[node])
            .collect();
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

    /// Where a node stands [L].
    fn place(&self, node: NodeIndex) -> Vector {
        let moved = self.plan.dofs.translation(&self.committed.displacement, node);
        add(self.plan.model.nodes.position(node), moved)
    }

    /// A node with the element in which it stands, where it is deep in it by the height of that.
    fn holds(&self, behind: &Behind) -> Option<Strayed> {
        let &Behind { pair, node, depth, normal } = behind;
        let at = self.place(node);
        let mut found = None;
        self.tree.overlapping((at, at), |solid| {
            let (cell, element) = &self.solids[solid];
            if found.is_some() || element.nodes.contains(&node) {
                return;
            }
            let places: Vec<Vector> = element.nodes.iter().map(|&node| self.place(node)).collect();
            let reach = |way: Vector| {
                let along = places.iter().map(|&place| dot(place, way));
                let (low, high) = along
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), own| {
                        (low.min(own), high.max(own))
                    });
                high - low
            };
            let size = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(reach);
            let near = UPON * size.into_iter().fold(0.0, f64::max);
            let inside = within(cell, &places, at).is_some_and(|inside| inside.distance <= near);
            if inside && depth > DEEP * reach(normal) {
                found = Some(Strayed { pair, node, depth, element: element.label });
            }
        });
        found
    }
}
