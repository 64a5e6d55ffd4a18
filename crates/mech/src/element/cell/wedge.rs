//! Wedges: a triangle along a line, zeta from -1 to 1.
//!
//! ```text
//!        6          linear:      L (1 + c zeta)/2, c: -1 below, 1 above
//!      / | \        corner:      L (1 + c zeta)(2 L - 1)/2 - L (1 - zeta^2)/2
//!     4-----5       horizontal:  2 L L' (1 + c zeta)
//!     |  3  |       vertical:    L (1 - zeta^2)
//!     | / \ |
//!     1-----2
//! ```

use super::simplex::{by_corners, slope_of_corner};

/// Edges of a triangle.
const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// A function of the triangle's coordinates and zeta with its slopes: value, by each of the three
/// corners' coordinates, by zeta.
type Parts = (f64, [f64; 3], f64);

fn corner(l: &[f64; 4], zeta: f64, i: usize, c: f64) -> Parts {
    let (own, up, bubble) = (l[i], 1.0 + c * zeta, 1.0 - zeta * zeta);
    let mut by = [0.0; 3];
    by[i] = 0.5 * up * (4.0 * own - 1.0) - 0.5 * bubble;
    let value = 0.5 * own * up * (2.0 * own - 1.0) - 0.5 * own * bubble;
    (value, by, 0.5 * c * own * (2.0 * own - 1.0) + own * zeta)
}

fn horizontal(l: &[f64; 4], zeta: f64, [i, j]: [usize; 2], c: f64) -> Parts {
    let up = 1.0 + c * zeta;
    let mut by = [0.0; 3];
    by[i] = 2.0 * l[j] * up;
    by[j] = 2.0 * l[i] * up;
    (2.0 * l[i] * l[j] * up, by, 2.0 * l[i] * l[j] * c)
}

fn vertical(l: &[f64; 4], zeta: f64, i: usize) -> Parts {
    let mut by = [0.0; 3];
    by[i] = 1.0 - zeta * zeta;
    (l[i] * (1.0 - zeta * zeta), by, -2.0 * l[i] * zeta)
}

fn linear(l: &[f64; 4], zeta: f64, i: usize, c: f64) -> Parts {
    let mut by = [0.0; 3];
    by[i] = 0.5 * (1.0 + c * zeta);
    (0.5 * l[i] * (1.0 + c * zeta), by, 0.5 * c * l[i])
}

/// Node of six or fifteen.
fn node(node: usize, quadratic: bool, at: &[f64; 3]) -> Parts {
    let l = by_corners::<2>(at);
    let (zeta, above) = (at[2], |first: usize| if node < first + 3 { -1.0 } else { 1.0 });
    match node {
        0..6 if quadratic => corner(&l, zeta, node % 3, above(0)),
        0..6 => linear(&l, zeta, node % 3, above(0)),
        6..12 => horizontal(&l, zeta, EDGES[node % 3], above(6)),
        _ => vertical(&l, zeta, node % 3),
    }
}

fn shapes(quadratic: bool, at: &[f64; 3], into: &mut [f64]) {
    for (index, shape) in into.iter_mut().enumerate() {
        *shape = node(index, quadratic, at).0;
    }
}

fn slopes(quadratic: bool, at: &[f64; 3], into: &mut [[f64; 3]]) {
    for (index, slopes) in into.iter_mut().enumerate() {
        let (_, by, by_zeta) = node(index, quadratic, at);
        let along = |axis: usize| (0..3).map(|i| by[i] * slope_of_corner(i, axis)).sum();
        *slopes = [along(0), along(1), by_zeta];
    }
}

pub(super) fn wedge6_shapes(at: &[f64; 3], into: &mut [f64]) {
    shapes(false, at, into);
}

pub(super) fn wedge6_slopes(at: &[f64; 3], into: &mut [[f64; 3]]) {
    slopes(false, at, into);
}

pub(super) fn wedge15_shapes(at: &[f64; 3], into: &mut [f64]) {
    shapes(true, at, into);
}

pub(super) fn wedge15_slopes(at: &[f64; 3], into: &mut [[f64; 3]]) {
    slopes(true, at, into);
}
