//! Stresses over the height of a beam's section.
//!
//! ```text
//!     5 o-------   y = +height/2, on the side of the normal that stands
//!     4 o          90 degrees counter-clockwise of the beam's direction
//!     3 o  -> direction
//!     2 o
//!     1 o-------   y = -height/2
//! ```

use slideline_model::{BeamSection, SECTION_POINTS};
use slideline_solve::observe::{BeamRow, Frame};

/// Axial stress at the section points [F/L2]: N/A - y M/I. A positive moment
/// turns the beam counter-clockwise along its way, which shortens the fibres
/// on the side of the normal. Derived: rectangle, plane sections.
pub(crate) fn axial_stresses(row: &BeamRow, section: &BeamSection) -> [f64; SECTION_POINTS] {
    let area = section.width * section.height;
    let second_moment = area * section.height * section.height / 12.0;
    [-0.5, -0.25, 0.0, 0.25, 0.5].map(|place| {
        row.axial_force / area - place * section.height * row.bending_moment / second_moment
    })
}

/// Mises stress of the outer fibres [F/L2], where the shear stress of a
/// section is zero: the larger |S11|.
pub(crate) fn outer_mises(stresses: &[f64; SECTION_POINTS]) -> f64 {
    stresses[0].abs().max(stresses[SECTION_POINTS - 1].abs())
}

/// The beams of a frame with their sections.
pub(crate) fn beams<'a>(
    frame: &Frame<'a>,
) -> impl Iterator<Item = (&'a BeamRow, &'a BeamSection)> + use<'a> {
    let blocks = frame.model.blocks.iter().filter_map(|block| block.beams());
    let sections =
        blocks.flat_map(|block| std::iter::repeat_n(&block.section, block.elements.len()));
    frame.beams.iter().zip(sections)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slideline_model::ShearRule;

    /// Requirement: the stresses have the resultants they come from, N as sum
    /// and M as moment. Source: definition of the resultants; the stress is
    /// linear, so that Simpson's rule over points 1, 3, 5 is exact. Tolerance:
    /// rounding.
    #[test]
    fn stresses_have_the_resultants_of_the_section() {
        let section = BeamSection {
            width: 2.0,
            height: 3.0,
            poisson: 0.0,
            material: slideline_mech::material::Elastic { modulus: 1.0, poisson: 0.0 },
            shear: ShearRule::default(),
        };
        let row = BeamRow { axial_force: 5.0, bending_moment: -7.0, ..BeamRow::default() };
        let s = axial_stresses(&row, &section);
        let normal = 2.0 * 3.0 / 6.0 * (s[0] + 4.0 * s[2] + s[4]);
        let moment = -2.0 * 3.0 / 6.0 * (-1.5 * s[0] + 1.5 * s[4]);
        assert!((normal - 5.0).abs() < 1e-13 && (moment + 7.0).abs() < 1e-13);
        assert!((s[1] - 0.5 * (s[0] + s[2])).abs() < 1e-13);
        assert_eq!(outer_mises(&s), s[4]);
    }
}
