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
use super::solids_of_side::{Behind, SolidsOfSide};
use crate::problem::Problem;
use crate::state::{PointState, State};
use slideline_model::NodeIndex;

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
        let mut found: Vec<(usize, Behind)> = behind
            .map(|(place, now)| {
                let point = &self.points[place];
                let own = Behind { node: point.node, depth: now.behind, normal: now.normal };
                (self.parent(point.pair), own)
            })
            .collect();
        if found.is_empty() {
            return None;
        }
        let held = self.held_nodes(&committed.points);
        found.retain(|(_, behind)| held.binary_search(&behind.node).is_err());
        found.sort_by(|(of, a), (other, b)| of.cmp(other).then(a.deeper_first(b)));
        let parts = found.chunk_by(|a, b| a.0 == b.0);
        parts.into_iter().find_map(|of_pair| {
            let pair = of_pair[0].0;
            let of_master = plan.model.contact_pairs[pair].master.deforming_nodes();
            let part = SolidsOfSide::new(plan, committed, &of_master)?;
            of_pair.iter().find_map(|(_, behind)| {
                let element = part.holds(behind)?;
                Some(Strayed { pair, node: behind.node, depth: behind.depth, element })
            })
        })
    }

    /// Nodes that are closed in some pair, in order.
    pub(super) fn held_nodes(&self, points: &[PointState]) -> Vec<NodeIndex> {
        let states = self.points.iter().zip(points);
        let mut held: Vec<NodeIndex> =
            states.filter(|(_, state)| state.closed).map(|(point, _)| point.node).collect();
        held.sort_unstable();
        held
    }
}
