//! Which faces smooth one another at their corners.
//!
//! ```text
//!    o-----o-----o
//!    |  f  |  g  |     round a node: the faces between which no crease and no edge that is drawn lies;
//!    o-----*-----o     in a plane of symmetry their images too
//!    |     |     |
//!    o-----o-----o
//! ```
//!
//! docs/theory.md section 5.9.

use super::drawn_edges::Joints;
use super::edges::{MeshFace, faces_around, is_crease, neighbours, normal};
use super::mirror::{Mirror, Reflected};
use super::patch::MOST_CORNERS;
use super::star::Corner;
use crate::vector::Vector;
use std::collections::HashMap;

/// Faces at every node, with the corner that they have there.
type Around = HashMap<usize, Vec<(usize, usize)>>;
/// The face behind each edge of a face.
type Neighbours = [Option<usize>; MOST_CORNERS];

/// What smooths a corner of a face.
#[derive(Debug, Clone, Default)]
pub(super) struct Round {
    /// The (next, previous) nodes of the faces that meet there.
    pub corners: Vec<Corner>,
    /// Directions in which these and their images cancel [1].
    pub across: Vec<Vector>,
}

/// What smooths faces.
#[derive(Default)]
pub(super) struct Smoothing {
    /// Edges of each face that are drawn as they are.
    pub drawn: Vec<[bool; MOST_CORNERS]>,
    /// What smooths each corner of each face; nothing of faces with nodes in the middle of their edges.
    pub rounds: Vec<Vec<Round>>,
}

impl Smoothing {
    /// Of faces at their undeformed positions [L].
    pub fn new(own: &[MeshFace], reference: &[Vector], mirrors: &[Mirror]) -> Self {
        let all = Reflected::new(own, reference, mirrors);
        let (faces, neighbours, around) =
            (&all.faces[..], neighbours(&all.faces), faces_around(&all.faces));
        let place = |node: usize| all.positions[node];
        let normals: Vec<_> = faces.iter().map(|face| normal(face, place)).collect();
        let joints = Joints { faces, neighbours: &neighbours, around: &around, normals: &normals };
        let mut drawn = joints.drawn(place);
        let joins = |own: usize, edge: usize, other: usize| {
            !is_crease(normals[own], normals[other]) && !drawn[own][edge]
        };
        let of_face = |own: usize| match faces[own].nodes.len() == faces[own].cell.faces.len() {
            true => rounds(&all, own, (&around, &neighbours), joins),
            false => Vec::new(),
        };
        let rounds = (0..own.len()).map(of_face).collect();
        drawn.truncate(own.len());
        Self { drawn, rounds }
    }
}

/// What smooths the corners of a face: the faces that it is joined with round each of them.
fn rounds(
    all: &Reflected,
    own: usize,
    (around, neighbours): (&Around, &[Neighbours]),
    joins: impl Fn(usize, usize, usize) -> bool,
) -> Vec<Round> {
    let faces = &all.faces;
    let round = |node: &usize| {
        let at = &around[node];
        let group = group(own, at, neighbours, &joins);
        // in the order of the faces: both sides of an edge sum alike
        let here = at.iter().filter(|(face, _)| group.contains(face) && !all.is_image(*face));
        let corners = here.map(|&(face, corner)| {
            let nodes = &faces[face].nodes;
            let count = faces[face].cell.faces.len();
            [nodes[(corner + 1) % count], nodes[(corner + count - 1) % count]]
        });
        Round { corners: corners.collect(), across: all.crossed(&group) }
    };
    faces[own].nodes.iter().map(round).collect()
}

/// The faces that a face is joined with round a node without crossing a crease, itself first; `at`
/// are all faces there.
pub(super) fn group(
    own: usize,
    at: &[(usize, usize)],
    neighbours: &[Neighbours],
    joins: impl Fn(usize, usize, usize) -> bool,
) -> Vec<usize> {
    let mut group = vec![own];
    let mut open = vec![own];
    while let Some(face) = open.pop() {
        for (edge, next) in neighbours[face].iter().enumerate() {
            let Some(next) = *next else { continue };
            let here = at.iter().any(|(other, _)| *other == next);
            if here && !group.contains(&next) && joins(face, edge, next) {
                group.push(next);
                open.push(next);
            }
        }
    }
    group
}
