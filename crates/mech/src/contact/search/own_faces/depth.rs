//! How deep a part is behind a face of its surface.
//!
//! ```text
//!    ----x----      the straight way inward from the middle of a face to the next one
//!        : depth
//!    ----v----
//! ```
//!
//! docs/theory.md section 5.12. (derived)

use crate::contact::search::INSIDE;
use crate::contact::search::faces::FaceTree;
use crate::surface::mesh::FaceMesh;
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// How far the straight way inward from the middle of a face leads to the next face that ends its
/// part [L]; looked for within twice the distance, and twice, as long as there is more of it.
pub(super) fn depth_behind(
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
        let hits = depth > 0.0 && v >= -INSIDE && w >= -INSIDE;
        if hits && v + w <= 1.0 + INSIDE { depth } else { f64::INFINITY }
    };
    own.triangles().iter().map(depth).fold(f64::INFINITY, f64::min)
}
