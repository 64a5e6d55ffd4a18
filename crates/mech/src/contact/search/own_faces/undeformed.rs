//! A surface that meets itself as it stood before anything moved: whether a node has sunk in behind a
//! face since, or stands on the other side of its own part.
//!
//! ```text
//!           ____
//!     _____/    |      x at the foot of a step stands behind the end of the part, seen through that: it has
//!    |    x     |      not sunk in there
//!    |__________|
//! ```
//!
//! docs/theory.md section 5.12. (derived)

use super::depth::depth_behind;
use super::inward::leads_in;
use super::ranks::stretches;
use crate::contact::search::faces::{self, nearest_of};
use crate::contact::search::itself::{INSIDE_OF, LOOKS, STAYS, SUNK};
use crate::surface::mesh::FaceMesh;
use crate::vector::{Vector, dot, sub};

/// What a surface of faces was before anything moved.
#[derive(Debug, Clone)]
pub(super) struct Undeformed {
    /// The faces that have a node, of every node.
    pub(super) at: Vec<Vec<usize>>,
    /// Positions of the nodes [L].
    pub(super) reference: Vec<Vector>,
    /// Depth of the part behind every face [L]; infinite where nothing ends it.
    pub(super) thickness: Vec<f64>,
    /// The stretch of connected faces of every node, by its first node.
    stretches: Vec<usize>,
}

impl Undeformed {
    /// The surface of faces whose nodes stand at `reference` [L], with the faces at every node.
    pub(super) fn new((mesh, reference): (&FaceMesh, &[Vector]), at: Vec<Vec<usize>>) -> Self {
        let tree = faces::tree(mesh, reference);
        let depth = |face: usize| {
            depth_behind((mesh, reference), &tree, (face, mesh.size(face, reference)))
        };
        let thickness = (0..mesh.faces().len()).map(depth).collect();
        let stretches = stretches(mesh, &at);
        Self { at, reference: reference.to_vec(), thickness, stretches }
    }

    /// Depth of the part at a node: the least of the faces about it [L].
    pub(super) fn thickness_at(&self, node: usize) -> f64 {
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

    /// Whether a node that is so deep behind a face and so far from it [L] has sunk in there. It has
    /// not where their own part was between them at the start, and they were back to back or the node
    /// is deeper than half of what is behind its own faces, as from the foot of a hook to its end; nor
    /// where it stood behind the face of its part before anything moved, as beside another limb, and
    /// has come no nearer since.
    pub(super) fn has_sunk_in(
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
        let is_joined = self.stretches[node] == self.stretches[mesh.faces()[face].nodes[0]];
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
