//! A rigid circle pushed by a force, held by contact and a spring only.
//!
//! ```text
//!     ||   column, k = 1e6 N/m
//!    .--.  gap 10 um
//!   (  99 )  <- CLOAD up
//!     <     spring to ground, 2e5 N/m
//! ```

use slideline::output::plot::Axis;
use slideline_verification::{Claim, Group, Record, run, series, worst};

pub const GROUP: Group = Group {
    file: "free_circle",
    claims: &[Claim {
        name: "spring_then_spring_and_column",
        requirement: "The free reference node goes with the spring alone until the gap is closed, \
                      then with spring and column.",
        source: "Equilibrium of two linear springs (derived).",
        tolerance: "1e-9 of the gap: nothing is discretised.",
        measure: spring_then_spring_and_column,
    }],
};

const COLUMN: f64 = 1e6;
const SPRING: f64 = 2e5;
const GAP: f64 = 1e-5;
const LOAD: f64 = 20.0;

fn deck() -> String {
    let y = -5e-3 - GAP;
    format!(
        "*HEADING\nfree circle\n*NODE\n1, 0.0, 0.0\n2, 0.05, 0.0\n11, 0.0, 0.1\n12, 0.05, 0.1\n\
         99, 0.0, {y:?}\n*ELEMENT, TYPE=B21, ELSET=COLUMNS\n1, 11, 1\n2, 12, 2\n\
         *BEAM SECTION, ELSET=COLUMNS, SECTION=RECT, MATERIAL=M\n0.01, 0.01\n\
         *MATERIAL, NAME=M\n*ELASTIC\n1.0E9, 0.3\n\
         *ELEMENT, TYPE=SPRING1, ELSET=GROUND\n21, 99\n*SPRING, ELSET=GROUND\n2\n{SPRING:?}\n\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -5.0E-3, {y:?}\n\
         CIRCL, 0.0, {:?}, 0.0, {y:?}\nCIRCL, 5.0E-3, {y:?}, 0.0, {y:?}\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n31, 1, 2, 99\n*INTERFACE, ELSET=CONTACT\n0.025\n\
         *STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n11, ENCASTRE\n12, ENCASTRE\n\
         1, 1\n1, 6\n2, 1\n2, 6\n99, 1\n99, 6\n*CLOAD\n99, 2, {LOAD:?}\n\
         *CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n",
        -GAP
    )
}

fn spring_then_spring_and_column(record: &mut Record) {
    let curve = run(&deck()).unwrap();
    let (u, tip) = (curve.displacement(99, 2), curve.displacement(1, 2));
    let loads: Vec<f64> = curve.rows.iter().map(|row| LOAD * row.time).collect();
    let exact: Vec<f64> = loads
        .iter()
        .map(|load| {
            let alone = load / SPRING;
            if alone <= GAP { alone } else { (load + COLUMN * GAP) / (SPRING + COLUMN) }
        })
        .collect();
    let circle = u.iter().zip(&exact).map(|(found, exact)| (found - exact).abs() / GAP);
    record.at_most("circle, largest error (of the gap)", worst(circle), 1e-9);
    let column = tip.iter().zip(&exact).map(|(tip, exact)| tip - (exact - GAP).max(0.0));
    let column = column.map(|off| off.abs() / GAP);
    record.at_most("tip of the column, largest error (of the gap)", worst(column), 1e-9);
    let (x, y) = (Axis::linear("load (N)"), Axis::linear("U2 (m)"));
    let curves = vec![series(&loads, ("circle", &u)), series(&loads, ("tip of the column", &tip))];
    record.chart("A circle held by a spring and a column", x, y, curves);
}
