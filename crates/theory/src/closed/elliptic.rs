//! Elliptic integrals by Carlson's duplication.

use crate::error::TheoryError;

/// Carlson's symmetric integral R_F(x, y, z); at most one argument may vanish.
fn carlson_f(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    // each duplication divides the spread of the arguments by four
    for _ in 0..60 {
        let mean = (x + y + z) / 3.0;
        let spread = (x - mean).abs().max((y - mean).abs()).max((z - mean).abs()) / mean;
        if spread < 1e-3 {
            break;
        }
        let shift = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
    }
    let mean = (x + y + z) / 3.0;
    let (a, b) = (1.0 - x / mean, 1.0 - y / mean);
    let c = -a - b;
    let (e2, e3) = (a * b - c * c, a * b * c);
    // Taylor series of Carlson (1995), to fifth order
    let series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0;
    series / mean.sqrt()
}

/// Carlson's symmetric integral R_D(x, y, z), z > 0.
fn carlson_d(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    let (mut sum, mut factor) = (0.0, 1.0);
    for _ in 0..60 {
        let mean = (x + y + 3.0 * z) / 5.0;
        let spread = (x - mean).abs().max((y - mean).abs()).max((z - mean).abs()) / mean;
        if spread < 1e-3 {
            break;
        }
        let shift = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        sum += factor / (z.sqrt() * (z + shift));
        factor *= 0.25;
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
    }
    let mean = (x + y + 3.0 * z) / 5.0;
    let (a, b) = (1.0 - x / mean, 1.0 - y / mean);
    let c = -(a + b) / 3.0;
    let (ab, cc) = (a * b, c * c);
    let (e2, e3, e4, e5) =
        (ab - 6.0 * cc, (3.0 * ab - 8.0 * cc) * c, 3.0 * (ab - cc) * cc, ab * cc * c);
    let series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0
        - 3.0 * e4 / 22.0
        - 9.0 * e2 * e3 / 52.0
        + 3.0 * e5 / 26.0;
    3.0 * sum + factor * series / (mean * mean.sqrt())
}

/// Incomplete elliptic integral of the first kind F(phi, k), |phi| <= pi/2, modulus k.
///
/// # Errors
/// [`TheoryError::InvalidInput`] outside that range or for k sin phi > 1.
pub fn first_kind(phi: f64, k: f64) -> Result<f64, TheoryError> {
    let (s, c, d) = legendre_arguments(phi, k)?;
    Ok(s * carlson_f(c, d, 1.0))
}

/// Incomplete elliptic integral of the second kind E(phi, k), |phi| <= pi/2, modulus k.
///
/// # Errors
/// As [`first_kind`].
pub fn second_kind(phi: f64, k: f64) -> Result<f64, TheoryError> {
    let (s, c, d) = legendre_arguments(phi, k)?;
    Ok(s * carlson_f(c, d, 1.0) - k * k * s.powi(3) * carlson_d(c, d, 1.0) / 3.0)
}

/// sin phi, cos^2 phi, 1 - k^2 sin^2 phi.
fn legendre_arguments(phi: f64, k: f64) -> Result<(f64, f64, f64), TheoryError> {
    let (s, c) = phi.sin_cos();
    let d = (1.0 - k * s) * (1.0 + k * s);
    if phi.abs() > std::f64::consts::FRAC_PI_2 || d.is_nan() || d <= 0.0 {
        return Err(TheoryError::InvalidInput("elliptic integral outside its range"));
    }
    Ok((s, c * c, d))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::gauss;

    /// Against the defining integrals by Gauss-Legendre quadrature.
    #[test]
    fn agrees_with_quadrature() {
        let rule = gauss::rule(48);
        for (phi, k) in
            [(0.3, 0.5), (1.2, 0.9), (1.5, 0.2), (-0.7, 0.99), (std::f64::consts::FRAC_PI_2, 0.8)]
        {
            let root = |t: f64| (1.0 - (k * t.sin()).powi(2)).sqrt();
            let f = gauss::integrate(&rule, 0.0, phi, |t| 1.0 / root(t));
            let e = gauss::integrate(&rule, 0.0, phi, root);
            assert!((first_kind(phi, k).unwrap() / f - 1.0).abs() < 1e-13, "F({phi}, {k})");
            assert!((second_kind(phi, k).unwrap() / e - 1.0).abs() < 1e-13, "E({phi}, {k})");
        }
        assert!(first_kind(1.57, 1.1).is_err());
    }
}
