//! B21: the geometrically exact (Reissner) two-node beam, one integration point.
//!
//! ```text
//!                      2   dofs of each node: ux, uy, rotation
//!              ____---o
//!       ___----   \      section turned by the mean rotation p = (f1 + f2)/2,
//!      o           \     free to lean by the shear strain
//!      1
//! ```
//!
//! Everything is formed in the frame of the undeformed element from displacement *differences*, so
//! that rounding of the end forces does not grow with the coordinates [semantics: force floor].

mod derivatives;

use super::beam_strains::{BeamSectionForces, BeamStrains};
use super::heated::{BeamHeat, Heated, weighted};
use super::kernel::Surroundings;
use crate::differentiate::Real;
use crate::section::BeamStiffness;

/// Two-node plane beam element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam21 {
    /// Undeformed positions of the two nodes [L].
    pub reference: [[f64; 2]; 2],
    /// EA, K, EI.
    pub stiffness: BeamStiffness,
    length: f64,
    /// 1/l, or zero for an element without length.
    inverse: f64,
    direction: [f64; 2],
    /// Strains of the free element, hot as it is: docs/theory.md eq. (3.63).
    pub(super) free: BeamStrains,
}

impl Beam21 {
    /// The element between two undeformed positions [L]. They should differ (check
    /// [`Beam21::length`]): an element without length carries nothing and links nothing.
    pub fn new(reference: [[f64; 2]; 2], stiffness: BeamStiffness) -> Self {
        let along = [reference[1][0] - reference[0][0], reference[1][1] - reference[0][1]];
        let length = along[0].hypot(along[1]);
        let inverse = if length > 0.0 { 1.0 / length } else { 0.0 };
        let direction =
            if length > 0.0 { [along[0] / length, along[1] / length] } else { [1.0, 0.0] };
        let free = BeamStrains::ZERO;
        Self { reference, stiffness, length, inverse, direction, free }
    }

    /// Undeformed length l [L].
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Angle alpha0 of the undeformed element with the x axis [rad].
    pub fn angle(&self) -> f64 {
        self.direction[1].atan2(self.direction[0])
    }

    /// Strains eps = c dx + s dy - 1, gam = -s dx + c dy, kap = (f2 - f1)/l, in the undeformed
    /// element's frame, where d = (1, 0) + (u2 - u1)/l. cos p - 1 is written -2 sin^2(p/2), so that
    /// small strains keep all their digits. [semantics: B21, strains]
    pub fn strains_of<R: Real>(&self, q: &[R; 6]) -> BeamStrains<R> {
        let mean = (q[2] + q[5]) * R::from_f64(0.5);
        self.strains_turned(q, mean, (mean.sin(), mean.cos()))
    }

    /// The same with the mean rotation of both ends, its sine and its cosine.
    fn strains_turned<R: Real>(&self, q: &[R; 6], mean: R, (s, c): (R, R)) -> BeamStrains<R> {
        let number = R::from_f64;
        let (ex, ey) = (number(self.direction[0]), number(self.direction[1]));
        let inverse = number(self.inverse);
        let (wx, wy) = ((q[3] - q[0]) * inverse, (q[4] - q[1]) * inverse);
        let (along, across) = (ex * wx + ey * wy, ex * wy - ey * wx);
        let half = (mean * number(0.5)).sin();
        let versine = number(2.0) * half * half;
        BeamStrains {
            axial: c * along + s * across - versine,
            shear: c * across - s * along - s,
            curvature: (q[5] - q[2]) * inverse,
        }
    }

    /// Strain energy W = l/2 (EA eps^2 + K gam^2 + EI kap^2), eps at the centroid, [F L] of the displacements
    /// q = (u1x, u1y, f1, u2x, u2y, f2). [semantics: B21, energy]
    pub fn energy<R: Real>(&self, q: &[R; 6]) -> R {
        R::from_f64(0.5 * self.length)
            * self.stiffness.twice_energy(&self.strains_of(q), &self.free)
    }

    /// Strains at the integration point.
    pub fn strains(&self, q: &[f64; 6]) -> BeamStrains {
        self.strains_of(q)
    }

    /// Section forces N = EA eps, V = K gam, M = EI kap where the axis is the centroid.
    pub fn section_forces(&self, q: &[f64; 6]) -> BeamSectionForces {
        self.forces_of(&self.strains(q))
    }

    fn forces_of(&self, strains: &BeamStrains) -> BeamSectionForces {
        self.stiffness.forces(&strains.less(&self.free))
    }

    fn energy_of(&self, strains: &BeamStrains, forces: &BeamSectionForces) -> f64 {
        let strains = strains.less(&self.free);
        0.5 * self.length
            * (forces.axial * strains.axial
                + forces.shear * strains.shear
                + forces.moment * strains.curvature)
    }
}

impl Heated<6, 36> for Beam21 {
    /// At the mean temperature of both ends.
    fn warmed(&self, heat: &BeamHeat, under: &Surroundings<'_>) -> Self {
        let [now, initial] =
            [under.temperatures, under.initial].map(|nodes| weighted(&[0.5, 0.5], nodes));
        let stiffness = heat.stiffness(&self.stiffness, now.value);
        Self { stiffness, free: heat.free(&self.stiffness, now, initial), ..*self }
    }
}
