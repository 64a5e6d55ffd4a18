//! A material of the embedding program that is not elastic: rubber that softens (Mullins).
//!
//! ```text
//!   stress |      __/   first loading: (1 - d) of the elastic stress, d grows with the largest
//!          |    _/ /    energy so far
//!          |  _/  /     unloading and loading again: d stays
//!          |_/___/____ stretch
//! ```
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // test code throughout

use slideline_mech::element::cell::{Cell, HEX8, QUAD4};
use slideline_mech::element::quadrature::{HEX_8, QUAD_4, Quadrature};
use slideline_mech::element::solid::{Formulation, Kinematics, Recipe, Told, states};
use slideline_mech::element::{Kernel, Response, Strains};
use slideline_mech::material::tensor::{Matrix, add_dyad, symmetric};
use slideline_mech::material::{Answer, Conditions, Elastic, Law, Material};
use std::sync::Arc;

const ELASTIC: Elastic = Elastic { modulus: 7.0, poisson: 0.3 };
/// Largest softening [1], and energy after which most of it is there [F/L2].
const MOST: f64 = 0.4;
const ENERGY: f64 = 0.05;

/// Softening by the largest energy k that the elastic body would have had: d = m (1 - exp(-k/e)).
/// State: k.
#[derive(Debug)]
struct Softening;

impl Softening {
    fn softening(largest: f64) -> f64 {
        MOST * -(-largest / ENERGY).exp_m1()
    }

    /// Integral of 1 - d over k: the work of a first loading.
    fn first_work(largest: f64) -> f64 {
        largest - MOST * (largest + ENERGY * (-largest / ENERGY).exp_m1())
    }
}

impl Law for Softening {
    fn states(&self) -> usize {
        1
    }

    fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer {
        let elastic = match under.large {
            true => ELASTIC.hencky(gradient),
            false => ELASTIC.small(&symmetric(gradient)),
        };
        let largest = elastic.energy.max(committed[0]);
        state[0] = largest;
        let kept = 1.0 - Self::softening(largest);
        let mut answer = elastic;
        answer.stress = elastic.stress.map(|stress| kept * stress);
        answer.moduli = elastic.moduli.map(|row| row.map(|entry| kept * entry));
        if elastic.energy >= committed[0] {
            let slope = MOST / ENERGY * (-largest / ENERGY).exp();
            add_dyad(&mut answer.moduli, -slope, &elastic.stress);
        }
        answer.energy = Self::first_work(largest) - kept * (largest - elastic.energy);
        answer.dissipation = answer.energy - kept * elastic.energy;
        answer
    }

    fn stiffest(&self) -> f64 {
        ELASTIC.bulk_modulus() + 4.0 / 3.0 * ELASTIC.shear_modulus()
    }

    fn shear_modulus(&self) -> f64 {
        ELASTIC.shear_modulus()
    }
}

fn element(
    (cell, rule): (&'static Cell, &'static Quadrature),
    kinematics: Kinematics,
    formulation: Formulation,
) -> (Box<dyn Kernel>, usize) {
    let material = Material::User(Arc::new(Softening));
    let count = states((cell, rule), (kinematics, formulation), &material);
    let (thickness, told) = (0.5, Told::Logarithmic);
    let orientation = None;
    let recipe = Recipe {
        cell,
        rule,
        kinematics,
        formulation,
        material,
        thickness,
        told,
        orientation,
        temperatures: Default::default(),
    };
    let moved = |(a, place): (usize, &[f64; 3])| -> [f64; 3] {
        std::array::from_fn(|axis| place[axis] + 0.1 * ((a * 5 + axis) as f64).sin())
    };
    let nodes: Vec<[f64; 3]> = cell.places.iter().enumerate().map(moved).collect();
    (slideline_kernels::solids(recipe, &nodes).unwrap(), count)
}

fn respond(
    kernel: &dyn Kernel,
    q: &[f64],
    committed: &[f64],
    strains: Strains<'_>,
) -> (f64, Vec<f64>, Vec<f64>, Vec<f64>) {
    let width = kernel.variables();
    let (mut force, mut tangent) = (vec![0.0; width], vec![0.0; width * width]);
    let mut state = committed.to_vec();
    let into = Response { force: &mut force, tangent: Some(&mut tangent), state: &mut state };
    let energy = kernel.respond(0, q, committed, &strains.into(), into).unwrap();
    (energy, force, tangent, state)
}

/// Requirement: in elements of plane stress, with one pressure and with incompatible modes, on the
/// way out (first loading) and half-way back, the tangent is the derivative of the force; on the
/// way out the force is that of the work. Source: central differences of step 1e-6. Tolerance:
/// their error.
#[test]
fn tangents() {
    let elements = [
        element((&QUAD4, &QUAD_4), Kinematics::PlaneStress, Formulation::Plain),
        element((&HEX8, &HEX_8), Kinematics::Space, Formulation::MeanDilation),
        element((&HEX8, &HEX_8), Kinematics::Space, Formulation::Incompatible),
    ];
    for (kernel, count) in elements {
        let far: Vec<f64> =
            (0..kernel.variables()).map(|k| 0.1 * ((3 * k * k + 1) as f64).sin()).collect();
        let back: Vec<f64> = far.iter().map(|u| 0.5 * u).collect();
        for strains in [Strains::Exact, Strains::Linear] {
            let zero = vec![0.0; count];
            let committed = respond(&*kernel, &far, &zero, strains).3;
            for (q, from, out) in [(&far, &zero, true), (&back, &committed, false)] {
                let (_, force, tangent, _) = respond(&*kernel, q, from, strains);
                for j in 0..q.len() {
                    let moved = |by: f64| {
                        let mut q = q.clone();
                        q[j] += by;
                        respond(&*kernel, &q, from, strains)
                    };
                    let (up, down) = (moved(1e-6), moved(-1e-6));
                    let slope = (up.0 - down.0) / 2e-6;
                    assert!((slope - force[j]).abs() < 1e-7, "{out} {slope} {}", force[j]);
                    for i in 0..q.len() {
                        let slope = (up.1[i] - down.1[i]) / 2e-6;
                        let own = tangent[q.len() * i + j];
                        assert!((slope - own).abs() < 1e-6, "{out} {i} {j} {slope} {own}");
                    }
                }
            }
        }
    }
}

/// Requirement: the work lost in a cycle of stretch is that between the curves, int d dk of the
/// largest energy k less d k, at a point; the second cycle loses none. Source: closed form.
#[test]
fn a_cycle_dissipates() {
    let law = Softening;
    let under = Conditions { large: true, ..Conditions::default() };
    let at = |stretch: f64, from: f64| {
        let gradient = [[stretch, 0.0, 0.0], [0.0; 3], [0.0; 3]];
        let mut state = [0.0];
        let answer = law.respond(&gradient, &under, &[from], &mut state);
        (answer, state[0])
    };
    let (out, largest) = at(0.2, 0.0);
    let (rest, kept) = at(0.0, largest);
    let exact = Softening::first_work(largest) - (1.0 - Softening::softening(largest)) * largest;
    assert_eq!(kept, largest);
    assert!(exact > 0.01 * out.energy && (rest.energy - exact).abs() < 1e-15);
    assert!((rest.dissipation - rest.energy).abs() < 1e-16 && rest.stress[0] == 0.0);
    let (again, _) = at(0.2, largest);
    assert!((again.energy - out.energy).abs() < 1e-15 && again.stress == out.stress);
    assert!((again.dissipation - rest.dissipation).abs() < 1e-15);
}
