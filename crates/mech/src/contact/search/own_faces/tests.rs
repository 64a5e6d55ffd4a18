use super::*;
use crate::element::cell::QUAD4;
use crate::surface::mesh::MeshFace;

/// The six faces of a box between two corners, outward, over nodes from `first`.
fn block([low, high]: [Vector; 2], faces: &mut Vec<MeshFace>, nodes: &mut Vec<Vector>) {
    let first = nodes.len();
    let pick = |k: usize, axis: usize| if k >> axis & 1 == 0 { low[axis] } else { high[axis] };
    nodes.extend((0..8).map(|k| [pick(k, 0), pick(k, 1), pick(k, 2)]));
    let outward =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    faces.extend(
        outward
            .map(|own| MeshFace { cell: &QUAD4, nodes: own.iter().map(|k| first + k).collect() }),
    );
}

/// Two boxes, one above the other: the lower one 1 thick, the upper one 2, with a gap.
fn two(gap: f64) -> (FaceMesh, Vec<Vector>, OwnFaces) {
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    block([[0.0, 0.0, 0.0], [4.0, 4.0, 1.0]], &mut faces, &mut nodes);
    block([[1.0, 1.0, 1.0 + gap], [3.0, 3.0, 3.0 + gap]], &mut faces, &mut nodes);
    let mesh = FaceMesh::new(faces, &nodes, false);
    let own = OwnFaces::new(&mesh, &nodes);
    (mesh, nodes, own)
}

fn met(mesh: &FaceMesh, nodes: &[Vector], own: &OwnFaces, node: usize) -> Option<FacePlace> {
    let tree = faces::tree(mesh, nodes);
    let placed = PlacedOwn { mesh, positions: nodes, tree: &tree };
    let mut room = PlacedFace::EMPTY;
    own.met(placed, (node, 0.1), &mut room)
}

/// Requirement: what is behind a face is as deep as its part is thick, whatever else is there.
#[test]
fn a_part_is_as_deep_as_it_is_thick() {
    let (.., own) = two(0.25);
    for (face, depth) in [(0, 1.0), (1, 1.0), (2, 4.0), (5, 4.0), (6, 2.0), (7, 2.0), (10, 2.0)] {
        assert!((own.thickness[face] - depth).abs() < 1e-12, "{face}: {}", own.thickness[face]);
    }
}

/// Requirement: the lower corners of the upper box meet the top of the lower one, in front of it and
/// sunk in by less than half of it; no node meets a face of its own box, however flat that is pressed.
#[test]
fn a_node_meets_what_it_looks_at_in_front_of_it() {
    let (mesh, mut nodes, own) = two(0.25);
    for lift in [0.0, -0.25, -0.5] {
        let moved: Vec<Vector> = nodes
            .iter()
            .enumerate()
            .map(|(k, &at)| if k < 8 { at } else { add(at, [0.0, 0.0, lift]) })
            .collect();
        for node in 8..12 {
            let place = met(&mesh, &moved, &own, node).unwrap();
            assert_eq!(place.face, 1, "{lift}");
        }
        for node in (0..8).chain(12..16) {
            let other = met(&mesh, &moved, &own, node);
            assert!(other.is_none_or(|place| (place.face < 6) != (node < 8)), "{node}");
        }
    }
    // too deep for what is still before the face
    let sunk: Vec<Vector> =
        nodes.iter().map(|&at| if at[2] > 1.1 { add(at, [0.0, 0.0, -1.0]) } else { at }).collect();
    assert!((8..12).all(|node| met(&mesh, &sunk, &own, node).is_none_or(|place| place.face != 1)));
    // the lower box pressed to a tenth of its thickness
    for at in &mut nodes[..8] {
        at[2] *= 0.1;
    }
    for node in 0..8 {
        assert!(met(&mesh, &nodes, &own, node).is_none_or(|place| place.face >= 6), "{node}");
    }
}

/// Requirement: nothing is met beyond the reach of a node.
#[test]
fn a_node_looks_no_farther_than_its_reach() {
    let (mesh, nodes, own) = two(200.0);
    assert!((0..16).all(|node| met(&mesh, &nodes, &own, node).is_none()));
}

/// Requirement: of two boxes whose corners meet each other's faces one alone carries the points.
#[test]
fn one_of_two_that_meet_is_the_slave() {
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    block([[0.0, 0.0, 0.0], [2.0, 2.0, 1.0]], &mut faces, &mut nodes);
    block([[0.1, 0.1, 1.1], [2.1, 2.1, 2.1]], &mut faces, &mut nodes);
    let mesh = FaceMesh::new(faces, &nodes, false);
    let own = OwnFaces::new(&mesh, &nodes);
    let tree = faces::tree(&mesh, &nodes);
    let placed = PlacedOwn { mesh: &mesh, positions: &nodes, tree: &tree };
    let mut room = PlacedFace::EMPTY;
    let slaves: Vec<usize> = (0..16)
        .filter(|&node| own.closest(placed, (node, 0.1, None), &mut room).is_some())
        .collect();
    assert!(!slaves.is_empty());
    assert!(slaves.iter().all(|&n| n < 8) || slaves.iter().all(|&n| n >= 8), "{slaves:?}");
}

/// Requirement: both sides of one wall do not meet, however flat it is pressed.
#[test]
fn the_sides_of_a_wall_do_not_meet() {
    const CELLS: usize = 4;
    let node = |side: usize, i: usize, j: usize| side * (CELLS + 1).pow(2) + j * (CELLS + 1) + i;
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    for side in 0..2 {
        for (j, i) in (0..=CELLS).flat_map(|j| (0..=CELLS).map(move |i| (j, i))) {
            nodes.push([i as f64, j as f64, side as f64]);
            if i < CELLS && j < CELLS {
                let round = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| node(side, i + a, j + b));
                let [a, b, c, d] = round;
                let round = if side == 1 { [a, b, c, d] } else { [a, d, c, b] };
                faces.push(MeshFace { cell: &QUAD4, nodes: round.to_vec() });
            }
        }
    }
    let mesh = FaceMesh::new(faces, &nodes, false);
    let own = OwnFaces::new(&mesh, &nodes);
    for flat in [1.0, 0.45, 0.1] {
        let pressed: Vec<Vector> = nodes.iter().map(|&[x, y, z]| [x, y, flat * z]).collect();
        assert!((0..nodes.len()).all(|node| met(&mesh, &pressed, &own, node).is_none()), "{flat}");
    }
}
