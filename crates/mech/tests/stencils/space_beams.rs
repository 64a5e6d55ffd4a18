//! Beams in space: derivatives, invariance, agreement with the plane.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use slideline_mech::element::{
    Beam21, Beam22, Kernel, Response, SpaceBeam, SpaceBeams, Strains, Surroundings,
};
use slideline_mech::rotation;
use slideline_mech::section::{BeamStiffness, SpaceStiffness};
use slideline_mech::turn::Turn;

const SECTION: SpaceStiffness = SpaceStiffness {
    axial: 900.0,
    shear: [310.0, 270.0],
    torsion: 3.1,
    bending: [4.2, 0.7, 2.6],
    centroid: [0.03, -0.05],
    shear_center: [0.06, 0.02],
};
/// Displacements and rotations of three nodes, of order one.
const MOVED: [f64; 18] = [
    0.1, -0.2, 0.3, 0.5, -0.8, 0.3, 0.2, 0.1, -0.1, 0.7, -0.5, 0.6, -0.2, 0.4, 0.2, 0.2, -0.9, 1.1,
];

fn b31(first: [f64; 3]) -> SpaceBeams<2, 1> {
    let nodes = [[1.0, 2.0, -1.0], [1.7, 2.4, -0.2]];
    SpaceBeam::new(nodes, first, &SECTION).into_iter().collect()
}

/// A bow out of any plane of the axes.
fn b32(first: [f64; 3]) -> SpaceBeams<3, 2> {
    let nodes = [[1.0, 2.0, -1.0], [1.4, 2.3, -0.55], [1.7, 2.4, -0.2]];
    SpaceBeam::new(nodes, first, &SECTION).into_iter().collect()
}

struct Answer {
    energy: f64,
    force: Vec<f64>,
    tangent: Vec<f64>,
}

fn respond(kernel: &dyn Kernel, q: &[f64], under: &Surroundings<'_>) -> Answer {
    let width = kernel.variables();
    let (mut force, mut tangent) = (vec![0.0; width], vec![0.0; width * width]);
    let into = Response { force: &mut force, tangent: Some(&mut tangent), state: &mut [] };
    let energy = kernel.respond(0, &q[..width], &[], under, into).unwrap();
    let mut alone = vec![0.0; width];
    let into = Response { force: &mut alone, tangent: None, state: &mut [] };
    assert_eq!(kernel.respond(0, &q[..width], &[], under, into), Ok(energy));
    assert_eq!(alone, force, "the force alone has the same bits");
    Answer { energy, force, tangent }
}

fn largest(list: &[f64]) -> f64 {
    list.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// Compares force and tangent with central differences of energy and force, relative to their
/// largest entry.
fn differences(kernel: &dyn Kernel, q: &[f64], under: &Surroundings<'_>) {
    let (here, width) = (respond(kernel, q, under), kernel.variables());
    let step = 1e-5;
    for j in 0..width {
        let moved = |by: f64| {
            let mut q = q.to_vec();
            q[j] += by;
            respond(kernel, &q, under)
        };
        let (up, down) = (moved(step), moved(-step));
        let slope = (up.energy - down.energy) / (2.0 * step);
        let scale = largest(&here.force).max(largest(&here.tangent));
        assert!((slope - here.force[j]).abs() < 1e-7 * scale, "{j}");
        for i in 0..width {
            let slope = (up.force[i] - down.force[i]) / (2.0 * step);
            let own = here.tangent[width * i + j];
            assert!((slope - own).abs() < 1e-7 * largest(&here.tangent), "{i} {j}: {slope} {own}");
            let turned = here.tangent[width * j + i];
            assert!((own - turned).abs() < 1e-12 * largest(&here.tangent), "symmetric");
        }
    }
}

fn turns() -> [Turn; 3] {
    let of = |start: [f64; 3], phi: [f64; 3]| Turn { start, before: rotation::quaternion(&phi) };
    [
        of([0.3, -0.1, 0.2], [1.1, 2.4, -0.7]),
        of([0.5, 0.2, -0.4], [1.4, 2.1, -0.6]),
        of([0.0; 3], [1.2, 2.2, -0.8]),
    ]
}

/// Requirement: force and tangent are the derivatives of the energy, at rest and far from it,
/// from rest and from other starts of the rotations. Central differences; 1e-7.
#[test]
fn derivatives_by_differences() {
    let turns = turns();
    let first = [0.3, -0.2, 0.9];
    for kernel in [&b31(first) as &dyn Kernel, &b32(first)] {
        for strains in [Strains::Exact, Strains::Linear] {
            let plain = Surroundings::from(strains);
            for under in [plain, Surroundings { turns: &turns, ..plain }] {
                differences(kernel, &[0.0; 18], &under);
                differences(kernel, &MOVED, &under);
            }
        }
    }
}

/// Requirement: without displacements there is neither strain nor force, however curved; small
/// displacements are the derivative of large ones.
#[test]
fn small_displacements_are_the_limit() {
    let first = [0.3, -0.2, 0.9];
    for kernel in [&b31(first) as &dyn Kernel, &b32(first)] {
        let exact = respond(kernel, &[0.0; 18], &Strains::Exact.into());
        let linear = respond(kernel, &MOVED, &Strains::Linear.into());
        assert_eq!(largest(&exact.force), 0.0);
        for (a, b) in exact.tangent.iter().zip(&linear.tangent) {
            assert!((a - b).abs() < 1e-12 * largest(&linear.tangent));
        }
    }
}

/// Requirement: a rigid motion after any deformation changes neither energy nor section forces and
/// turns the forces: nodal forces in full, moments about fixed axes. 1e-12 of the largest.
#[test]
fn a_rigid_motion_changes_nothing() {
    let turn = rotation::quaternion(&[2.3, -1.2, 3.4]);
    let first = [0.3, -0.2, 0.9];
    let places = [[1.0, 2.0, -1.0], [1.4, 2.3, -0.55], [1.7, 2.4, -0.2]];
    for (kernel, picked) in
        [(&b31(first) as &dyn Kernel, &[0, 2][..]), (&b32(first), &[0, 1, 2][..])]
    {
        let width = kernel.variables();
        let vectors = |q: &[f64], a: usize| [q[6 * a + 3], q[6 * a + 4], q[6 * a + 5]];
        let starts: Vec<Turn> = (0..picked.len())
            .map(|a| {
                let start = vectors(&MOVED, a);
                Turn { start, before: rotation::quaternion(&start) }
            })
            .collect();
        let before = Surroundings { turns: &starts, ..Strains::Exact.into() };
        let here = respond(kernel, &MOVED, &before);
        let mut q = MOVED[..width].to_vec();
        let after: Vec<Turn> = starts
            .iter()
            .map(|own| Turn { before: rotation::after(&turn, &own.before), ..*own })
            .collect();
        for (a, &node) in picked.iter().enumerate() {
            let x: [f64; 3] = std::array::from_fn(|k| places[node][k] + MOVED[6 * a + k]);
            let moved = rotation::displacement_by(&turn, &x);
            (0..3).for_each(|k| q[6 * a + k] += moved[k] + [5.0, -3.0, 8.0][k]);
        }
        let under = Surroundings { turns: &after, ..Strains::Exact.into() };
        let there = respond(kernel, &q, &under);
        let scale = largest(&here.force);
        assert!((here.energy - there.energy).abs() < 1e-12 * here.energy);
        for (own, turned) in
            here.force.as_chunks::<3>().0.iter().zip(there.force.as_chunks::<3>().0)
        {
            let moved = rotation::displacement_by(&turn, own);
            assert!((0..3).all(|k| (own[k] + moved[k] - turned[k]).abs() < 1e-12 * scale));
        }
        let results = |q: &[f64], under: &Surroundings<'_>| {
            let mut all = [0.0; 12];
            kernel.results(0, &q[..width], &[], under, &mut all);
            all
        };
        for (a, b) in results(&MOVED, &before).iter().zip(results(&q, &under)) {
            assert!((a - b).abs() < 1e-12 * scale, "{a} {b}");
        }
    }
}

/// Requirement: forces and moments of an element are in equilibrium at any displacement.
#[test]
fn forces_and_moments_balance() {
    let first = [0.3, -0.2, 0.9];
    let starts: [Turn; 3] = std::array::from_fn(|a| {
        let start = [MOVED[6 * a + 3], MOVED[6 * a + 4], MOVED[6 * a + 5]];
        Turn { start, before: rotation::quaternion(&start) }
    });
    let under = Surroundings { turns: &starts, ..Strains::Exact.into() };
    let places = [[1.0, 2.0, -1.0], [1.4, 2.3, -0.55], [1.7, 2.4, -0.2]];
    for (kernel, picked) in
        [(&b31(first) as &dyn Kernel, &[0, 2][..]), (&b32(first), &[0, 1, 2][..])]
    {
        let answer = respond(kernel, &MOVED, &under);
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for (a, &node) in picked.iter().enumerate() {
            let own = &answer.force[6 * a..6 * a + 6];
            let x: [f64; 3] = std::array::from_fn(|k| places[node][k] + MOVED[6 * a + k]);
            for k in 0..3 {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                force[k] += own[k];
                moment[k] += own[3 + k] + x[i] * own[j] - x[j] * own[i];
            }
        }
        let scale = largest(&answer.force);
        assert!(largest(&force).max(largest(&moment)) < 1e-12 * scale, "{force:?} {moment:?}");
    }
}

/// Requirement: in the plane x, y with n1 = (0, 0, -1) they are B21 and B22: energy, forces and
/// section forces with their signs. 1e-12.
#[test]
fn in_the_plane_they_are_the_plane_beams() {
    let section = SpaceStiffness {
        bending: [4.2, 0.0, 2.6],
        centroid: [0.0, 0.05],
        shear_center: [0.0, 0.04],
        ..SECTION
    };
    let plane = BeamStiffness { axial: 900.0, shear: 270.0, bending: 4.2, centroid: 0.05 };
    let at = [[1.0, 2.0], [1.4, 2.3], [1.7, 2.4]];
    let in_space = at.map(|[x, y]| [x, y, 0.0]);
    let q: [f64; 9] = [0.1, -0.2, 0.5, 0.2, 0.1, 0.7, -0.2, 0.4, 1.1];
    let first = [0.0, 0.0, -1.0];
    let two: SpaceBeams<2, 1> =
        SpaceBeam::new([in_space[0], in_space[1]], first, &section).into_iter().collect();
    let three: SpaceBeams<3, 2> = SpaceBeam::new(in_space, first, &section).into_iter().collect();
    let check = |kernel: &dyn Kernel, energy: f64, force: &[f64], sections: [f64; 3]| {
        let mut spatial = vec![0.0; kernel.variables()];
        for (node, own) in spatial.as_chunks_mut::<6>().0.iter_mut().zip(q.as_chunks::<3>().0) {
            (node[0], node[1], node[5]) = (own[0], own[1], own[2]);
        }
        let answer = respond(kernel, &spatial, &Strains::Exact.into());
        let scale = largest(force);
        assert!((answer.energy - energy).abs() < 1e-12 * energy);
        for (own, plane) in answer.force.as_chunks::<6>().0.iter().zip(force.as_chunks::<3>().0) {
            let expected = [plane[0], plane[1], 0.0, 0.0, 0.0, plane[2]];
            assert!((0..6).all(|k| (own[k] - expected[k]).abs() < 1e-12 * scale));
        }
        let mut results = [0.0; 12];
        kernel.results(0, &spatial, &[], &Strains::Exact.into(), &mut results);
        let expected = [sections[0], sections[1], 0.0, sections[2], 0.0, 0.0];
        assert!((0..6).all(|k| (results[k] - expected[k]).abs() < 1e-12 * scale), "{results:?}");
    };
    let b21 = Beam21::new([at[0], at[1]], plane);
    let (ends, mut force) = ([q[0], q[1], q[2], q[3], q[4], q[5]], [0.0; 6]);
    let energy = b21.force_and_tangent(&ends, &mut force, &mut [0.0; 36]);
    let own = b21.section_forces(&ends);
    check(&two, energy, &force, [own.axial, own.shear, own.moment]);
    let b22 = Beam22::new(at, plane);
    let mut force = [0.0; 9];
    let energy = b22.force_and_tangent(&q, &mut force, &mut [0.0; 81]);
    let own = b22.section_forces(&q);
    check(&three, energy, &force, [own.axial, own.shear, own.moment]);
}

/// Requirement: estimated stresses that are those of the strains give the derivative of the force
/// and the force itself; others give the same force and another tangent, whose geometric stiffness
/// is linear in them; a change arrives at the derivative of the stresses.
#[test]
fn stresses_of_their_own() {
    let first = [0.3, -0.2, 0.9];
    let turns = turns();
    for kernel in [&b31(first) as &dyn Kernel, &b32(first)] {
        let width = kernel.variables();
        let q = &MOVED[..width];
        let under = Surroundings { turns: &turns, ..Strains::Exact.into() };
        let exact = respond(kernel, q, &under);
        let stresses = |q: &[f64], change: &[f64]| {
            let mut all = vec![0.0; kernel.estimate_size()];
            kernel.stresses_after(0, q, change, &under, &mut all);
            all
        };
        let own = stresses(q, &vec![0.0; width]);
        let mixed =
            |s: &[f64]| respond(kernel, q, &Surroundings { strains: Strains::Mixed(s), ..under });
        for (a, b) in mixed(&own).tangent.iter().zip(&exact.tangent) {
            assert!((a - b).abs() < 1e-12 * largest(&exact.tangent));
        }
        let mut force = vec![0.0; width];
        assert!(kernel.force_of_stresses(0, (q, &turns), &own, &mut force));
        for (a, b) in force.iter().zip(&exact.force) {
            assert!((a - b).abs() < 1e-12 * largest(&exact.force));
        }
        let double: Vec<f64> = own.iter().map(|s| 2.0 * s).collect();
        let (none, twice) = (mixed(&vec![0.0; own.len()]), mixed(&double));
        assert_eq!(none.force, exact.force);
        for ((a, b), c) in none.tangent.iter().zip(&exact.tangent).zip(&twice.tangent) {
            assert!((2.0 * b - a - c).abs() < 1e-12 * largest(&exact.tangent));
        }
        let change: Vec<f64> = (0..width).map(|k| (1.7 * k as f64).sin()).collect();
        let moved = |by: f64| -> Vec<f64> {
            let q: Vec<f64> = q.iter().zip(&change).map(|(q, c)| q + by * c).collect();
            stresses(&q, &vec![0.0; width])
        };
        let (arrived, up, down) = (stresses(q, &change), moved(1e-5), moved(-1e-5));
        for k in 0..own.len() {
            let slope = (up[k] - down[k]) / 2e-5;
            assert!((arrived[k] - own[k] - slope).abs() < 1e-7 * largest(&arrived));
        }
    }
}

/// Requirement: a direction of n1 along the axis makes no element.
#[test]
fn n1_must_not_run_along_the_axis() {
    let nodes = [[0.0; 3], [0.0, 0.0, 2.0]];
    assert!(SpaceBeam::<2, 1>::new(nodes, [0.0, 0.0, -1.0], &SECTION).is_none());
    let turned = SpaceBeam::<2, 1>::new(nodes, [1.0, 0.0, -1.0], &SECTION).unwrap();
    assert_eq!(turned.length(), 2.0);
}
