//! The designer's rule for a cantilever snap-fit.
//!
//! ```text
//!  |\
//!  |=============__
//!  |/       t      \_| hook: ramp a, undercut y
//!   |<---- L ---->|
//! ```

use crate::error::TheoryError;

/// A snap-fit arm of rectangular section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SnapFit {
    /// Width b [L].
    pub width: f64,
    /// Thickness t [L].
    pub thickness: f64,
    /// Length L [L].
    pub length: f64,
    /// Young's modulus (secant) E [F/L2].
    pub modulus: f64,
}

impl SnapFit {
    /// Transverse force P = E b t^3 y/(4 L^3) [F] at the deflection `y` [L]
    /// (rule published by Bayer; slope of the arm ignored).
    pub fn deflection_force(&self, y: f64) -> f64 {
        self.modulus * self.width * (self.thickness / self.length).powi(3) * y / 4.0
    }

    /// Largest strain 1.5 t y/L^2 [-].
    pub fn strain(&self, y: f64) -> f64 {
        1.5 * self.thickness * y / (self.length * self.length)
    }

    /// Push (or pull) W = P (mu + tan a)/(1 - mu tan a) [F] over a ramp of angle
    /// `ramp` [rad].
    ///
    /// # Errors
    /// [`TheoryError::Jamming`] for mu tan a >= 1: the fit locks itself.
    pub fn mating_force(&self, y: f64, ramp: f64, mu: f64) -> Result<f64, TheoryError> {
        Ok(self.deflection_force(y) * super::incline::raising(ramp.tan(), mu)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the worked numbers of verification section 6 (mm, N, MPa).
    #[test]
    fn worked_example() {
        let arm = SnapFit { width: 25.0, thickness: 1.5, length: 50.0, modulus: 6900.0 };
        assert!((arm.deflection_force(2.0) - 2.328750).abs() < 6e-7);
        assert!((arm.strain(2.0) - 0.0018).abs() < 1e-15);
        assert!((arm.mating_force(2.0, 30f64.to_radians(), 0.3).unwrap() - 2.471144).abs() < 6e-7);
        assert!(arm.mating_force(2.0, 75f64.to_radians(), 0.3).is_err());
    }
}
