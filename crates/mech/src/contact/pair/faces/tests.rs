use super::super::super::search::faces::{closest, tree};
use super::*;
use crate::element::cell::{QUAD4, TRI3};
use crate::surface::mesh::MeshFace;
use crate::vector::{add, scale, size};

/// A bent sheet of 3 x 3 cells, of quadrilaterals or of triangles.
fn sheet(triangles: bool) -> (FaceMesh, Vec<Vector>) {
    let mut positions = Vec::new();
    for j in 0..4 {
        for i in 0..4 {
            let (x, y) = (f64::from(i), f64::from(j) * 0.9);
            let wave = 0.06 * (1.7 * x + 2.3 * y).sin();
            positions.push([x + wave, y - wave, 0.15 * x * x - 0.1 * x * y + 0.02 * wave]);
        }
    }
    let mut faces = Vec::new();
    for j in 0..3 {
        for i in 0..3 {
            let a = 4 * j + i;
            let quad = vec![a, a + 1, a + 5, a + 4];
            match triangles {
                false => faces.push(MeshFace { cell: &QUAD4, nodes: quad }),
                true => {
                    faces.push(MeshFace { cell: &TRI3, nodes: vec![a, a + 1, a + 5] });
                    faces.push(MeshFace { cell: &TRI3, nodes: vec![a, a + 5, a + 4] });
                }
            }
        }
    }
    (FaceMesh::new(faces, &positions, true), positions)
}

fn point_at(
    mesh: &FaceMesh,
    positions: &[Vector],
    point: Vector,
    before: Option<&Footing>,
    room: &mut FaceRoom,
) -> FacePoint {
    let own = tree(mesh, positions);
    let place = closest(mesh, positions, &own, (point, 0.1, None), room.face()).unwrap();
    FacePoint::new(mesh, positions, (place, point), before, room).unwrap()
}

/// Rows over the slave and all nodes of the mesh.
fn all_rows(mesh: &FaceMesh, own: &FacePoint, room: &FaceRoom, count: usize) -> Vec<Vec<f64>> {
    let mut rows = vec![vec![0.0; 3 * (1 + count)]; 5];
    own.rows(mesh, room, |row, side, node, value| {
        let place = match side {
            0 => 0,
            1 => 1 + mesh.stencil(own.place().face)[node],
            _ => 1 + mesh.stencil(own.other_face().unwrap())[node],
        };
        add_at(&mut rows[row], place, value);
    });
    rows
}

const STEP: f64 = 1e-6;

/// Requirement: rows of overclosure and slip, and the tangent of the geometry, are those of
/// differences by the slave and every node, on the face where the point stood and on another one.
#[test]
fn rows_and_tangent_are_those_of_differences() {
    for triangles in [false, true] {
        for from in [[1.3, 1.2, 0.4], [0.4, 1.1, 0.3]] {
            let (mesh, positions) = sheet(triangles);
            let mut room = FaceRoom::default();
            let before = point_at(&mesh, &positions, from, None, &mut room).footing();
            let mut all = vec![[1.5, 1.3, 0.45]];
            let bent = |&p: &Vector| add(p, [0.03 * p[1], -0.02 * p[0], 0.05 * p[1]]);
            all.extend(positions.iter().map(bent));
            let at = |all: &[Vector], room: &mut FaceRoom| {
                point_at(&mesh, &all[1..], all[0], Some(&before), room)
            };
            let own = at(&all, &mut room);
            let count = positions.len();
            assert_eq!(own.other_face().is_some(), from[0] < 1.0, "the case is meant to differ");
            let rows = all_rows(&mesh, &own, &room, count);
            let forces = (1.1, Tangential([0.7, -0.4]));
            let mut tangent = Vec::new();
            own.derivative(&mesh, forces, &mut room, &mut tangent);
            let stencil = mesh.stencil(own.place().face);
            let wide = 3 * (1 + stencil.len());
            let local = |k: usize| match k / 3 {
                0 => Some(k),
                node => stencil.iter().position(|&s| s + 1 == node).map(|p| 3 * (p + 1) + k % 3),
            };
            for k in 0..3 * all.len() {
                let side = |step: f64| {
                    let mut moved = all.clone();
                    moved[k / 3][k % 3] += step;
                    let mut room = FaceRoom::default();
                    let own = at(&moved, &mut room);
                    let rows = all_rows(&mesh, &own, &room, count);
                    let force: Vec<f64> = (0..3 * all.len())
                        .map(|i| {
                            forces.0 * rows[0][i]
                                + forces.1[0] * rows[3][i]
                                + forces.1[1] * rows[4][i]
                        })
                        .collect();
                    (-own.gap().gap, own.slip, force)
                };
                let (plus, minus) = (side(STEP), side(-STEP));
                let difference = |a: f64, b: f64| (a - b) / (2.0 * STEP);
                assert!((difference(plus.0, minus.0) - rows[0][k]).abs() < 1e-8);
                for direction in 0..2 {
                    let slip = difference(plus.1[direction], minus.1[direction]);
                    assert!((slip - rows[1 + direction][k]).abs() < 1e-8, "{k} {direction}");
                }
                for i in 0..3 * all.len() {
                    let by = difference(plus.2[i], minus.2[i]);
                    let own = match (local(i), local(k)) {
                        (Some(i), Some(k)) => tangent[i * wide + k],
                        _ => 0.0,
                    };
                    assert!((by - own).abs() < 3e-7, "{triangles} {i} {k}: {own} {by}");
                }
            }
        }
    }
}

/// Requirement: a rigid motion of point and surface changes neither gap nor slip, and directions
/// turn with it, also about the normal.
#[test]
fn rigid_motions_slip_nothing() {
    let (mesh, positions) = sheet(false);
    let mut room = FaceRoom::default();
    let point = [1.4, 1.3, 0.3];
    let first = point_at(&mesh, &positions, point, None, &mut room);
    let n = first.gap().normal;
    let angle = 0.7_f64;
    // about the normal through the origin (Rodrigues)
    let turn = |x: Vector| {
        let along = scale(n, dot(n, x));
        let across = sub(x, along);
        let turned = add(scale(across, angle.cos()), scale(cross(n, x), angle.sin()));
        add(add(along, turned), [0.3, -0.2, 0.1])
    };
    let moved: Vec<_> = positions.iter().map(|&p| turn(p)).collect();
    let footing = first.footing();
    let second = point_at(&mesh, &moved, turn(point), Some(&footing), &mut room);
    assert!((first.gap().gap - second.gap().gap).abs() < 1e-13);
    let way = first.gap().gap;
    assert!(second.slip.size() < 1e-13 * way.abs().max(1.0), "{:?}", second.slip);
    let expected = sub(turn(add(point, footing.direction)), turn(point));
    assert!(size(sub(second.footing().direction, expected)) < 1e-12);
}

/// Requirement: forces and moments on slave and nodes balance, normals of neighbours included.
#[test]
fn forces_and_moments_of_all_nodes_balance() {
    let (mesh, positions) = sheet(true);
    let mut room = FaceRoom::default();
    let mut all = vec![[1.4, 1.3, 0.5]];
    all.extend(&positions);
    let own = point_at(&mesh, &positions, all[0], None, &mut room);
    for row in [0, 3, 4] {
        let force = &all_rows(&mesh, &own, &room, positions.len())[row];
        let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
        for (at, f) in all.iter().zip(force.chunks_exact(3)) {
            let f = [f[0], f[1], f[2]];
            sum = add(sum, f);
            moment = add(moment, cross(*at, f));
        }
        assert!(size(sum) < 1e-13 && size(moment) < 1e-13, "{sum:?} {moment:?}");
    }
}
