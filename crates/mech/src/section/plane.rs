//! The three stiffnesses of a plane beam.

use super::shape::Shape;
use crate::material::Elastic;

/// The stiffnesses of a plane beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamStiffness {
    /// EA [F].
    pub axial: f64,
    /// Transverse shear stiffness K [F].
    pub shear: f64,
    /// EI about the centroid [F L2].
    pub bending: f64,
    /// Place of the centroid on the normal of the beam, counted from its axis [L].
    pub centroid: f64,
}

/// How the transverse shear stiffness is found (`*TRANSVERSE SHEAR STIFFNESS`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransverseShear {
    /// Slenderness compensation factor SCF [1]; 0.25 by default.
    pub slenderness: f64,
    /// K23 as given in the deck [F]; `None`: k G A.
    pub given: Option<f64>,
    /// K13 likewise, across the plane; `None`: k G A.
    pub across: Option<f64>,
    /// Replace the factor f_p by the exact residual bending flexibility l^2 / 12 EI, which makes a
    /// cantilever exact on any mesh. Off by default.
    pub residual_bending_flexibility: bool,
}

impl Default for TransverseShear {
    fn default() -> Self {
        Self { slenderness: 0.25, given: None, across: None, residual_bending_flexibility: false }
    }
}

impl TransverseShear {
    /// The rule as it stands for second-order elements: the slenderness factor multiplied by 1e-4
    /// and no residual bending flexibility, both of which mend the one-point element only.
    /// [semantics: B21, transverse shear]
    pub fn second_order(self) -> Self {
        Self { slenderness: 1e-4 * self.slenderness, residual_bending_flexibility: false, ..self }
    }
}

/// EA, K, EI of a section in an element of the given length [L].
///
/// K = f_p k G A with the shear factor k of the shape and f_p = 1 / (1 + SCF l^2 A / 12 I); or, with residual bending
/// flexibility, 1/K = 1/(k G A) + l^2 / (12 EI). [semantics: B21, transverse shear]
pub fn stiffness(
    section: &Shape,
    material: &Elastic,
    shear: &TransverseShear,
    length: f64,
) -> BeamStiffness {
    let (area, second_moment) = (section.area(), section.second_moment());
    let bending = material.modulus * second_moment;
    let full = shear.given.unwrap_or(section.shear_factor() * material.shear_modulus() * area);
    let reduced = if shear.residual_bending_flexibility {
        full / (1.0 + full * length * length / (12.0 * bending))
    } else {
        full / (1.0 + shear.slenderness * length * length * area / (12.0 * second_moment))
    };
    let centroid = section.centroid()[1];
    BeamStiffness { axial: material.modulus * area, shear: reduced, bending, centroid }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: f_p of the seed's beam as tabulated. Source: semantics, section 7. Tolerance:
    /// half a unit of the last digit printed there.
    #[test]
    fn slenderness_factor_of_the_1995_beam() {
        let section = Shape::Rectangle { width: 25e-3, height: 1.5e-3 };
        let material = Elastic { modulus: 6.9e9, poisson: 0.3 };
        let total = 50.049_348_5e-3;
        for (elements, factor) in
            [(4.0, 0.05436), (12.0, 0.34097), (24.0, 0.67422), (100.0, 0.97292)]
        {
            let stiffness =
                stiffness(&section, &material, &TransverseShear::default(), total / elements);
            assert!((stiffness.shear / 84_591.346 - factor).abs() < 6e-6, "{elements}");
            assert!((stiffness.axial - 258_750.0).abs() < 1e-6);
            assert!((stiffness.bending - 0.048_515_625).abs() < 1e-12);
        }
    }

    /// Requirement: with residual bending flexibility the compliance is 1/kGA + l^2/12EI.
    #[test]
    fn residual_bending_flexibility() {
        let section = Shape::Rectangle { width: 2.0, height: 3.0 };
        let material = Elastic { modulus: 10.0, poisson: 0.25 };
        let shear = TransverseShear { residual_bending_flexibility: true, ..Default::default() };
        let stiffness = stiffness(&section, &material, &shear, 5.0);
        let full = 0.85 * 4.0 * 6.0;
        let expected = 1.0 / (1.0 / full + 25.0 / (12.0 * stiffness.bending));
        assert!((stiffness.shear - expected).abs() < 1e-12 * expected);
    }
}
