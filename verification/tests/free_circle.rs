//! A rigid circle pushed by a force, held by contact and a spring only.
//!
//! ```text
//!     ||   column, k = 1e6 N/m
//!    .--.  gap 10 um
//!   (  99 )  <- CLOAD up
//!     <     spring to ground, 2e5 N/m
//! ```
//!
//! Requirement: the free reference node goes with the spring alone until the
//! gap is closed, then with spring and column. Source: equilibrium of two
//! linear springs (derived). Tolerance 1e-9: nothing is discretised.

use slideline_verification::run;

const COLUMN: f64 = 1e6;
const SPRING: f64 = 2e5;
const GAP: f64 = 1e-5;

#[test]
fn spring_then_spring_and_column() {
    let load = 20.0;
    let y = -5e-3 - GAP;
    let deck = format!(
        "*HEADING\nfree circle\n*NODE\n1, 0.0, 0.0\n2, 0.05, 0.0\n11, 0.0, 0.1\n12, 0.05, 0.1\n\
         99, 0.0, {y:?}\n*ELEMENT, TYPE=B21, ELSET=COLUMNS\n1, 11, 1\n2, 12, 2\n\
         *BEAM SECTION, ELSET=COLUMNS, SECTION=RECT, MATERIAL=M\n0.01, 0.01\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1.0E9, 0.3\n\
         *ELEMENT, TYPE=SPRING1, ELSET=GROUND\n21, 99\n*SPRING, ELSET=GROUND\n2\n{SPRING:?}\n\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -5.0E-3, {y:?}\n\
         CIRCL, 0.0, {:?}, 0.0, {y:?}\nCIRCL, 5.0E-3, {y:?}, 0.0, {y:?}\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n31, 1, 2, 99\n*INTERFACE, ELSET=CONTACT\n0.025\n\
         *STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n11, ENCASTRE\n12, ENCASTRE\n\
         1, 1\n1, 6\n2, 1\n2, 6\n99, 1\n99, 6\n*CLOAD\n99, 2, {load:?}\n\
         *CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n",
        -GAP
    );
    let curve = run(&deck).unwrap();
    let (u, tip) = (curve.displacement(99, 2), curve.displacement(1, 2));
    for (k, row) in curve.rows.iter().enumerate() {
        let force = load * row.time;
        let alone = force / SPRING;
        let exact = if alone <= GAP { alone } else { (force + COLUMN * GAP) / (SPRING + COLUMN) };
        assert!((u[k] - exact).abs() < 1e-9 * GAP, "{force}: {} {exact}", u[k]);
        assert!((tip[k] - (exact - GAP).max(0.0)).abs() < 1e-9 * GAP, "{force}: {}", tip[k]);
    }
}
