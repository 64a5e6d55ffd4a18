//! Force and tangent of an element from its points.
//!
//! ```text
//!   f_ai  = sum w tau_ij g_aj                     K_aibk = sum w g_aj (c_ijkl + 1_ik tau_jl) g_bl
//! ```
//!
//! For a pair of axes (i, k) the products with g_b of all points are made first; then every row is
//! a sum over points and axes of rows as long as the element has nodes, which compilers turn into
//! vector instructions. docs/theory.md eqs. (3.37) and (3.38).

use super::Point;
use crate::material::tensor::INDEX;

/// Writes the force.
pub(super) fn force<const D: usize, const N: usize>(points: &[Point<D, N>], into: &mut [f64]) {
    let mut sums = [[0.0; N]; D];
    for point in points {
        for (i, sum) in sums.iter_mut().enumerate() {
            for (j, slopes) in point.slopes.iter().enumerate() {
                add(sum, point.weight * point.stress[INDEX[i][j]], slopes);
            }
        }
        if D == 2 {
            add(&mut sums[0], point.weight * point.stress[2], &point.hoop);
        }
    }
    for (a, node) in into.chunks_exact_mut(D).enumerate() {
        node.iter_mut().zip(&sums).for_each(|(force, sum)| *force = sum[a]);
    }
}

/// sum += factor * row.
fn add<const N: usize>(sum: &mut [f64; N], factor: f64, row: &[f64; N]) {
    for (sum, entry) in sum.iter_mut().zip(row) {
        *sum += factor * entry;
    }
}

/// Writes the tangent, row-major; `ring`: hoop strains count.
pub(super) fn tangent<const D: usize, const N: usize, const P: usize>(
    points: &[Point<D, N>; P],
    ring: bool,
    into: &mut [f64],
) {
    for i in 0..D {
        for k in i..D {
            block(points, ring, [i, k], into);
        }
    }
}

/// The entries of a pair of axes, and those of the pair turned round.
fn block<const D: usize, const N: usize, const P: usize>(
    points: &[Point<D, N>; P],
    ring: bool,
    [i, k]: [usize; 2],
    into: &mut [f64],
) {
    let hoop = ring && i == 0;
    let products: [([[f64; N]; D], [f64; N]); P] =
        std::array::from_fn(|point| products(&points[point], ring, [i, k]));
    let width = D * N;
    for a in 0..N {
        let mut row = [0.0; N];
        for (point, (products, of_hoop)) in points.iter().zip(&products) {
            for (slopes, product) in point.slopes.iter().zip(products) {
                add(&mut row, slopes[a], product);
            }
            if hoop {
                add(&mut row, point.hoop[a], of_hoop);
            }
        }
        for (b, entry) in row.iter().enumerate() {
            into[width * (D * a + i) + D * b + k] = *entry;
        }
        if i != k {
            for (b, entry) in row.iter().enumerate() {
                into[width * (D * b + k) + D * a + i] = *entry;
            }
        }
    }
}

/// w (c_ijkl + 1_ik tau_jl) g_bl for every j, and the same of the hoop strain.
fn products<const D: usize, const N: usize>(
    point: &Point<D, N>,
    ring: bool,
    [i, k]: [usize; 2],
) -> ([[f64; N]; D], [f64; N]) {
    let (mut rows, mut of_hoop) = ([[0.0; N]; D], [0.0; N]);
    let w = point.weight;
    for (j, row) in rows.iter_mut().enumerate() {
        let moduli = &point.moduli[INDEX[i][j]];
        for (l, slopes) in point.slopes.iter().enumerate() {
            let turning = if i == k { point.turning[INDEX[j][l]] } else { 0.0 };
            add(row, w * (moduli[INDEX[k][l]] + turning), slopes);
        }
        if ring && k == 0 {
            add(row, w * moduli[2], &point.hoop);
        }
    }
    if ring && i == 0 {
        for (l, slopes) in point.slopes.iter().enumerate() {
            add(&mut of_hoop, w * point.moduli[2][INDEX[k][l]], slopes);
        }
        if k == 0 {
            add(&mut of_hoop, w * (point.moduli[2][2] + point.turning[2]), &point.hoop);
        }
    }
    (rows, of_hoop)
}
