//! Finite rotations in space, by a rotation vector.
//!
//! ```text
//!    phi ^   o R a        R a = a + A phi x a + B phi x (phi x a)
//!        |  /             A = sin t / t,  B = (1 - cos t) / t^2,  t = |phi|
//!        | /  o a
//!        |/_-'
//! ```
//! docs/theory.md eq. (4.5).

use crate::differentiate::{Real, Second, taylor};

/// Below this square of the angle [1] the series are summed, above it the formulas are used: both
/// give full accuracy on either side.
const SMALL: f64 = 0.25;

/// R(phi) a - a [L]: how far the end of an arm `a` [L] moves when it turns by phi [1]. Written
/// without a difference of near numbers: small turns keep their digits.
pub fn displacement<R: Real>(phi: &[R; 3], arm: [f64; 3]) -> [R; 3] {
    let arm = arm.map(R::from_f64);
    let square = phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2];
    let [a, b] = coefficients(square.value());
    let (a, b) = (taylor(square, a), taylor(square, b));
    let once = cross(phi, &arm);
    let twice = cross(phi, &once);
    std::array::from_fn(|k| a * once[k] + b * twice[k])
}

/// d(R(phi) a)/d phi [L]: a row for each component, a column for each part of phi.
pub fn slopes(phi: [f64; 3], arm: [f64; 3]) -> [[f64; 3]; 3] {
    displacement(&Second::variables(&phi), arm).map(|moved| moved.gradient)
}

/// Second derivatives of f . R(phi) a by phi [F L], for a force f [F].
pub fn curvature(phi: [f64; 3], arm: [f64; 3], force: [f64; 3]) -> [[f64; 3]; 3] {
    let moved = displacement(&Second::variables(&phi), arm);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).map(|k| force[k] * moved[k].hessian[i][j]).sum())
    })
}

fn cross<R: Real>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A and B as functions of s = t^2, each with two derivatives.
fn coefficients(s: f64) -> [[f64; 3]; 2] {
    if s < SMALL {
        return [series(s, 1.0), series(s, 2.0)];
    }
    let angle = s.sqrt();
    let (sin, cos) = angle.sin_cos();
    let a = sin / angle;
    let half = (0.5 * angle).sin();
    let b = 2.0 * half * half / s;
    let a1 = (cos - a) / (2.0 * s);
    let b1 = (0.5 * a - b) / s;
    [[a, a1, -(0.5 * a + 3.0 * a1) / (2.0 * s)], [b, b1, (0.5 * a1 - 2.0 * b1) / s]]
}

/// sum_k (-s)^k / (2k + first)!, with two derivatives.
fn series(s: f64, first: f64) -> [f64; 3] {
    // term k of the sum is c_k s^k
    let mut c = 1.0 / if first == 1.0 { 1.0 } else { 2.0 };
    let mut sum = [c, 0.0, 0.0];
    let mut powers = [1.0, 0.0, 0.0]; // s^k, s^(k-1), s^(k-2)
    for k in 1..12 {
        let k = f64::from(k);
        c /= -(2.0 * k + first) * (2.0 * k + first - 1.0);
        powers = [powers[0] * s, powers[0], powers[1]];
        sum[0] += c * powers[0];
        sum[1] += c * k * powers[1];
        sum[2] += c * k * (k - 1.0) * powers[2];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a turn about z is the plane's, a full turn brings back, lengths stay.
    #[test]
    fn known_turns() {
        let arm = [0.3, -0.2, 0.7];
        for angle in [1e-9, 0.3, 0.49, 0.51, 2.0, 3.1] {
            let [x, y, z] = displacement(&[0.0, 0.0, angle], arm);
            let (s, c) = f64::sin_cos(angle);
            assert!((x - ((c - 1.0) * arm[0] - s * arm[1])).abs() < 1e-15, "{angle}");
            assert!((y - (s * arm[0] + (c - 1.0) * arm[1])).abs() < 1e-15, "{angle}");
            assert_eq!(z, 0.0);
        }
        let [x, y, z] = displacement(&[0.4, -1.1, 0.6], arm);
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>();
        let turned = [arm[0] + x, arm[1] + y, arm[2] + z];
        assert!((length(turned) - length(arm)).abs() < 1e-15);
    }

    /// Requirement: slopes and curvature are derivatives of the displacement, on both sides of the
    /// border between series and formula, and at rest. Central differences of step 1e-5; 1e-9.
    #[test]
    fn derivatives_by_differences() {
        let (arm, force) = ([0.3, -0.2, 0.7], [1.5, 0.4, -0.8]);
        for phi in [[0.0; 3], [0.2, -0.1, 0.3], [0.3, 0.4, -0.05], [0.9, -1.4, 0.6]] {
            let (slope, curve) = (slopes(phi, arm), curvature(phi, arm, force));
            for j in 0..3 {
                let moved = |by: f64| {
                    let mut phi = phi;
                    phi[j] += by;
                    phi
                };
                let (up, down) = (moved(1e-5), moved(-1e-5));
                let (a, b) = (displacement(&up, arm), displacement(&down, arm));
                let (da, db) = (slopes(up, arm), slopes(down, arm));
                for i in 0..3 {
                    assert!((slope[i][j] - (a[i] - b[i]) / 2e-5).abs() < 1e-9, "{phi:?}");
                    let of = |d: [[f64; 3]; 3]| (0..3).map(|k| force[k] * d[k][i]).sum::<f64>();
                    assert!((curve[i][j] - (of(da) - of(db)) / 2e-5).abs() < 1e-9, "{phi:?}");
                }
            }
        }
    }
}
