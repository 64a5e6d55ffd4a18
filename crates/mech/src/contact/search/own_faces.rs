//! A surface of faces in space that meets itself: which of its own faces may a node of it touch?
//!
//! ```text
//!     ______________
//!    /  upper wall /     a node of the upper wall meets a face of the lower one: they look at one
//!   /______.______/      another, are no neighbours, and the node stands in front of the face, or
//!    \     : gap  \      no deeper behind it than half the part is thick there
//!     \____v_______\
//!        lower wall
//! ```
//!
//! The rules are those of a surface in the plane ([`super::itself`]); a node looks no farther than a
//! few faces about it. docs/theory.md section 5.12. (derived)

mod depth;
mod inward;
mod ranks;
mod undeformed;

use super::faces::{FacePlace, FaceTree, keep, nearest_of, walk};
use super::itself::{HERE, LOOKS, SUNK};
use crate::surface::mesh::{FaceMesh, PlacedFace};
use crate::vector::{Vector, dot, size, sub};
use ranks::ranks;
use std::collections::HashMap;
use undeformed::Undeformed;

/// Faces about a node that are remembered.
const MOST: usize = 16;
/// Sizes of the faces about a node, or of all faces on average, beyond which it meets nothing [1].
const REACH: f64 = 8.0;

/// What a surface of faces knows of its own parts.
#[derive(Debug, Clone)]
pub struct OwnFaces {
    /// The surface as it stood before anything moved.
    undeformed: Undeformed,
    /// The faces that have a node and all that share a corner with them, in order.
    near: Vec<Vec<usize>>,
    /// Of every node: of two that meet, the lower one is the slave.
    ranks: Vec<usize>,
    /// How far every node looks [L].
    reach: Vec<f64>,
}

/// How the faces of a surface stand, face by face.
#[derive(Debug, Clone, Default)]
pub struct Standing {
    /// Unit normals [1].
    normals: Vec<Vector>,
    /// The middles of their corners [L].
    middles: Vec<Vector>,
}

impl Standing {
    /// Takes how they stand with nodes at these positions [L].
    pub fn take(&mut self, mesh: &FaceMesh, positions: &[Vector]) {
        let faces = || 0..mesh.faces().len();
        self.normals.clear();
        self.normals.extend(faces().map(|face| mesh.normal(face, positions)));
        self.middles.clear();
        self.middles.extend(faces().map(|face| mesh.middle(face, positions)));
    }
}

/// A surface of faces where it stands.
#[derive(Clone, Copy)]
pub struct PlacedOwn<'a> {
    /// Its faces.
    pub mesh: &'a FaceMesh,
    /// Positions of its nodes [L].
    pub positions: &'a [Vector],
    /// How its faces stand at these.
    pub standing: &'a Standing,
    /// A tree fitted to them.
    pub tree: &'a FaceTree,
}

/// A face that a node meets, and its distance [L].
#[derive(Clone, Copy)]
struct Met {
    face: usize,
    distance: f64,
}

/// A node with the unit normals of the faces about it, and the least depth of the part behind them.
struct Looking {
    node: usize,
    point: Vector,
    normals: [Vector; MOST],
    count: usize,
    thickness: f64,
}

impl OwnFaces {
    /// The surface of faces whose nodes stand at `reference` undeformed [L].
    pub fn new(mesh: &FaceMesh, reference: &[Vector]) -> Self {
        let mut at = vec![Vec::new(); reference.len()];
        for (face, own) in mesh.faces().iter().enumerate() {
            own.nodes.iter().for_each(|&node| at[node].push(face));
        }
        let going_on = going_on((mesh, reference), &at);
        let near = at.iter().zip(&going_on).map(|(faces, going_on)| {
            let own = || faces.iter().chain(going_on).copied();
            let around = own().flat_map(|face| mesh.around(face).iter().copied());
            let mut near: Vec<usize> = own().chain(around).collect();
            near.sort_unstable();
            near.dedup();
            near
        });
        let near: Vec<Vec<usize>> = near.collect();
        let sizes: Vec<f64> =
            (0..mesh.faces().len()).map(|face| mesh.size(face, reference)).collect();
        let mean = |faces: &[usize]| {
            faces.iter().map(|&face| sizes[face]).sum::<f64>() / faces.len().max(1) as f64
        };
        let fineness: Vec<f64> = near.iter().map(|faces| mean(faces)).collect();
        let all = sizes.iter().sum::<f64>() / sizes.len().max(1) as f64;
        let reach = fineness.iter().map(|&own| REACH * own.max(all)).collect();
        let ranks = ranks((mesh, reference), &at, &fineness);
        Self { undeformed: Undeformed::new((mesh, reference), at), near, ranks, reach }
    }

    /// The same of nodes that stand elsewhere undeformed; nothing is done where they do not.
    pub fn take(
        &mut self,
        mesh: &FaceMesh,
        reference: impl ExactSizeIterator<Item = Vector> + Clone,
    ) {
        let known = &self.undeformed.reference;
        let same = reference.len() == known.len()
            && reference.clone().zip(known).all(|(new, old)| new == *old);
        if !same {
            *self = Self::new(mesh, &reference.collect::<Vec<_>>());
        }
    }

    /// Whether a node can pass through a face.
    pub fn stops(&self, node: usize, face: usize) -> bool {
        self.near[node].binary_search(&face).is_err()
    }

    /// What a node meets: the nearest face that it may meet, unless that one's nearest node meets it
    /// here and ranks before it. Open ends are prolonged by `extension` of their faces; the face
    /// `before`, on which it stood, keeps it until it is well beyond its edge.
    pub fn closest(
        &self,
        placed: PlacedOwn<'_>,
        (node, extension, before): (usize, f64, Option<usize>),
        room: &mut PlacedFace,
    ) -> Option<FacePlace> {
        let looking = self.looking(placed, node);
        let met = self.nearest(placed, &looking)?;
        let apart = |&other: &usize| size(sub(placed.positions[other], looking.point));
        let nodes = placed.mesh.faces()[met.face].nodes.iter().copied();
        let other = nodes.min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        if self.ranks[other] < self.ranks[node] {
            let reach = met.distance + HERE * apart(&other);
            let back = self.nearest(placed, &self.looking(placed, other));
            let yields = back.is_some_and(|back| {
                let own = &placed.mesh.faces()[back.face].nodes;
                back.distance <= reach && own.contains(&node)
            });
            if yields {
                return None;
            }
        }
        self.place(placed, (&looking, met, extension, before), room)
    }

    /// What a node meets, whichever of both is the slave.
    pub fn met(
        &self,
        placed: PlacedOwn<'_>,
        (node, extension): (usize, f64),
        room: &mut PlacedFace,
    ) -> Option<FacePlace> {
        let looking = self.looking(placed, node);
        let met = self.nearest(placed, &looking)?;
        self.place(placed, (&looking, met, extension, None), room)
    }

    fn place(
        &self,
        placed: PlacedOwn<'_>,
        (looking, met, extension, before): (&Looking, Met, f64, Option<usize>),
        room: &mut PlacedFace,
    ) -> Option<FacePlace> {
        let (PlacedOwn { mesh, positions, standing, .. }, point) = (placed, looking.point);
        let may_keep = |&face: &usize| {
            self.stops(looking.node, face) && looking.looks_at(standing.normals[face])
        };
        let kept = before
            .filter(may_keep)
            .and_then(|face| keep(mesh, positions, (face, point), (extension, met.distance), room));
        if kept.is_some() {
            return kept;
        }
        let may = |face: usize| self.distance(placed, looking, face).is_finite();
        walk((mesh, positions), (met.face, point, extension), may, room)
    }

    fn looking(&self, placed: PlacedOwn<'_>, node: usize) -> Looking {
        let mut normals = [[0.0; 3]; MOST];
        let own = self.undeformed.at[node].iter().map(|&face| placed.standing.normals[face]);
        let count = normals.iter_mut().zip(own).map(|(into, own)| *into = own).count();
        let thickness = self.undeformed.thickness_at(node);
        Looking { node, point: placed.positions[node], normals, count, thickness }
    }

    fn nearest(&self, placed: PlacedOwn<'_>, looking: &Looking) -> Option<Met> {
        let measure = |face: usize| self.distance(placed, looking, face);
        let found = placed.tree.nearest_within(looking.point, self.reach[looking.node], measure);
        found.map(|(face, square)| Met { face, distance: square.sqrt() })
    }

    /// Square of the distance of a node from a face [L2]; infinite where it may not meet it. What
    /// costs least is asked first: most faces near a node are those of its own wall.
    fn distance(
        &self,
        PlacedOwn { mesh, positions, standing, .. }: PlacedOwn<'_>,
        looking: &Looking,
        face: usize,
    ) -> f64 {
        let normal = standing.normals[face];
        if !looking.looks_at(normal) || !self.stops(looking.node, face) {
            return f64::INFINITY;
        }
        let depth = dot(normal, sub(standing.middles[face], looking.point));
        if depth > SUNK * self.undeformed.thickness[face] {
            return f64::INFINITY;
        }
        let nearest = nearest_of(mesh, positions, face, looking.point);
        let may = match depth > 0.0 {
            true => self.undeformed.has_sunk_in(
                mesh,
                looking.node,
                (face, depth, nearest.square.sqrt()),
            ),
            false => looking.reaches(normal, nearest.way),
        };
        if may { nearest.square } else { f64::INFINITY }
    }
}

impl Looking {
    /// Whether one of the faces about the node and a face with that normal look at one another.
    fn looks_at(&self, normal: Vector) -> bool {
        self.normals[..self.count].iter().any(|own| dot(*own, normal) < -LOOKS)
    }

    /// Whether the way to a face in front of which the node stands does not lead through the part: it
    /// leaves one of the faces that look at that face, or is shorter than the part could be sunk in.
    fn reaches(&self, normal: Vector, way: Vector) -> bool {
        let (length, mut all) = (size(way), self.normals[..self.count].iter());
        length <= SUNK * self.thickness
            || all.any(|own| dot(*own, normal) < -LOOKS && dot(*own, way) > LOOKS * length)
    }
}

/// The faces with which the surface goes on at every node though they have another one in its place, as
/// beyond the cut through a bolt: those that look at none of the node's own faces.
fn going_on((mesh, reference): (&FaceMesh, &[Vector]), at: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut standing: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
    for (node, place) in reference.iter().enumerate() {
        // the same place but for the sign of a zero
        standing.entry(place.map(|x| (x + 0.0).to_bits())).or_default().push(node);
    }
    let mut going_on = vec![Vec::new(); reference.len()];
    for nodes in standing.values().filter(|nodes| nodes.len() > 1) {
        for &node in nodes {
            let others = nodes.iter().filter(|&&other| other != node);
            let faces = others.flat_map(|&other| at[other].iter().copied());
            let looks = |face: usize, own: usize| {
                dot(mesh.normal(face, reference), mesh.normal(own, reference)) < -LOOKS
            };
            going_on[node] =
                faces.filter(|&face| !at[node].iter().any(|&own| looks(face, own))).collect();
        }
    }
    going_on
}

#[cfg(test)]
mod tests;
