//! B22 and B23 through the whole program: linear cantilever, roll-up, curved
//! beam, a contact deck; orders of convergence.
//!
//! Requirements and sources beside each test (verification section 5).

use slideline_theory::closed::timoshenko::ShearBeam;
use slideline_verification::run;

const LOAD: f64 = 0.01;

fn cantilever(kind: &str, elements: usize) -> f64 {
    let (per, middle) = if kind == "B22" { (2, ", 3") } else { (1, "") };
    let tip = per * elements + 1;
    let deck = format!(
        "*HEADING\nlinear cantilever\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n{tip}, 50.0E-3, 0.0\n\
         *NGEN, NSET=BEAM\n1, {tip}, 1\n*ELEMENT, TYPE={kind}, ELSET=BEAM\n1, 1, 2{middle}\n\
         *ELGEN, ELSET=BEAM\n1, {elements}, {per}, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n25.0E-3, 1.5E-3\n\
         *TRANSVERSE SHEAR STIFFNESS\n, , 0.0\n\
         *MATERIAL, NAME=M\n*ELASTIC\n6.9E9, 0.3\n*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n\
         1, ENCASTRE\n*CLOAD\n{tip}, 2, {LOAD:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n"
    );
    run(&deck).unwrap().displacement(tip as u64, 2)[0]
}

/// Requirement: B22 gives Timoshenko's beam, B23 Bernoulli's, at any number of
/// elements. Tolerance 1e-9: an identity, up to rounding.
#[test]
fn linear_cantilever_is_exact() {
    let bending = 6.9e9 * 25e-3 * 1.5e-3f64.powi(3) / 12.0;
    let shear = 0.85 * 6.9e9 / 2.6 * 25e-3 * 1.5e-3;
    let flexible = ShearBeam { length: 50e-3, bending_stiffness: bending, shear_stiffness: shear };
    let rigid = LOAD * 50e-3f64.powi(3) / (3.0 * bending);
    for n in [1, 4, 12] {
        for (kind, exact) in [("B22", flexible.deflection(LOAD)), ("B23", rigid)] {
            let found = cantilever(kind, n);
            assert!((found / exact - 1.0).abs() < 1e-9, "{kind} {n}: {found} {exact}");
        }
    }
}

/// Requirement: ten B23 under M = q EI/L lie on the circle, closed at q = 2 pi
/// (Simo and Vu-Quoc). Tolerance 1e-8 L: what the force tolerance leaves.
#[test]
fn rolled_up_cantilever_closes() {
    let text = include_str!("../../corpus/keywords/element_b23.inp");
    let curve = run(text).unwrap();
    let last = |dof| *curve.displacement(11, dof).last().unwrap();
    assert!((last(1) + 100.0).abs() < 1e-6 && last(2).abs() < 1e-6);
    assert!((last(6) - std::f64::consts::TAU).abs() < 1e-8);
}
