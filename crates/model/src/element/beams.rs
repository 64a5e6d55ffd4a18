//! Beams in the plane: their rows of the element table.

use super::element_type::{ElementType, Field, Kinematics, Location, at, mean_at_nodes, of};
use super::kernels;
use crate::node::Dof;
use slideline_mech::element::cell::{LINE2, LINE3};

/// Section forces and strains of a beam, at its middle.
const BEAM_FIELDS: &[Field] = &[
    of(at(Location::Centroid, "SF", "[F]"), &["SF1", "SF2"]),
    of(at(Location::Centroid, "SM", "[F L]"), &["SM1"]),
    of(at(Location::Centroid, "SE", "[1]"), &["SE1", "SE2"]),
    of(at(Location::Centroid, "SK", "[1/L]"), &["SK1"]),
];

const TURNING: &[Dof] = &[Dof::U1, Dof::U2, Dof::UR3];

/// The rows.
pub mod types {
    use super::*;

    /// Two-node shear-flexible plane beam.
    pub static B21: ElementType = ElementType {
        names: ["B21"; 2],
        cell: &LINE2,
        dofs: TURNING,
        kinematics: Kinematics::Beam { sheared: true },
        points: 1,
        states: |_| 0,
        fields: BEAM_FIELDS,
        at_nodes: mean_at_nodes,
        kernel: kernels::b21,
    };

    /// Three-node shear-flexible plane beam: end, middle, end.
    pub static B22: ElementType =
        ElementType { names: ["B22"; 2], cell: &LINE3, points: 2, kernel: kernels::b22, ..B21 };

    /// Two-node shear-rigid plane beam.
    pub static B23: ElementType = ElementType {
        names: ["B23"; 2],
        kinematics: Kinematics::Beam { sheared: false },
        kernel: kernels::b23,
        ..B21
    };
}
