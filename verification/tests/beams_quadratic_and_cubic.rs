//! B22 and B23 through the whole program: linear cantilever, roll-up.

use slideline_theory::closed::timoshenko::ShearBeam;
use slideline_verification::{Claim, Group, Record, run, worst};

pub const GROUP: Group = Group {
    file: "beams_quadratic_and_cubic",
    claims: &[
        Claim {
            name: "linear_cantilever_is_exact",
            requirement: "Under a load at the tip B22 gives Timoshenko's beam, B23 Bernoulli's, at \
                          any number of elements.",
            source: "Closed forms PL3/3EI + PL/kGA and PL3/3EI.",
            tolerance: "1e-9: an identity, up to rounding.",
            measure: linear_cantilever_is_exact,
        },
        Claim {
            name: "rolled_up_cantilever_closes",
            requirement: "Ten B23 under an end moment q EI/L lie on the circle, closed at q = 2 pi.",
            source: "Simo and Vu-Quoc (1986).",
            tolerance: "1e-8 of the length (1e-6 of 100): what the force tolerance leaves.",
            measure: rolled_up_cantilever_closes,
        },
    ],
};

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

fn linear_cantilever_is_exact(record: &mut Record) {
    let bending = 6.9e9 * 25e-3 * 1.5e-3f64.powi(3) / 12.0;
    let shear = 0.85 * 6.9e9 / 2.6 * 25e-3 * 1.5e-3;
    let flexible = ShearBeam { length: 50e-3, bending_stiffness: bending, shear_stiffness: shear };
    let rigid = LOAD * 50e-3f64.powi(3) / (3.0 * bending);
    for (kind, exact) in [("B22", flexible.deflection(LOAD)), ("B23", rigid)] {
        let off = [1, 4, 12].map(|n| (cantilever(kind, n) / exact - 1.0).abs());
        record.at_most(format!("{kind}, 1, 4, 12 elements, largest error"), worst(off), 1e-9);
    }
}

fn rolled_up_cantilever_closes(record: &mut Record) {
    let curve = run(include_str!("../../corpus/keywords/element_b23.inp")).unwrap();
    let last = |dof| *curve.displacement(11, dof).last().unwrap();
    record.at_most("distance of the tip from the clamp", (last(1) + 100.0).hypot(last(2)), 1e-6);
    let turn = (last(6) - std::f64::consts::TAU).abs();
    record.at_most("rotation of the tip less 2 pi", turn, 1e-8);
}
