//! `*SURFACE BEHAVIOR, NO SEPARATION`: what has closed carries tension.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::two_blocks::{ALL, Curve, left_and_whole, mesh, solved};
use std::fmt::Write as _;

/// Two blocks under laws, with a step of two increments for every motion of the top along the gap
/// and across it.
fn deck((in_space, kind): (bool, &str), gap: f64, laws: &str, motions: &[[f64; 2]]) -> String {
    let up = if in_space { 3 } else { 2 };
    let mut deck = mesh(in_space, gap);
    let _ = write!(
        deck,
        "*SURFACE INTERACTION, NAME=I\n{laws}*CONTACT PAIR, INTERACTION=I, TYPE={kind}\n\
         UPPER, LOWER\n"
    );
    for [along, across] in motions {
        let still = if in_space { "HIGH, 2, 2\n" } else { "" };
        let _ = write!(
            deck,
            "*STEP\n*STATIC, DIRECT\n0.5, 1.0\n*BOUNDARY\nLOW, 1, {up}\nHIGH, 1, 1, {across:?}\n\
             {still}HIGH, {up}, {up}, {along:?}\n*END STEP\n"
        );
    }
    deck
}

fn along(curve: &Curve, in_space: bool) -> f64 {
    curve.force.last().unwrap()[if in_space { 2 } else { 1 }]
}

const HARD: &str = "*SURFACE BEHAVIOR, NO SEPARATION\n";
const LINEAR: &str = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR, NO SEPARATION\n1.0E4\n";

/// Requirement: pressed by 0.01 and then pulled by 0.02, blocks of stiffness E A/L = 1000 each that
/// do not separate are a bar: N = d/(1/1000 + 1/1000 + 1/(K A)), 1/K = 0 for hard contact. At nodes
/// and over faces, in the plane and in space. Tolerance: rounding.
#[test]
fn pulled_blocks_are_a_bar() {
    for (case, (laws, compliance)) in
        ALL.into_iter().flat_map(|case| [(case, (HARD, 0.0)), (case, (LINEAR, 1e-4))])
    {
        let curve = solved(&deck(case, 0.0, laws, &[[-0.01, 0.0], [0.02, 0.0]]));
        let wanted = -0.02 / (2e-3 + compliance);
        let force = along(&curve, case.0);
        assert!((force - wanted).abs() < 1e-7, "{case:?} {laws}: {force} for {wanted}");
        assert!(curve.imbalance < 1e-12, "{case:?}: {}", curve.imbalance);
        assert!(curve.balance < 1e-6, "{case:?} {laws}: energies leave {}", curve.balance);
    }
}

/// Requirement: what touches when the job begins is closed, so that a pull alone finds the bar; what
/// has a gap and never closes is not; without NO SEPARATION nothing is pulled.
#[test]
fn what_touches_at_the_start_is_closed() {
    for case in ALL {
        let bar = along(&solved(&deck(case, 0.0, HARD, &[[0.02, 0.0]])), case.0);
        assert!((bar + 10.0).abs() < 1e-7, "{case:?}: {bar}");
        let apart = along(&solved(&deck(case, 1e-3, HARD, &[[0.02, 0.0]])), case.0);
        assert_eq!(apart, 0.0, "{case:?}: a gap");
        let plain = along(&solved(&deck(case, 0.0, "", &[[-0.01, 0.0], [0.02, 0.0]])), case.0);
        assert_eq!(plain, 0.0, "{case:?}: without NO SEPARATION");
    }
}

/// Requirement: with ROUGH blocks that do not separate are one under tension too: pulled and sheared
/// they answer as if tied. Coulomb's friction has nothing to hold by there. Tolerance: rounding.
#[test]
fn rough_blocks_are_tied() {
    for case in ALL {
        let motions = [[0.02, 0.0], [0.02, 1e-3]];
        let rough = solved(&deck(case, 0.0, &format!("{HARD}*FRICTION, ROUGH\n"), &motions));
        let slides = solved(&deck(case, 0.0, &format!("{HARD}*FRICTION\n0.5\n"), &motions));
        let shear = |curve: &Curve| curve.force.last().unwrap()[0];
        let tied = tied_shear(case.0, 1e-3);
        let own = shear(&rough);
        assert!((own - tied).abs() < 1e-7 * tied.abs(), "{case:?}: {own} for {tied}");
        assert!(shear(&slides).abs() < 0.05 * tied.abs(), "{case:?}: {}", shear(&slides));
    }
}

/// Requirement: left while it is pulled and continued, a job knows what has closed: to the bit.
#[test]
fn a_continued_job_stays_closed() {
    for (number, case) in ALL.into_iter().enumerate() {
        let deck = deck(case, 0.0, HARD, &[[-0.01, 0.0], [0.02, 0.0]]);
        let [left, whole] = left_and_whole(&format!("pulled-{number}"), &deck, 3);
        assert_eq!(left, whole, "{case:?}");
    }
}

/// Shear force through two blocks of four-node elements that share their nodes, the ends held from
/// turning, small strain: in series G A each, and the bending of full integration. The middle nodes
/// move as the stiffness of one element says; by symmetry about the middle both columns have the
/// same shear and opposite bending: u = d/2, w = -+ a.
fn tied_shear(in_space: bool, d: f64) -> f64 {
    // Element [0,1]^2, base held: top moves by (u, -+a): strains of the bilinear field
    //   ux = u eta, uy = a (1 - 2 xi) eta  (xi, eta in 0..1)
    //   exx = 0, eyy = a (1 - 2 xi), gxy = u - 2 a eta
    // energy of both with E = 1000, G = 500: 2 * 1/2 [E a^2/3 + G (u^2 - 2 a u + 4 a^2/3)];
    // the upper element is the lower one turned by half a turn about the middle, u = d/2 each.
    // C3D8 takes the mean change of volume, which the bending of this element has none of: with
    // nu = 0 the deviator of a strain along one axis holds two thirds of its energy.
    let part = if in_space { 2.0 / 3.0 } else { 1.0 };
    let (e, g, u) = (part * 1000.0, 500.0, 0.5 * d);
    // least for a: 2 E a/3 + G (8 a/3 - 2 u) = 0
    let a = 2.0 * g * u / (2.0 * e / 3.0 + 8.0 * g / 3.0);
    // force on the upper block: minus d(energy)/dd, with u = d/2
    -g * (u - a)
}
