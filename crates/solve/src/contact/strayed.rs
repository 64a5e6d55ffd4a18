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
use crate::problem::Problem;
use crate::state::State;
use slideline_mech::element::cell::within;
use slideline_mech::vector::add;
use slideline_model::{Kinematics, NodeIndex};

/// Part of the size of the element in which a node stands by which it may stand behind the master unsaid [1].
const DEEP: f64 = 0.1;
/// Distance from an element at which a node is inside, in sizes of the element [1].
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

impl Contact {
    /// The deepest slave node that stands in a solid behind its master, to which it came beyond an end of the surface;
    /// `None`: all that stand behind are beside the part, or held by another pair.
    pub fn strayed(
        &self,
        plan: &Problem<'_>,
        committed: &State,
        kinematics: &[PointKinematics],
    ) -> Option<Strayed> {
        let behind =
            kinematics.iter().enumerate().filter(|(_, own)| !own.faces && own.behind > 0.0);
        let mut found: Vec<Strayed> = behind
            .map(|(place, own)| {
                let point = &self.points[place];
                let pair = self.parent(point.pair);
                Strayed { pair, node: point.node, depth: own.behind, element: 0 }
            })
            .collect();
        if found.is_empty() {
            return None;
        }
        let states = self.points.iter().zip(&committed.points);
        let mut held: Vec<NodeIndex> =
            states.filter(|(_, state)| state.closed).map(|(point, _)| point.node).collect();
        held.sort_unstable();
        found.retain(|own| held.binary_search(&own.node).is_err());
        found.sort_by(|a, b| b.depth.total_cmp(&a.depth).then(a.node.cmp(&b.node)));
        found.into_iter().find_map(|own| stands_in_solid(plan, committed, own))
    }
}

/// The same with the element in which it stands.
fn stands_in_solid(plan: &Problem<'_>, committed: &State, own: Strayed) -> Option<Strayed> {
    let u = &committed.displacement;
    let place =
        |node: NodeIndex| add(plan.model.nodes.position(node), plan.dofs.translation(u, node));
    let at = place(own.node);
    let mut places = Vec::new();
    for (block, element) in plan.step.presence.elements(&plan.model.blocks) {
        let is_solid = matches!(block.kind.kinematics, Kinematics::Solid { .. });
        if !is_solid || element.nodes.contains(&own.node) {
            continue;
        }
        places.clear();
        places.extend(element.nodes.iter().map(|&node| place(node)));
        let bound = |axis: usize, fold: fn(f64, f64) -> f64| {
            places.iter().map(|place| place[axis]).reduce(fold).unwrap_or(0.0)
        };
        let bounds: [[f64; 2]; 3] =
            std::array::from_fn(|axis| [bound(axis, f64::min), bound(axis, f64::max)]);
        let size = bounds.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        let is_about = bounds.iter().zip(at).all(|([low, high], x)| (*low..=*high).contains(&x));
        if !is_about || own.depth <= DEEP * size {
            continue;
        }
        let inside = within(block.kind.cell, &places, at);
        if inside.is_some_and(|inside| inside.distance <= UPON * size) {
            return Some(Strayed { element: element.label, ..own });
        }
    }
    None
}
