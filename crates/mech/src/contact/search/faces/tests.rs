use super::*;
use crate::element::cell::QUAD4;
use crate::surface::mesh::MeshFace;
use crate::vector::size;

/// Half a tube of radius 1 along y, of `around` x 3 faces, seen from outside.
fn tube(around: usize) -> (FaceMesh, Vec<Vector>) {
    let mut positions = Vec::new();
    for j in 0..4 {
        for i in 0..=around {
            let angle = std::f64::consts::PI * (1.0 - i as f64 / around as f64);
            positions.push([angle.cos(), 0.4 * j as f64, angle.sin()]);
        }
    }
    let row = around + 1;
    let face = |j: usize, i: usize| {
        let a = j * row + i;
        MeshFace { cell: &QUAD4, nodes: vec![a, a + 1, a + row + 1, a + row] }
    };
    let faces = (0..3).flat_map(|j| (0..around).map(move |i| (j, i)));
    let faces = faces.map(|(j, i)| face(j, i)).collect();
    (FaceMesh::new(faces, &positions, true), positions)
}

fn distance(around: usize, angle: f64, radius: f64) -> Option<f64> {
    let (mesh, positions) = tube(around);
    let tree = tree(&mesh, &positions);
    let point = [radius * angle.cos(), 0.55, radius * angle.sin()];
    let mut room = PlacedFace::EMPTY;
    let place = closest(&mesh, &positions, &tree, (point, 0.0, None), &mut room)?;
    let patch = mesh.place(place.face, &positions, &mut room)?;
    let own = patch.place(place.at);
    let (_, normal) = patch.frame(&own)?;
    let way = sub(point, patch.position(&own.value));
    assert!(size(way) < 1e-12 || (dot(way, normal).abs() / size(way) - 1.0).abs() < 1e-9);
    Some(dot(way, normal))
}

/// Requirement: outside and inside, on faces and across their edges, the distance of a point is
/// that of the tube. Smoothing makes the error fall with the fourth power of the faces: their flat
/// shape alone would be (pi / around)^2 / 8 off.
#[test]
fn distances_are_those_of_the_tube() {
    for radius in [0.8, 1.0, 1.3] {
        let worst = |around: usize| {
            let angles = (1..60).map(|k| 0.3 + 2.5 * f64::from(k) / 60.0);
            let errors = angles
                .map(|angle| (distance(around, angle, radius).unwrap() - (radius - 1.0)).abs());
            errors.fold(0.0, f64::max)
        };
        let (coarse, fine) = (worst(12), worst(24));
        let flat = (std::f64::consts::PI / 12.0).powi(2) / 8.0;
        assert!(coarse < 0.1 * flat, "{radius}: {coarse} {flat}");
        assert!(fine < coarse / 8.0, "{radius}: {coarse} {fine}");
    }
}

/// Requirement: along a way round the tube the distance has no step anywhere: it changes by no more
/// than a smooth curve lets it.
#[test]
fn the_distance_has_no_step() {
    let angles: Vec<_> = (0..2000).map(|k| 0.3 + 2.5 * f64::from(k) / 2000.0).collect();
    let all: Vec<_> = angles.iter().map(|&angle| distance(12, angle, 1.02).unwrap()).collect();
    let step = all.windows(2).map(|w| (w[1] - w[0]).abs()).fold(0.0, f64::max);
    assert!(step < 2e-5, "{step}");
}

/// Requirement: beyond an open end nothing faces a point, but where the end is prolonged.
#[test]
fn an_open_end_is_prolonged_as_far_as_asked() {
    let (mesh, positions) = tube(8);
    let tree = tree(&mesh, &positions);
    let mut room = PlacedFace::EMPTY;
    let mut faces = |y: f64, extension: f64| {
        closest(&mesh, &positions, &tree, ([0.1, y, 1.1], extension, None), &mut room).is_some()
    };
    assert!(faces(1.19, 0.0) && !faces(1.21, 0.0));
    assert!(faces(1.21, 0.1) && !faces(1.25, 0.1));
}

/// How far beyond the middle of a roof of two sides of length 1 [L] a point keeps the left one, by which it stood at
/// the last commit; each has so many faces and falls by a slope, and slave faces are 0.1 long.
fn kept(count: usize, slope: f64) -> f64 {
    let columns = 2 * count + 1;
    let along = slope.hypot(1.0);
    let x = |i: usize| (i as f64 / count as f64 - 1.0) / along;
    let node = |k: usize| [x(k % columns), (k / columns) as f64, -slope * x(k % columns).abs()];
    let positions: Vec<Vector> = (0..2 * columns).map(node).collect();
    let face =
        |i: usize| MeshFace { cell: &QUAD4, nodes: vec![i, i + 1, i + 1 + columns, i + columns] };
    let mut mesh = FaceMesh::new((0..2 * count).map(face).collect(), &positions, true);
    mesh.slave = 0.1;
    let (tree, left) = (tree(&mesh, &positions), count - 1);
    let keeps = |beyond: f64| {
        let point = [beyond / along, 0.5, slope * beyond / along];
        let at = (point, 0.0, Some(left));
        closest(&mesh, &positions, &tree, at, &mut { PlacedFace::EMPTY }).unwrap().face == left
    };
    let (mut low, mut high) = (0.0, 0.5);
    while high - low > 1e-9 {
        let middle = 0.5 * (low + high);
        if keeps(middle) { low = middle } else { high = middle }
    }
    low
}

/// Requirement: beyond a ridge or a valley that is drawn as it is a point keeps its face up to a part of the slave's face from the
/// other one, however many faces draw the sides; beyond an edge between faces of a plane up to a part of the face.
#[test]
fn what_a_point_keeps_does_not_depend_on_the_number_of_faces() {
    for count in [1, 3] {
        for slope in [0.1_f64, 0.2, 0.4] {
            let sine = (2.0 * slope.atan()).sin();
            for (slope, apart) in [(slope, RIDGE), (-slope, VALLEY)] {
                let expected = (apart * 0.1 / sine).min(SEAM / count as f64);
                let found = kept(count, slope);
                assert!((found - expected).abs() < 1e-7, "{count} {slope}: {found} {expected}");
            }
        }
        assert!((kept(count, 0.0) - SEAM / count as f64).abs() < 1e-7, "{count}");
    }
}
