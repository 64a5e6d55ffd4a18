//! Williams' toggle: two shallow clamped beams that snap through.
//!
//! ```text
//!            P |  v
//!              v
//!          __.--.__        apex guided: no rotation
//!     __---        ---__   rise
//!  |/                    \|
//!   |<- half span ->|
//! ```

use crate::error::TheoryError;
use crate::numerics::gauss::Collocation;
use crate::numerics::{newton, root};

/// A symmetric toggle of two beams, clamped at the feet, rigid in shear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toggle {
    /// Half of the span [L].
    pub half_span: f64,
    /// Rise of the apex over the feet [L].
    pub rise: f64,
    /// Axial stiffness EA [F].
    pub axial_stiffness: f64,
    /// Bending stiffness EI [F L2].
    pub bending_stiffness: f64,
}

/// Steps in which the apex is brought down from rest.
const STEPS: usize = 64;

impl Toggle {
    /// Williams' (1964) frame, in inches and pounds.
    pub const fn williams() -> Self {
        Self {
            half_span: 12.943,
            rise: 0.386,
            axial_stiffness: 1.885e6,
            bending_stiffness: 9.274e3,
        }
    }

    /// Load P [F] that holds the apex at the deflection `v` [L] (downwards), on
    /// the symmetric path.
    ///
    /// One beam is antisymmetric about its middle, where no moment acts: with
    /// the force constant, x' = (1 + n_1/EA) cos f, y' = (1 + n_1/EA) sin f,
    /// EI f'' = -(x' n_y - y' n_x), three numbers are found by shooting over half
    /// of a beam (derived).
    ///
    /// # Errors
    /// [`TheoryError::InvalidInput`] for dimensions that are not positive,
    /// [`TheoryError::NotConverged`] where the path cannot be followed.
    pub fn load(&self, v: f64) -> Result<f64, TheoryError> {
        self.check()?;
        let method = Collocation::new(6);
        let mut unknowns = [0.0; 3];
        for i in 1..=STEPS {
            unknowns = self.shoot(v * i as f64 / STEPS as f64, unknowns, &method)?;
        }
        // the beam pushes the apex up by n_y from each side
        Ok(2.0 * unknowns[1] * self.force_unit())
    }

    /// First limit point (v, P) between the deflections `from` and `to`, where
    /// dP/dv changes sign once.
    ///
    /// # Errors
    /// Those of [`Toggle::load`], or no change of sign of dP/dv.
    pub fn limit(&self, from: f64, to: f64) -> Result<(f64, f64), TheoryError> {
        let d = 1e-4 * self.rise;
        let slope = |v: f64| Ok(self.load(v + d)? - self.load(v - d)?);
        let v = root::fallible(slope, from, to)?;
        Ok((v, self.load(v)?))
    }

    fn check(&self) -> Result<(), TheoryError> {
        for value in [self.half_span, self.rise, self.axial_stiffness, self.bending_stiffness] {
            super::positive(value, "the dimensions of the toggle must be positive")?;
        }
        Ok(())
    }

    fn force_unit(&self) -> f64 {
        self.bending_stiffness / (self.half_span * self.half_span)
    }

    /// Unknowns: force (n_x, n_y) on the upper end, and clamping moment, in units
    /// of EI/L^2 and EI/L.
    fn shoot(
        &self,
        v: f64,
        start: [f64; 3],
        method: &Collocation,
    ) -> Result<[f64; 3], TheoryError> {
        let (l, unit) = (self.half_span, self.force_unit());
        let (slope, length) = (self.rise.atan2(l), l.hypot(self.rise) / l);
        let stretch = unit / self.axial_stiffness;
        let residual = |z: &[f64; 3]| {
            // n here is the force on the lower part across a cut: the upper end is pushed down
            let n = [z[0], -z[1]];
            let end =
                method.advance([0.0, 0.0, slope, z[2]], 0.5 * length, 4, |y: &[f64; 4]| {
                    let (s, c) = y[2].sin_cos();
                    let e = 1.0 + stretch * (n[0] * c + n[1] * s);
                    [e * c, e * s, y[3], e * (s * n[0] - c * n[1])]
                })?;
            // the place of the middle matters on the scale of the axial strain
            Ok([(end[0] - 0.5) / stretch, (end[1] - 0.5 * (self.rise - v) / l) / 0.01, end[3]])
        };
        newton::solve(residual, start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: P(v) and both limit points of verification section 5, to eight digits.
    #[test]
    fn williams_table() {
        let toggle = Toggle::williams();
        for (v, p) in [
            (0.1, 25.205796),
            (0.232128, 33.871804),
            (0.391622, 31.279999),
            (0.5, 36.094288),
            (0.7, 88.186339),
        ] {
            let found = toggle.load(v).unwrap();
            assert!((found - p).abs() < 1e-6, "{v}: {found}");
        }
        let (v, p) = toggle.limit(0.15, 0.3).unwrap();
        assert!((v - 0.232128).abs() < 1e-5 && (p - 33.871804).abs() < 1e-6, "{v} {p}");
        let (v, p) = toggle.limit(0.3, 0.5).unwrap();
        assert!((v - 0.391622).abs() < 1e-5 && (p - 31.279999).abs() < 1e-6, "{v} {p}");
    }
}
