//! Strains and section forces of plane beams.

use super::mixed::arrival;
use crate::differentiate::Second;

/// Strains of a plane beam at its integration point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamStrains<R = f64> {
    /// Axial strain eps [1].
    pub axial: R,
    /// Shear strain gam [1].
    pub shear: R,
    /// Curvature kap [1/L].
    pub curvature: R,
}

/// Section forces, work conjugate to [`BeamStrains`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamSectionForces {
    /// Normal force N [F], tension positive.
    pub axial: f64,
    /// Shear force V [F].
    pub shear: f64,
    /// Bending moment M [F L].
    pub moment: f64,
}

impl BeamStrains {
    /// None.
    pub(super) const ZERO: Self = Self { axial: 0.0, shear: 0.0, curvature: 0.0 };

    /// What is left of these strains without others.
    pub(super) fn less(&self, other: &Self) -> Self {
        Self {
            axial: self.axial - other.axial,
            shear: self.shear - other.shear,
            curvature: self.curvature - other.curvature,
        }
    }

    /// Writes the section forces, then these strains.
    pub(super) fn write_with(&self, forces: &BeamSectionForces, into: &mut [f64]) {
        let own =
            [forces.axial, forces.shear, forces.moment, self.axial, self.shear, self.curvature];
        into.iter_mut().zip(own).for_each(|(into, value)| *into = value);
    }
}

impl From<[f64; 3]> for BeamSectionForces {
    fn from([axial, shear, moment]: [f64; 3]) -> Self {
        Self { axial, shear, moment }
    }
}

impl From<BeamSectionForces> for [f64; 3] {
    fn from(forces: BeamSectionForces) -> Self {
        [forces.axial, forces.shear, forces.moment]
    }
}

impl BeamStrains<Second<1>> {
    /// eps + B dq of strains along a line of displacements.
    pub(super) fn arrived(&self) -> BeamStrains {
        BeamStrains {
            axial: arrival(&self.axial),
            shear: arrival(&self.shear),
            curvature: arrival(&self.curvature),
        }
    }
}
