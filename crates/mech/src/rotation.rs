//! Finite rotations in space, by a rotation vector.
//!
//! ```text
//!    phi ^   o R a        R a = a + A phi x a + B phi x (phi x a)
//!        |  /             A = sin t / t,  B = (1 - cos t) / t^2,  t = |phi|
//!        | /  o a
//!        |/_-'
//! ```
//! docs/theory.md eq. (4.5). A rotation itself is a unit quaternion, which no rotation vector is too
//! large for; section 3.7.

use crate::differentiate::{Real, Second, taylor};

/// Cosine of half the angle, then its sine times the axis.
pub type Quaternion<R = f64> = [R; 4];

/// No rotation.
pub const REST: Quaternion = [1.0, 0.0, 0.0, 0.0];

/// Below this square of the angle [1] the series are summed, above it the formulas are used: both
/// give full accuracy on either side.
const SMALL: f64 = 0.25;

/// R(phi) a - a [L]: how far the end of an arm `a` [L] moves when it turns by phi [1]. Written
/// without a difference of near numbers: small turns keep their digits.
pub fn displacement<R: Real>(phi: &[R; 3], arm: [f64; 3]) -> [R; 3] {
    let arm = arm.map(R::from_f64);
    let square = phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2];
    let [a, b, _] = coefficients(square.value());
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

/// The rotation of a rotation vector `phi` [1].
pub fn quaternion<R: Real>(phi: &[R; 3]) -> Quaternion<R> {
    let half = phi.map(|part| part * R::from_f64(0.5));
    let square = half[0] * half[0] + half[1] * half[1] + half[2] * half[2];
    let [a, b, _] = coefficients(square.value());
    let (a, b) = (taylor(square, a), taylor(square, b));
    let [x, y, z] = half.map(|part| a * part);
    [R::from_f64(1.0) - b * square, x, y, z]
}

/// The first rotation after the second one.
pub fn after<R: Real>(a: &Quaternion<R>, b: &Quaternion<R>) -> Quaternion<R> {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
        a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1],
    ]
}

/// The rotation back.
pub fn back<R: Real>(of: &Quaternion<R>) -> Quaternion<R> {
    [of[0], -of[1], -of[2], -of[3]]
}

/// R a - a [L] of a rotation, without a difference of near numbers.
pub fn displacement_by<R: Real>(of: &Quaternion<R>, arm: &[R; 3]) -> [R; 3] {
    let axis = [of[1], of[2], of[3]];
    let once = cross(&axis, arm);
    let twice = cross(&axis, &once);
    std::array::from_fn(|k| R::from_f64(2.0) * (of[0] * once[k] + twice[k]))
}

/// The rotation vector of a rotation, of at most half a turn [1].
pub fn vector<R: Real>(of: &Quaternion<R>) -> [R; 3] {
    let sign = R::from_f64(if of[0].value() < 0.0 { -1.0 } else { 1.0 });
    let cosine = sign * of[0];
    let ratio = taylor(cosine, arc_by_sine(cosine.value())) * sign;
    [ratio * of[1], ratio * of[2], ratio * of[3]]
}

/// 2 arccos(c)/sqrt(1 - c^2) of a cosine c in [0, 1], with two derivatives.
fn arc_by_sine(c: f64) -> [f64; 3] {
    let c = c.min(1.0);
    let versine = 1.0 - c;
    if versine > 0.2 {
        let square = versine * (1.0 + c);
        let value = 2.0 * c.acos() / square.sqrt();
        let first = (c * value - 2.0) / square;
        return [value, first, (value + 3.0 * c * first) / square];
    }
    // the hypergeometric series of (1, 1; 3/2) at half the versine, term by term
    let (half, mut term) = (0.5 * versine, 2.0);
    let (mut sum, mut powers) = ([term, 0.0, 0.0], [1.0, 0.0, 0.0]);
    for k in 1..20 {
        let k = f64::from(k);
        term *= k / (k + 0.5);
        powers = [powers[0] * half, powers[0], powers[1]];
        sum[0] += term * powers[0];
        sum[1] -= 0.5 * term * k * powers[1];
        sum[2] += 0.25 * term * k * (k - 1.0) * powers[2];
    }
    sum
}

/// The axis about which a body turns as its rotation vector grows, axial(dR R') = T dphi:
/// a row for each component of the turn, a column for each part of phi; docs/theory.md eq. (3.73).
pub fn spin(phi: [f64; 3]) -> [[f64; 3]; 3] {
    let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    unit.map(|along| along_vector(&phi, &along))
}

/// T(phi)' m: the share of a moment `m` [F L] that works on a rotation vector, whose transpose is
/// [`spin`]. T(phi)' is T(-phi).
pub fn along_vector<R: Real>(phi: &[R; 3], moment: &[R; 3]) -> [R; 3] {
    let square = phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2];
    let [_, b, c] = coefficients(square.value());
    let (b, c) = (taylor(square, b), taylor(square, c));
    let once = cross(phi, moment);
    let twice = cross(phi, &once);
    std::array::from_fn(|k| moment[k] - b * once[k] + c * twice[k])
}

/// The moment `m` [F L] whose share T(phi)' m works on a rotation vector: the inverse of
/// [`along_vector`], docs/theory.md eq. (4.15).
pub fn moment_of_share(phi: [f64; 3], share: [f64; 3]) -> [f64; 3] {
    let once = cross(&phi, &share);
    if once == [0.0; 3] {
        return share;
    }
    let twice = cross(&phi, &once);
    let d = inverse_coefficient(phi.iter().map(|part| part * part).sum());
    std::array::from_fn(|k| share[k] + 0.5 * once[k] + d * twice[k])
}

/// (1 - (t/2) cot(t/2))/t^2 as a function of s = t^2.
fn inverse_coefficient(s: f64) -> f64 {
    if s >= SMALL {
        let half = 0.5 * s.sqrt();
        return (1.0 - half / half.tan()) / s;
    }
    // |B_2n| s^(n-1)/(2n)!, n from 1, with Bernoulli's numbers
    const TERMS: [f64; 7] = [
        1.0 / 12.0,
        1.0 / 720.0,
        1.0 / 30_240.0,
        1.0 / 1_209_600.0,
        1.0 / 47_900_160.0,
        691.0 / 1_307_674_368_000.0,
        1.0 / 74_724_249_600.0,
    ];
    TERMS.iter().rev().fold(0.0, |sum, term| sum * s + term)
}

/// Derivatives of T(phi)' m by phi, a row for each component [F L].
pub fn along_vector_slopes(phi: [f64; 3], moment: [f64; 3]) -> [[f64; 3]; 3] {
    let fixed = moment.map(Second::<3>::from_f64);
    along_vector(&Second::variables(&phi), &fixed).map(|share| share.gradient)
}

/// a x b.
pub(crate) fn cross<R: Real>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A, B and C = (t - sin t)/t^3 as functions of s = t^2, each with two derivatives.
fn coefficients(s: f64) -> [[f64; 3]; 3] {
    if s < SMALL {
        return [(1.0, 1.0), (2.0, 2.0), (3.0, 6.0)].map(|(first, by)| series(s, first, 1.0 / by));
    }
    let angle = s.sqrt();
    let (sin, cos) = angle.sin_cos();
    let a = sin / angle;
    let half = (0.5 * angle).sin();
    let b = 2.0 * half * half / s;
    let a1 = (cos - a) / (2.0 * s);
    let b1 = (0.5 * a - b) / s;
    let a2 = -(0.5 * a + 3.0 * a1) / (2.0 * s);
    let c = (1.0 - a) / s;
    let c1 = -(a1 + c) / s;
    [[a, a1, a2], [b, b1, (0.5 * a1 - 2.0 * b1) / s], [c, c1, -(a2 + 2.0 * c1) / s]]
}

/// sum_k (-s)^k / (2k + first)!, with two derivatives; c is that of k = 0.
fn series(s: f64, first: f64, mut c: f64) -> [f64; 3] {
    // term k of the sum is c_k s^k
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

    /// Requirement: the moment of a share is the one whose share it is, on both sides of the border
    /// between series and formula, and at rest; along the axis it is the share itself. 1e-13.
    #[test]
    fn moments_of_shares() {
        let moment = [1.5, 0.4, -0.8];
        for phi in
            [[0.0; 3], [1e-9, 0.0, 2e-9], [0.28, -0.1, 0.4], [0.3, 0.39, -0.1], [1.9, -1.4, 2.1]]
        {
            let found = moment_of_share(phi, along_vector(&phi, &moment));
            for k in 0..3 {
                assert!((found[k] - moment[k]).abs() < 1e-13, "{phi:?} {found:?}");
            }
        }
        let full = [0.0, 0.0, 2.0 * std::f64::consts::PI];
        assert_eq!(moment_of_share(full, [0.0, 0.0, 3.0]), [0.0, 0.0, 3.0]);
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
