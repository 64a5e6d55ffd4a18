//! Linear shear-flexible cantilever under a load at its tip.

use slideline_theory::closed::timoshenko::ShearBeam;
use slideline_verification::{Claim, Group, Record, run, worst};

pub const GROUP: Group = Group {
    file: "beams_timoshenko",
    claims: &[Claim {
        name: "exactly_what_one_point_elements_give",
        requirement: "n equal one-point elements give exactly (PL3/3EI)(1 - 1/4n2) + PL/K, with \
                      and without the slenderness factor in K, and the beam itself where K carries \
                      the residual bending flexibility.",
        source: "Derived (docs/theory.md, beam B21).",
        tolerance: "1e-9: an identity, up to rounding amplified by EA L2/EI.",
        measure: exactly_what_one_point_elements_give,
    }],
};

const LOAD: f64 = 0.01;

fn beam() -> ShearBeam {
    let bending = 6.9e9 * 25e-3 * 1.5e-3f64.powi(3) / 12.0;
    let shear = 0.85 * 6.9e9 / 2.6 * 25e-3 * 1.5e-3;
    ShearBeam { length: 50e-3, bending_stiffness: bending, shear_stiffness: shear }
}

fn tip(elements: usize, shear_card: &str) -> f64 {
    let tip = elements + 1;
    let deck = format!(
        "*HEADING\nlinear cantilever\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n{tip}, 50.0E-3, 0.0\n\
         *NGEN, NSET=BEAM\n1, {tip}, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n\
         *ELGEN, ELSET=BEAM\n1, {elements}, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n25.0E-3, 1.5E-3\n{shear_card}\
         *MATERIAL, NAME=M\n*ELASTIC\n6.9E9, 0.3\n*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n\
         1, ENCASTRE\n*CLOAD\n{tip}, 2, {LOAD:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n"
    );
    run(&deck).unwrap().displacement(tip as u64, 2)[0]
}

fn exactly_what_one_point_elements_give(record: &mut Record) {
    let (area, inertia) = (25e-3 * 1.5e-3, 25e-3 * 1.5e-3f64.powi(3) / 12.0);
    let mut off = [const { Vec::new() }; 3];
    for n in [1, 4, 12, 24] {
        let with = beam().slenderness_stiffness(n, area, inertia);
        let without = beam().shear_stiffness;
        let residual = beam().residual_flexibility_stiffness(n);
        let cases = [
            (tip(n, ""), beam().one_point_deflection(LOAD, n, with)),
            (
                tip(n, "*TRANSVERSE SHEAR STIFFNESS\n, , 0.0\n"),
                beam().one_point_deflection(LOAD, n, without),
            ),
            (
                tip(n, &format!("*TRANSVERSE SHEAR STIFFNESS\n{residual:?}, , 0.0\n")),
                beam().deflection(LOAD),
            ),
        ];
        for (off, (found, exact)) in off.iter_mut().zip(cases) {
            off.push((found / exact - 1.0).abs());
        }
    }
    let names =
        ["with the slenderness factor", "without it", "with the residual bending flexibility"];
    for (name, off) in names.iter().zip(off) {
        record.at_most(format!("{name}, 1, 4, 12, 24 elements, largest error"), worst(off), 1e-9);
    }
}
