//! Elements of one point, held against their hourglass modes.
#![allow(clippy::unwrap_used, clippy::expect_used)] // test code throughout

use slideline_mech::element::cell::{HEX8, QUAD4};
use slideline_mech::element::quadrature::{HEX_1, QUAD_1};
use slideline_mech::element::solid::{Formulation, Interpolation, Kinematics, Recipe, Told};
use slideline_mech::element::{Kernel, Strains};
use slideline_mech::material::{Elastic, LargeStrain, Material};
use slideline_mech::rotation::displacement;

use super::solids::{Answer, respond};

const MODULUS: f64 = 7.0;

fn material(poisson: f64) -> Material {
    Material::Elastic(Elastic { modulus: MODULUS, poisson }, LargeStrain::Logarithmic)
}

fn recipe(kinematics: Kinematics, poisson: f64) -> Recipe {
    let (cell, rule) = match kinematics {
        Kinematics::Space => (&HEX8, &HEX_1),
        _ => (&QUAD4, &QUAD_1),
    };
    Recipe {
        cell,
        rule,
        kinematics,
        formulation: Formulation::Hourglass,
        material: material(poisson),
        thickness: 1.0,
        told: Told::Logarithmic,
        orientation: None,
        temperatures: Interpolation::Mean,
    }
}

fn brick(nodes: &[[f64; 3]], poisson: f64) -> Box<dyn Kernel> {
    slideline_kernels::solids(recipe(Kinematics::Space, poisson), nodes).unwrap()
}

fn quadrilateral(nodes: &[[f64; 2]; 4], kinematics: Kinematics, poisson: f64) -> Box<dyn Kernel> {
    let nodes = nodes.map(|[x, y]| [x, y, 0.0]);
    slideline_kernels::solids(recipe(kinematics, poisson), &nodes).unwrap()
}

fn block(sides: [f64; 3]) -> Vec<[f64; 3]> {
    HEX8.places.iter().map(|at| std::array::from_fn(|k| sides[k] * at[k])).collect()
}

fn answer(kernel: &dyn Kernel, q: &[f64], strains: Strains<'_>) -> Answer {
    respond(kernel, q, &[0.0], strains)
}

/// Displacements of nodes.
fn moved(nodes: &[[f64; 3]], by: impl Fn(&[f64; 3]) -> [f64; 3]) -> Vec<f64> {
    nodes.iter().flat_map(by).collect()
}

fn noise(seed: usize) -> f64 {
    ((seed as f64 * 12.9898 + 4.1414).sin() * 43_758.545).fract()
}

const SHAPES: [[f64; 3]; 5] =
    [[1.0, 1.0, 1.0], [8.0, 1.0, 2.0], [0.25, 1.0, 1.0], [0.3, 5.0, 0.7], [1e-3, 2e-3, 1.6e-2]];

/// Requirement: a brick of any proportions bends as a beam in each of six ways, and where its sides are held as a plate:
/// E, or E / (1 - nu^2), times I / 2 of the curvature squared. Source: beam and plate theory. Tolerance: rounding.
#[test]
fn bricks_bend_as_beams_and_plates() {
    for sides in SHAPES {
        let nodes = block(sides);
        let volume = 8.0 * sides.iter().product::<f64>();
        for (along, across) in [(0, 1), (0, 2), (1, 2), (1, 0), (2, 0), (2, 1)] {
            let other = 3 - along - across;
            for (narrower, modulus) in [(0.3, MODULUS), (0.0, MODULUS / 0.91)] {
                let q = moved(&nodes, |x| {
                    let mut u = [0.0; 3];
                    u[along] = x[along] * x[across];
                    u[other] = -narrower * x[across] * x[other];
                    u
                });
                let energy = answer(&*brick(&nodes, 0.3), &q, Strains::Linear).energy;
                let exact = 0.5 * modulus * volume * sides[across].powi(2) / 3.0;
                assert!((energy - exact).abs() < 1e-12 * exact, "{sides:?} {energy} {exact}");
            }
        }
    }
}

/// Requirement: a brick that is twisted about an axis, and warps as it likes, has the energy of the shears that
/// vary linearly over its section: G V / 2 of twist squared times 4 b^2 c^2 / (3 (b^2 + c^2)). Source: the integral
/// of (theta + psi)^2 y^2 + (psi - theta)^2 z^2, least in psi; thin sections are exact. Tolerance: rounding.
#[test]
fn bricks_twist_as_thin_bars() {
    for sides in SHAPES {
        let (nodes, shear) = (block(sides), MODULUS / 2.6);
        for axis in 0..3 {
            let (y, z) = ((axis + 1) % 3, (axis + 2) % 3);
            let (b, c) = (sides[y] * sides[y], sides[z] * sides[z]);
            let warp = (c - b) / (c + b);
            let q = moved(&nodes, |x| {
                let mut u = [0.0; 3];
                u[axis] = warp * x[y] * x[z];
                u[y] = -x[axis] * x[z];
                u[z] = x[axis] * x[y];
                u
            });
            let energy = answer(&*brick(&nodes, 0.3), &q, Strains::Linear).energy;
            let volume = 8.0 * sides.iter().product::<f64>();
            let exact = 0.5 * shear * volume * 4.0 * b * c / (3.0 * (b + c));
            assert!((energy - exact).abs() < 1e-12 * exact, "{sides:?} {energy} {exact}");
        }
    }
}

/// Requirement: so does a rectangle, with E in plane stress and E / (1 - nu^2) in plane strain.
#[test]
fn rectangles_bend_as_beams() {
    for [a, b, _] in SHAPES {
        let nodes: [[f64; 2]; 4] = [[-a, -b], [a, -b], [a, b], [-a, b]];
        for (kinematics, modulus) in
            [(Kinematics::PlaneStress, MODULUS), (Kinematics::PlaneStrain, MODULUS / 0.91)]
        {
            for (along, height) in [(0, b), (1, a)] {
                let mut q = [0.0; 8];
                for (u, x) in q.chunks_exact_mut(2).zip(&nodes) {
                    u[along] = x[0] * x[1];
                }
                let kernel = quadrilateral(&nodes, kinematics, 0.3);
                let energy = answer(&*kernel, &q, Strains::Linear).energy;
                let exact = 0.5 * modulus * 4.0 * a * b * height * height / 3.0;
                assert!((energy - exact).abs() < 1e-12 * exact, "{energy} {exact}");
            }
        }
    }
}

/// Requirement: a ring far from its axis bends as a plate, by E / (1 - nu^2) in both ways. Tolerance: what the curvature
/// of the ring does, the square of its size over its radius, 1e-6, by up to the square of its proportions.
#[test]
fn rings_bend_as_plates() {
    for [a, b, _] in SHAPES {
        let radius = 1e3 * a.max(b);
        let proportions = (a.max(b) / a.min(b)).powi(2);
        let corners = [[-a, -b], [a, -b], [a, b], [-a, b]];
        let nodes = corners.map(|[x, y]| [radius + x, y]);
        for (along, height) in [(0, b), (1, a)] {
            let mut q = [0.0; 8];
            for (u, x) in q.chunks_exact_mut(2).zip(&corners) {
                u[along] = x[0] * x[1];
            }
            let kernel = quadrilateral(&nodes, Kinematics::Axisymmetric, 0.3);
            let energy = answer(&*kernel, &q, Strains::Linear).energy;
            let volume = 4.0 * a * b * std::f64::consts::TAU * radius;
            let exact = 0.5 * MODULUS / 0.91 * volume * height * height / 3.0;
            assert!(
                (energy - exact).abs() < 1e-6 * proportions * exact,
                "{a} {b} {along}: {energy} {exact}"
            );
        }
    }
}

/// A slender brick askew and out of shape, and a large motion of its nodes.
fn askew() -> (Vec<[f64; 3]>, Vec<f64>) {
    let shape = |(a, at): (usize, &[f64; 3])| {
        let x: [f64; 3] = std::array::from_fn(|k| at[k] + 0.1 * noise(7 * a + k));
        [3.0 * x[0] + 0.4 * x[1], 0.5 * x[1] + 0.2 * x[2], x[2] - 0.3 * x[0]]
    };
    let nodes: Vec<[f64; 3]> = HEX8.places.iter().enumerate().map(shape).collect();
    let turned = |(a, x): (usize, &[f64; 3])| {
        let turn = displacement(&[0.6, -0.9, 0.4], *x);
        let stretch = [0.2 * x[0], -0.1 * x[1], 0.15 * x[0] + 0.1 * x[2]];
        std::array::from_fn::<f64, 3, _>(|k| turn[k] + stretch[k] + 0.1 * noise(3 * a + k))
    };
    let q = nodes.iter().enumerate().flat_map(turned).collect();
    (nodes, q)
}

/// Requirement: force and tangent are derivatives of the energy at any deformation, the tangent symmetric. Source:
/// central differences. Tolerance: their error.
#[test]
fn differences_of_large_motion() {
    let (nodes, q) = askew();
    let kernel = brick(&nodes, 0.3);
    let at = answer(&*kernel, &q, Strains::Exact);
    let step = 1e-5;
    for k in 0..24 {
        let beside = |way: f64| {
            let mut q = q.clone();
            q[k] += way * step;
            answer(&*kernel, &q, Strains::Exact)
        };
        let (up, down) = (beside(1.0), beside(-1.0));
        let force = (up.energy - down.energy) / (2.0 * step);
        assert!((force - at.force[k]).abs() < 1e-7, "{k}: {force} {}", at.force[k]);
        for i in 0..24 {
            let slope = (up.force[i] - down.force[i]) / (2.0 * step);
            let own = at.tangent[24 * i + k];
            assert!((slope - own).abs() < 1e-6, "{i} {k}: {slope} {own}");
            assert!((own - at.tangent[24 * k + i]).abs() < 1e-11, "{i} {k}");
        }
    }
}

/// Requirement: a turn of the deformed element as a whole changes no energy. Tolerance: rounding.
#[test]
fn turns_as_a_whole() {
    let (nodes, q) = askew();
    let kernel = brick(&nodes, 0.3);
    let still = answer(&*kernel, &q, Strains::Exact).energy;
    let turned = nodes.iter().zip(q.chunks_exact(3)).flat_map(|(x, u)| {
        let place = [x[0] + u[0], x[1] + u[1], x[2] + u[2]];
        let turn = displacement(&[1.1, 0.7, -2.0], place);
        std::array::from_fn::<f64, 3, _>(|k| u[k] + turn[k])
    });
    let turned: Vec<f64> = turned.collect();
    let energy = answer(&*kernel, &turned, Strains::Exact).energy;
    assert!((energy - still).abs() < 1e-12 * still, "{energy} {still}");
}
