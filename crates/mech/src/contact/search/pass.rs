//! Which faces in space does a moving point cross on its way?
//!
//! ```text
//!      x p0                 point and corners on straight ways; they stand in one plane
//!       \      ____         where (p - a) . (b - a) x (c - a), a cubic in the fraction of
//!     ---\----/---          the way, vanishes; inside the triangle it is a crossing
//!         x p1
//! ```

use super::INSIDE;
use super::sweep::Crossing;
use crate::surface::mesh::FaceMesh;
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// Halvings of a root's interval.
const HALVINGS: usize = 60;

/// Crossings of a point on its way with faces whose nodes go from `before` to `after`; faces are
/// the triangles of their corners, an analytical surface is crossed as it is.
pub fn cross_faces(
    mesh: &FaceMesh,
    (before, after): (&[Vector], &[Vector]),
    faces: impl Iterator<Item = usize>,
    (from, to): (Vector, Vector),
    mut each: impl FnMut(Crossing),
) {
    if let Some(swept) = mesh.swept() {
        super::swept::cross(swept, (before, after), (from, to), each);
        return;
    }
    for face in faces {
        let own = &mesh.faces()[face];
        for triangle in own.triangles() {
            let nodes = triangle.map(|k| own.nodes[k]);
            let ends = nodes.map(|node| (before[node], after[node]));
            cross_triangle(face, ends, (from, to), &mut each);
        }
    }
}

fn cross_triangle(
    face: usize,
    corners: [(Vector, Vector); 3],
    (from, to): (Vector, Vector),
    each: &mut impl FnMut(Crossing),
) {
    let at = |(from, to): (Vector, Vector), t: f64| add(from, scale(sub(to, from), t));
    let placed = |t: f64| {
        let [a, b, c] = corners.map(|corner| at(corner, t));
        (sub(b, a), sub(c, a), sub(at((from, to), t), a))
    };
    let height = |t: f64| {
        let (b, c, p) = placed(t);
        dot(p, cross(b, c))
    };
    let mut last = (0.0, height(0.0));
    for end in turns(height) {
        let next = (end, height(end));
        if (last.1 > 0.0) != (next.1 > 0.0) && end > last.0 {
            let fraction = root(height, last, next);
            let (b, c, p) = placed(fraction);
            let normal = cross(b, c);
            let square = dot(normal, normal);
            let (v, w) = (dot(cross(p, c), normal) / square, dot(cross(b, p), normal) / square);
            if square > 0.0 && v >= -INSIDE && w >= -INSIDE && v + w <= 1.0 + INSIDE {
                each(Crossing {
                    segment: face,
                    parameter: 0.0,
                    fraction,
                    normal: scale(normal, 1.0 / size(normal)),
                    inward: last.1 > 0.0,
                });
            }
        }
        last = next;
    }
}

/// Where a cubic on 0 to 1 may turn, ascending, and 1.
fn turns(f: impl Fn(f64) -> f64) -> impl Iterator<Item = f64> {
    // its coefficients by four values; the slope c1 + 2 c2 t + 3 c3 t^2 vanishes where it turns
    let [f0, f1, f2, f3] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(f);
    let c3 = 4.5 * (f3 - 3.0 * f2 + 3.0 * f1 - f0);
    let c2 = 4.5 * (2.0 * f0 - 5.0 * f1 + 4.0 * f2 - f3);
    let c1 = f3 - f0 - c2 - c3;
    let [a, b] = super::sweep::roots(c1, 2.0 * c2, 3.0 * c3).map(|t| t.unwrap_or(f64::NAN));
    let inside = |t: f64| if t > 0.0 && t < 1.0 { t } else { 1.0 };
    let (a, b) = (inside(a), inside(b));
    [a.min(b), a.max(b), 1.0].into_iter()
}

/// The root between two places of opposite sign.
fn root(f: impl Fn(f64) -> f64, from: (f64, f64), to: (f64, f64)) -> f64 {
    let ((mut low, at_low), (mut high, _)) = (from, to);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == (at_low > 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cell::QUAD4;
    use crate::surface::mesh::MeshFace;

    const SQUARE: [Vector; 4] =
        [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];

    fn crossings(after: [Vector; 4], way: (Vector, Vector)) -> Vec<Crossing> {
        let face = MeshFace { cell: &QUAD4, nodes: vec![0, 1, 2, 3] };
        let mesh = FaceMesh::new(vec![face], &SQUARE, false);
        let mut found = Vec::new();
        cross_faces(&mesh, (&SQUARE, &after), 0..1, way, |crossing| found.push(crossing));
        found
    }

    /// Requirement: a way through a face is seen with its place, normal and sense; one beside it,
    /// and one that stays in front, is not.
    #[test]
    fn a_way_through_a_face_is_seen() {
        let down = crossings(SQUARE, ([0.3, -0.2, 1.0], [0.3, -0.2, -3.0]));
        assert_eq!(down.len(), 1);
        assert!((down[0].fraction - 0.25).abs() < 1e-12 && down[0].inward);
        assert!((down[0].normal[2] - 1.0).abs() < 1e-12);
        let up = crossings(SQUARE, ([0.3, -0.2, -1.0], [0.3, -0.2, 1.0]));
        assert!(up.len() == 1 && !up[0].inward);
        assert!(crossings(SQUARE, ([1.3, 0.0, 1.0], [1.3, 0.0, -1.0])).is_empty());
        assert!(crossings(SQUARE, ([0.3, 0.0, 1.0], [-0.3, 0.0, 0.5])).is_empty());
    }

    /// Requirement: a face that comes down on a point at rest and rises again is no way through;
    /// one that turns over it on the way is.
    #[test]
    fn faces_move_too() {
        let raised = SQUARE.map(|p| add(p, [0.0, 0.0, 2.0]));
        let passed = crossings(raised, ([0.2, 0.1, 1.0], [0.2, 0.1, 1.0]));
        assert!(passed.len() == 1 && passed[0].inward);
        assert!((passed[0].fraction - 0.5).abs() < 1e-12);
        let tipped = [0.0, 0.0, 4.0, 4.0];
        let tipped: [Vector; 4] = std::array::from_fn(|k| add(SQUARE[k], [0.0, 0.0, tipped[k]]));
        let passed = crossings(tipped, ([0.0, 0.5, 1.0], [0.0, 0.5, 1.0]));
        assert_eq!(passed.len(), 1);
        assert!((passed[0].fraction - 1.0 / 3.0).abs() < 1e-9, "{passed:?}");
    }
}
