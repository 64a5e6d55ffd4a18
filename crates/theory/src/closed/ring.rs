//! A thin ring between two opposite forces.
//!
//! ```text
//!        ^ P
//!     .-----.
//!    /       \     R: radius, EI: bending stiffness, q = P R^2/EI
//!   |    +    |    a: half width, b: half height, a = b = R without a load
//!    \       /
//!     '-----'
//!        v P
//! ```

use crate::error::TheoryError;
use crate::numerics::{gauss, root};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, FRAC_PI_4};

/// Growth of the diameter along the forces [L], small: P R^3/EI (pi/4 - 2/pi). [Timoshenko, Strength
/// of Materials II, bending of rings]
pub fn growth(force: f64, radius: f64, bending_stiffness: f64) -> f64 {
    force * radius.powi(3) / bending_stiffness * (FRAC_PI_4 - FRAC_2_PI)
}

/// Half height b/R and half width a/R [-] of an inextensible ring pulled by q = P R^2/EI [-]. The
/// angle t from the direction of the force grows from 0 to pi/2 along a quarter, R^2 t'' = (q/2)
/// sin t, hence R t' = sqrt(c^2 + q (1 - cos t)) with c such that the quarter keeps its length.
/// [derived]
///
/// # Errors
/// [`TheoryError::InvalidInput`] for a pull that is not positive, or so large (beyond about 40) that
/// the sides are straight.
pub fn pulled(q: f64) -> Result<[f64; 2], TheoryError> {
    super::positive(q, "the pull must be positive")?;
    let rule = gauss::rule(200);
    let curvature = |c: f64, t: f64| (c * c + q * (1.0 - t.cos())).sqrt();
    let along = |c: f64, of: fn(f64) -> f64| {
        gauss::integrate(&rule, 0.0, FRAC_PI_2, |t| of(t) / curvature(c, t))
    };
    let c = root::bracketed(|c| along(c, |_| 1.0) - FRAC_PI_2, 0.02, 1.0)?;
    Ok([along(c, f64::cos), along(c, f64::sin)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a small pull is the linear one. Tolerance: the square of the growth.
    #[test]
    fn small_pulls_are_linear() {
        let q = 1e-4;
        let [height, _] = pulled(q).unwrap_or_default();
        let linear = 0.5 * growth(q, 1.0, 1.0);
        assert!((height - 1.0 - linear).abs() < 1e-8, "{height} {linear}");
    }

    /// Requirement: the work of the pull is the energy of bending. Source: the same ring as a chain
    /// of 400 angles in balance, which knows nothing of c. Tolerance: the square of its links.
    #[test]
    fn work_is_energy() {
        let height = |q: f64| pulled(q).map_or(f64::NAN, |[height, _]| height);
        let (n, most) = (200, 8.0);
        // q/2 db = [q b/2] - int b dq/2
        let simpson: f64 = (0..=n)
            .map(|k| {
                let b = if k == 0 { 1.0 } else { height(most * k as f64 / n as f64) };
                b * if k == 0 || k == n { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 }
            })
            .sum::<f64>()
            * most
            / (3.0 * n as f64);
        let work = 0.5 * (most * height(most) - simpson);
        let energy = energy_of_a_chain(most);
        assert!((work - energy).abs() < 2e-4 * energy, "{work} {energy}");
    }

    /// Bending energy of a quarter under q.
    fn energy_of_a_chain(q: f64) -> f64 {
        let n = 400;
        let h = FRAC_PI_2 / n as f64;
        let mut angles: Vec<f64> = (0..=n).map(|k| k as f64 * h).collect();
        // (t[k+1] - 2 t[k] + t[k-1])/h = h q/2 sin t[k], by Newton
        for _ in 0..30 {
            let mut diagonal = vec![1.0; n + 1];
            let mut right = vec![0.0; n + 1];
            for k in 1..n {
                let bend = angles[k + 1] - 2.0 * angles[k] + angles[k - 1];
                right[k] = -(bend - 0.5 * h * h * q * angles[k].sin());
                diagonal[k] = -2.0 - 0.5 * h * h * q * angles[k].cos();
            }
            for k in 2..n {
                let factor = 1.0 / diagonal[k - 1];
                diagonal[k] -= factor;
                right[k] -= factor * right[k - 1];
            }
            let mut next = 0.0;
            for k in (1..n).rev() {
                next = (right[k] - next) / diagonal[k];
                angles[k] += next;
            }
        }
        angles.windows(2).map(|pair| 0.5 * ((pair[1] - pair[0]) / h - 1.0).powi(2) * h).sum()
    }
}
