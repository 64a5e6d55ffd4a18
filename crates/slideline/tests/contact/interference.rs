//! `*CONTACT INTERFERENCE`: overclosures that are taken away over a step.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::two_blocks::{ALL, left_and_whole, mesh, solved};
use std::fmt::Write as _;

/// What overlaps between the rings [L].
const OVERLAP: f64 = 2e-5;
const MODULUS: f64 = 1000.0;
const POISSON: f64 = 0.3;

/// A ring of CAX8 between two radii, one element high.
fn ring(deck: &mut String, base: usize, [inner, outer]: [f64; 2], cells: usize) {
    let node = |i: usize, j: usize| base + 1 + i + (2 * cells + 1) * j;
    deck.push_str("*NODE, NSET=ALL\n");
    for j in 0..3 {
        for i in 0..=2 * cells {
            let r = inner + (outer - inner) * i as f64 / (2 * cells) as f64;
            let _ = writeln!(deck, "{}, {r:?}, {:?}", node(i, j), 0.25 * j as f64);
        }
    }
    let _ = writeln!(deck, "*ELEMENT, TYPE=CAX8, ELSET=RINGS");
    for k in 0..cells {
        let at = |a: usize, b: usize| node(2 * k + a, b);
        let _ = writeln!(
            deck,
            "{}, {}, {}, {}, {}, {}, {}, {}, {}",
            base + 1 + k,
            at(0, 0),
            at(2, 0),
            at(2, 2),
            at(0, 2),
            at(1, 0),
            at(2, 1),
            at(1, 2),
            at(0, 1)
        );
    }
}

/// A ring of radii 1 and 2 in one of 2 and 3, in plane strain, four increments.
fn press_fit(kind: &str, of_step: &str) -> String {
    let mut deck = String::new();
    ring(&mut deck, 0, [1.0, 2.0 + OVERLAP], 4);
    ring(&mut deck, 1000, [2.0, 3.0], 4);
    let _ = write!(
        deck,
        "*SOLID SECTION, ELSET=RINGS, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n{MODULUS}, {POISSON}\n\
         *SURFACE, NAME=INNER\n4, S2\n*SURFACE, NAME=OUTER\n1001, S4\n\
         *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE={kind}\nINNER, OUTER\n\
         *STEP\n*STATIC, DIRECT\n0.25, 1.0\n*BOUNDARY\nALL, 2, 2\n{of_step}*END STEP\n"
    );
    deck
}

/// Lame's pressure of the press fit: the elastic constants are those of plane strain.
fn lame() -> f64 {
    let modulus = MODULUS / (1.0 - POISSON * POISSON);
    let [a, b, c] = [1.0_f64, 2.0, 3.0];
    let ratio =
        |inner: f64, outer: f64| (outer * outer + inner * inner) / (outer * outer - inner * inner);
    modulus * OVERLAP / (b * (ratio(a, b) + ratio(b, c)))
}

/// The mean pressure over the face, of the last increment.
fn pressure(kind: &str, of_step: &str) -> f64 {
    let curve = solved(&press_fit(kind, of_step));
    // no friction: energies are those of a linear structure
    assert!(curve.balance < 1e-8, "{kind}: energies leave {}", curve.balance);
    let rows = &curve.contact;
    let area: f64 = rows.iter().map(|row| row.area).sum();
    rows.iter().map(|row| row.area * row.pressure).sum::<f64>() / area
}

/// Requirement: rings that overlap are pressed apart to Lame's pressure, whether at once, over the
/// step by SHRINK or from a given interference. Tolerance: 1e-3, the mesh; the ways differ by
/// rounding.
#[test]
fn a_press_fit_has_the_pressure_of_lame() {
    for kind in ["NODE TO SURFACE", "SURFACE TO SURFACE"] {
        let ways = [
            String::new(),
            "*CONTACT INTERFERENCE, SHRINK\nINNER, OUTER\n".to_owned(),
            format!("*CONTACT INTERFERENCE\nINNER, OUTER, {OVERLAP}\n"),
        ];
        let found = ways.map(|way| pressure(kind, &way));
        assert!((found[0] / lame() - 1.0).abs() < 1e-3, "{kind}: {} for {}", found[0], lame());
        for other in &found[1..] {
            assert!((other / found[0] - 1.0).abs() < 1e-9, "{kind}: {found:?}");
        }
    }
}

/// Requirement: columns that overlap by d carry p = E d/2 in the end and the part of it that the time
/// of the step has come to before; with an amplitude as it says. In the plane and in space, at nodes
/// and over faces. Tolerance: what the overlap does to the length of the columns, 1e-4.
#[test]
fn the_overlap_goes_with_time() {
    let overlap = 1e-4;
    let steps = [
        ("*CONTACT INTERFERENCE, SHRINK\nUPPER, LOWER\n", [0.25, 0.5, 0.75, 1.0]),
        ("*CONTACT INTERFERENCE, AMPLITUDE=A\nUPPER, LOWER, 1.0E-4\n", [0.5, 1.0, 1.0, 1.0]),
        ("*CONTACT INTERFERENCE, SHRINK, AMPLITUDE=A\nUPPER, LOWER\n", [0.5, 1.0, 1.0, 1.0]),
    ];
    for ((in_space, kind), (card, parts)) in
        ALL.into_iter().flat_map(|case| steps.map(|step| (case, step)))
    {
        let up = if in_space { 3 } else { 2 };
        let deck = format!(
            "{}*AMPLITUDE, NAME=A\n0.0, 1.0, 0.5, 0.0, 1.0, 0.0\n*SURFACE INTERACTION, NAME=I\n\
             *CONTACT PAIR, INTERACTION=I, TYPE={kind}\nUPPER, LOWER\n*STEP\n*STATIC, DIRECT\n\
             0.25, 1.0\n*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\n{card}*END STEP\n",
            mesh(in_space, -overlap)
        );
        let curve = solved(&deck);
        for (force, part) in curve.force.iter().zip(parts) {
            let wanted = 0.5 * 1000.0 * overlap * part;
            let off = force[up - 1] / wanted - 1.0;
            assert!(off.abs() < 1e-3, "{kind} {in_space} {card}: {force:?} for {wanted}");
        }
        assert!(curve.balance < 1e-8, "{kind} {in_space} {card}: {}", curve.balance);
    }
}

/// Requirement: what an amplitude leaves of the overlap is taken away at the start of the next step, with the
/// work that this takes: p = E d/2 in the end, and energies balance. Tolerance: as above.
#[test]
fn what_a_step_leaves_goes_with_the_next() {
    let overlap = 1e-4;
    for ((in_space, kind), shrink) in ALL.into_iter().flat_map(|case| [(case, true), (case, false)])
    {
        let up = if in_space { 3 } else { 2 };
        let card = if shrink { ", SHRINK" } else { "" };
        let value = if shrink { "" } else { ", 1.0E-4" };
        let deck = format!(
            "{}*AMPLITUDE, NAME=A\n0.0, 1.0, 1.0, 0.4\n*SURFACE INTERACTION, NAME=I\n\
             *CONTACT PAIR, INTERACTION=I, TYPE={kind}\nUPPER, LOWER\n*STEP\n*STATIC, DIRECT\n\
             0.25, 1.0\n*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, {up}\n\
             *CONTACT INTERFERENCE{card}, AMPLITUDE=A\nUPPER, LOWER{value}\n*END STEP\n\
             *STEP\n*STATIC, DIRECT\n0.5, 1.0\n*END STEP\n",
            mesh(in_space, -overlap)
        );
        let curve = solved(&deck);
        for (force, part) in curve.force.iter().zip([0.15, 0.3, 0.45, 0.6, 1.0, 1.0]) {
            let off = force[up - 1] / (500.0 * overlap * part) - 1.0;
            assert!(off.abs() < 1e-3, "{kind} {in_space} {shrink}: {force:?}, {part}");
        }
        assert!(curve.balance < 1e-8, "{kind} {in_space} {shrink}: {}", curve.balance);
    }
}

/// Requirement: left while the overlap goes and continued, a job ends where it would have: to the
/// bit.
#[test]
fn a_continued_job_knows_what_is_allowed() {
    let deck = press_fit("SURFACE TO SURFACE", "*CONTACT INTERFERENCE, SHRINK\nINNER, OUTER\n");
    let [left, whole] = left_and_whole("shrunk", &deck, 2);
    assert_eq!(left, whole);
}
