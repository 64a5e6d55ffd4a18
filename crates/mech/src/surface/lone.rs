//! Edges of less than 45 degrees that are no part of a round.
//!
//! ```text
//!     o----o----o               o----o.
//!                \                     `o.        a chamfer turns once, and the lines beside the edge do
//!                 \                       `o      not; a round turns again at the next one
//!                  o                       |
//!      lone                     round      o
//! ```
//!
//! docs/theory.md section 5.17

use super::edges::{MeshFace, SHARP, edge, faces_around, neighbours, normal};
use super::patch::MOST_CORNERS;
use crate::vector::{Vector, dot, size, sub};
use std::collections::HashMap;

/// Turn from which on an edge may be lone [rad]: 20 degrees. (choice)
const LEAST: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// Part of its turn that a line beside it has at least where both are of a round [1]: at the ends of a round it is a half.
/// (choice)
const ROUND: f64 = 0.4;
/// Cosine of the angle between edges of a round at most [1]. (choice)
const ALONG: f64 = 0.8;

/// Whether an edge that turns by so much [rad] between lines that turn by those is one that stands alone: it is no part of a
/// round, nor sharp by itself. `None`: the surface ends there, and the image beyond a plane of symmetry may turn on.
pub fn is_lone(turn: f64, mut beside: impl Iterator<Item = Option<f64>>) -> bool {
    let may_be = |turn: f64| turn <= SHARP.acos();
    let is_next = |other: f64| other > ROUND * turn && may_be(other);
    may_be(turn) && turn > LEAST && !beside.any(|other| other.is_none_or(is_next))
}

/// Nodes of edges between faces that stand out: the corners of lone ones, then the middle nodes of lone and of sharp ones, whose corners
/// turn sharply themselves; `position` gives undeformed positions of nodes [L].
pub fn nodes_of_edges(faces: &[MeshFace], position: impl Fn(usize) -> Vector) -> Vec<usize> {
    let turning = Turning::new(faces, position);
    let lone = || turning.edges(|turn, beside| is_lone(turn, beside));
    let outstanding = turning.edges(|turn, beside| turn > SHARP.acos() || is_lone(turn, beside));
    let middle = |&(face, k): &(usize, usize)| {
        faces[face].nodes.get(faces[face].cell.faces.len() + k).copied()
    };
    let corners = lone().into_iter().flat_map(|(face, k)| edge(&faces[face], k));
    corners.chain(outstanding.iter().filter_map(middle)).collect()
}

/// How faces turn at their edges.
struct Turning<'a, F> {
    faces: &'a [MeshFace],
    position: F,
    normals: Vec<Vector>,
    neighbours: Vec<[Option<usize>; MOST_CORNERS]>,
    around: HashMap<usize, Vec<(usize, usize)>>,
}

impl<'a, F: Fn(usize) -> Vector> Turning<'a, F> {
    fn new(faces: &'a [MeshFace], position: F) -> Self {
        let normals = faces.iter().map(|face| normal(face, &position)).collect();
        let (neighbours, around) = (neighbours(faces), faces_around(faces));
        Self { faces, position, normals, neighbours, around }
    }

    /// Edges, each once by one of its faces, whose turn among those beside it is of a kind.
    fn edges(
        &self,
        is_of_kind: impl Fn(f64, &mut dyn Iterator<Item = Option<f64>>) -> bool,
    ) -> Vec<(usize, usize)> {
        let count = |face: usize| self.faces[face].cell.faces.len();
        let all = (0..self.faces.len()).flat_map(|face| (0..count(face)).map(move |k| (face, k)));
        let kept = all.filter(|&(face, k)| {
            let is_first = self.neighbours[face][k].is_some_and(|other| face < other);
            let turn = self.turn(face, k).filter(|_| is_first);
            turn.is_some_and(|turn| is_of_kind(turn, &mut self.beside(face, k)))
        });
        kept.collect()
    }

    /// The turn at an edge of a face, positive where the edge stands out [rad]; `None` at an end of the surface.
    fn turn(&self, face: usize, k: usize) -> Option<f64> {
        let other = self.neighbours[face][k]?;
        let angle = dot(self.normals[face], self.normals[other]).clamp(-1.0, 1.0).acos();
        let corner = edge(&self.faces[face], k)[0];
        let off = |&node: &usize| {
            dot(sub((self.position)(node), (self.position)(corner)), self.normals[face])
        };
        let corners = &self.faces[other].nodes[..self.faces[other].cell.faces.len()];
        let behind: f64 = corners.iter().map(off).sum();
        Some(if behind < 0.0 { angle } else { -angle })
    }

    /// Turns at the edges about both faces of an edge that go along it on the lines beside it [rad].
    fn beside(&self, face: usize, k: usize) -> impl Iterator<Item = Option<f64>> {
        let own = edge(&self.faces[face], k);
        let both = [Some(face), self.neighbours[face][k]].into_iter().flatten();
        let corners = |face: usize| {
            let corners = self.faces[face].cell.faces.len();
            self.faces[face].nodes[..corners].iter()
        };
        let near = both.clone().flat_map(corners).flat_map(|node| &self.around[node]);
        let edges = near
            .flat_map(|&(face, _)| (0..self.faces[face].cell.faces.len()).map(move |k| (face, k)));
        let (way, nodes) = (self.way(own), both.clone().flat_map(corners));
        let nodes: Vec<usize> = nodes.copied().collect();
        edges.filter_map(move |(face, k)| {
            let other = edge(&self.faces[face], k);
            let touches = other.iter().any(|node| own.contains(node));
            let is_next = other.iter().any(|node| nodes.contains(node));
            let along = dot(self.way(other), way).abs();
            (!touches && is_next && along > ALONG).then(|| self.turn(face, k))
        })
    }

    /// The direction between two nodes [1].
    fn way(&self, [a, b]: [usize; 2]) -> Vector {
        let way = sub((self.position)(b), (self.position)(a));
        way.map(|own| own / size(way))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::cell::{QUAD4, TRI3};

    /// Faces, four corners each or halves of them, over a line of the plane that goes on along z.
    fn swept(turns: &[f64], halved: bool) -> usize {
        let (mut way, mut line) = (0.0_f64, vec![[0.0, 0.0], [1.0, 0.0]]);
        for turn in turns {
            way -= turn.to_radians();
            let [x, y] = line[line.len() - 1];
            line.push([x + way.cos(), y + way.sin()]);
        }
        let rows = 3;
        let node = |k: usize, row: usize| rows * k + row;
        let mut faces = Vec::new();
        for (k, row) in (0..line.len() - 1).flat_map(|k| (0..rows - 1).map(move |row| (k, row))) {
            // the outside is above: x, then z downwards
            let own = [node(k, row + 1), node(k + 1, row + 1), node(k + 1, row), node(k, row)];
            if halved {
                for nodes in [[own[0], own[1], own[2]], [own[0], own[2], own[3]]] {
                    faces.push(MeshFace { cell: &TRI3, nodes: nodes.to_vec() });
                }
            } else {
                faces.push(MeshFace { cell: &QUAD4, nodes: own.to_vec() });
            }
        }
        let at = |n: usize| [line[n / rows][0], line[n / rows][1], 0.7 * (n % rows) as f64];
        Turning::new(&faces, at).edges(|turn, beside| is_lone(turn, beside)).len()
    }

    /// Requirement: edges of a chamfer are lone, of quadrilaterals and of triangles, those of a round, of a valley and sharp
    /// ones are not. Two rows of faces have each edge twice.
    #[test]
    fn chamfers_are_lone_and_rounds_are_not() {
        for halved in [false, true] {
            assert_eq!(swept(&[0.0, 30.0, 0.0], halved), 2);
            assert_eq!(swept(&[0.0, 30.0, 60.0, 0.0], halved), 2);
            assert_eq!(swept(&[0.0, 40.0, 0.0, 40.0, 0.0], halved), 4);
            assert_eq!(swept(&[30.0], halved), 0);
            for turn in [22.5, 30.0, 36.0] {
                assert_eq!(swept(&[turn; 5], halved), 0, "{turn}");
                assert_eq!(swept(&[turn / 2.0, turn, turn, turn / 2.0], halved), 0, "{turn}");
            }
            assert_eq!(swept(&[0.0, -30.0, 0.0], halved), 0);
            assert_eq!(swept(&[0.0, 60.0, 0.0], halved), 0);
            assert_eq!(swept(&[0.0, 18.0, 0.0], halved), 0);
        }
    }
}
