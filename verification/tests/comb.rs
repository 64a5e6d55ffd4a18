//! The comb: six columns over the crest of a circle or a plane, an exact test
//! of contact force and friction onset.
//!
//! ```text
//!   ||  ||  ||  ||  ||  ||   columns of k = 1e6 N/m, tips 10 mm apart
//!     .--.                   crest 20 um above the tips
//!    (    )  -> 10 mm an increment
//! ```

use slideline::output::plot::{Axis, Mark, Series};
use slideline_theory::{ExponentialLaw, closed::comb};
use slideline_verification::{Claim, Curve, Group, Record, largest_difference, run, worst};

const SOURCE: &str = "Linear springs against hard contact or the exponential law; the table of \
                      friction onset (derived).";
const EXACT: &str = "1e-9 of the normal force: every column is a linear spring, nothing is \
                     discretised.";

pub const GROUP: Group = Group {
    file: "comb",
    claims: &[
        Claim {
            name: "first_contacts_in_every_increment",
            requirement: "Every increment ends exactly under a new tip, so that every contact is a \
                          first contact: mu N under IMMEDIATE, no friction under DELAYED and \
                          MATFRU, for hard and softened contact, inner and end tips.",
            source: SOURCE,
            tolerance: EXACT,
            measure: first_contacts_in_every_increment,
        },
        Claim {
            name: "reversed_motion",
            requirement: "Reversed motion flips the sign of friction exactly.",
            source: SOURCE,
            tolerance: EXACT,
            measure: reversed_motion,
        },
        Claim {
            name: "half_pitch",
            requirement: "With half the pitch every second increment is open, and a tip is never \
                          closed twice running: no friction but under IMMEDIATE, none in the open \
                          increments.",
            source: SOURCE,
            tolerance: EXACT,
            measure: half_pitch,
        },
        Claim {
            name: "flat_drag",
            requirement: "A plane in contact from the first increment on: five times mu N under \
                          IMMEDIATE, nothing and then four times mu N under DELAYED and MATFRU, \
                          nothing once it is lifted off.",
            source: SOURCE,
            tolerance: EXACT,
            measure: flat_drag,
        },
    ],
};

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

/// Largest difference of both forces [of the normal force].
fn off(curve: &Curve, [side, up]: [&[f64]; 2], scale: f64) -> f64 {
    let [fx, fy] = [1, 2].map(|dof| curve.reaction(999, dof));
    worst([largest_difference(&fx, side), largest_difference(&fy, up)]) / scale
}

fn law(softened: bool) -> &'static str {
    if softened { "softened" } else { "hard" }
}

fn first_contacts_in_every_increment(record: &mut Record) {
    let mut drags = Vec::new();
    for softened in [false, true] {
        let up: Vec<f64> = (0..6).map(|k| normal_force(softened, k == 0 || k == 5)).collect();
        for stick in ["", ", LAGRANGE"] {
            for (onset, mu) in
                [("IMMEDIATE", 0.3), ("DELAYED", 0.3), ("MATFRU", 0.3), ("IMMEDIATE", 0.0)]
            {
                let curve = Comb { softened, onset, mu, stick, ..FORWARD }.run();
                let called = onset == "IMMEDIATE";
                let side: Vec<f64> =
                    up.iter().map(|normal| if called { mu * normal } else { 0.0 }).collect();
                let what = format!("{}{stick}, {onset}, mu {mu}", law(softened));
                record.at_most(what, off(&curve, [&side, &up], up[0]), TOLERANCE);
                if stick.is_empty() && mu > 0.0 {
                    drags.push(drag(&format!("{}, {onset}", law(softened)), &curve));
                }
            }
        }
    }
    let (x, y) = (Axis::linear("increment"), Axis::linear("RF1 (N)"));
    record.chart("Friction of first contacts", x, y, drags);
}

fn drag(name: &str, curve: &Curve) -> Series {
    let points = (1..).zip(curve.reaction(999, 1)).map(|(k, force)| [f64::from(k), force]);
    let mark = match name {
        name if name.ends_with("DELAYED") => Mark::Dashed,
        name if name.ends_with("MATFRU") => Mark::Guide,
        _ => Mark::Curve,
    };
    Series { name: name.to_owned(), points: points.collect(), mark, colour: 0 }
}

fn reversed_motion(record: &mut Record) {
    for softened in [false, true] {
        let there = Comb { softened, ..FORWARD }.run().reaction(999, 1);
        let back = Comb { softened, start: 0.06, way: -0.06, ..FORWARD }.run().reaction(999, 1);
        let turned: Vec<f64> = back.iter().rev().map(|force| -force).collect();
        let off = largest_difference(&there, &turned) / there[0];
        record.at_most(format!("{}, forward against backward", law(softened)), off, TOLERANCE);
    }
}

fn half_pitch(record: &mut Record) {
    let up: Vec<f64> = (0..12).map(|k| if k % 2 == 1 { 20.0 } else { 0.0 }).collect();
    for onset in ["IMMEDIATE", "DELAYED", "MATFRU"] {
        let curve = Comb { increments: 12, onset, ..FORWARD }.run();
        let mu = if onset == "IMMEDIATE" { 0.3 } else { 0.0 };
        let side: Vec<f64> = up.iter().map(|normal| mu * normal).collect();
        record.at_most(onset, off(&curve, [&side, &up], 20.0), TOLERANCE);
    }
}

fn flat_drag(record: &mut Record) {
    let mut drags = Vec::new();
    for softened in [false, true] {
        let normal = 4.0 * normal_force(softened, false) + 2.0 * normal_force(softened, true);
        let up: Vec<f64> = (0..6).map(|k| if k < 5 { normal } else { 0.0 }).collect();
        for stick in ["", ", LAGRANGE"] {
            for onset in ["IMMEDIATE", "DELAYED", "MATFRU"] {
                let comb = Comb {
                    circle: false,
                    softened,
                    stick,
                    onset,
                    start: 0.0,
                    increments: 5,
                    way: 5e-3,
                    lift: true,
                    ..FORWARD
                };
                let curve = comb.run();
                let called = |k: usize| k > 0 || onset == "IMMEDIATE";
                let side: Vec<f64> =
                    (0..6).map(|k| if called(k) { 0.3 * up[k] } else { 0.0 }).collect();
                let what = format!("{}{stick}, {onset}", law(softened));
                record.at_most(what, off(&curve, [&side, &up], normal), TOLERANCE);
                if stick.is_empty() {
                    drags.push(drag(&format!("{}, {onset}", law(softened)), &curve));
                }
            }
        }
    }
    let (x, y) = (Axis::linear("increment, the last lifts off"), Axis::linear("RF1 (N)"));
    record.chart("Drag of a plane", x, y, drags);
}
