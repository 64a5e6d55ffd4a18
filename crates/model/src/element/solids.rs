//! The rows of solids: cell x rule x kinematics x formulation.
//!
//! ```text
//!   CPS plane stress   CPE plane strain   CAX rings   C3D space
//!   3 6 triangles   4 8 quadrilaterals   4 10 tetrahedra   6 15 wedges   8 20 hexahedra
//!   I incompatible modes   R fewer points   H few pressures an element
//! ```

use super::element_type::{ElementType, Field, IN_SPACE, Kinematics, Location, MOVING, at, of};
use super::kernels;
use super::section::Section;
use slideline_mech::element::cell::Cell;
use slideline_mech::element::quadrature::Quadrature;
use slideline_mech::element::solid::{self, Formulation};

/// Equivalent plastic strain.
const PEEQ: Field = of(at(Location::Points, "PEEQ", "[1]"), &["PEEQ"]);
/// Equivalent creep strain.
const CEEQ: Field = of(at(Location::Points, "CEEQ", "[1]"), &["CEEQ"]);
/// Stored energy of a unit of undeformed volume.
const ENER: Field = of(at(Location::Points, "ENER", "[F/L2]"), &["ENER"]);
/// Energy that plastic strain took of it.
const PENER: Field = of(at(Location::Points, "PENER", "[F/L2]"), &["PENER"]);
/// Stored energy of the whole element.
const ELSE: Field = of(at(Location::Centroid, "ELSE", "[F L]"), &["ELSE"]);
/// Energy that plastic strain took of it.
const ELPD: Field = of(at(Location::Centroid, "ELPD", "[F L]"), &["ELPD"]);
/// Its volume.
const EVOL: Field = of(at(Location::Centroid, "EVOL", "[L3]"), &["EVOL"]);

/// Stress, strain and energies of a plane solid at its integration points.
const PLANE_FIELDS: &[Field] = &[
    of(at(Location::Points, "S", "[F/L2]"), &["S11", "S22", "S33", "S12"]),
    of(at(Location::Points, "E", "[1]"), &["E11", "E22", "E33", "E12"]),
    PEEQ,
    CEEQ,
    ENER,
    PENER,
    ELSE,
    ELPD,
    EVOL,
];

/// The same in space.
const SPACE_FIELDS: &[Field] = &[
    of(at(Location::Points, "S", "[F/L2]"), &["S11", "S22", "S33", "S12", "S13", "S23"]),
    of(at(Location::Points, "E", "[1]"), &["E11", "E22", "E33", "E12", "E13", "E23"]),
    PEEQ,
    CEEQ,
    ENER,
    PENER,
    ELSE,
    ELPD,
    EVOL,
];

/// State variables of an element of a row.
fn states(
    parts: (&Cell, &Quadrature),
    way: (solid::Kinematics, Formulation),
    section: &Section,
) -> usize {
    match section {
        Section::Solid(section) => solid::states(parts, way, &section.material),
        _ => 0,
    }
}

macro_rules! rows {
    ($($(#[$doc:meta])* $name:ident: $cell:ident, $rule:ident, $strains:ident, $formulation:ident / $other:ident,
       $dimension:literal, $points:literal;)*) => {
        /// The rows of solids.
        pub mod types {
            use super::*;
            use slideline_mech::element::cell::{
                HEX20, HEX8, QUAD4, QUAD8, TET10, TET4, TRI3, TRI6, WEDGE15, WEDGE6,
            };
            use slideline_mech::element::quadrature::{
                HEX_1, HEX_27, HEX_8, QUAD_1, QUAD_4, QUAD_9, TET_1, TET_4, TRI_1, TRI_3,
                WEDGE_3X3, WEDGE_AXIS_2,
            };
            $(
                $(#[$doc])*
                pub static $name: ElementType = ElementType {
                    names: [stringify!($name); 2],
                    cell: &$cell,
                    dofs: if $dimension == 2 { MOVING } else { IN_SPACE },
                    kinematics: Kinematics::Solid {
                        strains: solid::Kinematics::$strains,
                        formulation: [Formulation::$formulation, Formulation::$other],
                        rule: &$rule,
                    },
                    points: $points,
                    states: |section| {
                        let way = (solid::Kinematics::$strains, Formulation::$formulation);
                        states((&$cell, &$rule), way, section)
                    },
                    fields: if $dimension == 2 { PLANE_FIELDS } else { SPACE_FIELDS },
                    at_nodes: |points, components, nodes| {
                        $rule.carry(points, components, &$cell, nodes);
                    },
                    kernel: kernels::solid,
                };
            )*
        }
        /// All rows of solids.
        pub(super) const SOLIDS: &[&ElementType] = &[$(&types::$name),*];
    };
}

rows! {
    /// Quadrilateral in plane strain, one pressure an element; four of them in CalculiX.
    CPE4: QUAD4, QUAD_4, PlaneStrain, MeanDilation / Plain, 2, 4;
    /// Quadrilateral in plane strain with incompatible modes.
    CPE4I: QUAD4, QUAD_4, PlaneStrain, Incompatible / Incompatible, 2, 4;
    /// Quadrilateral in plane strain of one point, with hourglass control.
    CPE4R: QUAD4, QUAD_1, PlaneStrain, Hourglass / Hourglass, 2, 1;
    /// Quadrilateral in plane strain, hybrid: one pressure an element.
    CPE4H: QUAD4, QUAD_4, PlaneStrain, MeanDilation / MeanDilation, 2, 4;
    /// Triangle in plane strain.
    CPE3: TRI3, TRI_1, PlaneStrain, Plain / Plain, 2, 1;
    /// Quadratic triangle in plane strain.
    CPE6: TRI6, TRI_3, PlaneStrain, Plain / Plain, 2, 3;
    /// Quadratic quadrilateral in plane strain.
    CPE8: QUAD8, QUAD_9, PlaneStrain, Plain / Plain, 2, 9;
    /// Quadratic quadrilateral in plane strain, hybrid: its pressure is linear in position.
    CPE8H: QUAD8, QUAD_9, PlaneStrain, LinearDilation / LinearDilation, 2, 9;
    /// Quadratic quadrilateral in plane strain of four points.
    CPE8R: QUAD8, QUAD_4, PlaneStrain, Plain / Plain, 2, 4;
    /// Triangle in plane stress.
    CPS3: TRI3, TRI_1, PlaneStress, Plain / Plain, 2, 1;
    /// Quadrilateral in plane stress.
    CPS4: QUAD4, QUAD_4, PlaneStress, Plain / Plain, 2, 4;
    /// Quadrilateral in plane stress with incompatible modes.
    CPS4I: QUAD4, QUAD_4, PlaneStress, Incompatible / Incompatible, 2, 4;
    /// Quadrilateral in plane stress of one point, with hourglass control.
    CPS4R: QUAD4, QUAD_1, PlaneStress, Hourglass / Hourglass, 2, 1;
    /// Quadratic triangle in plane stress.
    CPS6: TRI6, TRI_3, PlaneStress, Plain / Plain, 2, 3;
    /// Quadratic quadrilateral in plane stress.
    CPS8: QUAD8, QUAD_9, PlaneStress, Plain / Plain, 2, 9;
    /// Quadratic quadrilateral in plane stress of four points.
    CPS8R: QUAD8, QUAD_4, PlaneStress, Plain / Plain, 2, 4;
    /// Triangular ring.
    CAX3: TRI3, TRI_1, Axisymmetric, Plain / Plain, 2, 1;
    /// Quadrilateral ring, one pressure an element; four of them in CalculiX.
    CAX4: QUAD4, QUAD_4, Axisymmetric, MeanDilation / Plain, 2, 4;
    /// Quadrilateral ring with incompatible modes.
    CAX4I: QUAD4, QUAD_4, Axisymmetric, Incompatible / Incompatible, 2, 4;
    /// Quadrilateral ring of one point, with hourglass control.
    CAX4R: QUAD4, QUAD_1, Axisymmetric, Hourglass / Hourglass, 2, 1;
    /// Quadrilateral ring, hybrid: one pressure an element.
    CAX4H: QUAD4, QUAD_4, Axisymmetric, MeanDilation / MeanDilation, 2, 4;
    /// Quadratic triangular ring.
    CAX6: TRI6, TRI_3, Axisymmetric, Plain / Plain, 2, 3;
    /// Quadratic quadrilateral ring.
    CAX8: QUAD8, QUAD_9, Axisymmetric, Plain / Plain, 2, 9;
    /// Quadratic quadrilateral ring, hybrid: its pressure is linear in position.
    CAX8H: QUAD8, QUAD_9, Axisymmetric, LinearDilation / LinearDilation, 2, 9;
    /// Quadratic quadrilateral ring of four points.
    CAX8R: QUAD8, QUAD_4, Axisymmetric, Plain / Plain, 2, 4;
    /// Tetrahedron.
    C3D4: TET4, TET_1, Space, Plain / Plain, 3, 1;
    /// Tetrahedron, hybrid: its one pressure is that of its one point.
    C3D4H: TET4, TET_1, Space, Plain / Plain, 3, 1;
    /// Wedge.
    C3D6: WEDGE6, WEDGE_AXIS_2, Space, Plain / Plain, 3, 2;
    /// Hexahedron, one pressure an element; eight of them in CalculiX.
    C3D8: HEX8, HEX_8, Space, MeanDilation / Plain, 3, 8;
    /// Hexahedron with incompatible modes.
    C3D8I: HEX8, HEX_8, Space, Incompatible / Incompatible, 3, 8;
    /// Hexahedron of one point, with hourglass control.
    C3D8R: HEX8, HEX_1, Space, Hourglass / SoftHourglass, 3, 1;
    /// Hexahedron, hybrid: one pressure an element.
    C3D8H: HEX8, HEX_8, Space, MeanDilation / MeanDilation, 3, 8;
    /// Quadratic tetrahedron.
    C3D10: TET10, TET_4, Space, Plain / Plain, 3, 4;
    /// Quadratic tetrahedron, hybrid: one pressure an element.
    C3D10H: TET10, TET_4, Space, MeanDilation / MeanDilation, 3, 4;
    /// Quadratic wedge.
    C3D15: WEDGE15, WEDGE_3X3, Space, Plain / Plain, 3, 9;
    /// Quadratic hexahedron.
    C3D20: HEX20, HEX_27, Space, Plain / Plain, 3, 27;
    /// Quadratic hexahedron, hybrid: its pressure is linear in position.
    C3D20H: HEX20, HEX_27, Space, LinearDilation / LinearDilation, 3, 27;
    /// Quadratic hexahedron of eight points.
    C3D20R: HEX20, HEX_8, Space, Plain / Plain, 3, 8;
}
