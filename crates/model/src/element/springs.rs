//! Springs and gaps: their rows of the element table.

use super::element_type::{ElementType, Kinematics, MOVING, mean_at_nodes};
use super::kernels;
use slideline_mech::element::cell::{LINE2, POINT};

/// The rows.
pub mod types {
    use super::*;

    /// Spring between a dof and the ground.
    pub static SPRING1: ElementType = ElementType {
        names: ["SPRING1"; 2],
        cell: &POINT,
        dofs: MOVING,
        kinematics: Kinematics::Spring,
        points: 0,
        states: |_| 0,
        fields: &[],
        at_nodes: mean_at_nodes,
        kernel: kernels::spring1,
    };

    /// Spring between dofs of two nodes.
    pub static SPRING2: ElementType =
        ElementType { names: ["SPRING2"; 2], cell: &LINE2, kernel: kernels::spring2, ..SPRING1 };

    /// Spring between two nodes, along the line that joins them.
    pub static SPRINGA: ElementType =
        ElementType { names: ["SPRINGA"; 2], cell: &LINE2, kernel: kernels::springa, ..SPRING1 };

    /// Gap between two nodes along a direction that stays.
    pub static GAPUNI: ElementType = ElementType {
        names: ["GAPUNI"; 2],
        cell: &LINE2,
        kinematics: Kinematics::Gap,
        kernel: kernels::gapuni,
        ..SPRING1
    };

    /// Gap by the distance of two nodes across an axis.
    pub static GAPCYL: ElementType =
        ElementType { names: ["GAPCYL"; 2], kernel: kernels::round_gap, ..GAPUNI };

    /// Gap by the distance of two nodes.
    pub static GAPSPHER: ElementType =
        ElementType { names: ["GAPSPHER"; 2], kernel: kernels::round_gap, ..GAPUNI };
}
