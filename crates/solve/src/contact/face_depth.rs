//! Ridges and rounds of analytical surfaces that stand in faces of the slave, between its nodes.
//!
//! ```text
//!         slave          contact is at the nodes of the slave, and an analytical surface has no nodes
//!      o----------o      that could be held: what lies between two slave nodes goes in unheld
//!       '-. /\ .-'
//!          '  '   master
//! ```

use super::edges::EdgeInside;
use super::falls::places;
use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::PointState;
use slideline_mech::vector::size;
use slideline_model::NodeIndex;
use std::collections::HashSet;

/// Part of the size of a face by which its master may stand in it between its nodes unsaid [1].
const DEEP: f64 = 0.1;
/// The same by which a place is moved to see whether the master is met from before [1].
const ASIDE: f64 = 0.01;

impl Contact {
    /// The deepest analytical surface in a face between slave nodes none of which is closed.
    pub fn surface_inside(
        &self,
        (u, points): (&[f64], &[PointState]),
        positions: &MasterPositions,
    ) -> Option<EdgeInside> {
        let held = self.points.iter().zip(points).filter(|(_, state)| state.closed);
        let held: HashSet<NodeIndex> = held.map(|(point, _)| point.node).collect();
        let own = (0..self.points.len()).filter(|&place| {
            let point = &self.points[place];
            point.is_node() && point.pair < self.own_pairs() && self.is_analytical(point.pair)
        });
        let found = own.flat_map(|place| {
            let faces = self.points[place].faces.iter();
            // each face once, by its first node
            let first = faces.filter(|&&face| {
                let mut nodes = self.slave_faces[face].corners.iter().map(|(node, ..)| *node);
                nodes.next() == Some(self.points[place].node)
                    && !held.contains(&self.points[place].node)
                    && !nodes.any(|node| held.contains(&node))
            });
            let first: Vec<usize> = first.copied().collect();
            first.into_iter().filter_map(move |face| self.in_face(place, face, u, positions))
        });
        found.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, inside)| inside)
    }

    fn is_analytical(&self, pair: usize) -> bool {
        match &self.masters[pair] {
            MasterSurface::Body { .. } => true,
            MasterSurface::Faces { mesh, .. } => mesh.swept().is_some(),
            _ => false,
        }
    }

    /// How deep the master of a slave node stands in a face beyond what the nodes of the face show, in sizes of the
    /// face; `None` where that is little.
    fn in_face(
        &self,
        place: usize,
        face: usize,
        u: &[f64],
        positions: &MasterPositions,
    ) -> Option<(f64, EdgeInside)> {
        let (point, own) = (&self.points[place], &self.slave_faces[face]);
        let depth = |at| self.depth_at(point, at, (u, positions));
        let (corners, (normal, long)) = (own.places(u), own.stands(u));
        let near = corners.iter().any(|&at| depth(at).is_some_and(|own| own.abs() <= long));
        if !near || long <= 0.0 {
            return None;
        }
        let shown = corners.iter().filter_map(|&at| depth(at)).fold(0.0, f64::max);
        let step = ASIDE * long / size(normal);
        let deepest = places(&corners).into_iter().filter_map(|at| {
            let own = depth(at)?;
            let ahead = depth(std::array::from_fn(|axis| at[axis] + step * normal[axis]))?;
            (ahead > own).then_some(own - shown)
        });
        let depth = deepest.fold(0.0, f64::max);
        let face = own.corners.iter().map(|(node, ..)| *node).collect();
        let inside = EdgeInside { pair: point.pair, edge: None, face, depth };
        (DEEP * long..=long).contains(&depth).then_some((depth / long, inside))
    }
}
