//! Planes of symmetry at which masters end.
//!
//! ```text
//!      slave    |
//!   ---o---o----|      beyond the plane stands the mirror image of the master: normals and curves
//!   ---o---o----|- -   go on into it
//! ```
//!
//! docs/theory.md sections 5.3 and 5.9.

use slideline_mech::surface::mesh::{MeshFace, surface_ends};
use slideline_mech::surface::mirror::Mirror;
use slideline_model::SymmetryPlane;

/// The planes in which faces at these undeformed positions [L] end.
pub fn mirrors(
    faces: &[MeshFace],
    positions: &[[f64; 3]],
    planes: &[SymmetryPlane],
) -> Vec<Mirror> {
    if planes.is_empty() {
        return Vec::new();
    }
    let ends = surface_ends(faces, |node| positions[node]);
    let of_plane = |plane: &SymmetryPlane| {
        let inside = positions.iter().map(|&at| plane.holds(at)).collect();
        Mirror { normal: plane.normal, inside }
    };
    let ends_in = |mirror: &Mirror| {
        faces.iter().zip(&ends).any(|(face, ends)| {
            let corners = face.cell.faces.len();
            let edge = |own: usize| [face.nodes[own], face.nodes[(own + 1) % corners]];
            (0..corners).any(|own| ends[own] && mirror.has(edge(own)))
        })
    };
    planes.iter().map(of_plane).filter(ends_in).collect()
}
