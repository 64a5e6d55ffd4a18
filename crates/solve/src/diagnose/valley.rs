//! A slave node in a valley of its master that nothing smooths.
//!
//! ```text
//!     \     o     /      each of both faces pushes the node to where it meets the other one: there
//!      \  ,' ',  /       is no equilibrium but between both, which a point on one face never finds
//!       \'  v  '/
//! ```

use super::case::Case;
use slideline_mech::vector::{cross, size, sub};
use slideline_model::{Master, NodeIndex, SlideLine};

/// Part of the shorter of both faces by which a node stands from the bottom, at most [1].
const NEAR: f64 = 0.05;

impl Case<'_> {
    /// A slave node that presses into a valley of a master without smoothed corners, and the node of the
    /// master at its bottom.
    pub(super) fn in_a_valley(&self) -> Option<(NodeIndex, NodeIndex)> {
        let points = self.plan.contact.points.iter().enumerate();
        let pressing = points.filter(|(place, point)| {
            point.is_node()
                && !self.plan.contact.is_edge(*place)
                && self.work.evaluation.points[*place].closed
        });
        pressing.into_iter().find_map(|(place, point)| {
            let pair = self.plan.pair_of(place);
            let Master::SlideLine(line) = &pair.master else { return None };
            let at = self.work.evaluation.kinematics.points()[place].position;
            (line.smooth == Some(0.0))
                .then(|| self.bottom_at(line, at))
                .flatten()
                .map(|b| (point.node, b))
        })
    }

    /// The node of a line at the bottom of a valley that a place is near.
    fn bottom_at(&self, line: &SlideLine, at: [f64; 3]) -> Option<NodeIndex> {
        let stands = |node: NodeIndex| {
            let from = self.plan.model.nodes.get(node).position;
            self.plan.dofs.translations(node).displace(from, &self.work.u)
        };
        line.nodes.windows(3).find_map(|nodes| {
            let [a, bottom, b] = [nodes[0], nodes[1], nodes[2]].map(stands);
            let (before, behind) = (sub(bottom, a), sub(b, bottom));
            // the outside is on the left of travel: a valley turns to the left
            let is_valley = cross(before, behind)[2] > 0.0;
            let is_near = size(sub(at, bottom)) < NEAR * size(before).min(size(behind));
            (is_valley && is_near).then_some(nodes[1])
        })
    }
}
