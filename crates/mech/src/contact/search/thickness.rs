//! How thick a part is behind each face of its surface.
//!
//! ```text
//!     o-----o-----o
//!     |     |     |      from the middle of a face inwards to the next face of the same surface that
//!     |     v     |      looks the other way; no end where the surface is open there
//!     o-----o-----o
//! ```

use super::faces::FaceTree;
use crate::surface::mesh::{MeshFace, area_between};
use crate::vector::{Vector, add, cross, dot, scale, size, sub};
use std::cell::Cell;

/// Part of a triangle beside it that still belongs to it: meshes have faces middle upon edge [1].
const BESIDE: f64 = 1e-9;

/// The thickness behind each face [L], infinite where the surface is open there; `at` gives undeformed positions of
/// nodes [L].
pub fn thicknesses(faces: &[MeshFace], at: impl Fn(usize) -> Vector) -> Vec<f64> {
    let bounds = |face: usize| {
        let nothing = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        faces[face].nodes.iter().fold(nothing, |(low, high), &node| {
            let place = at(node);
            let join = |k: usize| (low[k].min(place[k]), high[k].max(place[k]));
            (std::array::from_fn(|k| join(k).0), std::array::from_fn(|k| join(k).1))
        })
    };
    let tree = FaceTree::new(faces.len(), bounds);
    let behind = |own: usize| {
        let face = corners(&faces[own], &at);
        let area = area_between(face.len(), |corner| face[corner]);
        let inwards = scale(area, -1.0 / size(area));
        let middle =
            scale(face.iter().fold([0.0; 3], |sum, &x| add(sum, x)), 1.0 / face.len() as f64);
        let nearest = Cell::new(f64::INFINITY);
        tree.along((middle, inwards), &nearest, |other| {
            let other = if other == own { Vec::new() } else { corners(&faces[other], &at) };
            for k in 2..other.len() {
                let way = reached([other[0], other[k - 1], other[k]], (middle, inwards));
                nearest.set(way.map_or(nearest.get(), |way| nearest.get().min(way)));
            }
        });
        nearest.get()
    };
    (0..faces.len()).map(behind).collect()
}

fn corners(face: &MeshFace, at: impl Fn(usize) -> Vector) -> Vec<Vector> {
    face.nodes[..face.cell.faces.len()].iter().map(|&node| at(node)).collect()
}

/// After which way along a line from a place [L] it leaves through a triangle that looks along it; `None`: it does not.
fn reached([a, b, c]: [Vector; 3], (from, along): (Vector, Vector)) -> Option<f64> {
    let normal = cross(sub(b, a), sub(c, a));
    let leaves = dot(normal, along);
    if leaves <= 0.0 {
        return None;
    }
    let way = dot(normal, sub(a, from)) / leaves;
    let hit = add(from, scale(along, way));
    let square = dot(normal, normal);
    let is_beside = |from: Vector, to: Vector| {
        dot(cross(sub(to, from), sub(hit, from)), normal) < -BESIDE * square
    };
    let misses = is_beside(a, b) || is_beside(b, c) || is_beside(c, a);
    (way > 0.0 && !misses).then_some(way)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cell::{QUAD4, TRI3};

    /// The corners of a box of these sides, sheared along x by its height.
    fn corner([a, b, c]: [f64; 3], shear: f64, node: usize) -> Vector {
        let is_on = |axis: usize| f64::from(u8::from(node >> axis & 1 == 1));
        [a * is_on(0) + shear * is_on(2), b * is_on(1), c * is_on(2)]
    }

    const SIDES: [[usize; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

    /// Requirement: behind each side of a box there is its thickness, of whole sides and of halves; the same wherever it
    /// stands; an open box has none behind what faces the hole.
    #[test]
    fn a_box_is_as_thick_as_its_sides() {
        let sides = [3.0, 2.0, 0.5];
        let place = |node: usize| corner(sides, 0.0, node);
        let whole = |own: &[usize; 4]| MeshFace { cell: &QUAD4, nodes: own.to_vec() };
        let all: Vec<_> = SIDES.iter().map(whole).collect();
        let close = |found: Vec<f64>, exact: &[f64]| {
            assert_eq!(found.len(), exact.len());
            for (one, other) in found.iter().zip(exact) {
                assert!((one - other).abs() < 1e-12 || one == other, "{found:?}");
            }
        };
        let exact = [0.5, 0.5, 2.0, 2.0, 3.0, 3.0];
        close(thicknesses(&all, place), &exact);
        let (s, c) = 0.7_f64.sin_cos();
        let turned = |node: usize| {
            let [x, y, z] = place(node);
            [c * x - s * z + 5.0, y, s * x + c * z]
        };
        close(thicknesses(&all, turned), &exact);
        close(thicknesses(&all[..5], place), &[0.5, 0.5, 2.0, 2.0, f64::INFINITY]);
        let half = |[a, b, c, d]: &[usize; 4]| {
            [[*a, *b, *c], [*a, *c, *d]].map(|own| MeshFace { cell: &TRI3, nodes: own.to_vec() })
        };
        let halves: Vec<_> = SIDES.iter().flat_map(half).collect();
        let twice: Vec<f64> = exact.iter().flat_map(|&own| [own; 2]).collect();
        close(thicknesses(&halves, place), &twice);
    }
}
