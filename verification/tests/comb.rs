//! The comb: six columns over the crest of a circle or a plane, an exact test
//! of contact force and friction onset.
//!
//! ```text
//!   ||  ||  ||  ||  ||  ||   columns of k = 1e6 N/m, tips 10 mm apart
//!     .--.                   crest 20 um above the tips
//!    (    )  -> 10 mm an increment
//! ```
//!
//! Requirement and numbers: verification section 4. Tolerance 1e-9: every
//! column is a linear spring, nothing is discretised.

use slideline_theory::{ExponentialLaw, closed::comb};
use slideline_verification::{Curve, run};

const STIFFNESS: f64 = 1e6;
const RISE: f64 = 2e-5;
const TOLERANCE: f64 = 1e-9;

struct Comb {
    /// Circle of 5 mm; a plane if not.
    circle: bool,
    softened: bool,
    mu: f64,
    stick: &'static str,
    onset: &'static str,
    /// Start of the reference node and its way [m].
    start: f64,
    way: f64,
    increments: usize,
    /// A second step lifts the tool off.
    lift: bool,
}

const FORWARD: Comb = Comb {
    circle: true,
    softened: false,
    mu: 0.3,
    stick: "",
    onset: "IMMEDIATE",
    start: -0.01,
    way: 0.06,
    increments: 6,
    lift: false,
};

impl Comb {
    fn run(&self) -> Curve {
        run(&self.deck()).unwrap()
    }

    fn deck(&self) -> String {
        let law = if self.softened { "*SURFACE CONTACT, SOFTENED\n1.0E-5, 4.8E6\n" } else { "" };
        let y = -5e-3 + RISE;
        let x = self.start;
        let surface = if self.circle {
            format!(
                "START, {:?}, {y:?}\nCIRCL, {x:?}, {RISE:?}, {x:?}, {y:?}\n\
                 CIRCL, {:?}, {y:?}, {x:?}, {y:?}",
                x - 5e-3,
                x + 5e-3
            )
        } else {
            format!("START, -1.0, {RISE:?}\nLINE, 1.0, {RISE:?}")
        };
        let dt = 1.0 / self.increments as f64;
        let controls = "*CONTROLS, PARAMETERS=FIELD\n1.0E-10\n*END STEP\n";
        let lift =
            format!("*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n999, 2, 2, -1.0E-3\n{controls}");
        format!(
            "*HEADING\ncomb\n*NODE, NSET=TIPS\n1, 0.0, 0.0\n6, 50.0E-3, 0.0\n*NGEN, NSET=TIPS\n\
             1, 6, 1\n*NODE, NSET=ROOTS\n11, 0.0, 0.1\n16, 50.0E-3, 0.1\n*NGEN, NSET=ROOTS\n\
             11, 16, 1\n*NODE\n999, {x:?}, {y:?}\n*ELEMENT, TYPE=B21, ELSET=COLUMNS\n1, 11, 1\n\
             *ELGEN, ELSET=COLUMNS\n1, 6, 1, 1\n\
             *BEAM SECTION, ELSET=COLUMNS, SECTION=RECT, MATERIAL=M\n0.01, 0.01\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1.0E9, 0.3\n\
             *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\n{surface}\n\
             *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n101, 1, 2, 999\n*ELGEN, ELSET=CONTACT\n\
             101, 5, 1, 1\n*INTERFACE, ELSET=CONTACT\n25.0E-3\n*FRICTION{}\n{:?}\n{law}\
             *CONTACT CONTROLS, FRICTION ONSET={}\n\
             *STEP, NLGEOM\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n*BOUNDARY\nROOTS, ENCASTRE\n\
             TIPS, 1\nTIPS, 6\n999, 2\n999, 6\n999, 1, 1, {:?}\n{controls}{}",
            self.stick,
            self.mu,
            self.onset,
            self.way,
            if self.lift { &lift } else { "" },
        )
    }
}

fn normal_force(softened: bool, end: bool) -> f64 {
    let area = if end { 1.25e-4 } else { 2.5e-4 };
    if softened {
        comb::softened_force(STIFFNESS, RISE, area, &ExponentialLaw::diehl()).unwrap().0
    } else {
        comb::hard_force(STIFFNESS, RISE)
    }
}

fn close(found: f64, exact: f64, scale: f64, what: &str) {
    assert!((found - exact).abs() <= TOLERANCE * scale, "{what}: {found:?}, exact {exact:?}");
}

/// Every increment ends exactly under a new tip, so every contact is a first
/// contact: the decisive case for the onset.
#[test]
fn first_contacts_in_every_increment() {
    for softened in [false, true] {
        for stick in ["", ", LAGRANGE"] {
            for (onset, mu) in
                [("IMMEDIATE", 0.3), ("DELAYED", 0.3), ("MATFRU", 0.3), ("IMMEDIATE", 0.0)]
            {
                let comb = Comb { softened, onset, mu, stick, ..FORWARD };
                let curve = comb.run();
                let (side, up) = (curve.reaction(999, 1), curve.reaction(999, 2));
                assert_eq!(up.len(), 6);
                for k in 0..6 {
                    let normal = normal_force(softened, k == 0 || k == 5);
                    let drag = if onset == "IMMEDIATE" { mu * normal } else { 0.0 };
                    let what = format!("softened {softened}{stick} {onset} mu {mu} tip {k}");
                    close(up[k], normal, normal, &what);
                    close(side[k], drag, normal, &what);
                }
            }
        }
    }
}

/// Requirement: reversed motion flips the sign of friction exactly.
#[test]
fn reversed_motion() {
    for softened in [false, true] {
        let there = Comb { softened, ..FORWARD }.run().reaction(999, 1);
        let back = Comb { softened, start: 0.06, way: -0.06, ..FORWARD }.run().reaction(999, 1);
        for k in 0..6 {
            close(back[5 - k], -there[k], there[k].abs(), "reversed");
        }
    }
}

/// Requirement: with half the pitch every second increment is open, and a tip
/// is never closed twice running: no friction but under IMMEDIATE.
#[test]
fn half_pitch() {
    for onset in ["IMMEDIATE", "DELAYED", "MATFRU"] {
        let curve = Comb { increments: 12, onset, ..FORWARD }.run();
        let (side, up) = (curve.reaction(999, 1), curve.reaction(999, 2));
        for k in 0..12 {
            let normal = if k % 2 == 1 { 20.0 } else { 0.0 };
            let drag = if onset == "IMMEDIATE" { 0.3 * normal } else { 0.0 };
            close(up[k], normal, 20.0, &format!("{onset} increment {}", k + 1));
            close(side[k], drag, 20.0, &format!("{onset} increment {}", k + 1));
        }
    }
}

/// Requirement: a plane in contact from the first increment on: five times
/// mu N under IMMEDIATE, nothing and then four times mu N under the other two,
/// nothing once it is lifted off.
#[test]
fn flat_drag() {
    for softened in [false, true] {
        for stick in ["", ", LAGRANGE"] {
            for onset in ["IMMEDIATE", "DELAYED", "MATFRU"] {
                let curve = Comb {
                    circle: false,
                    softened,
                    stick,
                    onset,
                    start: 0.0,
                    increments: 5,
                    way: 5e-3,
                    lift: true,
                    ..FORWARD
                }
                .run();
                let normal =
                    4.0 * normal_force(softened, false) + 2.0 * normal_force(softened, true);
                let (side, up) = (curve.reaction(999, 1), curve.reaction(999, 2));
                for k in 0..6 {
                    let in_contact = if k < 5 { normal } else { 0.0 };
                    let called = k > 0 || onset == "IMMEDIATE";
                    let drag = if called { 0.3 * in_contact } else { 0.0 };
                    let what = format!("softened {softened}{stick} {onset} increment {}", k + 1);
                    close(up[k], in_contact, normal, &what);
                    close(side[k], drag, normal, &what);
                }
            }
        }
    }
}
