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

mod inward;
mod ranks;

use super::faces::{self, FacePlace, FaceTree, keep, nearest_of, walk};
use super::itself::{HERE, INSIDE_OF, LOOKS, STAYS, SUNK};
use crate::surface::mesh::{FaceMesh, PlacedFace};
use crate::vector::{Vector, add, cross, dot, scale, size, sub};
use inward::leads_in;
use ranks::ranks;
use std::collections::HashMap;

/// Faces about a node that are remembered.
const MOST: usize = 16;
/// Sizes of the faces about a node, or of all faces on average, beyond which it meets nothing [1].
const REACH: f64 = 8.0;

/// What a surface of faces knows of its own parts.
#[derive(Debug, Clone)]
pub struct OwnFaces {
    /// The faces that have a node, of every node.
    at: Vec<Vec<usize>>,
    /// Those and all that share a corner with them, in order.
    near: Vec<Vec<usize>>,
    /// Of every node: of two that meet, the lower one is the slave.
    ranks: Vec<usize>,
    /// How far every node looks [L].
    reach: Vec<f64>,
    /// Undeformed positions of the nodes [L].
    reference: Vec<Vector>,
    /// Depth of the part behind every face, undeformed [L]; infinite where nothing ends it.
    thickness: Vec<f64>,
    /// Of every node the first one of all that faces join it with.
    joined: Vec<usize>,
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
        let tree = faces::tree(mesh, reference);
        let depth = |face: usize| depth_behind((mesh, reference), &tree, (face, sizes[face]));
        let thickness = (0..mesh.faces().len()).map(depth).collect();
        let ranks = ranks((mesh, reference), &at, &fineness);
        let joined = joined(mesh, reference.len());
        Self { at, near, ranks, reach, reference: reference.to_vec(), thickness, joined }
    }

    /// The same of nodes that stand elsewhere undeformed; nothing is done where they do not.
    pub fn take(
        &mut self,
        mesh: &FaceMesh,
        reference: impl ExactSizeIterator<Item = Vector> + Clone,
    ) {
        let same = reference.len() == self.reference.len()
            && reference.clone().zip(&self.reference).all(|(new, old)| new == *old);
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
        let own = self.at[node].iter().map(|&face| placed.standing.normals[face]);
        let count = normals.iter_mut().zip(own).map(|(into, own)| *into = own).count();
        let thickness = self.thickness_at(node);
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
        if depth > SUNK * self.thickness[face] {
            return f64::INFINITY;
        }
        let nearest = nearest_of(mesh, positions, face, looking.point);
        let may = match depth > 0.0 {
            true => self.has_sunk_in(mesh, looking.node, (face, depth, nearest.square.sqrt())),
            false => looking.reaches(normal, nearest.way),
        };
        if may { nearest.square } else { f64::INFINITY }
    }

    /// Depth of the part at a node, undeformed: the least of the faces about it [L].
    fn thickness_at(&self, node: usize) -> f64 {
        let own = self.at[node].iter().map(|&face| self.thickness[face]);
        own.fold(f64::INFINITY, f64::min)
    }

    /// The same of those that look at a face of this normal: what lies between them is that deep. A
    /// plate is thin across, and wide between its hole and its rim.
    fn thickness_towards(&self, (mesh, node): (&FaceMesh, usize), normal: Vector) -> f64 {
        let looks = |&&own: &&usize| dot(mesh.normal(own, &self.reference), normal) < -LOOKS;
        let own = self.at[node].iter().filter(looks).map(|&face| self.thickness[face]);
        own.reduce(f64::min).unwrap_or_else(|| self.thickness_at(node))
    }

    /// Whether a node that is so deep behind a face and so far from it [L] has sunk in there. It has not where their own part was
    /// between them at the start, and they were back to back or the node is deeper than half of what is behind its own
    /// faces, as from the foot of a hook to its end; nor where it stood behind the face of its part before anything moved, as
    /// beside another limb, and has come no nearer since.
    fn has_sunk_in(
        &self,
        mesh: &FaceMesh,
        node: usize,
        (face, depth, distance): (usize, f64, f64),
    ) -> bool {
        let most = SUNK * self.thickness[face];
        if distance > most {
            return false;
        }
        let reference = &self.reference[..];
        let (from, normal) = (reference[node], mesh.normal(face, reference));
        let nearest = nearest_of(mesh, reference, face, from);
        let first = nearest.square.sqrt();
        // a hollow is no part of the outside by its faces, and far enough from it to be met
        let is_joined = self.joined[node] == self.joined[mesh.faces()[face].nodes[0]];
        // beside the face and in line with it, as exactly as a deck gives that, counts as behind
        let was_behind = is_joined && dot(normal, nearest.way) > -LOOKS * first;
        if was_behind && most.is_finite() && first <= most && distance > STAYS * first {
            return false;
        }
        let own = self.thickness_towards((mesh, node), normal);
        let near = INSIDE_OF * own.min(self.thickness[face]) + mesh.size(face, reference);
        if first > near && (depth <= SUNK * own || !is_joined) {
            return true;
        }
        // to the middle: which side of the part it leads to is asked, not how far
        let way = sub(mesh.middle(face, reference), from);
        dot(normal, way) <= 0.0 || !leads_in((mesh, reference), (node, &self.at[node]), way)
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

/// Of every node the first one of all that faces join it with.
fn joined(mesh: &FaceMesh, count: usize) -> Vec<usize> {
    let mut first: Vec<usize> = (0..count).collect();
    let mut is_new = true;
    while is_new {
        is_new = false;
        for face in mesh.faces() {
            let least = face.nodes.iter().map(|&node| first[first[node]]).min().unwrap_or_default();
            for &node in &face.nodes {
                is_new |= first[node] != least;
                first[node] = least;
            }
        }
    }
    first
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

/// How far the straight way inward from the middle of a face leads to the next face that ends its
/// part [L]; looked for within twice the distance, and twice, as long as there is more of it.
fn depth_behind(
    (mesh, reference): (&FaceMesh, &[Vector]),
    tree: &FaceTree,
    (face, own): (usize, f64),
) -> f64 {
    let (from, inward) = (mesh.middle(face, reference), scale(mesh.normal(face, reference), -1.0));
    let all = tree.bounds().map_or(0.0, |(low, high)| size(sub(high, low)));
    let mut length = own;
    while length > 0.0 {
        let to = add(from, scale(inward, length));
        let low = std::array::from_fn(|k| from[k].min(to[k]));
        let high = std::array::from_fn(|k| from[k].max(to[k]));
        let mut least = f64::INFINITY;
        tree.overlapping((low, high), |other| {
            if other != face {
                least = least.min(depth_of((mesh, reference), other, (from, inward)));
            }
        });
        if least <= length || length > all {
            return least;
        }
        length *= 2.0;
    }
    f64::INFINITY
}

/// How far a way leads until it leaves the material through a face [L]; infinite where it does not.
fn depth_of(
    (mesh, reference): (&FaceMesh, &[Vector]),
    face: usize,
    (from, way): (Vector, Vector),
) -> f64 {
    let own = &mesh.faces()[face];
    let depth = |triangle: &[usize; 3]| {
        let [a, b, c] = triangle.map(|corner| reference[own.nodes[corner]]);
        let (first, second, to) = (sub(b, a), sub(c, a), sub(from, a));
        let normal = cross(first, second);
        let leaves = dot(normal, way);
        if leaves <= 0.0 {
            return f64::INFINITY;
        }
        // a + v (b - a) + w (c - a) = from + depth way
        let aside = cross(to, way);
        let (v, w) = (-dot(second, aside) / leaves, dot(first, aside) / leaves);
        let depth = -dot(normal, to) / leaves;
        let hits = depth > 0.0 && v >= -super::INSIDE && w >= -super::INSIDE;
        if hits && v + w <= 1.0 + super::INSIDE { depth } else { f64::INFINITY }
    };
    own.triangles().iter().map(depth).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
