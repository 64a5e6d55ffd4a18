//! Halves of surfaces against the whole, and derivatives of normals in planes of symmetry.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use super::super::mesh::{FaceMesh, PlacedFace};
use super::super::star::Star;
use super::*;
use crate::element::cell::QUAD4;

/// A round strip of faces along x from some column on, and its nodes.
fn strip(from: i32) -> (Vec<MeshFace>, Vec<Vector>) {
    let columns: Vec<i32> = (from..=3).collect();
    let place = |&i: &i32, y: f64| [f64::from(i), y, -0.1 * f64::from(i * i)];
    let nodes = columns.iter().flat_map(|i| [place(i, 0.0), place(i, 1.0)]).collect();
    let face =
        |k: usize| MeshFace { cell: &QUAD4, nodes: vec![2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1] };
    ((0..columns.len() - 1).map(face).collect(), nodes)
}

/// Requirement: the normals of half of a surface are those of the whole, in the plane of symmetry too.
#[test]
fn halves_have_the_normals_of_the_whole() {
    let ((faces, nodes), (all, places)) = (strip(0), strip(-3));
    let inside = nodes.iter().map(|at| at[0] == 0.0).collect();
    let mirror = Mirror { normal: [-1.0, 0.0, 0.0], inside };
    let half = FaceMesh::mirrored(faces, &nodes, (true, &[mirror]));
    let whole = FaceMesh::new(all, &places, true);
    let (mut own, mut expected) = (PlacedFace::EMPTY, PlacedFace::EMPTY);
    for face in 0..3 {
        half.place(face, &nodes, &mut own).unwrap();
        whole.place(face + 3, &places, &mut expected).unwrap();
        for (a, b) in own.normals.iter().zip(&expected.normals) {
            assert!(size(sub(a.normal, b.normal)) < 1e-14, "{face}: {a:?} {b:?}");
        }
    }
    assert!(half.is_mirrored(0, 3) && !half.is_mirrored(0, 1));
}

/// Requirement: first and second derivatives of a normal in a plane are those of differences.
#[test]
fn derivatives_of_a_normal_in_a_plane() {
    let across = [[0.8, 0.0, 0.6]];
    let star = Star { node: 0, corners: &[[1, 2], [2, 3]], across: &across };
    let at = [[0.1, 0.2, 0.0], [1.0, 0.1, 0.3], [0.2, 1.1, -0.2], [-0.9, 0.3, 0.4]];
    let y = [0.3, -0.7, 0.5];
    let pull = |at: &[Vector]| {
        let mut by = [[0.0; 3]; 4];
        let own = star.normal(at).unwrap();
        star.pull(at, (&own, y), |node, value| by[node] = crate::vector::add(by[node], value));
        by
    };
    let mut second = [[0.0; 12]; 12];
    star.pull_twice(&at, (&star.normal(&at).unwrap(), y), |i, j, block| {
        for (a, b) in (0..3).flat_map(|a| (0..3).map(move |b| (a, b))) {
            second[3 * i + a][3 * j + b] += block[a][b];
        }
    });
    let step = 1e-5;
    for (node, axis) in (0..4).flat_map(|node| (0..3).map(move |axis| (node, axis))) {
        let moved = |by: f64| {
            let mut moved = at;
            moved[node][axis] += by;
            moved
        };
        let ends = [moved(step), moved(-step)];
        let [plus, minus] = ends.each_ref().map(|at| dot(y, star.normal(at).unwrap().normal));
        let first = (plus - minus) / (2.0 * step);
        assert!((first - pull(&at)[node][axis]).abs() < 1e-9, "{node} {axis}");
        let [plus, minus] = ends.each_ref().map(|at| pull(at));
        for (row, own) in second.iter().enumerate() {
            let expected = (plus[row / 3][row % 3] - minus[row / 3][row % 3]) / (2.0 * step);
            assert!((expected - own[3 * node + axis]).abs() < 1e-8, "{row} {node} {axis}");
        }
    }
}
