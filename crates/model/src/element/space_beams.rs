//! Beams in space: their rows of the element table.

use super::beams::types::B21;
use super::element_type::{ElementType, Field, Kinematics, Location, at, of};
use super::kernels;
use crate::node::Dof;
use slideline_mech::element::cell::LINE3;

/// Section forces and strains of a beam in space, at its middle.
const SPACE_BEAM_FIELDS: &[Field] = &[
    of(at(Location::Centroid, "SF", "[F]"), &["SF1", "SF2", "SF3"]),
    of(at(Location::Centroid, "SM", "[F L]"), &["SM1", "SM2", "SM3"]),
    of(at(Location::Centroid, "SE", "[1]"), &["SE1", "SE2", "SE3"]),
    of(at(Location::Centroid, "SK", "[1/L]"), &["SK1", "SK2", "SK3"]),
];

/// The rows.
pub mod types {
    use super::*;

    /// Two-node shear-flexible beam in space.
    pub static B31: ElementType = ElementType {
        names: ["B31"; 2],
        dofs: &Dof::ALL,
        kinematics: Kinematics::SpaceBeam,
        fields: SPACE_BEAM_FIELDS,
        kernel: kernels::space_beam::<2, 1>,
        ..B21
    };

    /// Three-node shear-flexible beam in space: end, middle, end.
    pub static B32: ElementType = ElementType {
        names: ["B32"; 2],
        cell: &LINE3,
        points: 2,
        kernel: kernels::space_beam::<3, 2>,
        ..B31
    };
}
