//! Elements at temperatures: force and tangent are derivatives of the energy, whatever is hot.
//!
//! Tolerance: central differences of second order.

use slideline_mech::element::cell::{HEX8, HEX20, QUAD4, QUAD8, TRI3};
use slideline_mech::element::quadrature::{HEX_8, HEX_27, QUAD_4, QUAD_9, TRI_1};
use slideline_mech::element::solid::{
    Formulation, Interpolation, Kinematics, Recipe, Told, states,
};
use slideline_mech::element::{
    Bar, Beam21, Beam22, Beam23, BeamHeat, HeatedBeams, Kernel, Response, SpaceBeam, SpaceBeams,
    Strains, Surroundings, Temperature,
};
use slideline_mech::material::{
    Clock, Elastic, Expanding, Expansion, Graded, Growth, LargeStrain, Material,
};
use slideline_mech::section::{BeamStiffness, SpaceStiffness};
use std::sync::Arc;

const COLD: Elastic = Elastic { modulus: 200.0, poisson: 0.3 };
const HOT: Elastic = Elastic { modulus: 120.0, poisson: 0.35 };

fn expansion() -> Expansion {
    let table = vec![
        (0.0, [1e-3, 2e-3, 5e-4, 3e-4, 1e-4, -2e-4]),
        (100.0, [2e-3, 1e-3, 1e-3, -1e-4, 0.0, 2e-4]),
    ];
    Expansion { zero: 10.0, table }
}

fn even() -> Expansion {
    Expansion {
        zero: 10.0,
        table: vec![
            (0.0, [1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0]),
            (100.0, [2e-3, 2e-3, 2e-3, 0.0, 0.0, 0.0]),
        ],
    }
}

fn graded(large: LargeStrain) -> Material {
    let rows = vec![(0.0, Material::Elastic(COLD, large)), (90.0, Material::Elastic(HOT, large))];
    Material::Graded(Arc::new(Graded::new(rows).unwrap_or_default()))
}

fn expanding(expansion: Expansion, law: Material) -> Material {
    let growth = Growth::Logarithmic;
    Material::Expanding(Box::new(Expanding { expansion, growth, law }))
}

/// Temperatures of the nodes now and before, none like another.
fn temperatures(nodes: usize) -> [Vec<Temperature>; 2] {
    [31.0, 7.0].map(|base| {
        let own = |k: usize| Temperature {
            value: base + 9.0 * (1.7 * k as f64).sin(),
            slopes: [20.0, 10.0],
        };
        (0..nodes).map(own).collect()
    })
}

/// Displacements that strain and turn.
fn displacements(count: usize) -> Vec<f64> {
    (0..count).map(|k| 0.04 * (2.3 * k as f64 + 0.4).sin()).collect()
}

struct Answer {
    energy: f64,
    force: Vec<f64>,
    tangent: Vec<f64>,
}

fn respond(kernel: &dyn Kernel, states: usize, q: &[f64], under: &Surroundings<'_>) -> Answer {
    let mut force = vec![0.0; q.len()];
    let mut tangent = vec![0.0; q.len() * q.len()];
    let mut state = vec![0.0; states];
    let into = Response { force: &mut force, tangent: Some(&mut tangent), state: &mut state };
    let committed = vec![0.0; states];
    let answer = kernel.respond(0, q, &committed, under, into);
    let Ok(energy) = answer else { unreachable!("{answer:?}") };
    Answer { energy, force, tangent }
}

/// Compares force and tangent with differences; `stored`: the energy is one of the displacements.
fn check(name: &str, kernel: &dyn Kernel, (nodes, states, stored): (usize, usize, bool)) {
    let q = displacements(kernel.variables());
    let [now, initial] = temperatures(nodes);
    for strains in [Strains::Linear, Strains::Exact] {
        let (temperatures, initial) = (&now[..], &initial[..]);
        let under =
            Surroundings { strains, temperatures, initial, turns: &[], clock: Clock::default() };
        let own = respond(kernel, states, &q, &under);
        let cold = respond(kernel, states, &q, &Surroundings::from(strains));
        let size = own.force.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
        let apart = own.force.iter().zip(&cold.force).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) > 1e-2 * size, "{name}: heat does nothing");
        let stiff = own.tangent.iter().fold(0.0_f64, |most, k| most.max(k.abs()));
        let step = 1e-5;
        for i in 0..q.len() {
            let at = |by: f64| {
                let mut q = q.clone();
                q[i] += by;
                respond(kernel, states, &q, &under)
            };
            let (above, below) = (at(step), at(-step));
            let slope = (above.energy - below.energy) / (2.0 * step);
            assert!(
                !stored || (slope - own.force[i]).abs() < 1e-6 * size,
                "{name} {strains:?} {i}"
            );
            for j in 0..q.len() {
                let slope = (above.force[j] - below.force[j]) / (2.0 * step);
                let entry = own.tangent[q.len() * j + i];
                assert!((slope - entry).abs() < 1e-6 * stiff, "{name} {strains:?} {j} {i}");
            }
        }
    }
}

/// Requirement: force and tangent of beams of all types are derivatives of the energy, with
/// temperatures that differ along and through them. Source: docs/theory.md eqs. (3.63), (3.64).
#[test]
fn beams() {
    let heat = || BeamHeat {
        expansion: Some(even()),
        elastic: vec![(0.0, COLD), (90.0, HOT)],
        given_shear: false,
    };
    let stiffness = BeamStiffness { axial: 50.0, shear: 15.0, bending: 2.0, centroid: 0.1 };
    let ends = [[0.0, 0.1], [1.2, 0.5]];
    let b21 = HeatedBeams::new([Beam21::new(ends, stiffness)].into_iter(), heat());
    check("B21", &b21, (2, 0, true));
    let b23 = HeatedBeams::new([Beam23::new(ends, stiffness)].into_iter(), heat());
    check("B23", &b23, (2, 0, true));
    let nodes = [[0.0, 0.1], [0.6, 0.35], [1.2, 0.5]];
    let b22 = HeatedBeams::new([Beam22::new(nodes, stiffness)].into_iter(), heat());
    check("B22", &b22, (3, 0, true));
}

/// Requirement: the same of beams in space. Source: docs/theory.md eq. (3.109).
#[test]
fn beams_in_space() {
    let heat = BeamHeat {
        expansion: Some(even()),
        elastic: vec![(0.0, COLD), (90.0, HOT)],
        given_shear: false,
    };
    let section = SpaceStiffness {
        axial: 50.0,
        shear: [15.0, 12.0],
        torsion: 1.5,
        bending: [2.0, 0.3, 1.0],
        centroid: [0.1, -0.2],
        shear_center: [0.2, 0.1],
    };
    let (nodes, first) = ([[0.0, 0.1, 0.0], [0.6, 0.35, 0.2], [1.2, 0.5, 0.5]], [0.0, 0.3, -1.0]);
    let two = SpaceBeam::new([nodes[0], nodes[2]], first, &section).into_iter();
    let two: SpaceBeams<2, 1> = two.collect();
    check("B31", &two.heated(Some(heat.clone())), (2, 0, true));
    let three: SpaceBeams<3, 2> = SpaceBeam::new(nodes, first, &section).into_iter().collect();
    check("B32", &three.heated(Some(heat)), (3, 0, true));
}

/// Requirement: the same of trusses.
#[test]
fn trusses() {
    for (told, large) in
        [(Told::Logarithmic, LargeStrain::Logarithmic), (Told::Green, LargeStrain::Green)]
    {
        let bar = || Bar { material: expanding(even(), graded(large)), area: 0.3, told };
        let two = [[0.0, 0.1, 0.0], [1.2, 0.5, 0.3]];
        let Some(two) = slideline_kernels::trusses(bar(), [3, 2], &two) else { unreachable!() };
        check("T3D2", &*two, (2, 1, true));
        let three = [[0.0, 0.1, 0.0], [0.6, 0.35, 0.0], [1.2, 0.5, 0.0]];
        let Some(three) = slideline_kernels::trusses(bar(), [2, 3], &three) else { unreachable!() };
        check("T2D3", &*three, (3, 2, true));
    }
}

fn solid(name: &str, recipe: Recipe, stored: bool) {
    let shape = |at: &[f64; 3]| -> [f64; 3] {
        let [x, y, z] = *at;
        [3.0 + x + 0.2 * y, 0.1 * x + y - 0.1 * z, z + 0.05 * x * y]
    };
    let nodes: Vec<[f64; 3]> = recipe.cell.places.iter().map(shape).collect();
    let kinds = (recipe.kinematics, recipe.formulation);
    let states = states((recipe.cell, recipe.rule), kinds, &recipe.material);
    let Some(solids) = slideline_kernels::solids(recipe, &nodes) else { unreachable!() };
    check(name, &*solids, (nodes.len(), states, stored));
}

/// Requirement: the same of solids, of every formulation and way of temperatures; of what yields
/// the tangent alone.
#[test]
fn solids() {
    let elastic = expanding(expansion(), graded(LargeStrain::Logarithmic));
    let metal = Graded::metal(
        &[(0.0, COLD), (90.0, HOT)],
        &[(0.0, vec![[2.0, 0.0], [4.0, 0.1]]), (50.0, vec![[1.0, 0.0], [3.0, 0.2]])],
    );
    let metal = Material::Graded(Arc::new(Graded::new(metal).unwrap_or_default()));
    let plastic = expanding(even(), metal);
    for (material, stored) in [(elastic, true), (plastic, false)] {
        let recipe = |cell, rule, kinematics, formulation, temperatures| Recipe {
            cell,
            rule,
            kinematics,
            formulation,
            material: material.clone(),
            thickness: 0.5,
            told: Told::Logarithmic,
            orientation: None,
            temperatures,
        };
        use {Formulation::*, Interpolation::*, Kinematics::*};
        solid("CPE3", recipe(&TRI3, &TRI_1, PlaneStrain, Plain, Mean), stored);
        solid("CPS4", recipe(&QUAD4, &QUAD_4, PlaneStress, Plain, Mean), stored);
        solid("CAX4", recipe(&QUAD4, &QUAD_4, Axisymmetric, MeanDilation, Mean), stored);
        solid("CPE8", recipe(&QUAD8, &QUAD_9, PlaneStrain, Plain, Linear), stored);
        solid("C3D8", recipe(&HEX8, &HEX_8, Space, MeanDilation, Mean), stored);
        solid("C3D20", recipe(&HEX20, &HEX_27, Space, Plain, Linear), stored);
        solid("CPE4I", recipe(&QUAD4, &QUAD_4, PlaneStrain, Incompatible, Shapes), stored);
        solid("C3D8I", recipe(&HEX8, &HEX_8, Space, Incompatible, Shapes), stored);
    }
}
