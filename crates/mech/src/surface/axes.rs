//! The axes of a surface in space, along which friction has coefficients of its own.
//!
//! ```text
//!      n   2          axis 1 of the undeformed surface: the first of three axes (x) seen along its
//!      |  /           normal, or the third (z) where that is within 0.1 degrees of it; axis 2 = n x 1
//!      o----> 1       later it keeps its angle to an edge of the face
//! ```
//!
//! [docs/theory.md, section 7]

use crate::axes::Axes;
use crate::vector::{Vector, cross, dot, scale, size, sub};

/// How axis 1 stands to a tangent: components along the tangent and along the normal x the tangent [1].
pub type Bearing = [f64; 2];

/// Cosine of 0.1 degrees.
const ALONG_NORMAL: f64 = 0.999_998_476_912_901_3;

/// How axis 1 of an undeformed surface stands to a tangent of it, by the axes of space there.
pub fn bearing_of_axis([first, _, third]: Axes, tangent: Vector, normal: Vector) -> Bearing {
    let along = if dot(first, normal).abs() > ALONG_NORMAL { third } else { first };
    let [u, v] = frame(tangent, normal);
    let by = [dot(along, u), dot(along, v)];
    let whole = by[0].hypot(by[1]);
    by.map(|value| value / whole)
}

/// Axis 1 by its bearing, where the tangent and the normal stand now [1].
pub fn axis([c, s]: Bearing, tangent: Vector, normal: Vector) -> Vector {
    let [u, v] = frame(tangent, normal);
    std::array::from_fn(|k| c * u[k] + s * v[k])
}

/// The tangent across the normal, and what stands on both [1].
fn frame(tangent: Vector, normal: Vector) -> [Vector; 2] {
    let across = sub(tangent, scale(normal, dot(tangent, normal)));
    let u = scale(across, 1.0 / size(across));
    [u, cross(normal, u)]
}
