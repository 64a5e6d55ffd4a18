//! Finds the lines of sharp edges of both sides of a pair that may cross in space.
//!
//! docs/theory.md section 5.18

use crate::contact::{ContactPair, Formulation, Offset};
use crate::crossing_edges::{CrossingEdges, EdgeLine, SharpEdge};
use crate::friction::Friction;
use crate::model::Model;
use crate::node::NodeIndex;
use crate::surface::{ContactFace, Master, MasterFaces};
use slideline_mech::surface::mesh::{FaceMesh, SHARP};
use slideline_mech::vector::{dot, size, sub};
use std::collections::{HashMap, HashSet};

/// The lines of edges of a pair that may cross; `None` where one side has none, or contact is of another kind.
pub(crate) fn crossing_edges(
    model: &Model,
    (of, pair): (usize, &ContactPair),
) -> Option<CrossingEdges> {
    let is_spread = pair.formulation == Formulation::Mortar && !pair.faces.is_empty();
    let is_plain = pair.offset == Offset::NONE && pair.left_out.is_empty();
    let Master::Faces(MasterFaces { faces, swept: None, meets_itself: false, .. }) = &pair.master
    else {
        return None;
    };
    if !is_spread || !is_plain || is_directed(model, (of, pair)) {
        return None;
    }
    let nodes_of = |faces: &[ContactFace]| -> HashSet<NodeIndex> {
        faces.iter().flat_map(|face| face.nodes.iter().copied()).collect()
    };
    let (of_slave, of_master) = (nodes_of(&pair.faces), nodes_of(faces));
    let positions: Vec<_> = (0..model.nodes.len()).map(|n| model.nodes.position(n)).collect();
    let slave = lines(edges(&pair.faces, &positions, &of_master), &positions);
    let master = lines(edges(faces, &positions, &of_slave), &positions);
    (!slave.is_empty() && !master.is_empty()).then_some(CrossingEdges { of, slave, master })
}

/// Whether friction of a pair has coefficients of its own along axes of its surface, in some step.
fn is_directed(model: &Model, (of, pair): (usize, &ContactPair)) -> bool {
    let changed = model.steps.iter().flat_map(|step| &step.frictions);
    let laws = changed.filter(|own| own.pair == of).flat_map(|own| [&own.from, &own.to]);
    laws.chain([&pair.interaction.friction]).any(Friction::is_directed)
}

/// Edges at which neighbouring faces turn away sharply, without those that have a node of the other side.
fn edges(
    faces: &[ContactFace],
    positions: &[[f64; 3]],
    other: &HashSet<NodeIndex>,
) -> Vec<SharpEdge> {
    let faces = faces.iter().filter_map(ContactFace::of_mesh).collect();
    let mesh = FaceMesh::new(faces, positions, false);
    let corners = |face: usize| {
        let own = &mesh.faces()[face];
        own.nodes[..own.cell.faces.len()].to_vec()
    };
    let mut found = Vec::new();
    for (own, face) in mesh.faces().iter().enumerate() {
        for (edge, places) in face.cell.faces.iter().enumerate() {
            let behind = mesh.neighbour(own, edge).filter(|behind| own < *behind);
            let Some(behind) = behind.filter(|&other| mesh.stands_out(own, other, positions))
            else {
                continue;
            };
            let nodes: Vec<NodeIndex> = places.iter().map(|&place| face.nodes[place]).collect();
            let (Some(&first), Some(&last)) = (nodes.first(), nodes.last()) else { continue };
            if nodes.iter().any(|node| other.contains(node)) {
                continue;
            }
            let count = nodes.len() - 1;
            let part = |k: usize| k as f64 / count as f64..(k + 1) as f64 / count as f64;
            found.extend(nodes.windows(2).enumerate().map(|(k, ends)| SharpEdge {
                nodes: [ends[0], ends[1]],
                corners: [first, last],
                part: part(k),
                faces: [corners(own), corners(behind)],
            }));
        }
    }
    found
}

/// Edges joined to lines.
fn lines(edges: Vec<SharpEdge>, positions: &[[f64; 3]]) -> Vec<EdgeLine> {
    let mut at_node: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
    for (number, edge) in edges.iter().enumerate() {
        edge.nodes.iter().for_each(|&node| at_node.entry(node).or_default().push(number));
    }
    let next = |number: usize, edge: &SharpEdge| {
        let [a, b] = edge.nodes;
        let &[first, second] = &at_node[&b][..] else { return None };
        let number = if first == number { second } else { first };
        let other = edges[number].clone();
        let other = if other.nodes[0] == b { other } else { other.reversed() };
        let [way, on] = [[a, b], other.nodes].map(|[a, b]| sub(positions[b], positions[a]));
        (dot(way, on) > SHARP * size(way) * size(on)).then_some((number, other))
    };
    let (mut seen, mut found) = (vec![false; edges.len()], Vec::new());
    for number in 0..edges.len() {
        if seen[number] {
            continue;
        }
        // back to where the line begins, or once round
        let mut start = (number, edges[number].clone().reversed());
        let mut is_closed = false;
        while let Some(before) = next(start.0, &start.1) {
            if before.0 == number {
                is_closed = true;
                break;
            }
            start = before;
        }
        let mut here = (start.0, start.1.reversed());
        let mut line = EdgeLine { edges: Vec::new(), is_closed };
        while !std::mem::replace(&mut seen[here.0], true) {
            line.edges.push(here.1.clone());
            let Some(on) = next(here.0, &here.1) else { break };
            here = on;
        }
        found.push(line);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge([a, b]: [usize; 2]) -> SharpEdge {
        let faces = [vec![a, b, 10], vec![b, a, 11]];
        SharpEdge { nodes: [a, b], corners: [a, b], part: 0.0..1.0, faces }
    }

    /// Requirement: edges in any order and sense make lines that end at corners, or go round; a reversed edge has its
    /// faces exchanged.
    #[test]
    fn edges_make_lines() {
        let straight = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.1, 0.0], [2.1, 1.0, 0.0]];
        let own = lines(vec![edge([2, 1]), edge([0, 1]), edge([3, 2])], &straight);
        let nodes: Vec<Vec<_>> =
            own.iter().map(|line| line.edges.iter().map(|edge| edge.nodes).collect()).collect();
        assert_eq!(nodes, [vec![[2, 1], [1, 0]], vec![[3, 2]]]);
        assert_eq!(own[0].edges[1].faces, [vec![1, 0, 11], vec![0, 1, 10]]);
        let ring: Vec<[f64; 3]> = (0..12)
            .map(|k| (k as f64 * std::f64::consts::TAU / 12.0).sin_cos())
            .map(|(s, c)| [c, s, 0.0])
            .collect();
        let round = lines((0..12).map(|k| edge([k, (k + 1) % 12])).collect(), &ring);
        assert!(round.len() == 1 && round[0].is_closed && round[0].edges.len() == 12);
        assert_eq!(round[0].most_crossings(1), 2);
    }
}
