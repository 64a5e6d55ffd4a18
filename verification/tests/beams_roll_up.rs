//! Simo and Vu-Quoc's roll-up: a cantilever under a moment at its end.
//!
//! Requirement: curvature is exact in the two-node one-point element, so the
//! nodes lie on a regular polygon at every load and close at 2 pi, within ten
//! increments. Source: verification section 5. Tolerance 1e-10 of the length:
//! no discretisation error is left, only the residual at which Newton stops.

use slideline_theory::closed::roll_up;
use slideline_verification::run;
use std::f64::consts::PI;

const ELEMENTS: usize = 10;

/// EI = 1, L = 1, end moment 2 pi.
fn deck() -> String {
    format!(
        "*HEADING\nroll-up\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n11, 1.0, 0.0\n*NGEN, NSET=BEAM\n\
         1, 11, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, {ELEMENTS}, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n1.0, 0.1\n\
         *MATERIAL, NAME=M\n*ELASTIC\n12000.0, 0.0\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n1, ENCASTRE\n\
         *CLOAD\n11, 6, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-11\n*END STEP\n",
        2.0 * PI
    )
}

#[test]
fn polygon_at_every_load_and_closed_at_the_last() {
    let curve = run(&deck()).unwrap();
    assert_eq!(curve.rows.len(), 10, "within ten increments");
    let (x, y) = (curve.displacement(11, 1), curve.displacement(11, 2));
    let mut worst: f64 = 0.0;
    for (k, row) in curve.rows.iter().enumerate() {
        let [tip_x, tip_y] = roll_up::polygon_tip(2.0 * PI * row.time, ELEMENTS);
        worst = worst.max((1.0 + x[k] - tip_x).hypot(y[k] - tip_y));
    }
    let gap = (1.0 + x[9]).hypot(y[9]);
    let turn = curve.displacement(11, 6)[9];
    println!(
        "roll-up: polygon {worst:.2e}, closing {gap:.2e}, {:.1} iterations",
        curve.mean_iterations()
    );
    assert!(worst < 1e-10, "{worst:e}");
    assert!(gap < 1e-10, "{gap:e}");
    assert!((turn - 2.0 * PI).abs() < 1e-10, "{turn}");
}
