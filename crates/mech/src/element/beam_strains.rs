//! Strains and section forces of plane beams.

use super::mixed::arrival;
use crate::differentiate::Real;
use crate::first_order::First;
use crate::section::BeamStiffness;

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

impl BeamStiffness {
    /// Section forces about the axis of strains that the free beam does not have:
    /// docs/theory.md eq. (3.104).
    pub(super) fn forces(&self, strains: &BeamStrains) -> BeamSectionForces {
        let axial = self.axial * (strains.axial - self.centroid * strains.curvature);
        BeamSectionForces {
            axial,
            shear: self.shear * strains.shear,
            moment: self.bending * strains.curvature - self.centroid * axial,
        }
    }

    /// Twice the energy of such strains by length [F].
    pub(super) fn twice_energy<R: Real>(&self, strains: &BeamStrains<R>, free: &BeamStrains) -> R {
        let number = R::from_f64;
        let curvature = strains.curvature - number(free.curvature);
        let axial = strains.axial - number(free.axial) - number(self.centroid) * curvature;
        number(self.axial) * axial * axial
            + number(self.shear) * strains.shear * strains.shear
            + number(self.bending) * curvature * curvature
    }

    /// Rows of the derivatives of the strains, that of the axial strain at the centroid.
    pub(super) fn at_centroid<const N: usize>(
        &self,
        [axial, shear, curvature]: [[f64; N]; 3],
    ) -> [[f64; N]; 3] {
        let moved = std::array::from_fn(|i| axial[i] - self.centroid * curvature[i]);
        [moved, shear, curvature]
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

impl BeamStrains<First<1>> {
    /// eps + B dq of strains along a line of displacements.
    pub(super) fn arrived(&self) -> BeamStrains {
        BeamStrains {
            axial: arrival(&self.axial),
            shear: arrival(&self.shear),
            curvature: arrival(&self.curvature),
        }
    }
}
