//! How faces meet at their edges.
//!
//! ```text
//!    o-----o-----o
//!    |  f  |  g  |     two faces that share an edge in opposite directions are neighbours; an
//!    o-----o-----o     edge with one face alone, or between faces that turn sharply, is an end
//! ```

use super::patch::MOST_CORNERS;
use crate::element::cell::Cell;
use crate::vector::{Vector, add, cross, dot, scale, size, sub};
use std::collections::HashMap;

/// Cosine of the turn of a surface from which on an edge is sharp [1]: 45 degrees, and a tenth of a degree less, so that
/// rounding of places does not choose at chamfers of just 45.
pub const SHARP: f64 = 0.708_339_837_724_528_9;

/// A face by its cell and its nodes, counter-clockwise as seen from outside.
#[derive(Debug, Clone)]
pub struct MeshFace {
    /// Its reference cell.
    pub cell: &'static Cell,
    /// Its nodes, corners first.
    pub nodes: Vec<usize>,
}

impl MeshFace {
    /// The triangles between its corners, by their places among its nodes.
    pub fn triangles(&self) -> &'static [[usize; 3]] {
        match self.cell.faces.len() {
            3 => &[[0, 1, 2]],
            _ => &[[0, 1, 2], [0, 2, 3]],
        }
    }
}

/// The corner nodes of a face's edge.
pub(super) fn edge(face: &MeshFace, edge: usize) -> [usize; 2] {
    let corners = face.cell.faces.len();
    [face.nodes[edge], face.nodes[(edge + 1) % corners]]
}

/// The face behind each edge: where exactly two faces share it, in opposite directions.
pub(super) fn neighbours(faces: &[MeshFace]) -> Vec<[Option<usize>; MOST_CORNERS]> {
    let mut sharing: HashMap<[usize; 2], Vec<(usize, usize)>> = HashMap::new();
    for (place, face) in faces.iter().enumerate() {
        for k in 0..face.cell.faces.len() {
            let [a, b] = edge(face, k);
            sharing.entry([a.min(b), a.max(b)]).or_default().push((place, k));
        }
    }
    let mut all = vec![[None; MOST_CORNERS]; faces.len()];
    for pair in sharing.values() {
        if let [(f, k), (g, l)] = pair[..]
            && edge(&faces[f], k)[0] == edge(&faces[g], l)[1]
        {
            all[f][k] = Some(g);
            all[g][l] = Some(f);
        }
    }
    all
}

/// At which edges of faces a surface ends or has a crease; `position` gives undeformed positions of
/// nodes [L].
pub fn surface_ends(
    faces: &[MeshFace],
    position: impl Fn(usize) -> Vector,
) -> Vec<[bool; MOST_CORNERS]> {
    let normals: Vec<_> = faces.iter().map(|face| normal(face, &position)).collect();
    ends(faces, &neighbours(faces), |a, b| !is_crease(normals[a], normals[b]))
}

pub(super) fn ends(
    faces: &[MeshFace],
    neighbours: &[[Option<usize>; MOST_CORNERS]],
    joins: impl Fn(usize, usize) -> bool,
) -> Vec<[bool; MOST_CORNERS]> {
    let of_face = |(own, face): (usize, &MeshFace)| {
        let corners = face.cell.faces.len();
        let is_end = |edge: usize| neighbours[own][edge].is_none_or(|other| !joins(own, other));
        std::array::from_fn(|edge| edge < corners && is_end(edge))
    };
    faces.iter().enumerate().map(of_face).collect()
}

/// The nodes on edges at which a surface ends, in order.
pub fn nodes_at_ends(faces: &[MeshFace], ends: &[[bool; MOST_CORNERS]]) -> Vec<usize> {
    let mut nodes = Vec::new();
    for (face, ends) in faces.iter().zip(ends) {
        let corners = face.cell.faces.len();
        for own in (0..corners).filter(|&own| ends[own]) {
            nodes.extend(edge(face, own));
            nodes.extend(face.nodes.get(corners + own));
        }
    }
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// Faces at every node, with the corner that they have there.
pub(super) fn faces_around(faces: &[MeshFace]) -> HashMap<usize, Vec<(usize, usize)>> {
    let mut around: HashMap<usize, Vec<(usize, usize)>> = HashMap::new();
    for (place, face) in faces.iter().enumerate() {
        for corner in 0..face.cell.faces.len() {
            around.entry(face.nodes[corner]).or_default().push((place, corner));
        }
    }
    around
}

/// Whether faces of these unit normals meet at a crease.
pub fn is_crease(a: Vector, b: Vector) -> bool {
    dot(a, b) <= SHARP
}

/// The area of a face between its three or four corners, along its normal [L2], with the places of these.
pub fn area_between(corners: usize, at: impl Fn(usize) -> Vector) -> Vector {
    let sides = match corners {
        3 => [sub(at(1), at(0)), sub(at(2), at(0))],
        _ => [sub(at(2), at(0)), sub(at(3), at(1))],
    };
    scale(cross(sides[0], sides[1]), 0.5)
}

/// The area of a face between its corners, along its normal [L2].
pub(super) fn area(face: &MeshFace, position: impl Fn(usize) -> Vector) -> Vector {
    area_between(face.cell.faces.len(), |k| position(face.nodes[k]))
}

/// The middle of the corners of a face [L].
pub(super) fn middle(face: &MeshFace, position: impl Fn(usize) -> Vector) -> Vector {
    let corners = face.cell.faces.len();
    let sum = face.nodes[..corners].iter().fold([0.0; 3], |sum, &n| add(sum, position(n)));
    scale(sum, 1.0 / corners as f64)
}

/// Unit normal in the middle of a face; zero of one without area.
pub(super) fn normal(face: &MeshFace, position: impl Fn(usize) -> Vector) -> Vector {
    let area = area(face, position);
    match size(area) {
        whole if whole > 0.0 => scale(area, 1.0 / whole),
        _ => [0.0; 3],
    }
}
