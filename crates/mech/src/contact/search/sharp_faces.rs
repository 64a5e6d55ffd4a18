//! The face in space that a slave node faces about a sharp edge.
//!
//! ```text
//!            x  node, its faces look down       the nearest face is the side; the node faces
//!      ______  . . .                            the top, which is prolonged a little for it
//!     / top  /|
//!    /______/ | side
//! ```
//!
//! docs/theory.md section 5.14. (derived)

use super::faces::{FacePlace, FaceTree, beyond, nearest_face, nearest_of, project};
use super::outlook::{BEYOND, Outlook, SUNK};
use crate::surface::mesh::{FaceMesh, PlacedFace};
use crate::vector::{Vector, dot, scale, size, sub};

/// The same as [`BEYOND`] for a node that stood on the face [1]: farther by half of that, so that it does not
/// come back by what it moves as it is let go.
const KEPT: f64 = 1.5 * BEYOND;
/// Faces of a side that are looked at.
const SIDE: usize = 32;
/// Faces that are asked one after the other beyond an edge.
const WAY: usize = 4;

/// What faces a slave node: the nearest face ([`super::faces::closest`]), or, about a sharp edge, a
/// face beyond it that looks at the node.
pub fn closest(
    mesh: &FaceMesh,
    positions: &[Vector],
    tree: &FaceTree,
    (point, extension, before, outlook): (Vector, f64, Option<usize>, &Outlook),
    room: &mut PlacedFace,
) -> Option<FacePlace> {
    let about = About { mesh, positions, point, outlook, extension, before };
    let before = before.filter(|&face| about.meets(face));
    let found = super::faces::closest(mesh, positions, tree, (point, extension, before), room);
    if outlook.is_everywhere() || mesh.swept().is_some() {
        return found;
    }
    let from = found.map(|found| found.face);
    let from = from.or_else(|| nearest_face(mesh, positions, tree, point))?;
    if !about.meets(from) {
        return about.beyond_edges(from, room).or(found);
    }
    // beyond a corner of the master, where edges meet, any face of it may be the nearest: all answer alike
    match found.filter(|found| about.meets(found.face)) {
        Some(found) => Some(found),
        None => about.place_on(from, room).map(|(_, place)| place).or(found),
    }
}

/// A slave node about faces.
struct About<'a> {
    mesh: &'a FaceMesh,
    positions: &'a [Vector],
    point: Vector,
    outlook: &'a Outlook,
    /// Part of its face by which an open end is prolonged [1].
    extension: f64,
    /// The face on which the node stood.
    before: Option<usize>,
}

impl About<'_> {
    /// Whether a face looks at the node.
    fn meets(&self, face: usize) -> bool {
        self.outlook.is_everywhere() || self.outlook.meets(self.mesh.normal(face, self.positions))
    }

    /// The nearest face that looks at the node beyond the sharp edges about the side of a face that
    /// does not: where the node has sunk in no deeper than half of that side.
    fn beyond_edges(&self, from: usize, room: &mut PlacedFace) -> Option<FacePlace> {
        let mut side = [usize::MAX; SIDE];
        (side[0], side[1]) = (from, usize::MAX);
        let (mut count, mut next) = (1, 0);
        let mut best: Option<(f64, FacePlace)> = None;
        while next < count {
            let face = side[next];
            next += 1;
            for edge in 0..self.mesh.faces()[face].cell.faces.len() {
                let Some(other) = self.mesh.neighbour(face, edge) else { continue };
                let is_edge = self.mesh.stands_out(face, other, self.positions);
                if is_edge && self.meets(other) {
                    let found = self.place_on(other, room);
                    let nearer = |found: &(f64, FacePlace)| best.is_none_or(|b| found.0 < b.0);
                    best = found.filter(nearer).or(best);
                } else if !is_edge && count < SIDE && !side[..count].contains(&other) {
                    side[count] = other;
                    count += 1;
                }
            }
        }
        let (depth, place) = best?;
        (depth <= SUNK * self.extent(&side[..count], place.face)).then_some(place)
    }

    /// How deep a side reaches behind the plane of a face [L].
    fn extent(&self, side: &[usize], face: usize) -> f64 {
        let (normal, middle) =
            (self.mesh.normal(face, self.positions), self.mesh.middle(face, self.positions));
        let nodes = side.iter().flat_map(|&own| &self.mesh.faces()[own].nodes);
        let depths = nodes.map(|&node| dot(sub(middle, self.positions[node]), normal));
        depths.fold(0.0, f64::max)
    }

    /// Distance of the node from a face, or the one beside it that it stands before, and its place
    /// there; `None` where it stands too far beyond an edge, or too deep.
    fn place_on(&self, mut face: usize, room: &mut PlacedFace) -> Option<(f64, FacePlace)> {
        for _ in 0..WAY {
            let start = nearest_of(self.mesh, self.positions, face, self.point).place;
            let patch = self.mesh.place(face, self.positions, room)?;
            let at = project(&patch, start, self.point)?;
            let (edge, outside) = beyond(patch.corners(), at);
            let neighbour = self.mesh.neighbour(face, edge);
            if neighbour.is_none() && outside > self.extension.max(super::INSIDE) {
                return None;
            }
            let goes_on = |&next: &usize| {
                self.meets(next) && !self.mesh.stands_out(face, next, self.positions)
            };
            if let Some(next) = neighbour.filter(|_| outside > super::INSIDE).filter(goes_on) {
                face = next;
                continue;
            }
            let nearest = patch.position(&patch.place(start).value);
            let (way, normal) = (sub(self.point, nearest), self.mesh.normal(face, self.positions));
            let height = dot(way, normal);
            let apart = size(sub(way, scale(normal, height)));
            let own = self.mesh.size(face, self.positions);
            let reach = if self.before == Some(face) { KEPT } else { BEYOND };
            let near = apart <= reach * own.min(self.outlook.size()) && -height <= SUNK * own;
            return near.then_some((height.abs(), FacePlace { face, at }));
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::search::faces;
    use crate::element::cell::QUAD4;
    use crate::surface::mesh::MeshFace;

    /// The unit cube, its faces looking out, the top at a place among them.
    fn cube(top: usize) -> (FaceMesh, Vec<Vector>) {
        let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(|x| x as f64);
        let positions: Vec<Vector> = (0..8).map(corner).collect();
        let mut all =
            [[4, 5, 7, 6], [0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        all[..=top].rotate_left(1);
        let faces = all.map(|nodes| MeshFace { cell: &QUAD4, nodes: nodes.to_vec() });
        (FaceMesh::new(faces.to_vec(), &positions, false), positions)
    }

    /// Whether a corner of a block upon the cube meets the top, so far beyond an edge, `aside` beyond the next one,
    /// and over the top.
    fn met(
        (top, side): (usize, usize),
        [beyond, aside, height]: [f64; 3],
        before: Option<usize>,
    ) -> bool {
        let (mesh, positions) = cube(top);
        let tree = faces::tree(&mesh, &positions);
        let (axis, sign) = (side / 2, if side % 2 == 0 { 1.0 } else { -1.0 });
        let mut outlook = Outlook::EVERYWHERE;
        let mut outward: Vector = [0.0; 3];
        outward[axis] = sign;
        for normal in [[0.0, 0.0, -1.0], outward, [outward[1].abs(), outward[0].abs(), 0.0]] {
            outlook.add(normal, 1.0);
        }
        let mut point = [1.0 + aside, 1.0 + aside, 1.0 + height];
        point[axis] = 0.5 + sign * (0.5 + beyond);
        let at = (point, 0.0, before, &outlook);
        let found = closest(&mesh, &positions, &tree, at, &mut { PlacedFace::EMPTY });
        found.is_some_and(|found| found.face == top)
    }

    /// Requirement: a corner of what stands on the cube, hardly beyond an edge of its top, meets the top as far as
    /// that is prolonged, be it above it, upon it or in it, at every edge and whichever face is found first: which
    /// side of the edge is nearer tells nothing. One that stood on the top keeps it a little farther.
    #[test]
    fn both_sides_of_an_edge_answer_alike() {
        let beyond = [0.0, 1e-9, 0.02, 0.049, 0.051, 0.099, 0.12, 0.3];
        let aside = [-0.6, -1e-3, 0.0, 1e-3, 0.01];
        let height = [0.02, 1e-3, 1e-9, 0.0, -1e-9, -1e-3, -0.02];
        let places = || aside.iter().flat_map(|&a| height.map(|h| (a, h)));
        for of in (0..6).flat_map(|top| (0..4).map(move |side| (top, side))) {
            for (beyond, (aside, height)) in
                beyond.iter().flat_map(|&b| places().map(move |own| (b, own)))
            {
                for (before, reach) in [(None, BEYOND), (Some(of.0), KEPT)] {
                    let meets = met(of, [beyond, aside, height], before);
                    let apart = beyond.hypot(f64::max(aside, 0.0));
                    assert_eq!(meets, apart < reach, "{of:?} {beyond} {aside} {height} {reach}");
                }
            }
        }
    }
}
