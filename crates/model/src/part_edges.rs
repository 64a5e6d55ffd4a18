//! Edges of a solid part at which a surface of it ends.
//!
//! ```text
//!       o--------------o
//!      /  surface     /|     the surface is the top alone, and ends where the part turns away: an edge of the
//!     o--------------o |     part, whether its side is named or not
//!     |     side     | o
//!     o--------------o/
//! ```
//!
//! docs/theory.md section 5.17

use crate::model::Model;
use crate::node::NodeIndex;
use crate::surface::ContactFace;
use crate::symmetry::{SymmetryPlane, corners_of, parts};
use slideline_mech::surface::mesh::{area_between, is_crease};
use slideline_mech::vector::{Vector, dot, scale, size, sub};
use std::collections::{BTreeMap, HashMap, HashSet};

/// An edge by its nodes, the lower one first.
type Edge = [NodeIndex; 2];

/// Part of an edge within which a node of the slave stands upon a node of it [1]. (choice)
const UPON: f64 = 0.01;

/// Nodes of the edges of a part in space at which its surface of these faces ends, and the part turns away sharply; none
/// that lie in one of the planes, or that nodes of the slave stand upon.
pub(crate) fn nodes_at_part_edges(
    model: &Model,
    (faces, slave): (&[ContactFace], &[NodeIndex]),
    planes: &[SymmetryPlane],
) -> Vec<NodeIndex> {
    let mut ends = ends_of_surface(faces);
    ends.retain(|edge, _| {
        !planes.iter().any(|plane| edge.iter().all(|&node| plane.holds(model.nodes.position(node))))
    });
    let sides = sides_at(model, &ends);
    let mut nodes: Vec<NodeIndex> = ends
        .iter()
        .filter(|(edge, face)| {
            let own = &faces[**face];
            let others = sides.get(*edge).into_iter().flatten();
            let mut others =
                others.filter(|side| !side.iter().all(|node| own.nodes.contains(node)));
            others.next().is_some_and(|side| turns_away(model, own, side))
        })
        .flat_map(|(edge, _)| *edge)
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    leave_met(model, &ends, slave, &mut nodes);
    nodes
}

/// Leaves out nodes that a node of the slave stands upon before any displacement, as where meshes match: that one is held.
fn leave_met(
    model: &Model,
    ends: &HashMap<Edge, usize>,
    slave: &[NodeIndex],
    nodes: &mut Vec<NodeIndex>,
) {
    let at = |node: NodeIndex| model.nodes.position(node);
    let mut of_slave: Vec<Vector> = slave.iter().map(|&node| at(node)).collect();
    of_slave.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut shortest: HashMap<NodeIndex, f64> = HashMap::new();
    for &[a, b] in ends.keys() {
        let length = size(sub(at(a), at(b)));
        for node in [a, b] {
            shortest.entry(node).and_modify(|own| *own = own.min(length)).or_insert(length);
        }
    }
    nodes.retain(|&node| {
        let (place, room) = (at(node), UPON * shortest.get(&node).copied().unwrap_or_default());
        let first = of_slave.partition_point(|other| other[0] < place[0] - room);
        let near = of_slave[first..].iter().take_while(|other| other[0] <= place[0] + room);
        !near.into_iter().any(|&other| size(sub(other, place)) <= room)
    });
}

/// The edges of faces that no other of them shares, with their face.
fn ends_of_surface(faces: &[ContactFace]) -> HashMap<Edge, usize> {
    let (mut once, mut shared) = (HashMap::new(), HashSet::new());
    for (place, face) in faces.iter().enumerate() {
        let corners = face.cell().map_or(0, |cell| cell.faces.len());
        for k in 0..corners {
            let edge = ordered([face.nodes[k], face.nodes[(k + 1) % corners]]);
            if once.insert(edge, place).is_some() {
                shared.insert(edge);
            }
        }
    }
    once.retain(|edge, _| !shared.contains(edge));
    once
}

fn ordered([a, b]: [NodeIndex; 2]) -> Edge {
    [a.min(b), a.max(b)]
}

/// Corners of a face of a solid, counter-clockwise as seen from outside.
type Side = Vec<NodeIndex>;

/// The free faces of solids at these edges.
fn sides_at(model: &Model, ends: &HashMap<Edge, usize>) -> HashMap<Edge, Vec<Side>> {
    let at_ends: HashSet<NodeIndex> = ends.keys().flatten().copied().collect();
    let mut free: BTreeMap<Side, (Side, usize)> = BTreeMap::new();
    for (block, element) in parts(model) {
        let is_solid = block.kind.cell.dimension == 3;
        if !is_solid || element.nodes.iter().filter(|node| at_ends.contains(node)).count() < 2 {
            continue;
        }
        for face in block.kind.cell.faces {
            let corners: Side = corners_of(3, face).map(|&k| element.nodes[k]).collect();
            let mut key = corners.clone();
            key.sort_unstable();
            free.entry(key).or_insert((corners, 0)).1 += 1;
        }
    }
    let mut sides: HashMap<Edge, Vec<Side>> = HashMap::new();
    for (corners, _) in free.into_values().filter(|(_, count)| *count == 1) {
        for k in 0..corners.len() {
            let edge = ordered([corners[k], corners[(k + 1) % corners.len()]]);
            if ends.contains_key(&edge) {
                sides.entry(edge).or_default().push(corners.clone());
            }
        }
    }
    sides
}

/// Whether a side of the part lies behind a face at an edge of both, and turns away sharply.
fn turns_away(model: &Model, face: &ContactFace, side: &[NodeIndex]) -> bool {
    let at = |node: NodeIndex| model.nodes.position(node);
    let corners = face.cell().map_or(0, |cell| cell.faces.len());
    let unit = |area: Vector| scale(area, 1.0 / size(area));
    let own = unit(area_between(corners, |k| at(face.nodes[k])));
    let other = unit(area_between(side.len(), |k| at(side[k])));
    let behind: f64 = side.iter().map(|&node| dot(sub(at(node), at(face.nodes[0])), own)).sum();
    is_crease(own, other) && behind < 0.0
}
