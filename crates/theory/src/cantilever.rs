//! The beam of both example problems.

use crate::error::{TheoryError, check_positive};

/// A straight cantilever of rectangular section, clamped at `base`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cantilever {
    /// Clamped end (x, y) [L].
    pub base: [f64; 2],
    /// Free end (x, y) [L].
    pub tip: [f64; 2],
    /// Width b out of the plane [L].
    pub width: f64,
    /// Thickness t in the plane of bending [L].
    pub thickness: f64,
    /// Young's modulus E [F/L2].
    pub modulus: f64,
    /// Poisson's ratio [-].
    pub poisson: f64,
    /// Shear coefficient k of the section [-]; 0.85 for a rectangle.
    pub shear_factor: f64,
}

impl Cantilever {
    /// Length L [L].
    pub fn length(&self) -> f64 {
        (self.tip[0] - self.base[0]).hypot(self.tip[1] - self.base[1])
    }
    /// Bending stiffness EI = E b t^3/12 [F L2].
    pub fn bending_stiffness(&self) -> f64 {
        self.modulus * self.width * self.thickness.powi(3) / 12.0
    }
    /// Axial stiffness EA = E b t [F].
    pub fn axial_stiffness(&self) -> f64 {
        self.modulus * self.width * self.thickness
    }
    /// Shear stiffness kGA = k E b t/(2 (1 + nu)) [F].
    pub fn shear_stiffness(&self) -> f64 {
        self.shear_factor * self.axial_stiffness() / (2.0 * (1.0 + self.poisson))
    }

    /// Refuses dimensions and moduli out of their range.
    pub(crate) fn check(&self) -> Result<(), TheoryError> {
        let positive = [
            (self.length(), "the length of the beam must be positive"),
            (self.width, "the width must be positive"),
            (self.thickness, "the thickness must be positive"),
            (self.modulus, "Young's modulus must be positive"),
            (self.shear_factor, "the shear coefficient must be positive"),
            (1.0 + self.poisson, "Poisson's ratio must lie above -1"),
        ];
        check_positive(&positive)
    }
}
