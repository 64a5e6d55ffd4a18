//! Rigid parts that contact alone holds, under moments.
//!
//! ```text
//!     O=====================      an arm on a hinge is pressed by a moment upon a pin; the model has no elastic part,
//!     hinge        (O) pin        and no stiffness but that of its contact
//! ```
//!
//! Source: docs/theory.md section 8.3; equilibrium of the arm.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use crate::noise::{folder, run_in};
use slideline::{Job, ReadOptions, Status};
use std::fmt::Write;

/// Elements of the arm, from x = 1 to 14, y = 0.5 to 1.1.
const COUNT: usize = 30;

/// The arm in a unit of length; the pin turns about a hinge of its own in the second step.
fn arm(unit: f64) -> String {
    let mut text = "*NODE\n".to_owned();
    for k in 0..=COUNT {
        let x = unit * (1.0 + 13.0 * k as f64 / COUNT as f64);
        let (low, high) = (0.5 * unit, 1.1 * unit);
        writeln!(text, "{}, {x:?}, {low:?}\n{}, {x:?}, {high:?}", 2 * k + 1, 2 * k + 2).unwrap();
    }
    text += "*ELEMENT, TYPE=CPE4, ELSET=ARM\n";
    for k in 1..=COUNT {
        let n = 2 * k - 1;
        writeln!(text, "{k}, {n}, {}, {}, {}", n + 2, n + 3, n + 1).unwrap();
    }
    let at = |x: f64| format!("{:?}", unit * x);
    let [right, middle, left, up, down] = [11.5, 11.0, 10.5, 0.5, -0.5].map(at);
    let (zero, pin, moment) = ("0.", at(8.0), at(-5.0));
    format!(
        "{text}*NODE, NSET=PIN\n9001, {pin}, 0.\n*NODE, NSET=HINGE\n9002, 0., 0.\n*SURFACE, NAME=FOOT\nARM, S1\n\
         *SURFACE, NAME=ROUND, TYPE=SEGMENTS\nSTART, {right}, {zero}\nCIRCL, {middle}, {down}, {middle}, {zero}\n\
         CIRCL, {left}, {zero}, {middle}, {zero}\nCIRCL, {middle}, {up}, {middle}, {zero}\n\
         CIRCL, {right}, {zero}, {middle}, {zero}\n*RIGID BODY, REF NODE=9001, ANALYTICAL SURFACE=ROUND\n\
         *RIGID BODY, REF NODE=9002, ELSET=ARM\n*SOLID SECTION, ELSET=ARM, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n1e4, 0.3\n\
         *SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nFOOT, ROUND\n*BOUNDARY\n\
         PIN, 1, 2\nHINGE, 1, 2\n*STEP, NLGEOM, INC=900\n*STATIC\n0.5, 1.\n*BOUNDARY\nPIN, 6, 6\n*CLOAD\n\
         HINGE, 6, {moment}\n*NODE PRINT, NSET=PIN\nU, RF\n*END STEP\n"
    )
}

/// Requirement: the pin carries the moment over its distance from the hinge, in as many increments and iterations
/// whatever the unit of length.
#[test]
fn an_arm_on_a_pin_knows_no_units() {
    let of = |power: i32| {
        let unit = 10.0_f64.powi(power);
        let place = folder(&format!("rigid_arm_{power}"));
        let outcome = run_in(&place, &Job::read_text("arm", &arm(unit), &ReadOptions::default()));
        assert_eq!(outcome.status, Status::Completed, "{power} {:?}", outcome.diagnostics);
        let table = std::fs::read_to_string(place.join("arm.pair.csv")).unwrap();
        let heads: Vec<&str> = table.lines().next().unwrap().split(',').collect();
        let last: Vec<&str> = table.lines().last().unwrap().split(',').collect();
        let value = |name: &str| -> f64 {
            last[heads.iter().position(|own| *own == name).unwrap()].parse().unwrap()
        };
        assert!((value("moment") / unit - 5.0).abs() < 1e-6, "{power} {}", value("moment"));
        let steps = std::fs::read_to_string(place.join("arm.sta")).unwrap();
        let told = std::fs::read_to_string(place.join("arm.msg")).unwrap();
        (steps.lines().count(), told.matches("  ITERATION ").count())
    };
    let usual = of(0);
    assert!(usual.1 <= 8, "{usual:?}");
    for power in [-4, -3, -2, 2, 3] {
        assert_eq!(of(power), usual, "{power}");
    }
}
