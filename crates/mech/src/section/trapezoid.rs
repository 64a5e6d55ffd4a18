//! Torsion of a trapezoid by Prandtl's stress function.
//!
//! ```text
//!          top            phi = sum c_ij f_i(xi) f_j(eta),  f_i = P_(i+2) - P_i: zero on the rim
//!       +--------+  -     J = max over c of  integral of 4 phi - |grad phi|^2
//!      /    ^ 2   \ height
//!     +-----+------+  -
//!         bottom
//! ```
//! docs/theory.md eq. (3.107). [timoshenko1951, chapter 10]

use std::f64::consts::PI;

/// Functions along the width, which are even, and along the height.
const ACROSS: usize = 7;
const ALONG: usize = 14;
const ALL: usize = ACROSS * ALONG;
/// Integration points of either direction: exact for products of two functions.
const POINTS: usize = ALONG + 6;

/// J of a trapezoid, symmetric about axis 2, of widths at the bottom and at the top, one of which
/// may be zero, and height [L4].
pub(super) fn torsion([bottom, top]: [f64; 2], height: f64) -> f64 {
    let rule = gauss();
    let (mut matrix, mut load) = (vec![[0.0; ALL]; ALL], [0.0; ALL]);
    for (eta, share) in rule {
        let up = 0.5 * (1.0 + eta);
        let width = bottom + (top - bottom) * up;
        for (xi, weight) in rule {
            let volume = share * weight * 0.25 * width * height;
            let values = functions(xi, eta);
            let slopes = values.map(|[_, by_xi, by_eta]| {
                let across = 2.0 / width * by_xi;
                let along = by_eta - 0.5 * xi * (top - bottom) / width * by_xi;
                [across, 2.0 / height * along]
            });
            for i in 0..ALL {
                load[i] += 2.0 * volume * values[i][0];
                for j in 0..=i {
                    let both = slopes[i][0] * slopes[j][0] + slopes[i][1] * slopes[j][1];
                    matrix[i][j] += volume * both;
                }
            }
        }
    }
    product_with_inverse(matrix, load)
}

/// Values and slopes by xi and eta of all functions.
fn functions(xi: f64, eta: f64) -> [[f64; 3]; ALL] {
    let (across, along) = (bubbles::<{ 2 * ACROSS }>(xi), bubbles::<ALONG>(eta));
    std::array::from_fn(|k| {
        let [f, slope_f] = across[2 * (k % ACROSS)];
        let [g, slope_g] = along[k / ACROSS];
        [f * g, slope_f * g, f * slope_g]
    })
}

/// P_(i+2) - P_i at x with their slopes, which are (2 i + 3) P_(i+1).
fn bubbles<const N: usize>(x: f64) -> [[f64; 2]; N] {
    let mut low = [1.0, x];
    std::array::from_fn(|i| {
        let n = i as f64;
        let next = ((2.0 * n + 3.0) * x * low[1] - (n + 1.0) * low[0]) / (n + 2.0);
        let own = [next - low[0], (2.0 * n + 3.0) * low[1]];
        low = [low[1], next];
        own
    })
}

/// Points and weights of Gauss' rule.
fn gauss() -> [(f64, f64); POINTS] {
    let count = POINTS as f64;
    std::array::from_fn(|k| {
        let mut x = (PI * (k as f64 + 0.75) / (count + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..6 {
            let mut low = [1.0, x];
            for n in 2..=POINTS {
                let n = n as f64;
                low = [low[1], ((2.0 * n - 1.0) * x * low[1] - (n - 1.0) * low[0]) / n];
            }
            slope = count * (x * low[1] - low[0]) / (x * x - 1.0);
            x -= low[1] / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// load' matrix^-1 load, of a matrix with a lower triangle that is positive definite.
fn product_with_inverse(mut matrix: Vec<[f64; ALL]>, mut load: [f64; ALL]) -> f64 {
    for i in 0..ALL {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let left = matrix[i][j] - known;
            matrix[i][j] = if i == j { left.sqrt() } else { left / matrix[j][j] };
        }
        let known: f64 = (0..i).map(|k| matrix[i][k] * load[k]).sum();
        load[i] = (load[i] - known) / matrix[i][i];
    }
    load.iter().map(|part| part * part).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: J of a rectangle is that of Saint-Venant's series, of an equilateral triangle
    /// of side a it is sqrt(3) a^4 / 80; both ways up. Source: Timoshenko and Goodier, articles 106
    /// and 109.
    #[test]
    fn rectangle_and_triangle() {
        let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() < by * b, "{a} {b}");
        near(torsion([1.0, 1.0], 1.0), 0.140_577_014_955_155_5, 1e-6);
        let series = super::super::Shape::Rectangle { width: 3.0, height: 0.4 };
        near(torsion([3.0, 3.0], 0.4), series.torsion_constant(), 1e-4);
        let (side, height) = (2.0, 3.0_f64.sqrt());
        let exact = 3.0_f64.sqrt() * 16.0 / 80.0;
        near(torsion([side, 0.0], height), exact, 1e-9);
        near(torsion([0.0, side], height), exact, 1e-9);
    }
}
