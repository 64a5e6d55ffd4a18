//! Solids of a material with axes of its own.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use slideline_mech::axes::System;
use slideline_mech::element::cell::{Cell, HEX8, HEX20, QUAD4, TET10};
use slideline_mech::element::quadrature::{HEX_8, QUAD_4, Quadrature, TET_4};
use slideline_mech::element::solid::Formulation::{self, Incompatible, MeanDilation, Plain};
use slideline_mech::element::solid::Kinematics::{self, Axisymmetric, PlaneStress, Space};
use slideline_mech::element::solid::{Recipe, Told, states};
use slideline_mech::element::{Kernel, Response, Strains};
use slideline_mech::material::{Anisotropic, LargeStrain, Material, Unsound};
use slideline_mech::orientation::{Basis, Orientation, Orientations};

/// E1, E2, E3, nu12, nu13, nu23, G12, G13, G23.
const PLY: [f64; 9] = [9.0, 3.0, 2.0, 0.3, 0.25, 0.4, 1.6, 1.1, 0.8];

type Kind = (&'static Cell, &'static Quadrature, Kinematics, Formulation);

const KINDS: [Kind; 6] = [
    (&QUAD4, &QUAD_4, PlaneStress, Plain),
    (&QUAD4, &QUAD_4, Axisymmetric, MeanDilation),
    (&HEX8, &HEX_8, Space, MeanDilation),
    (&HEX8, &HEX_8, Space, Incompatible),
    (&HEX20, &HEX_8, Space, Plain),
    (&TET10, &TET_4, Space, Plain),
];

fn ply() -> Material {
    Material::Anisotropic(
        Box::new(Anisotropic::engineering(&PLY).unwrap()),
        LargeStrain::Logarithmic,
    )
}

fn noise(seed: usize) -> f64 {
    let x = (seed as f64 * 12.9898 + 4.1).sin() * 43758.5453;
    2.0 * (x - x.floor()) - 1.0
}

/// Nodes of a cell, distorted, away from the origin.
fn nodes(cell: &Cell) -> Vec<[f64; 3]> {
    let of = |(a, place): (usize, &[f64; 3])| -> [f64; 3] {
        let moved = |k: usize| place[k] + 0.08 * noise(7 * a + k);
        let deep = if cell.dimension == 3 { 1.0 } else { 0.0 };
        [4.0 + moved(0), 0.3 * moved(0) + 1.2 * moved(1) - 3.0, deep * moved(2)]
    };
    cell.places.iter().enumerate().map(of).collect()
}

fn kernel(kind: &Kind, orientation: Option<Orientation>, nodes: &[[f64; 3]]) -> Box<dyn Kernel> {
    let (cell, rule, kinematics, formulation) = *kind;
    let (material, told, thickness) = (ply(), Told::Green, 0.5);
    let temperatures = Default::default();
    let recipe = Recipe {
        cell,
        rule,
        kinematics,
        formulation,
        material,
        thickness,
        told,
        orientation: orientation.map(Orientations::All),
        temperatures,
    };
    slideline_kernels::solids(recipe, nodes).unwrap()
}

/// Energy, force and tangent.
fn respond(
    kind: &Kind,
    kernel: &dyn Kernel,
    q: &[f64],
    strains: Strains<'_>,
) -> (f64, Vec<f64>, Vec<f64>) {
    let (cell, rule, kinematics, formulation) = *kind;
    let count = states((cell, rule), (kinematics, formulation), &ply());
    let (committed, mut state) = (vec![0.0; count], vec![0.0; count]);
    let (mut force, mut tangent) = (vec![0.0; q.len()], vec![0.0; q.len().pow(2)]);
    let into = Response { force: &mut force, tangent: Some(&mut tangent), state: &mut state };
    let energy = kernel.respond(0, q, &committed, &strains.into(), into).unwrap();
    (energy, force, tangent)
}

fn cylinder(turn: Option<(usize, f64)>, tilt: f64) -> Orientation {
    let system = System::cylindrical([1.0, -1.0, 0.0], [1.0, -1.0 + tilt, 1.0]).unwrap();
    Orientation { basis: Basis::System(system), turn }
}

/// Axes about a cylinder, tilted in space, turned about one of them, or of the element's nodes.
fn orientations(kind: &Kind) -> [Orientation; 2] {
    match kind.0.dimension {
        2 => [
            cylinder(Some((2, 0.5)), 0.0),
            Orientation { basis: Basis::Nodes([1, 2, 0]), turn: None },
        ],
        _ => [
            cylinder(Some((0, 0.5)), 0.3),
            Orientation { basis: Basis::Nodes([1, 2, 3]), turn: Some((1, -0.4)) },
        ],
    }
}

fn motion(kind: &Kind, nodes: &[[f64; 3]]) -> Vec<f64> {
    let d = kind.0.dimension;
    let a = [[0.1, 0.08, -0.05], [-0.05, -0.08, 0.06], [0.02, 0.04, 0.06]];
    let of = |k: usize| {
        let (node, i) = (k / d, k % d);
        (0..d).map(|j| a[i][j] * nodes[node][j]).sum::<f64>() + 0.02 * noise(k + 31)
    };
    (0..d * nodes.len()).map(of).collect()
}

/// Requirement: with axes that differ from point to point the tangent is the derivative of the
/// force, the force that of the energy, and the tangent symmetric, at large strain and at small.
/// Source: central differences. Tolerance: their error.
#[test]
fn derivatives() {
    for kind in KINDS {
        let nodes = nodes(kind.0);
        for orientation in orientations(&kind) {
            let kernel = kernel(&kind, Some(orientation), &nodes);
            let q = motion(&kind, &nodes);
            for strains in [Strains::Exact, Strains::Linear] {
                let (_, force, tangent) = respond(&kind, &*kernel, &q, strains);
                let width = q.len();
                for j in (0..width).step_by(2) {
                    let moved = |by: f64| {
                        let mut q = q.clone();
                        q[j] += by;
                        respond(&kind, &*kernel, &q, strains)
                    };
                    let (up, down) = (moved(1e-6), moved(-1e-6));
                    assert!(((up.0 - down.0) / 2e-6 - force[j]).abs() < 1e-6, "{}", kind.0.name);
                    for i in 0..width {
                        let slope = (up.1[i] - down.1[i]) / 2e-6;
                        let own = tangent[i * width + j];
                        assert!((slope - own).abs() < 5e-6, "{} {slope} {own}", kind.0.name);
                        assert!((tangent[j * width + i] - own).abs() < 1e-10);
                    }
                }
            }
        }
    }
}

/// Requirement: an element turned with its axes has the same energy and turned forces; turned
/// after it was deformed, too, since the axes go with the material. Turning the element alone
/// changes the energy. Source: objectivity. Tolerance: rounding.
#[test]
fn turned_elements() {
    for kind in KINDS.iter().filter(|kind| kind.2 == Space) {
        let nodes = nodes(kind.0);
        let orientation = cylinder(Some((0, 0.5)), 0.3);
        let Basis::System(system) = orientation.basis else { return };
        let (s, c) = 0.6_f64.sin_cos();
        let turn = |x: [f64; 3]| [c * x[0] - s * x[2], x[1], s * x[0] + c * x[2]];
        let turned: Vec<[f64; 3]> = nodes.iter().map(|&x| turn(x)).collect();
        let moved = Orientation { basis: Basis::System(system.moved(turn, turn)), ..orientation };
        let q = motion(kind, &nodes);
        let (at, _) = q.as_chunks::<3>();
        let after: Vec<f64> = at.iter().flat_map(|&u| turn(u)).collect();
        let (energy, force, _) =
            respond(kind, &*kernel(kind, Some(orientation), &nodes), &q, Strains::Exact);
        let same = kernel(kind, Some(moved), &turned);
        let (with, turned_force, _) = respond(kind, &*same, &after, Strains::Exact);
        assert!((energy - with).abs() < 1e-12 * energy, "{energy} {with}");
        let (forces, _) = force.as_chunks::<3>();
        for (own, expected) in turned_force.iter().zip(forces.iter().flat_map(|&f| turn(f))) {
            assert!((own - expected).abs() < 1e-11);
        }
        let alone = kernel(kind, Some(orientation), &turned);
        let (other, ..) = respond(kind, &*alone, &after, Strains::Exact);
        assert!((energy - other).abs() > 1e-3 * energy, "{energy} {other}");
        // the body turns after it was deformed
        let placed = nodes.iter().zip(at).flat_map(|(&x, &u)| {
            let y = turn(std::array::from_fn(|k| x[k] + u[k]));
            [y[0] - x[0], y[1] - x[1], y[2] - x[2]]
        });
        let placed: Vec<f64> = placed.collect();
        let own = kernel(kind, Some(orientation), &nodes);
        let (later, ..) = respond(kind, &*own, &placed, Strains::Exact);
        assert!((energy - later).abs() < 1e-12 * energy, "{energy} {later}");
    }
}

/// Requirement: tension along x of a ply whose fibres run at an angle to it makes the strains of
/// the closed form, 1/Ex = c^4/E1 + (1/G12 - 2 nu12/E1) s^2 c^2 + s^4/E2 and the like, at every
/// point of distorted elements in plane stress and in space; results along the axes of the
/// material are the turned stress. Source: Jones, Mechanics of Composite Materials, 2.6.
#[test]
fn off_axis_tension() {
    let [e1, e2, e3, nu12, nu13, nu23, g12, ..] = PLY;
    let angle = 0.4_f64;
    let (s, c) = angle.sin_cos();
    let pull = 0.01;
    let mixed = 1.0 / g12 - 2.0 * nu12 / e1;
    let ex = pull * (c.powi(4) / e1 + mixed * s * s * c * c + s.powi(4) / e2);
    let ey = pull
        * ((1.0 / e1 + 1.0 / e2 - 1.0 / g12) * s * s * c * c - nu12 / e1 * (c.powi(4) + s.powi(4)));
    let angle_xy = pull
        * ((2.0 / e1 + 2.0 * nu12 / e1 - 1.0 / g12) * s * c.powi(3)
            - (2.0 / e2 + 2.0 * nu12 / e1 - 1.0 / g12) * s.powi(3) * c);
    let ez = -pull * (nu13 / e1 * c * c + nu23 / e2 * s * s);
    assert!(e3 > 0.0);
    for kind in KINDS.iter().filter(|kind| kind.2 != Axisymmetric && kind.3 != Incompatible) {
        let nodes = nodes(kind.0);
        let basis = Basis::System(System::rectangular([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]).unwrap());
        let orientation = Orientation { basis, turn: Some((2, angle)) };
        let kernel = kernel(kind, Some(orientation), &nodes);
        let d = kind.0.dimension;
        let place = |x: &[f64; 3]| [ex * x[0] + angle_xy * x[1], ey * x[1], ez * x[2]];
        let q: Vec<f64> = nodes.iter().flat_map(|x| place(x).into_iter().take(d)).collect();
        let points = kind.1.points.len();
        let width = if d == 2 { 4 } else { 6 };
        let mut results = vec![0.0; (2 * width + 4) * points + 3];
        let (cell, rule, kinematics, formulation) = *kind;
        let mut state = vec![0.0; states((cell, rule), (kinematics, formulation), &ply())];
        if kinematics == PlaneStress {
            state.fill(ez);
        }
        kernel.results(0, &q, &state, &Strains::Linear.into(), &mut results);
        for stress in results[..width * points].chunks_exact(width) {
            for (k, stress) in stress.iter().enumerate() {
                let expected = if k == 0 { pull } else { 0.0 };
                assert!((stress - expected).abs() < 1e-14, "{} {k}: {stress}", kind.0.name);
            }
        }
    }
}

/// Requirement: constants that would release energy are refused with the bound that they break;
/// a ply in plane stress has the moduli of its closed form; a general matrix is taken as it is.
#[test]
fn bounds_of_constants() {
    let with = |at: usize, value: f64| {
        let mut constants = PLY;
        constants[at] = value;
        Anisotropic::engineering(&constants)
    };
    assert_eq!(with(6, 0.0), Err(Unsound::NotPositive("G12")));
    assert_eq!(with(3, 2.0), Err(Unsound::Ratio { name: "nu12", most: 3.0_f64.sqrt() }));
    assert!(matches!(with(5, 1.2), Err(Unsound::Determinant(left)) if left < 0.0));
    assert!(with(3, f64::NAN).is_err() && with(0, f64::INFINITY).is_err());
    let lamina = Anisotropic::lamina(&[9.0, 3.0, 0.3, 1.6, 1.1, 0.8]).unwrap().moduli;
    let left = 1.0 - 0.3 * 0.1;
    for (own, expected) in [(lamina[0][0], 9.0), (lamina[0][1], 0.9), (lamina[1][1], 3.0)] {
        assert!((own - expected / left).abs() < 1e-14);
    }
    assert!(lamina[0][2] == 0.0 && lamina[1][2] == 0.0 && lamina[3][3] == 1.6);
    let mut general = lamina;
    (general[0][3], general[3][0]) = (0.4, 0.4);
    assert_eq!(Anisotropic::general(&general).unwrap().moduli, general);
    (general[0][3], general[3][0]) = (4.0, 4.0);
    assert_eq!(Anisotropic::general(&general), Err(Unsound::Energy(4)));
}

/// Requirement: parts of elements have the axes of the whole, chosen elements their own.
#[test]
fn axes_of_many_elements() {
    let turned =
        |angle: f64| Orientation { basis: Basis::Nodes([0, 1, 2]), turn: Some((2, angle)) };
    let all = Orientations::Each([0.1, 0.2, 0.3].map(turned).into());
    let angles = |all: &Orientations, count: usize| -> Vec<f64> {
        (0..count).map(|place| all.of(place).unwrap().turn.unwrap().1).collect()
    };
    assert_eq!(angles(&all.chosen(&[2, 0]), 2), [0.3, 0.1]);
    assert_eq!(angles(&all.parted(&[0, 2, 2, 3]), 3), [0.1, 0.1, 0.3]);
    assert_eq!(all.of(3), None);
    let one = Orientations::All(turned(0.4));
    assert_eq!(angles(&one.parted(&[0, 2]).chosen(&[7]), 5), [0.4; 5]);
}
