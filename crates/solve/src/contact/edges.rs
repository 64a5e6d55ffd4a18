//! Sharp edges of a deforming master that stand in faces of the slave, between its nodes.
//!
//! ```text
//!      \     slave
//!       \            |~~~~~~      contact is at the nodes of the slave: the edge goes into its face
//!        o-----------X            unheld, and the node behind it catches on the side of the master
//!               side |  master
//! ```

use super::master::MasterSurface;
use super::pairs::Contact;
use crate::state::PointState;
use slideline_mech::contact::search::sharp;
use slideline_mech::vector::{cross, dot, sub};
use slideline_model::NodeIndex;

/// Part of the length of a face by which an edge may stand in it unsaid [1]: less is what faces that bend
/// about an edge, and meshes that do not match, come to.
const DEEP: f64 = 0.1;

/// An edge of a master in a face of the slave.
#[derive(Debug, Clone, Copy)]
pub struct EdgeInside {
    /// The pair.
    pub pair: usize,
    /// Place of the edge in the chain of its master.
    pub edge: usize,
    /// Nodes of the face.
    pub face: [NodeIndex; 2],
    /// How deep it stands [L].
    pub depth: f64,
}

impl Contact {
    /// The deepest sharp edge of a master that stands in a face between two slave nodes, of pairs that are
    /// closed somewhere; in the plane.
    pub fn edge_inside(&self, u: &[f64], points: &[PointState]) -> Option<EdgeInside> {
        let pairs = (0..self.masters.len()).filter(|&pair| self.sharp[pair]);
        let closed = |pair: usize| {
            let own = self.points.iter().zip(points);
            own.into_iter().any(|(point, state)| point.pair == pair && state.closed)
        };
        let found = pairs.filter(|&pair| closed(pair)).filter_map(|pair| self.edge_of(pair, u));
        found.max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    fn edge_of(&self, pair: usize, u: &[f64]) -> Option<EdgeInside> {
        let MasterSurface::Line { nodes, itself: None, .. } = &self.masters[pair] else {
            return None;
        };
        let stands = |place: usize| nodes[place].1.displace(nodes[place].0, u);
        let edges = (1..nodes.len().saturating_sub(1))
            .filter(|&edge| sharp::is_sharp([edge - 1, edge, edge + 1].into_iter().map(stands)));
        let found = edges.flat_map(|edge| {
            let at = stands(edge);
            let own = self.points.iter().filter(move |point| point.pair == pair && point.is_node());
            own.flat_map(|point| &point.faces).filter_map(move |&face| {
                let (depth, face) = self.depth_in(face, at, u)?;
                Some(EdgeInside { pair, edge, face, depth })
            })
        });
        found.max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// How deep a place stands in a face of the slave, and the nodes of that; `None` where it stands before
    /// it, beside it, hardly in it or farther behind it than it is long.
    fn depth_in(&self, face: usize, at: [f64; 3], u: &[f64]) -> Option<(f64, [NodeIndex; 2])> {
        let [first, last] = &self.slave_faces[face].corners[..] else { return None };
        let [a, b] = [first, last].map(|(_, from, dofs)| dofs.displace(*from, u));
        let (along, off) = (sub(b, a), sub(at, a));
        let square = dot(along, along);
        let t = dot(along, off) / square;
        // the material is on the left
        let depth = cross(along, off)[2] / square;
        let is_inside = (0.0..=1.0).contains(&t) && (DEEP..=1.0).contains(&depth);
        is_inside.then_some((depth * square.sqrt(), [first.0, last.0]))
    }
}
