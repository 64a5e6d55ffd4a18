//! Forces of tractions against rigid turns, the polar decomposition, closed forms, and differences.

use super::*;
use crate::element::cell::{QUAD4, QUAD8, TRI3, TRI6};
use crate::element::quadrature::{QUAD_4, QUAD_9, TRI_3};

const TURNS: Follows = Follows { turns: true, grows: true };

/// All ways to follow.
fn ways() -> impl Iterator<Item = Follows> {
    [true, false].into_iter().flat_map(|turns| [true, false].map(|grows| Follows { turns, grows }))
}

/// Faces with bent undeformed places.
fn faces() -> Vec<(Face, Vec<[f64; 3]>)> {
    let bent = |k: usize, [a, b]: [f64; 2], space: bool| {
        let bump = 0.1 * (1.3 * k as f64).sin();
        match space {
            true => [a + bump, b - 0.3 * bump, 0.2 * a * b + bump],
            false => [a + bump + 2.0, 0.4 * a * a - bump, 0.0],
        }
    };
    let along = [[-1.0, 0.0], [1.0, 0.0]];
    let middle = [[-1.0, 0.0], [0.0, 0.0], [1.0, 0.0]];
    let flat = |places: &[[f64; 2]]| -> Vec<[f64; 3]> {
        places.iter().enumerate().map(|(k, &own)| bent(k, own, false)).collect()
    };
    let mut all = vec![
        (Face::Edge { nodes: 2, thickness: 0.7 }, flat(&along)),
        (Face::Edge { nodes: 3, thickness: 0.7 }, flat(&middle)),
        (Face::Ring { nodes: 2 }, flat(&along)),
        (Face::Ring { nodes: 3 }, flat(&middle)),
    ];
    for (cell, rule) in [(&TRI3, &TRI_3), (&QUAD4, &QUAD_4), (&TRI6, &TRI_3), (&QUAD8, &QUAD_9)] {
        let places = cell.places.iter().enumerate();
        let x = places.map(|(k, &[a, b, _])| bent(k, [a, b], true)).collect();
        all.push((Face::Area(cell, rule), x));
    }
    all
}

/// A motion far from rest that is smooth but not affine; within the plane for edges.
fn moved(x: &[[f64; 3]], space: bool) -> Vec<[f64; 3]> {
    let of = |&[a, b, c]: &[f64; 3]| match space {
        true => [0.3 * a - 1.2 * b + 0.2 * c, a + 0.1 * b * b, 0.4 * a + 0.9 * c + 0.3 * b],
        false => [1.1 * a - 0.9 * b + 0.1 * b * b, 0.7 * a + 0.8 * b, 0.0],
    };
    x.iter().map(of).collect()
}

fn forces(own: &Traction, [rest, x]: [&[[f64; 3]]; 2]) -> Vec<[f64; 3]> {
    let mut force = vec![[0.0; 3]; x.len()];
    own.at_rest(rest).pull(2.5, x, &mut force);
    force
}

/// Requirement: the stiffness is the derivative of the forces, on every face, in every way to follow,
/// far from rest. Central differences of step 1e-6; 1e-8.
#[test]
fn stiffness_is_the_derivative() {
    for (face, rest) in faces() {
        let space = face.axes() == 3;
        let x = moved(&rest, space);
        for follows in ways() {
            let direction = [0.6, -0.48, if space { 0.64 } else { 0.0 }];
            let own = Traction::new(face, follows, &rest, |_| direction);
            let width = 3 * x.len();
            let mut tangent = vec![0.0; width * width];
            own.at_rest(&rest).stiffness(2.5, &x, &mut tangent);
            for column in (0..width).filter(|column| space || column % 3 < 2) {
                let at = |by: f64| {
                    let mut x = x.clone();
                    x[column / 3][column % 3] += by;
                    forces(&own, [&rest, &x])
                };
                let (up, down) = (at(1e-6), at(-1e-6));
                for row in 0..width {
                    let by = (up[row / 3][row % 3] - down[row / 3][row % 3]) / 2e-6;
                    let slope = tangent[row * width + column];
                    assert!(
                        (slope - by).abs() < 1e-8 * (1.0 + slope.abs()),
                        "{face:?} {follows:?} {row} {column}: {slope} {by}"
                    );
                }
            }
        }
    }
}

/// Requirement: on a face that turns rigidly the forces turn with it, or stay, and keep their sizes,
/// about an axis across all others, in the plane about the third one. Tolerance: rounding.
#[test]
fn a_rigid_turn_turns_the_forces() {
    let (sin, cos) = 2.0_f64.sin_cos();
    for (face, rest) in faces() {
        let space = face.axes() == 3;
        if matches!(face, Face::Ring { .. }) {
            continue; // a ring does not turn rigidly
        }
        let axis = if space { [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0] } else { [0.0, 0.0, 1.0] };
        let turn = |v: [f64; 3]| {
            let along = scale(axis, (1.0 - cos) * dot(axis, v));
            add(add(scale(v, cos), scale(cross(axis, v), sin)), along)
        };
        let x: Vec<_> = rest.iter().map(|&place| add(turn(place), [3.0, -1.0, 0.0])).collect();
        let direction = [0.6, -0.8, 0.0];
        for follows in ways() {
            let own = Traction::new(face, follows, &rest, |_| direction);
            let before = forces(&own, [&rest, &rest]);
            for (now, before) in forces(&own, [&rest, &x]).into_iter().zip(before) {
                let expected = if follows.turns { turn(before) } else { before };
                assert!(size(sub(now, expected)) < 1e-14, "{face:?} {follows:?} {now:?}");
            }
        }
    }
}

/// Requirement: a sheared and stretched face turns as the polar decomposition says. A square under
/// F = ((a, c), (0, b)) turns in its plane by tan theta = -c/(a + b), and its area grows by a b. Source:
/// the condition that R' F be symmetric. Tolerance: rounding.
#[test]
fn shear_turns_by_half_of_it() {
    let (a, b, c) = (1.3, 0.8, 0.5);
    let rest: Vec<[f64; 3]> = QUAD4.places.to_vec();
    let x: Vec<_> = rest.iter().map(|&[u, v, _]| [a * u + c * v, b * v, 0.0]).collect();
    let angle = -(c / (a + b)).atan();
    for (direction, expected) in [
        ([1.0, 0.0, 0.0], [angle.cos(), angle.sin(), 0.0]),
        ([0.0, 1.0, 0.0], [-angle.sin(), angle.cos(), 0.0]),
        ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]),
    ] {
        for (grows, area) in [(true, 4.0 * a * b), (false, 4.0)] {
            let follows = Follows { turns: true, grows };
            let own = Traction::new(Face::Area(&QUAD4, &QUAD_4), follows, &rest, |_| direction);
            let sum = forces(&own, [&rest, &x]).into_iter().fold([0.0; 3], add);
            assert!(size(sub(sum, scale(expected, 2.5 * area))) < 1e-13, "{sum:?}");
        }
    }
}

/// Requirement: against the outward normal a traction that turns and grows is a pressure, on every
/// face as it is. Tolerance: rounding.
#[test]
fn across_the_face_it_is_a_pressure() {
    for (face, rest) in faces() {
        let x = moved(&rest, face.axes() == 3);
        let mut pressed = vec![[0.0; 3]; x.len()];
        face.press(2.5, &x, &mut pressed);
        let directions = face.points().map(|at| scale(Point::new(&face, &at, &rest).axes[2], -1.0));
        let own = Traction { face, follows: TURNS, directions: directions.collect() };
        for (pulled, pressed) in forces(&own, [&rest, &x]).into_iter().zip(pressed) {
            assert!(size(sub(pulled, pressed)) < 1e-13, "{face:?} {pulled:?} {pressed:?}");
        }
    }
}

/// Requirement: the sum of an axial traction on a cylinder that has grown from the radius 2 to 3 and from
/// the length 1 to 1.5 is its size times 2 pi 3 1.5, or of the undeformed 2 pi 2. Tolerance: rounding.
#[test]
fn a_ring_grows() {
    let rest = [[2.0, 0.0, 0.0], [2.0, 1.0, 0.0]];
    let x = [[3.0, 0.0, 0.0], [3.0, 1.5, 0.0]];
    let pi = std::f64::consts::PI;
    for (grows, area) in [(true, 9.0 * pi), (false, 4.0 * pi)] {
        let follows = Follows { turns: true, grows };
        let own = Traction::new(Face::Ring { nodes: 2 }, follows, &rest, |_| [0.0, 1.0, 0.0]);
        let sum = forces(&own, [&rest, &x]).into_iter().fold([0.0; 3], add);
        assert!(size(sub(sum, [0.0, 2.5 * area, 0.0])) < 1e-13, "{sum:?}");
    }
}

/// Requirement: a traction along a face has the size of its area and the direction laid onto it,
/// at every point of a bent one; a direction across the face has none. Tolerance: rounding.
#[test]
fn a_traction_along_a_face() {
    let quad = Face::Area(&QUAD8, &QUAD_9);
    let slope = 0.75; // the face rises along x: tangent (4, 0, 3)/5, area 4 * 5/4
    let x: Vec<_> = QUAD8.places.iter().map(|&[a, b, _]| [a, b, slope * a]).collect();
    let own = Traction::along(quad, TURNS, &x, |_| [1.0, 0.0, 0.0]).expect("along the face");
    let sum = forces(&own, [&x, &x]).into_iter().fold([0.0; 3], add);
    assert!(size(sub(sum, [10.0, 0.0, 7.5])) < 1e-13, "{sum:?}");
    assert_eq!(Traction::along(quad, TURNS, &x, |_| [-0.6, 0.0, 0.8]), None);
    // an arc of three nodes: along it all the way
    let arc = Face::Edge { nodes: 3, thickness: 1.0 };
    let x = [[-1.0, 0.0, 0.0], [0.0, 0.5, 0.0], [1.0, 0.0, 0.0]];
    let own = Traction::along(arc, TURNS, &x, |_| [1.0, 0.0, 0.0]).expect("along the arc");
    let sum = forces(&own, [&x, &x]).into_iter().fold([0.0; 3], add);
    assert!(size(sub(sum, [5.0, 0.0, 0.0])) < 1e-13, "{sum:?}");
}
