//! What of the area of a surface belongs to each of its nodes.
//!
//! ```text
//!    o-----o---------o     the integral of the shape function of the node: of quadratic faces
//!    1     4         3     nothing or less than nothing at a corner
//! ```

use std::collections::HashMap;

use slideline_diag::Span;
use slideline_mech::pressure::Face;
use slideline_model::NodeIndex;

use super::faces::{SolidFace, faces, nodes_of_surface};
use crate::draft::{Draft, ElementKind};
use crate::surfaces::{Extent, NamedSurface};

/// The nodes of a surface, each once, with their areas [L2]; with 1 each where the surface is made
/// of nodes. `user` names the surface.
pub(super) fn areas(
    surface: &NamedSurface,
    user: Span,
    draft: &mut Draft,
) -> Vec<(NodeIndex, f64)> {
    if !matches!(surface.extent, Extent::Elements(_)) {
        let nodes = nodes_of_surface(surface, user, draft);
        return nodes.into_iter().map(|node| (node, 1.0)).collect();
    }
    let mut places: HashMap<NodeIndex, usize> = HashMap::new();
    let mut areas: Vec<(NodeIndex, f64)> = Vec::new();
    for face in faces(surface, user, draft) {
        for (&node, share) in face.nodes.iter().zip(shares(&face, draft)) {
            let place = *places.entry(node).or_insert_with(|| {
                areas.push((node, 0.0));
                areas.len() - 1
            });
            areas[place].1 += share;
        }
    }
    areas
}

/// The areas of the nodes of a face [L2]; of a line, lengths [L].
fn shares(own: &SolidFace, draft: &Draft) -> Vec<f64> {
    let at: Vec<[f64; 3]> = own.nodes.iter().map(|&n| draft.model.nodes.position(n)).collect();
    let count = own.nodes.len();
    let face = own.face.and_then(|_| match draft.elements[own.element].kind {
        ElementKind::Structural(row) if row.is_ring() => Face::of_ring(count),
        ElementKind::Structural(row) => Face::of(row.cell.dimension, count, 1.0),
        kind => kind.bare().and_then(|mesh| Face::of(if mesh.spatial { 3 } else { 2 }, count, 1.0)),
    });
    let Some(face) = face else { return along_line(&at) };
    let mut forces = vec![[0.0; 3]; count];
    face.pull(|_| [1.0, 0.0, 0.0], &at, &mut forces);
    forces.into_iter().map(|[share, ..]| share).collect()
}

/// Lengths of the nodes of a line of two or three nodes, the middle one between its ends.
fn along_line(at: &[[f64; 3]]) -> Vec<f64> {
    let (Some(a), Some(b)) = (at.first(), at.last()) else { return Vec::new() };
    let length = (0..3).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
    match at.len() {
        3 => vec![length / 6.0, 2.0 * length / 3.0, length / 6.0],
        count => vec![length / count as f64; count],
    }
}
