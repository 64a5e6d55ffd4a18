//! Which face of a surface in space faces a point?
//!
//! ```text
//!             x              the nearest face by straight distance, then Newton on
//!             |              (x - X(xi)) . dX/dxi = 0; where that leaves the face, the
//!    o--------+---o------o   neighbour behind that edge is asked
//!                        |<->|  an open end is prolonged by a part of its face
//! ```
//!
//! [docs/theory.md, section 5.9]

use super::tree::{Bounds, BoxTree};
use crate::surface::mesh::{FaceMesh, PlacedFace, is_crease};
use crate::surface::patch::Patch;
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// A tree over the faces of a surface.
pub type FaceTree = BoxTree<3>;

/// Where on a surface a point is faced.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct FacePlace {
    /// The face.
    pub face: usize,
    /// Place on its reference cell [1].
    pub at: [f64; 2],
}

impl FacePlace {
    /// Shares of the corners of a triangle or a quadrilateral in it, linear between them [1].
    pub fn corner_shares(&self, corners: usize) -> [f64; 4] {
        let [s, t] = self.at;
        match corners {
            3 => [1.0 - s - t, s, t, 0.0],
            _ => [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
                .map(|(a, b)| 0.25 * (1.0 + a * s) * (1.0 + b * t)),
        }
    }
}

/// Faces that are asked one after the other.
const WAY: usize = 16;
/// Part of a face by which a point may stand beyond its edge and still belong to it: where it stood
/// there at the last commit, so that no iteration goes to and fro between two faces, or where both
/// faces refuse it [1].
pub(super) const SEAM: f64 = 0.05;
/// How far a point beyond an edge at which the normal leaps may stand from the other face, over the mean length of
/// slave faces [1]: where that turns away, from where a node is pushed farther to its side.
pub(super) const RIDGE: f64 = 0.005;
/// The same in a valley, where each face pushes the point to the other one.
const VALLEY: f64 = 0.02;
/// Newton iterations of a projection.
const ITERATIONS: usize = 40;

/// The box of a face.
pub fn bounds(mesh: &FaceMesh, positions: &[Vector], face: usize) -> Bounds<3> {
    let mut bounds = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for &node in &mesh.faces()[face].nodes {
        for (axis, at) in positions[node].into_iter().enumerate() {
            bounds.0[axis] = bounds.0[axis].min(at);
            bounds.1[axis] = bounds.1[axis].max(at);
        }
    }
    bounds
}

/// The box of a face on its way between two configurations.
pub fn way_bounds(mesh: &FaceMesh, (from, to): (&[Vector], &[Vector]), face: usize) -> Bounds<3> {
    let (a, b) = (bounds(mesh, from, face), bounds(mesh, to, face));
    (std::array::from_fn(|k| a.0[k].min(b.0[k])), std::array::from_fn(|k| a.1[k].max(b.1[k])))
}

/// Faces that a point may meet on its way, by a tree fitted to their ways.
pub fn near_way(tree: &FaceTree, (from, to): (Vector, Vector), near: &mut Vec<usize>) {
    near.clear();
    let low = std::array::from_fn(|k| from[k].min(to[k]));
    let high = std::array::from_fn(|k| from[k].max(to[k]));
    tree.overlapping((low, high), |face| near.push(face));
    near.sort_unstable();
}

/// The tree over the faces at these positions.
pub fn tree(mesh: &FaceMesh, positions: &[Vector]) -> FaceTree {
    BoxTree::new(mesh.faces().len(), |face| bounds(mesh, positions, face))
}

/// What faces a point, where an open end of the surface is prolonged by `extension` of its faces.
/// The face `before`, on which the point stood, keeps it until it is well beyond its edge.
pub fn closest(
    mesh: &FaceMesh,
    positions: &[Vector],
    tree: &FaceTree,
    (point, extension, before): (Vector, f64, Option<usize>),
    room: &mut PlacedFace,
) -> Option<FacePlace> {
    if let Some(swept) = mesh.swept() {
        let (face, at) = super::swept::closest(swept, positions, point)?;
        return Some(FacePlace { face, at });
    }
    let (face, least) = nearest(mesh, positions, tree, point)?;
    let kept = before
        .and_then(|face| keep(mesh, positions, (face, point), (extension, least.sqrt()), room));
    if kept.is_some() {
        return kept;
    }
    walk((mesh, positions), (face, point, extension), |_| true, room)
}

/// The place of a point on a face, or on a neighbour that it stands before and that `may` be met.
pub(super) fn walk(
    (mesh, positions): (&FaceMesh, &[Vector]),
    (mut face, point, extension): (usize, Vector, f64),
    may: impl Fn(usize) -> bool,
    room: &mut PlacedFace,
) -> Option<FacePlace> {
    let mut start = nearest_of(mesh, positions, face, point).place;
    let mut seen = [usize::MAX; WAY];
    for step in 0..WAY {
        seen[step] = face;
        let patch = mesh.place(face, positions, room)?;
        let at = project(&patch, start, point)?;
        let place = FacePlace { face, at };
        let (edge, beyond) = beyond(patch.corners(), at);
        if beyond <= super::INSIDE {
            return Some(place);
        }
        match mesh.neighbour(face, edge) {
            None => {
                let allowed = beyond_end(mesh, (face, edge), extension);
                return (beyond <= allowed).then_some(place);
            }
            Some(next) if seen.contains(&next) || !may(next) => {
                return (beyond <= SEAM).then_some(place);
            }
            Some(next) => face = next,
        }
        start = nearest_of(mesh, positions, face, point).place;
    }
    None
}

/// The face nearest to a point.
pub(super) fn nearest_face(
    mesh: &FaceMesh,
    positions: &[Vector],
    tree: &FaceTree,
    point: Vector,
) -> Option<usize> {
    nearest(mesh, positions, tree, point).map(|(face, _)| face)
}

/// The face nearest to a point, and the square of its distance [L2].
fn nearest(
    mesh: &FaceMesh,
    positions: &[Vector],
    tree: &FaceTree,
    point: Vector,
) -> Option<(usize, f64)> {
    tree.nearest(point, |face| nearest_of(mesh, positions, face, point).square)
}

/// The place of a face on which a point stood, where it faces it still: hardly farther away than
/// what is `nearest`, and at most SEAM beyond an edge.
pub(super) fn keep(
    mesh: &FaceMesh,
    positions: &[Vector],
    (face, point): (usize, Vector),
    (extension, nearest): (f64, f64),
    room: &mut PlacedFace,
) -> Option<FacePlace> {
    let patch = mesh.place(face, positions, room)?;
    let start = nearest_of(mesh, positions, face, point).place;
    let at = project(&patch, start, point)?;
    let place = patch.place(at);
    let (edge, beyond) = beyond(patch.corners(), at);
    let allowed = match mesh.neighbour(face, edge) {
        _ if beyond <= 0.0 => 0.0,
        Some(_) if mesh.is_smoothed_at(face, edge) => SEAM,
        Some(other) => seam(mesh, positions, (face, edge), other),
        None => beyond_end(mesh, (face, edge), extension),
    };
    let (tangents, _) = patch.frame(&place)?;
    let room = SEAM * size(tangents[0]).max(size(tangents[1]));
    let distance = size(sub(point, patch.position(&place.value)));
    (beyond <= allowed && distance <= nearest + room).then_some(FacePlace { face, at })
}

/// Part of a face by which a point keeps it beyond an edge to another one with a normal of its own [1], however many
/// faces there are. At creases the faces of the slave tell which side a node meets ([`super::sharp_faces`]).
fn seam(mesh: &FaceMesh, positions: &[Vector], (face, edge): (usize, usize), other: usize) -> f64 {
    let shorter = mesh.slave / mesh.across(face, edge, positions);
    let normals = [face, other].map(|own| mesh.normal(own, positions));
    let allowed = if is_crease(normals[0], normals[1]) {
        SEAM * shorter
    } else {
        let turn = size(cross(normals[0], normals[1]));
        let apart = if mesh.turns_away(face, other, positions) { RIDGE } else { VALLEY };
        apart * shorter / turn
    };
    // f64::min passes over what is no number
    allowed.min(SEAM)
}

/// Part of a face by which a point may stand beyond an edge at which the surface ends [1]; beyond one in a plane of
/// symmetry the image of the face goes on.
fn beyond_end(mesh: &FaceMesh, (face, edge): (usize, usize), extension: f64) -> f64 {
    let goes_on = if mesh.is_mirrored(face, edge) { SEAM } else { super::INSIDE };
    extension.max(goes_on)
}

/// The edge that a place lies farthest beyond, and by how much of the face [1].
pub(super) fn beyond(corners: usize, [x, y]: [f64; 2]) -> (usize, f64) {
    let sides = match corners {
        3 => [-y, x + y - 1.0, -x, f64::NEG_INFINITY],
        _ => [-0.5 * (1.0 + y), 0.5 * (x - 1.0), 0.5 * (y - 1.0), -0.5 * (1.0 + x)],
    };
    let farthest = |best: (usize, f64), own: (usize, f64)| if own.1 > best.1 { own } else { best };
    sides.into_iter().enumerate().fold((0, f64::NEG_INFINITY), farthest)
}

/// Newton on the square of the distance.
pub(super) fn project(patch: &Patch, start: [f64; 2], point: Vector) -> Option<[f64; 2]> {
    let mut at = start;
    for _ in 0..ITERATIONS {
        let place = patch.place(at);
        let ([a, b], _) = patch.frame(&place)?;
        let r = sub(point, patch.position(&place.value));
        let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
        let second = |k: usize, l: usize| dot(r, patch.position(place.second(k, l)));
        let mut matrix = [aa - second(0, 0), ab - second(0, 1), bb - second(1, 1)];
        // where the distance is no minimum along some way, the tangents alone tell the step
        if matrix[0] <= 0.0 || matrix[0] * matrix[2] <= matrix[1] * matrix[1] {
            matrix = [aa, ab, bb];
        }
        let whole = matrix[0] * matrix[2] - matrix[1] * matrix[1];
        let side = [dot(a, r), dot(b, r)];
        let step = [
            (matrix[2] * side[0] - matrix[1] * side[1]) / whole,
            (matrix[0] * side[1] - matrix[1] * side[0]) / whole,
        ];
        let size = step[0].abs().max(step[1].abs());
        let share = if size > 1.0 { 1.0 / size } else { 1.0 };
        at = [at[0] + share * step[0], at[1] + share * step[1]];
        if size <= 4.0 * f64::EPSILON {
            break;
        }
        // nothing far beyond a face belongs to it
        if !at[0].is_finite() || at[0].abs().max(at[1].abs()) > 4.0 {
            return Some(at).filter(|at| at.iter().all(|x| x.is_finite()));
        }
    }
    Some(at)
}

/// What of the corners' triangles of a face is nearest to a point.
pub(super) struct Nearest {
    /// Square of the distance [L2].
    pub square: f64,
    /// The place on the reference cell [1].
    pub place: [f64; 2],
    /// The way to it from the point [L].
    pub way: Vector,
}

/// What of a face is nearest to a point.
pub(super) fn nearest_of(
    mesh: &FaceMesh,
    positions: &[Vector],
    face: usize,
    point: Vector,
) -> Nearest {
    let own = &mesh.faces()[face];
    let corner = |k: usize| positions[own.nodes[k]];
    let mut best = Nearest { square: f64::INFINITY, place: [0.0; 2], way: [0.0; 3] };
    for triangle in own.triangles() {
        let (square, shares) = nearest_of_triangle(triangle.map(corner), point);
        if square < best.square {
            let mut found = Nearest { square, place: [0.0; 2], way: scale(point, -1.0) };
            for (&share, &k) in shares.iter().zip(triangle) {
                found.place[0] += share * own.cell.places[k][0];
                found.place[1] += share * own.cell.places[k][1];
                found.way = add(found.way, scale(corner(k), share));
            }
            best = found;
        }
    }
    best
}

/// Square of the distance of a point from a triangle [L2], with the shares of its corners in the
/// nearest place.
pub(super) fn nearest_of_triangle([a, b, c]: [Vector; 3], point: Vector) -> (f64, [f64; 3]) {
    let (ab, ac, ap) = (sub(b, a), sub(c, a), sub(point, a));
    let (d, e, f) = (dot(ab, ab), dot(ab, ac), dot(ac, ac));
    let (p, q) = (dot(ab, ap), dot(ac, ap));
    let whole = d * f - e * e;
    let square = |shares: [f64; 3]| {
        let at = add(add(scale(a, shares[0]), scale(b, shares[1])), scale(c, shares[2]));
        let way = sub(point, at);
        (dot(way, way), shares)
    };
    if whole > 0.0 {
        let (v, w) = ((f * p - e * q) / whole, (d * q - e * p) / whole);
        if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
            return square([1.0 - v - w, v, w]);
        }
    }
    let along = |from: Vector, to: Vector| {
        let way = sub(to, from);
        let length = dot(way, way);
        if length > 0.0 { (dot(way, sub(point, from)) / length).clamp(0.0, 1.0) } else { 0.0 }
    };
    let (s, t, u) = (along(a, b), along(b, c), along(c, a));
    let sides = [[1.0 - s, s, 0.0], [0.0, 1.0 - t, t], [u, 0.0, 1.0 - u]].map(square);
    sides.into_iter().fold((f64::INFINITY, [0.0; 3]), |best, own| match own.0 < best.0 {
        true => own,
        false => best,
    })
}

#[cfg(test)]
mod tests;
