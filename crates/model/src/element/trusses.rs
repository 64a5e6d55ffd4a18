//! Trusses: their rows of the element table.

use super::element_type::{
    ElementType, Field, IN_SPACE, Kinematics, Location, MOVING, at, mean_at_nodes, of,
};
use super::kernels;
use super::section::Section;
use slideline_mech::element::cell::{LINE2, LINE3};

/// Stress along a truss, its strains along and across, plastic strain and creep strain, at its integration points.
const TRUSS_FIELDS: &[Field] = &[
    of(at(Location::Points, "S", "[F/L2]"), &["S11"]),
    of(at(Location::Points, "E", "[1]"), &["E11", "E22"]),
    of(at(Location::Points, "PEEQ", "[1]"), &["PEEQ"]),
    of(at(Location::Points, "CEEQ", "[1]"), &["CEEQ"]),
];

/// State variables of a truss of that many points.
fn bar_states(section: &Section, points: usize) -> usize {
    match section {
        Section::Solid(section) => points * section.material.uniaxial_states(),
        _ => 0,
    }
}

/// The rows.
pub mod types {
    use super::*;

    /// Two-node truss in the plane.
    pub static T2D2: ElementType = ElementType {
        names: ["T2D2"; 2],
        cell: &LINE2,
        dofs: MOVING,
        kinematics: Kinematics::Truss,
        points: 1,
        states: |section| bar_states(section, 1),
        fields: TRUSS_FIELDS,
        at_nodes: mean_at_nodes,
        kernel: kernels::truss,
    };

    /// Three-node truss in the plane: end, middle, end.
    pub static T2D3: ElementType = ElementType {
        names: ["T2D3"; 2],
        cell: &LINE3,
        points: 2,
        states: |section| bar_states(section, 2),
        ..T2D2
    };

    /// Two-node truss in space.
    pub static T3D2: ElementType = ElementType { names: ["T3D2"; 2], dofs: IN_SPACE, ..T2D2 };

    /// Three-node truss in space: end, middle, end.
    pub static T3D3: ElementType = ElementType { names: ["T3D3"; 2], dofs: IN_SPACE, ..T2D3 };
}
