//! Trusses and springs.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use slideline_mech::element::solid::Told;
use slideline_mech::element::{
    AxialSpring, Bar, Element, Kernel, Response, SpringLaw, Strains, Trusses,
};
use slideline_mech::material::{Elastic, Hardening, LargeStrain, Material, Plastic};

const STEEL: Elastic = Elastic { modulus: 7.0, poisson: 0.3 };

fn plastic() -> Material {
    let table: Hardening = vec![[0.2, 0.0], [0.5, 0.3]];
    Material::Plastic(Plastic { elastic: STEEL, table, back_stresses: Vec::new() })
}

fn materials() -> [(&'static str, Material); 3] {
    [
        ("logarithmic", Material::Elastic(STEEL, LargeStrain::Logarithmic)),
        ("green", Material::Elastic(STEEL, LargeStrain::Green)),
        ("plastic", plastic()),
    ]
}

fn bar(material: Material) -> Bar {
    Bar { material, area: 0.4, told: Told::Logarithmic }
}

/// A straight truss of two nodes, and a curved one of three.
fn kernels(material: &Material) -> [(Box<dyn Kernel>, Vec<f64>); 2] {
    let two = [[1.0, 2.0, 0.5], [2.5, 1.0, 1.5]];
    let three = [[1.0, 2.0, 0.5], [1.9, 1.6, 0.8], [2.5, 1.0, 1.5]];
    let own = || bar(material.clone());
    [
        (Box::new(Trusses::<3, 2, 1>::new(own(), [two].into_iter()).unwrap()), two.concat()),
        (Box::new(Trusses::<3, 3, 2>::new(own(), [three].into_iter()).unwrap()), three.concat()),
    ]
}

/// Energy, force, tangent and state.
fn respond(
    kernel: &dyn Kernel,
    q: &[f64],
    committed: &[f64],
    strains: Strains<'_>,
) -> (f64, Vec<f64>, Vec<f64>, Vec<f64>) {
    let (mut force, mut tangent) = (vec![0.0; q.len()], vec![0.0; q.len().pow(2)]);
    let mut state = vec![0.0; committed.len()];
    let into = Response { force: &mut force, tangent: Some(&mut tangent), state: &mut state };
    let energy = kernel.respond(0, q, committed, &strains.into(), into).unwrap();
    (energy, force, tangent, state)
}

fn states(material: &Material, nodes: usize) -> Vec<f64> {
    vec![0.0; material.uniaxial_states() * (nodes - 1)]
}

/// Requirement: the tangent is the derivative of the force and, for elastic materials, the force
/// that of the energy, from a plastic state too; the tangent is symmetric. Source: central
/// differences. Tolerance: their error.
#[test]
fn trusses_by_differences() {
    for (what, material) in materials() {
        for (kernel, nodes) in kernels(&material) {
            let moved = |scale: f64| -> Vec<f64> {
                (0..nodes.len()).map(|k| scale * (1.7 * k as f64 + 0.3).sin()).collect()
            };
            let zero = states(&material, nodes.len() / 3);
            for strains in [Strains::Exact, Strains::Linear] {
                let committed = respond(&*kernel, &moved(-0.5), &zero, strains).3;
                let q = moved(-0.6);
                let (_, force, tangent, _) = respond(&*kernel, &q, &committed, strains);
                assert!(force.iter().any(|f| f.abs() > 1e-2));
                for j in 0..q.len() {
                    let at = |by: f64| {
                        let mut q = q.clone();
                        q[j] += by;
                        respond(&*kernel, &q, &committed, strains)
                    };
                    let (up, down) = (at(1e-6), at(-1e-6));
                    if what != "plastic" {
                        let slope = (up.0 - down.0) / 2e-6;
                        assert!((slope - force[j]).abs() < 1e-8, "{what} {slope} {}", force[j]);
                    }
                    for i in 0..q.len() {
                        let slope = (up.1[i] - down.1[i]) / 2e-6;
                        let own = tangent[i * q.len() + j];
                        assert!((slope - own).abs() < 1e-7, "{what} {i} {j}: {slope} {own}");
                        assert!((own - tangent[j * q.len() + i]).abs() < 1e-12);
                    }
                }
            }
        }
    }
}

/// Requirement: pulled to a stretch a bar has the force A E ln(l)/l of logarithmic strain and
/// A E (l^2 - 1) l/2 of Green's, whatever Poisson's ratio; a yielding one that of its table at the
/// plastic strain that is left; turned as a whole the same. Source: closed forms.
#[test]
fn pulled_bars() {
    let axis = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
    let end = axis.map(|x| 3.0 * x);
    for stretch in [0.7_f64, 1.0, 1.25] {
        let exact = [stretch.ln() / stretch, 0.5 * (stretch * stretch - 1.0) * stretch];
        for ((_, material), exact) in materials().iter().zip(exact) {
            let kernel =
                Trusses::<3, 2, 1>::new(bar(material.clone()), [[[0.0; 3], end]].into_iter());
            // the far end goes to the other side of the near one, stretched
            let moved: Vec<f64> =
                [0.0; 3].into_iter().chain(end.map(|x| -stretch * x - x)).collect();
            let zero = states(material, 2);
            let (_, force, ..) = respond(&kernel.unwrap(), &moved, &zero, Strains::Exact);
            for k in 0..3 {
                let expected = -0.4 * 7.0 * exact * axis[k];
                assert!((force[3 + k] - expected).abs() < 1e-13, "{stretch}: {force:?}");
            }
        }
    }
    // E (e - p) = .2 + p at e = ln 1.1
    let material = plastic();
    let kernel =
        Trusses::<3, 2, 1>::new(bar(material.clone()), [[[0.0; 3], end]].into_iter()).unwrap();
    let moved: Vec<f64> = [0.0; 3].into_iter().chain(end.map(|x| 0.1 * x)).collect();
    let (_, force, _, state) = respond(&kernel, &moved, &states(&material, 2), Strains::Exact);
    let plastic = (7.0 * 1.1_f64.ln() - 0.2) / 8.0;
    let expected = 0.4 * (0.2 + plastic) / 1.1;
    let pull: f64 = (0..3).map(|k| force[3 + k] * axis[k]).sum();
    assert!((pull - expected).abs() < 1e-12, "{pull} {expected}");
    // stress, strains along and across, plastic strain
    let mut results = [0.0; 4];
    kernel.results(0, &moved, &state, &Strains::Exact.into(), &mut results);
    assert!((results[0] - 0.2 - plastic).abs() < 1e-12 && (results[3] - plastic).abs() < 1e-12);
    assert!((results[1] - 1.1_f64.ln()).abs() < 1e-12 && results[2] < 0.0, "{results:?}");
}

/// Requirement: a spring in space is its energy, with a table too; the plane's is the same spring.
/// Source: central differences.
#[test]
fn springs_in_space_by_differences() {
    let reference = [[0.0, 1.0, 0.5], [2.0, 2.0, -1.0]];
    let laws =
        [SpringLaw::Linear(3.0), SpringLaw::Table([[-5.0, -2.0], [0.1, 1.0], [5.0, 12.0]].into())];
    for law in laws {
        let spring = AxialSpring { reference, law };
        let respond = |q: &[f64; 6]| {
            let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
            let energy = spring.exact(q, &mut force, &mut tangent);
            (energy, force, tangent)
        };
        let q = [0.3, -0.2, 0.4, 0.1, 0.5, -0.3];
        let (_, force, tangent) = respond(&q);
        for j in 0..6 {
            let at = |by: f64| {
                let mut q = q;
                q[j] += by;
                respond(&q)
            };
            let (up, down) = (at(1e-6), at(-1e-6));
            assert!(((up.0 - down.0) / 2e-6 - force[j]).abs() < 1e-8);
            for i in 0..6 {
                assert!(((up.1[i] - down.1[i]) / 2e-6 - tangent[6 * i + j]).abs() < 1e-8);
            }
        }
    }
}
