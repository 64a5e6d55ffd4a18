//! Line contact of elastic cylinders (plane strain), without and with partial slip.
//!
//! ```text
//!      (    )        half width a, pressure pmax sqrt(1 - x^2/a^2)
//!    ----==----      stick for |x| < c under a tangential force Q < mu P
//! ```

use crate::error::TheoryError;
use std::f64::consts::PI;

/// An elastic body with a cylindrical (or flat) surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Radius [L]; infinite for a half space.
    pub radius: f64,
    /// Young's modulus [F/L2].
    pub modulus: f64,
    /// Poisson's ratio [-].
    pub poisson: f64,
}

/// Line contact of two cylinders under a force per length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    /// Half width a of the contact [L].
    pub half_width: f64,
    /// Largest pressure pmax [F/L2].
    pub peak_pressure: f64,
}

impl LineContact {
    /// a = sqrt(4 F R/(pi E*)), pmax = 2 F/(pi a), with 1/E* and 1/R the sums over
    /// both bodies (Hertz 1882); `force` is per length [F/L].
    ///
    /// # Errors
    /// [`TheoryError::InvalidInput`] for a force or stiffness that is not positive, or two flat bodies.
    pub fn new(first: &Cylinder, second: &Cylinder, force: f64) -> Result<Self, TheoryError> {
        super::positive(force, "the force must be positive")?;
        let compliance = |c: &Cylinder| (1.0 - c.poisson * c.poisson) / c.modulus;
        let soft =
            super::positive(compliance(first) + compliance(second), "the moduli must be positive")?;
        let curvature =
            super::positive(1.0 / first.radius + 1.0 / second.radius, "one body must be round")?;
        let half_width = (4.0 * force * soft / (PI * curvature)).sqrt();
        Ok(Self { half_width, peak_pressure: 2.0 * force / (PI * half_width) })
    }

    /// Pressure [F/L2] at `x` [L] from the middle.
    pub fn pressure(&self, x: f64) -> f64 {
        self.peak_pressure * semicircle(x / self.half_width)
    }

    /// Largest shear stress [F/L2] below the surface and its depth [L]:
    /// 0.30028311 pmax at 0.786151 a.
    pub fn peak_shear(&self) -> (f64, f64) {
        (0.300_283_11 * self.peak_pressure, 0.786_151 * self.half_width)
    }

    /// Half width c [L] of the stick zone under the tangential force Q = `share` mu P:
    /// a sqrt(1 - share) (Cattaneo 1938, Mindlin 1949).
    ///
    /// # Errors
    /// [`TheoryError::InvalidInput`] unless 0 <= share <= 1: beyond, the contact slides.
    pub fn stick_half_width(&self, share: f64) -> Result<f64, TheoryError> {
        if !(0.0..=1.0).contains(&share) {
            return Err(TheoryError::InvalidInput(
                "the tangential force must lie between 0 and mu P",
            ));
        }
        Ok(self.half_width * (1.0 - share).sqrt())
    }

    /// Shear traction [F/L2] at `x` [L] under Q = `share` mu P:
    /// mu pmax [sqrt(1 - x^2/a^2) - (c/a) sqrt(1 - x^2/c^2)] (Cattaneo 1938, Mindlin 1949).
    ///
    /// # Errors
    /// As [`LineContact::stick_half_width`].
    pub fn shear_traction(&self, x: f64, mu: f64, share: f64) -> Result<f64, TheoryError> {
        let c = self.stick_half_width(share)?;
        let stick = if c > 0.0 { c / self.half_width * semicircle(x / c) } else { 0.0 };
        Ok(mu * self.peak_pressure * (semicircle(x / self.half_width) - stick))
    }
}

fn semicircle(x: f64) -> f64 {
    ((1.0 - x) * (1.0 + x)).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn equal_cylinders() -> LineContact {
        let body = Cylinder { radius: 10.0, modulus: 2e5, poisson: 0.3 };
        LineContact::new(&body, &body, 1000.0).unwrap()
    }

    /// Requirement: the Hertz rows of verification section 6.
    #[test]
    fn hertz_rows() {
        let steel = Cylinder { radius: 50.0, modulus: 210e3, poisson: 0.3 };
        let block = Cylinder { radius: f64::INFINITY, modulus: 70e3, poisson: 0.3 };
        let nafems = LineContact::new(&steel, &block, 35e3).unwrap();
        assert!(
            (nafems.half_width - 6.214628).abs() < 6e-7
                && (nafems.peak_pressure - 3585.3622).abs() < 6e-5
        );
        let pair = equal_cylinders();
        assert!(
            (pair.half_width - 0.24069150).abs() < 6e-9
                && (pair.peak_pressure - 2644.96156).abs() < 6e-6
        );
        assert!(LineContact::new(&block, &block, 1.0).is_err());
    }

    /// Requirement: the Cattaneo-Mindlin row, mu = 0.5.
    #[test]
    #[allow(clippy::approx_constant)]
    fn cattaneo_rows() {
        let pair = equal_cylinders();
        let table = [
            (0.25, 0.86602540, 661.240, 177.179),
            (0.5, 0.70710678, 935.135, 387.346),
            (0.75, 0.5, 1145.302, 661.240),
            (0.9, 0.31622777, 1254.615, 904.276),
        ];
        for (share, c, peak, centre) in table {
            let stick = pair.stick_half_width(share).unwrap();
            assert!((stick / pair.half_width - c).abs() < 6e-9);
            assert!((pair.shear_traction(stick, 0.5, share).unwrap() - peak).abs() < 6e-4);
            assert!((pair.shear_traction(0.0, 0.5, share).unwrap() - centre).abs() < 6e-4);
        }
    }
}
