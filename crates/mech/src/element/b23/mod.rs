//! B23: the shear-rigid (Euler-Bernoulli, Kirchhoff) two-node cubic beam, exact in finite rotation.
//!
//! ```text
//!        f1   ___---___   f2        section angle over the chord, xi = -1 .. 1:
//!       \ __--         --__ /         theta = k xi - psi P2(xi)
//!        o - - - - - - - - o        k = (f2 - f1)/2, P2 = (3 xi^2 - 1)/2
//!        1      chord L    2        psi = angle of the chord - mean rotation
//! ```
//!
//! A corotational element: what strains it is the length of the chord and the two section angles
//! over the chord, -k - psi and k - psi. Between the ends the angle is the slope of the cubic that
//! these angles define (quadratic in xi, without mean), so that small displacements give the exact
//! Hermite beam. Its axis has length l (1 + eps) and the direction theta everywhere, hence the
//! chord L = l (1 + eps) C, C = mean of cos theta, which gives the stretch eps; the bending energy
//! is EI/2 times the integral of (dtheta/ds)^2. One stretch for the whole element: no membrane
//! locking. The trigonometric functions are kept, so an arc of a circle is exact at any turn.
//! Neglected are theta^3 in the direction of the chord and the variation of the axial force over
//! the element: both of fourth order in its length, the second up to a term of second order with
//! the factor I/A times (curvature gradient)^2, below what neglecting shear costs. [derived:
//! docs/theory.md, "Without shear: B23"]
//!
//! Rotated by the mean rotation, the chord has the components 1 + e and g, the strains of the
//! one-point Reissner element B21: W is a function of those and the curvature, so that kinematics
//! and their derivatives are those of [`Beam21`].

mod derivatives;

use super::b21::Beam21;
use super::beam_strains::{BeamSectionForces, BeamStrains};
use super::heated::{BeamHeat, Heated};
use super::kernel::Surroundings;
use super::quadrature::{GAUSS_4, GAUSS_4_MEAN};
use crate::differentiate::Real;
use crate::section::BeamStiffness;

/// Two-node shear-rigid plane beam element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beam23 {
    /// The B21 on the same nodes, of transverse stiffness 12 EI/l^2: the source of the kinematics
    /// and, in linear kinematics, the same element.
    chord: Beam21,
}

impl Beam23 {
    /// The element between two undeformed positions [L]; the shear stiffness is not used. They
    /// should differ (check [`Beam23::length`]): an element without length carries nothing.
    pub fn new(reference: [[f64; 2]; 2], stiffness: BeamStiffness) -> Self {
        let mut chord = Beam21::new(reference, stiffness);
        let length = chord.length();
        chord.stiffness = if length > 0.0 {
            BeamStiffness { shear: 12.0 * stiffness.bending / (length * length), ..stiffness }
        } else {
            BeamStiffness { axial: 0.0, shear: 0.0, bending: 0.0, centroid: 0.0 }
        };
        Self { chord }
    }

    /// Undeformed positions of the two nodes [L].
    pub fn reference(&self) -> [[f64; 2]; 2] {
        self.chord.reference
    }

    /// Undeformed length l [L].
    pub fn length(&self) -> f64 {
        self.chord.length()
    }

    /// EA, the transverse stiffness 12 EI/l^2 and EI.
    pub fn stiffness(&self) -> BeamStiffness {
        self.chord.stiffness
    }

    /// Angle of the undeformed element with the x axis [rad].
    pub fn angle(&self) -> f64 {
        self.chord.angle()
    }

    /// Stretch eps [1] and psi [1], the angle from the mean rotation to the chord, of the strains
    /// of the chord: docs/theory.md eqs. (3.17) and (3.19). L/l - 1 and 1 - cos theta are formed
    /// without cancellation.
    fn stretch_and_lean<R: Real>(&self, chord: &BeamStrains<R>) -> (R, R) {
        let number = R::from_f64;
        let (e, g) = (chord.axial, chord.shear);
        let ahead = e + number(1.0);
        let excess = e * (e + number(2.0)) + g * g;
        let longer = excess / ((excess + number(1.0)).sqrt() + number(1.0));
        let psi = g.atan2(ahead);
        let k = chord.curvature * number(0.5 * self.length());
        let versine = mean_versine(k, psi);
        ((longer + versine) / (number(1.0) - versine), psi)
    }

    /// W/l = EA eps^2/2 + EI kap^2/2 + 6 EI psi^2/l^2 of the strains of the chord [F].
    fn energy_per_length<R: Real>(&self, chord: &BeamStrains<R>) -> R {
        let (stretch, psi) = self.stretch_and_lean(chord);
        self.energy_of(&stretch, &psi, &chord.curvature)
    }

    /// The same of eps, psi and kap.
    fn energy_of<R: Real>(&self, &stretch: &R, &psi: &R, &curvature: &R) -> R {
        let strains = BeamStrains { axial: stretch, shear: psi, curvature };
        R::from_f64(0.5) * self.chord.stiffness.twice_energy(&strains, &self.chord.free)
    }

    /// Strain energy W = l/2 (EA eps^2 + EI kap^2 + 12 EI psi^2/l^2) [F L] of the displacements
    /// q = (u1x, u1y, f1, u2x, u2y, f2), kap = (f2 - f1)/l. The last two terms are the integral of
    /// EI (dtheta/ds)^2/2. [derived: docs/theory.md eqs. (3.16) and (3.18)]
    pub fn energy<R: Real>(&self, q: &[R; 6]) -> R {
        R::from_f64(self.length()) * self.energy_per_length(&self.chord.strains_of(q))
    }

    /// Strains at the middle: eps, no shear, kap.
    pub fn strains(&self, q: &[f64; 6]) -> BeamStrains {
        self.strains_at(q, 0.0)
    }

    /// Strains at xi in [-1, 1]: the curvature is dtheta/ds = kap - 6 psi xi/l, docs/theory.md
    /// eq. (3.15).
    pub fn strains_at(&self, q: &[f64; 6], xi: f64) -> BeamStrains {
        let chord = self.chord.strains(q);
        let (axial, psi) = self.stretch_and_lean(&chord);
        let slope = if self.length() > 0.0 { 6.0 * psi / self.length() } else { 0.0 };
        let beyond = -slope * xi;
        // the axial force is one over the element, the strain at the centroid therefore too
        let axial = axial + self.chord.stiffness.centroid * beyond;
        BeamStrains { axial, shear: 0.0, curvature: chord.curvature + beyond }
    }

    /// Section forces at the middle: N = EA eps, M = EI kap, and V = -dM/ds = 12 EI psi/l^2, which
    /// equilibrium asks for where no shear strain tells it: docs/theory.md eq. (3.22).
    pub fn section_forces(&self, q: &[f64; 6]) -> BeamSectionForces {
        let chord = self.chord.strains(q);
        let (stretch, psi) = self.stretch_and_lean(&chord);
        let strains = BeamStrains { axial: stretch, shear: psi, curvature: chord.curvature };
        self.chord.stiffness.forces(&strains.less(&self.chord.free))
    }
}

/// Mean of 1 - cos theta over the element, theta = k xi - psi P2(xi), by four Gauss points: 1e-11
/// for an arc of 36 degrees.
fn mean_versine<R: Real>(k: R, psi: R) -> R {
    let mut mean = R::from_f64(0.0);
    for (xi, weight) in GAUSS_4.into_iter().zip(GAUSS_4_MEAN) {
        let theta = k * R::from_f64(xi) - psi * R::from_f64(legendre(xi));
        let half = (theta * R::from_f64(0.5)).sin();
        mean = mean + R::from_f64(2.0 * weight) * half * half;
    }
    mean
}

/// P2(xi).
fn legendre(xi: f64) -> f64 {
    1.5 * xi * xi - 0.5
}

impl Heated<6, 36> for Beam23 {
    fn warmed(&self, heat: &BeamHeat, under: &Surroundings<'_>) -> Self {
        let mut chord = self.chord.warmed(heat, under);
        // 12 EI/l^2, whatever the shear stiffness of the section is
        let softer = chord.stiffness.bending / self.chord.stiffness.bending;
        chord.stiffness.shear = self.chord.stiffness.shear * softer;
        Self { chord }
    }
}
