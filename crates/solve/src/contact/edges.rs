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
use super::slave_face::SlaveFace;
use crate::state::PointState;
use slideline_mech::contact::search::sharp;
use slideline_mech::pressure::Face;
use slideline_mech::vector::{dot, size, sub};
use slideline_model::NodeIndex;

/// Part of the size of a face by which an edge may stand in it unsaid [1]: less is what faces that bend
/// about an edge, and meshes that do not match, come to.
const DEEP: f64 = 0.1;
/// Places along an edge in space that are looked at, its ends among them.
const PLACES: usize = 5;
/// Cosine of the angle at which a place stands straight behind a border [1]: 2.6 degrees. (choice)
const STRAIGHT: f64 = 0.999;
/// Share of the nodes of a face that a place in it has at least [1]: less stands upon its border.
const WITHIN: f64 = 1e-6;

/// An edge of a master in a face of the slave.
#[derive(Debug, Clone)]
pub struct EdgeInside {
    /// The pair.
    pub pair: usize,
    /// What of the master.
    pub what: Found,
    /// Corners of the face.
    pub face: Vec<NodeIndex>,
    /// How deep it stands [L].
    pub depth: f64,
}

/// What of a master stands in a face of the slave; nodes by their places among those of the master.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Found {
    /// A sharp edge, near a node of it.
    Edge(usize),
    /// A node, in the part of the slave.
    Node(usize),
    /// A place of an analytical surface.
    Surface,
}

/// A place of a master, and the face of the slave that is nearest to it.
pub(super) struct EdgePlace {
    pub(super) at: [f64; 3],
    pub(super) node: usize,
    pub(super) nearest: Option<NearFace>,
}

#[derive(Clone, Copy)]
pub(super) struct NearFace {
    pub(super) face: usize,
    pub(super) distance: f64,
    /// How deep it stands behind the face, in sizes of the face [1]; zero before it or beside it.
    pub(super) depth: f64,
    /// The same, upon the border of the face too, where the place stands straight behind that.
    pub(super) straight: f64,
}

impl Contact {
    /// The deepest sharp edge of a master that stands in a face between slave nodes, of pairs that are
    /// closed somewhere.
    pub fn edge_inside(&self, u: &[f64], points: &[PointState]) -> Option<EdgeInside> {
        let pairs = (0..self.own_pairs()).filter(|&pair| self.sharp[pair]);
        let closed = |pair: usize| {
            let own = self.points.iter().zip(points);
            own.into_iter().any(|(point, state)| {
                point.pair == pair && state.closed && point.is_node() && point.mortar.is_none()
            })
        };
        let found = pairs.filter(|&pair| closed(pair)).filter_map(|pair| self.edge_of(pair, u));
        found.max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    fn edge_of(&self, pair: usize, u: &[f64]) -> Option<EdgeInside> {
        let mut edges = self.edge_places(pair, u);
        let axis = in_order(&mut edges);
        let own = self.points.iter().filter(|point| point.pair == pair && point.is_node());
        let mut faces: Vec<usize> = own.flat_map(|point| &point.faces).copied().collect();
        faces.sort_unstable();
        faces.dedup();
        for face in faces {
            note_nearest((face, &self.slave_faces[face]), u, (&mut edges, axis));
        }
        let inside = edges.iter().filter_map(|place| {
            let near = place.nearest.filter(|near| near.depth >= DEEP)?;
            let corners = &self.slave_faces[near.face].corners;
            let face = corners.iter().map(|(node, ..)| *node).collect();
            Some(EdgeInside { pair, what: Found::Edge(place.node), face, depth: near.distance })
        });
        inside.max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// Places of the sharp edges of a master that does not meet itself.
    fn edge_places(&self, pair: usize, u: &[f64]) -> Vec<EdgePlace> {
        let place = |at, node| EdgePlace { at, node, nearest: None };
        match &self.masters[pair] {
            MasterSurface::Line { nodes, beyond, itself: None, .. } => {
                let nodes = &nodes[beyond.own(nodes.len())];
                let stands = |node: usize| nodes[node].1.displace(nodes[node].0, u);
                let inner = 1..nodes.len().saturating_sub(1);
                inner
                    .filter(|&n| sharp::is_sharp([n - 1, n, n + 1].into_iter().map(stands)))
                    .map(|node| place(stands(node), node))
                    .collect()
            }
            MasterSurface::Faces { mesh, nodes, itself: None, .. } if mesh.swept().is_none() => {
                let stands: Vec<[f64; 3]> =
                    nodes.iter().map(|(from, dofs)| dofs.displace(*from, u)).collect();
                let mut places = Vec::new();
                for (own, face) in mesh.faces().iter().enumerate() {
                    for (edge, _) in mesh.ends(own).iter().enumerate().filter(|(_, ends)| **ends) {
                        // each edge once, and none behind which the surface ends
                        let other = mesh.neighbour(own, edge).filter(|other| own < *other);
                        if other.is_none_or(|other| !mesh.stands_out(own, other, &stands)) {
                            continue;
                        }
                        let count = face.cell.faces.len();
                        let [a, b] = [edge, (edge + 1) % count].map(|corner| face.nodes[corner]);
                        places.extend((0..PLACES).map(|k| {
                            let t = k as f64 / (PLACES - 1) as f64;
                            let way = sub(stands[b], stands[a]);
                            let at = std::array::from_fn(|axis| stands[a][axis] + t * way[axis]);
                            place(at, if 2 * k < PLACES { a } else { b })
                        }));
                    }
                }
                places
            }
            _ => Vec::new(),
        }
    }
}

/// Sorts places along the axis along which they stand farthest apart, which is returned.
pub(super) fn in_order(places: &mut [EdgePlace]) -> usize {
    let apart = |axis: usize| {
        let along = || places.iter().map(|place| place.at[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let axis = (0..3).max_by(|&a, &b| apart(a).total_cmp(&apart(b))).unwrap_or(0);
    places.sort_unstable_by(|a, b| {
        let along = a.at[axis].total_cmp(&b.at[axis]);
        along.then(a.node.cmp(&b.node))
    });
    axis
}

/// Notes a face at the places, in order along an axis, that it is nearest to.
pub(super) fn note_nearest(
    (number, face): (usize, &SlaveFace),
    u: &[f64],
    (edges, along): (&mut [EdgePlace], usize),
) {
    let x: Vec<[f64; 3]> =
        face.corners.iter().map(|(_, from, dofs)| dofs.displace(*from, u)).collect();
    let (normal, long) = face.stands(u);
    let dimension = if x.len() == 2 { 2 } else { 3 };
    let (Some(kind), true) = (Face::of(dimension, x.len(), 1.0), long > 0.0) else { return };
    let reach = [0, 1, 2].map(|axis| {
        let of = x.iter().map(|at| at[axis]);
        let low = of.clone().fold(f64::INFINITY, f64::min) - long;
        [low, of.fold(f64::NEG_INFINITY, f64::max) + long]
    });
    let begin = edges.partition_point(|place| place.at[along] < reach[along][0]);
    let near = edges[begin..].iter_mut();
    for place in near.take_while(|place| place.at[along] <= reach[along][1]) {
        if (0..3).any(|axis| !(reach[axis][0]..=reach[axis][1]).contains(&place.at[axis])) {
            continue;
        }
        let near = kind.nearest(&x, place.at);
        // what stands farther off lies in the box or not by how the model is turned
        let is_near = near.distance <= long;
        if !is_near || place.nearest.is_some_and(|other| other.distance <= near.distance) {
            continue;
        }
        let behind = dot(sub(near.place, place.at), normal) / size(normal);
        let is_within = near.shapes[..x.len()].iter().all(|share| *share > WITHIN);
        let is_straight = is_within || behind >= STRAIGHT * near.distance;
        let [depth, straight] =
            [is_within, is_straight].map(|is| if is { (behind / long).max(0.0) } else { 0.0 });
        place.nearest = Some(NearFace { face: number, distance: near.distance, depth, straight });
    }
}
