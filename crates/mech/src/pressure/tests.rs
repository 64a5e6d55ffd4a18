//! Forces of pressures and tractions against their sums, their derivatives and closed forms.

use super::*;

fn face(dimension: usize, nodes: usize) -> (Face, Vec<[f64; 3]>) {
    let face = Face::of(dimension, nodes, 0.7).unwrap_or(Face::Area(&TRI3, &TRI_3));
    let bent = |k: usize, [a, b, _]: [f64; 3]| {
        let bump = 0.1 * (1.3 * k as f64).sin();
        match dimension {
            2 => [a + bump, 0.4 * a * a - bump, 0.0],
            _ => [a + bump, b - 0.3 * bump, 0.2 * a * b + bump],
        }
    };
    let x = match face {
        Face::Edge { nodes: 2, .. } | Face::Ring { nodes: 2 } => {
            vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
        }
        Face::Edge { .. } | Face::Ring { .. } => {
            vec![[-1.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0]]
        }
        Face::Area(cell, _) => cell.places.to_vec(),
    };
    (face, x.into_iter().enumerate().map(|(k, x)| bent(k, x)).collect())
}

/// Requirement: a pressure presses against the outward normal with its area, and the stiffness
/// is the derivative of the forces. Central differences of step 1e-6; 1e-8.
#[test]
fn forces_and_their_derivatives() {
    let rings = [2, 3].map(|nodes| {
        let x = face(2, nodes).1.into_iter().map(|[r, z, _]| [r + 2.0, z, 0.0]).collect();
        (2, nodes, (Face::Ring { nodes }, x))
    });
    let others = [(2, 2), (2, 3), (3, 3), (3, 4), (3, 6), (3, 8)];
    let others = others.map(|(dimension, nodes)| (dimension, nodes, face(dimension, nodes)));
    for (dimension, nodes, (face, x)) in others.into_iter().chain(rings) {
        let force = |x: &[[f64; 3]]| {
            let mut force = vec![[0.0; 3]; nodes];
            face.press(2.5, x, &mut force);
            force
        };
        let mut tangent = vec![0.0; 9 * nodes * nodes];
        face.stiffness(2.5, &x, &mut tangent);
        for column in 0..3 * nodes {
            if dimension == 2 && column % 3 == 2 {
                continue;
            }
            let moved = |by: f64| {
                let mut x = x.clone();
                x[column / 3][column % 3] += by;
                force(&x)
            };
            let (up, down) = (moved(1e-6), moved(-1e-6));
            for row in 0..3 * nodes {
                let (a, b) = (up[row / 3][row % 3], down[row / 3][row % 3]);
                let own = tangent[row * 3 * nodes + column];
                let apart = own - (a - b) / 2e-6;
                assert!(apart.abs() < 1e-8 * (1.0 + own.abs()), "{nodes} {row} {column} {apart}");
            }
        }
    }
}

/// Requirement: of a point beside a face the nearest place is its foot, of one beyond the border
/// a place on the border; shape functions give the place.
#[test]
fn the_nearest_place() {
    for nodes in [3, 4, 6, 8] {
        let face = Face::of(3, nodes, 1.0).unwrap_or(Face::Area(&TRI3, &TRI_3));
        let Face::Area(cell, _) = face else { continue };
        let x: Vec<[f64; 3]> =
            cell.places.iter().map(|&[a, b, _]| [2.0 * a + 0.3 * b, b, 0.2 * a]).collect();
        let on = |a: f64, b: f64| [2.0 * a + 0.3 * b, b, 0.2 * a];
        let foot = on(0.3, 0.4);
        // the normal of the plane z = 0.1 x - 0.03 y
        let point = [foot[0] - 0.05, foot[1] + 0.015, foot[2] + 0.5];
        let near = face.nearest(&x, point);
        assert!((0..3).all(|k| (near.place[k] - foot[k]).abs() < 1e-12), "{nodes} {near:?}");
        assert!((near.shapes.iter().sum::<f64>() - 1.0).abs() < 1e-13);
        let near = face.nearest(&x, on(3.0, 0.25));
        assert!(near.distance > 1.0 && near.shapes.iter().all(|n| n.is_finite()));
    }
    let edge = Face::Edge { nodes: 2, thickness: 1.0 };
    let near = edge.nearest(&[[0.0; 3], [2.0, 0.0, 0.0]], [0.5, 0.3, 0.0]);
    assert!((near.distance - 0.3).abs() < 1e-15 && (near.shapes[1] - 0.25).abs() < 1e-15);
}

/// Requirement: on an edge that runs round, the axial sum is the pressure times the area of the
/// ring, pi (b^2 - a^2), and of a traction the traction times the area of the cone.
#[test]
fn a_ring_bears_on_its_circle() {
    let pi = std::f64::consts::PI;
    for nodes in [2_usize, 3] {
        let ring = Face::Ring { nodes };
        let end = (nodes - 1) as f64;
        let along = |a: f64, b: f64, k: usize| a + (b - a) * k as f64 / end;
        let x: Vec<_> = (0..nodes).map(|k| [along(1.0, 3.0, k), along(0.0, 1.5, k), 0.0]).collect();
        let mut force = vec![[0.0; 3]; nodes];
        ring.press(3.0, &x, &mut force);
        let sum: f64 = force.iter().map(|f| f[1]).sum();
        assert!((sum - 3.0 * pi * 8.0).abs() < 1e-12, "{nodes} {sum}");
        let mut pulled = vec![[0.0; 3]; nodes];
        ring.pull(|_| [0.0, 2.0, 0.0], &x, &mut pulled);
        let sum: f64 = pulled.iter().map(|f| f[1]).sum();
        assert!((sum - 2.0 * pi * 4.0 * 2.5).abs() < 1e-12, "{nodes} {sum}");
    }
}

/// Requirement: on flat faces the sum is pressure times area, inwards.
#[test]
fn sums_are_pressure_times_area() {
    let edge = Face::of(2, 3, 0.5).unwrap_or(Face::Area(&TRI3, &TRI_3));
    let mut force = [[0.0; 3]; 3];
    edge.press(3.0, &[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], &mut force);
    let sum: f64 = force.iter().map(|f| f[1]).sum();
    assert!((sum - 3.0).abs() < 1e-15, "material above the edge: the pressure acts upwards");
    let quad = Face::Area(&QUAD8, &QUAD_9);
    let mut force = [[0.0; 3]; 8];
    let x = QUAD8.places.iter().map(|&[a, b, _]| [a, b, 0.0]).collect::<Vec<_>>();
    quad.press(3.0, &x, &mut force);
    let sum: f64 = force.iter().map(|f| f[2]).sum();
    assert!((sum + 12.0).abs() < 1e-13);
    let mut pulled = [[0.0; 3]; 8];
    quad.pull(|_| [1.0, 0.0, -2.0], &x, &mut pulled);
    let sums = [0, 2].map(|k| pulled.iter().map(|f| f[k]).sum::<f64>());
    assert!((sums[0] - 4.0).abs() < 1e-13 && (sums[1] + 8.0).abs() < 1e-13);
}
