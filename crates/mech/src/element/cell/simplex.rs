//! Triangles and tetrahedra, in the coordinates of their corners.
//!
//! ```text
//!   3           L1 = 1 - xi - eta (- zeta), L2 = xi, L3 = eta, L4 = zeta
//!   | \         linear:    N = L
//!   6   5       quadratic: N = L (2 L - 1) at corners, 4 L L' between two of them
//!   |     \
//!   1--4---2
//! ```

/// Edges of the triangle of six nodes, in the order of its middle nodes.
const TRIANGLE: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];
/// Those of the tetrahedron of ten.
const TETRAHEDRON: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

/// Coordinates of a place by the corners of a simplex in `D` dimensions, zeros behind them.
pub(super) fn by_corners<const D: usize>(at: &[f64; 3]) -> [f64; 4] {
    let mut l = [0.0; 4];
    l[0] = 1.0 - at[..D].iter().sum::<f64>();
    l[1..=D].copy_from_slice(&at[..D]);
    l
}

/// Derivative of a corner's coordinate along an axis.
pub(super) fn slope_of_corner(corner: usize, axis: usize) -> f64 {
    match corner {
        0 => -1.0,
        _ if corner == axis + 1 => 1.0,
        _ => 0.0,
    }
}

fn linear_shapes<const D: usize>(at: &[f64; 3], shapes: &mut [f64]) {
    shapes.iter_mut().zip(by_corners::<D>(at)).for_each(|(shape, l)| *shape = l);
}

fn linear_slopes<const D: usize>(slopes: &mut [[f64; 3]]) {
    for (corner, slopes) in slopes.iter_mut().enumerate() {
        *slopes = [0.0; 3];
        (0..D).for_each(|axis| slopes[axis] = slope_of_corner(corner, axis));
    }
}

fn quadratic_shapes<const D: usize>(edges: &[[usize; 2]], at: &[f64; 3], shapes: &mut [f64]) {
    let l = by_corners::<D>(at);
    let Some((corners, middles)) = shapes.split_at_mut_checked(D + 1) else { return };
    corners.iter_mut().zip(l).for_each(|(shape, l)| *shape = l * (2.0 * l - 1.0));
    middles.iter_mut().zip(edges).for_each(|(shape, &[i, j])| *shape = 4.0 * l[i] * l[j]);
}

fn quadratic_slopes<const D: usize>(edges: &[[usize; 2]], at: &[f64; 3], slopes: &mut [[f64; 3]]) {
    let l = by_corners::<D>(at);
    let Some((corners, middles)) = slopes.split_at_mut_checked(D + 1) else { return };
    for (corner, slopes) in corners.iter_mut().enumerate() {
        *slopes = [0.0; 3];
        for (axis, slope) in slopes.iter_mut().take(D).enumerate() {
            *slope = (4.0 * l[corner] - 1.0) * slope_of_corner(corner, axis);
        }
    }
    for (slopes, &[i, j]) in middles.iter_mut().zip(edges) {
        *slopes = [0.0; 3];
        for (axis, slope) in slopes.iter_mut().take(D).enumerate() {
            *slope = 4.0 * (l[i] * slope_of_corner(j, axis) + l[j] * slope_of_corner(i, axis));
        }
    }
}

pub(super) fn tri3_shapes(at: &[f64; 3], shapes: &mut [f64]) {
    linear_shapes::<2>(at, shapes);
}

pub(super) fn tri3_slopes(_: &[f64; 3], slopes: &mut [[f64; 3]]) {
    linear_slopes::<2>(slopes);
}

pub(super) fn tri6_shapes(at: &[f64; 3], shapes: &mut [f64]) {
    quadratic_shapes::<2>(&TRIANGLE, at, shapes);
}

pub(super) fn tri6_slopes(at: &[f64; 3], slopes: &mut [[f64; 3]]) {
    quadratic_slopes::<2>(&TRIANGLE, at, slopes);
}

pub(super) fn tet4_shapes(at: &[f64; 3], shapes: &mut [f64]) {
    linear_shapes::<3>(at, shapes);
}

pub(super) fn tet4_slopes(_: &[f64; 3], slopes: &mut [[f64; 3]]) {
    linear_slopes::<3>(slopes);
}

pub(super) fn tet10_shapes(at: &[f64; 3], shapes: &mut [f64]) {
    quadratic_shapes::<3>(&TETRAHEDRON, at, shapes);
}

pub(super) fn tet10_slopes(at: &[f64; 3], slopes: &mut [[f64; 3]]) {
    quadratic_slopes::<3>(&TETRAHEDRON, at, slopes);
}
