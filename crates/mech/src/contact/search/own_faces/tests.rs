use super::*;
use crate::contact::search::faces;
use crate::element::cell::QUAD4;
use crate::surface::mesh::MeshFace;
use crate::vector::add;
use std::collections::HashMap;

/// Cells along every edge of a box: enough for faces that are no neighbours of a node.
const CELLS: usize = 4;

/// The skin of a box between two corners, outward, CELLS by CELLS faces a side.
fn block([low, high]: [Vector; 2], faces: &mut Vec<MeshFace>, nodes: &mut Vec<Vector>) {
    let mut known: HashMap<[usize; 3], usize> = HashMap::new();
    let mut node = |place: [usize; 3]| {
        *known.entry(place).or_insert_with(|| {
            let at = |k: usize| low[k] + (high[k] - low[k]) * place[k] as f64 / CELLS as f64;
            nodes.push(std::array::from_fn(at));
            nodes.len() - 1
        })
    };
    for (axis, is_high) in (0..3).flat_map(|axis| [(axis, false), (axis, true)]) {
        for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (i, j))) {
            let mut round = [[0, 0], [1, 0], [1, 1], [0, 1]];
            if !is_high {
                round.reverse();
            }
            let corner = |[a, b]: [usize; 2]| {
                let mut place = [if is_high { CELLS } else { 0 }; 3];
                (place[(axis + 1) % 3], place[(axis + 2) % 3]) = (i + a, j + b);
                node(place)
            };
            faces.push(MeshFace { cell: &QUAD4, nodes: round.map(corner).to_vec() });
        }
    }
}

/// Faces of a box, and its nodes.
const FACES: usize = 6 * CELLS * CELLS;
const NODES: usize = (CELLS + 1).pow(3) - (CELLS - 1).pow(3);

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
    let mut standing = Standing::default();
    standing.take(mesh, nodes);
    let placed = PlacedOwn { mesh, positions: nodes, standing: &standing, tree: &tree };
    let mut room = PlacedFace::EMPTY;
    own.met(placed, (node, 0.1), &mut room)
}

/// Requirement: what is behind a face is as deep as its part is thick, whatever else is there.
#[test]
fn a_part_is_as_deep_as_it_is_thick() {
    let (mesh, nodes, own) = two(0.25);
    for face in 0..2 * FACES {
        let across = mesh.normal(face, &nodes)[2].abs() > 0.5;
        let depth = match (face < FACES, across) {
            (true, true) => 1.0,
            (true, false) => 4.0,
            (false, _) => 2.0,
        };
        assert!(
            (own.undeformed.thickness[face] - depth).abs() < 1e-12,
            "{face}: {}",
            own.undeformed.thickness[face]
        );
    }
}

/// Requirement: the lower corners of the upper box meet the top of the lower one, in front of it and
/// sunk in by less than half of it, not deeper; no node meets a face of its own box, however flat that
/// is pressed.
#[test]
fn a_node_meets_what_it_looks_at_in_front_of_it() {
    let (mesh, nodes, own) = two(0.25);
    let bottom: Vec<usize> = (NODES..2 * NODES).filter(|&node| nodes[node][2] == 1.25).collect();
    assert_eq!(bottom.len(), (CELLS + 1).pow(2));
    let is_own = |node: usize, place: FacePlace| (place.face < FACES) == (node < NODES);
    for lift in [0.0, -0.25, -0.5] {
        let shift = |(k, &at): (usize, &Vector)| match k < NODES {
            true => at,
            false => add(at, [0.0, 0.0, lift]),
        };
        let moved: Vec<Vector> = nodes.iter().enumerate().map(shift).collect();
        for &node in &bottom {
            let face = met(&mesh, &moved, &own, node).map(|place| place.face);
            let is_top = |face: usize| face < FACES && mesh.normal(face, &nodes)[2] > 0.5;
            assert!(face.is_some_and(is_top), "{lift} {node} {face:?}");
        }
        for node in 0..2 * NODES {
            let other = met(&mesh, &moved, &own, node);
            assert!(other.is_none_or(|place| !is_own(node, place)), "{node}");
        }
    }
    // too deep for what is still before the face
    let deep = |(k, &at): (usize, &Vector)| if k < NODES { at } else { add(at, [0.0, 0.0, -1.0]) };
    let sunk: Vec<Vector> = nodes.iter().enumerate().map(deep).collect();
    let top = |place: FacePlace| place.face < FACES && mesh.normal(place.face, &nodes)[2] > 0.5;
    assert!(bottom.iter().all(|&node| met(&mesh, &sunk, &own, node).is_none_or(|own| !top(own))));
    // the lower box pressed to a tenth of its thickness
    let press = |(k, &at): (usize, &Vector)| match k < NODES {
        true => [at[0], at[1], 0.1 * at[2]],
        false => at,
    };
    let flat: Vec<Vector> = nodes.iter().enumerate().map(press).collect();
    for node in 0..NODES {
        let found = met(&mesh, &flat, &own, node);
        assert!(found.is_none_or(|place| !is_own(node, place)), "{node}");
    }
}

/// Requirement: faces at a right angle look at no one, however the box is turned: to rounding it is.
#[test]
fn faces_at_a_right_angle_do_not_meet() {
    // so thin that the middle of it knows nothing of its sides
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    block([[0.0, 0.0, 0.0], [40.0, 40.0, 1.0]], &mut faces, &mut nodes);
    for turn in [0.0_f64, 0.3, 0.7, 1.1] {
        let (s, c) = turn.sin_cos();
        let turned = nodes.iter().map(|&[x, y, z]| {
            let [x, y] = [c * x - s * y, s * x + c * y];
            // as a deck with seven digits has it
            [x, c * y - s * z, s * y + c * z].map(|x| (x * 1e6).round() / 1e6)
        });
        let turned: Vec<Vector> = turned.collect();
        let mesh = FaceMesh::new(faces.clone(), &turned, false);
        let own = OwnFaces::new(&mesh, &turned);
        assert!((0..NODES).all(|node| met(&mesh, &turned, &own, node).is_none()), "{turn}");
    }
}

/// Requirement: nothing is met beyond the reach of a node.
#[test]
fn a_node_looks_no_farther_than_its_reach() {
    let (mesh, nodes, own) = two(200.0);
    assert!((0..2 * NODES).all(|node| met(&mesh, &nodes, &own, node).is_none()));
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
    let mut standing = Standing::default();
    standing.take(&mesh, &nodes);
    let placed = PlacedOwn { mesh: &mesh, positions: &nodes, standing: &standing, tree: &tree };
    let mut room = PlacedFace::EMPTY;
    let slaves: Vec<usize> = (0..2 * NODES)
        .filter(|&node| own.closest(placed, (node, 0.1, None), &mut room).is_some())
        .collect();
    assert!(!slaves.is_empty());
    let lower = slaves.iter().filter(|&&node| node < NODES).count();
    assert!(lower == 0 || lower == slaves.len(), "{slaves:?}");
}

/// Requirement: both sides of one wall do not meet, however flat it is pressed.
#[test]
fn the_sides_of_a_wall_do_not_meet() {
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

/// Requirement: in a notch of 60 degrees what shares an edge or a corner with the faces of a node is no
/// part that it meets, down to the bottom; farther up the flanks meet.
#[test]
fn neighbours_in_a_notch_do_not_meet() {
    let rows = 2 * CELLS;
    let node = |row: usize, i: usize| row * (CELLS + 1) + i;
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    for row in 0..=rows {
        let along = row as f64 - CELLS as f64;
        for i in 0..=CELLS {
            nodes.push([0.5 * along, i as f64, 0.75_f64.sqrt() * along.abs()]);
            if row < rows && i < CELLS {
                let round =
                    [node(row, i), node(row + 1, i), node(row + 1, i + 1), node(row, i + 1)];
                faces.push(MeshFace { cell: &QUAD4, nodes: round.to_vec() });
            }
        }
    }
    let mesh = FaceMesh::new(faces, &nodes, false);
    let own = OwnFaces::new(&mesh, &nodes);
    for i in 0..=CELLS {
        assert_eq!(met(&mesh, &nodes, &own, node(CELLS, i)), None, "bottom {i}");
        for (row, flank) in [(0, CELLS..rows), (rows, 0..CELLS)] {
            let place = met(&mesh, &nodes, &own, node(row, i));
            let other = |place: FacePlace| flank.contains(&(place.face / CELLS));
            assert!(place.is_some_and(other), "{row} {i} {place:?}");
        }
    }
}

/// Requirement: a node on the outside of a tube sees nothing through the wall, though faces of the hollow
/// look at it from the other side; the rims of the tube, which stand at right angles, change nothing.
#[test]
fn nothing_is_met_through_a_wall() {
    const AROUND: usize = 80;
    let node = |column: usize, side: usize| 4 * (column % AROUND) + side;
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    for column in 0..AROUND {
        let (s, c) = (std::f64::consts::TAU * column as f64 / AROUND as f64).sin_cos();
        let places = [(8.5, 0.0), (10.0, 0.0), (10.0, 0.7), (8.5, 0.7)];
        nodes.extend(places.map(|(radius, z)| [radius * c, radius * s, z]));
        // rim below, outside, rim above, hollow
        for side in 0..4 {
            let next = (side + 1) % 4;
            let round = [node(column, side), node(column + 1, side), node(column + 1, next)];
            let nodes = round.into_iter().chain([node(column, next)]).collect();
            faces.push(MeshFace { cell: &QUAD4, nodes });
        }
    }
    let mesh = FaceMesh::new(faces, &nodes, false);
    assert!(mesh.normal(1, &nodes)[0] > 0.9, "the outside looks outward");
    let own = OwnFaces::new(&mesh, &nodes);
    let tree = faces::tree(&mesh, &nodes);
    let mut standing = Standing::default();
    standing.take(&mesh, &nodes);
    let placed = PlacedOwn { mesh: &mesh, positions: &nodes, standing: &standing, tree: &tree };
    for (number, at) in nodes.iter().enumerate().filter(|(_, at)| at[0].hypot(at[1]) > 9.0) {
        assert!(own.nearest(placed, &own.looking(placed, number)).is_none(), "{at:?}");
        assert_eq!(met(&mesh, &nodes, &own, number), None, "{at:?}");
    }
}

/// The skin of a plate of one layer of cells with a square hole in the middle: 10 wide, 1 thick, the hole 2.4.
fn plate_with_a_hole() -> (FaceMesh, Vec<Vector>) {
    const LINES: [f64; 6] = [-5.0, -2.5, -1.2, 1.2, 2.5, 5.0];
    let is_solid = |i: usize, j: usize| i < 5 && j < 5 && (i, j) != (2, 2);
    let (mut known, mut nodes, mut faces) = (HashMap::new(), Vec::new(), Vec::new());
    let mut node = |place: [usize; 3]| {
        *known.entry(place).or_insert_with(|| {
            nodes.push([LINES[place[0]], LINES[place[1]], place[2] as f64]);
            nodes.len() - 1
        })
    };
    let mut push = |corners: [[usize; 3]; 4]| {
        faces.push(MeshFace { cell: &QUAD4, nodes: corners.map(&mut node).to_vec() });
    };
    for (i, j) in (0..5).flat_map(|i| (0..5).map(move |j| (i, j))).filter(|&(i, j)| is_solid(i, j))
    {
        let round = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        push(round.map(|[a, b]| [a, b, 1]));
        push([3, 2, 1, 0].map(|k: usize| [round[k][0], round[k][1], 0]));
        let beside = [(i, j.wrapping_sub(1)), (i + 1, j), (i, j + 1), (i.wrapping_sub(1), j)];
        for (side, _) in beside.into_iter().enumerate().filter(|(_, (a, b))| !is_solid(*a, *b)) {
            let [from, to] = [round[side], round[(side + 1) % 4]];
            push([
                [from[0], from[1], 0],
                [to[0], to[1], 0],
                [to[0], to[1], 1],
                [from[0], from[1], 1],
            ]);
        }
    }
    let mesh = FaceMesh::new(faces, &nodes, false);
    (mesh, nodes)
}

/// Requirement: between the hole of a plate and its rim is material, however thin the plate is: no node
/// meets anything, as it stands and drawn or pressed a little.
#[test]
fn a_plate_does_not_meet_itself_through_its_rim() {
    let (mesh, nodes) = plate_with_a_hole();
    let own = OwnFaces::new(&mesh, &nodes);
    for stretch in [1.0, 0.98, 1.02] {
        let moved: Vec<Vector> = nodes.iter().map(|&[x, y, z]| [stretch * x, y, z]).collect();
        for (node, at) in nodes.iter().enumerate() {
            let face = met(&mesh, &moved, &own, node).map(|place| place.face);
            assert_eq!(face, None, "node {node} at {at:?}, {stretch}");
        }
    }
}

/// Requirement: a part that is cut through, as a bolt that is drawn together, has two nodes in every
/// place of the cut. Its sides go on beyond it, and what goes on does not stop a node.
#[test]
fn a_cut_part_goes_on() {
    let (mut faces, mut nodes) = (Vec::new(), Vec::new());
    block([[0.0, 0.0, 0.0], [1.0, 1.0, 2.0]], &mut faces, &mut nodes);
    block([[0.0, 0.0, 2.0], [1.0, 1.0, 4.0]], &mut faces, &mut nodes);
    faces.retain(|face| face.nodes.iter().any(|&node| nodes[node][2] != 2.0));
    let mesh = FaceMesh::new(faces, &nodes, false);
    let own = OwnFaces::new(&mesh, &nodes);
    let cut = |node: &usize| nodes[*node][2] == 2.0 && !own.undeformed.at[*node].is_empty();
    let mut checked = 0;
    for node in (0..nodes.len()).filter(cut) {
        for (face, other) in mesh.faces().iter().enumerate() {
            if other.nodes.iter().any(|&other| nodes[other] == nodes[node]) {
                assert!(!own.stops(node, face), "{node} {face}");
                checked += 1;
            }
        }
    }
    // 16 places about the square, two nodes each, two faces of each half
    assert_eq!(checked, 16 * 2 * 4);
}
