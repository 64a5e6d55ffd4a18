//! A weight pushed up and let down a slope; a point on a parabola.
//!
//! ```text
//!        G
//!        v __--
//!   F ->[-]      tan a = 0.1
//! ```
//!
//! Requirement: NAFEMS CGS-4, F/G = (tan a + mu)/(1 - mu tan a) upwards and
//! (mu - tan a)/(1 + mu tan a) against it downwards; on a frictionless
//! parabola F/G is its slope. Source: verification section 6. Gate there
//! 0.1 %; statics of a point is exact, so 1e-9 here.

use slideline_theory::closed::incline;
use slideline_verification::run;

/// A block of two slave nodes on the slope; up in ten increments, down again.
fn block(mu: f64, stick: &str, law: &str, held: &str) -> (f64, f64) {
    let step = |end: f64| {
        format!(
            "*STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n9, 1, 1, {end:?}\n99, 1, 6\n\
             *CLOAD\n9, 2, -5.0\n*CONTROLS, PARAMETERS=FIELD\n1.0E-10\n*END STEP\n"
        )
    };
    // rounding grows with the surface
    let (start, end) =
        if held.is_empty() { ("-10.0, -1.0", "10.0, 1.0") } else { ("-1.0, -0.1", "2.0, 0.2") };
    let deck = format!(
        "*HEADING\nincline\n*NODE\n1, -0.5, -0.05\n2, 0.5, 0.05\n9, 0.0, 0.0\n99, 0.0, -1.0\n\
         *MPC\nBEAM, 1, 9\nBEAM, 2, 9\n{held}\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, {start}\nLINE, {end}\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 2, 99\n\
         *INTERFACE, ELSET=CONTACT\n1.0\n*FRICTION{stick}\n{mu:?}\n{law}{}{}",
        step(1.0),
        step(0.0)
    );
    let curve = run(&deck).unwrap();
    let stiffness = if held.is_empty() { 0.0 } else { 1.0 };
    let (force, rise) = (curve.reaction(9, 1), curve.displacement(9, 2));
    // the weight and what the springs add to it
    let ratio = |k: usize| force[k] / (5.0 * curve.rows[k].time.min(1.0) + stiffness * rise[k]);
    let at = |time: f64| curve.rows.iter().position(|row| (row.time - time).abs() < 1e-9).unwrap();
    (ratio(at(1.0)), ratio(at(2.0)))
}

/// Springs of 1 to ground, upright and against turning, so that the block is
/// not held by contact alone.
const HELD: &str = "*ELEMENT, TYPE=SPRING1, ELSET=UP\n21, 9\n*SPRING, ELSET=UP\n2\n1.0\n\
    *ELEMENT, TYPE=SPRING1, ELSET=TURN\n22, 9\n*SPRING, ELSET=TURN\n6\n1.0\n";

#[test]
fn nafems_cgs_4() {
    check(HELD);
}

/// Requirement: a block that touches from the start may be held by contact alone.
#[test]
fn nafems_cgs_4_held_by_contact_alone() {
    check("");
}

fn check(held: &str) {
    for stick in ["", ", LAGRANGE"] {
        for mu in [0.0, 0.1, 0.3] {
            let (up, down) = block(mu, stick, "", held);
            let (exact_up, exact_down) =
                (incline::raising(0.1, mu).unwrap(), -incline::lowering(0.1, mu));
            println!("incline mu {mu}{stick}: up {up:.9} ({exact_up:.9}) down {down:.9} ({exact_down:.9})");
            assert!((up - exact_up).abs() < 1e-9, "{up} {exact_up}");
            assert!((down - exact_down).abs() < 1e-9, "{down} {exact_down}");
        }
    }
}

/// A softened law lowers the block and changes no force.
#[test]
fn softened() {
    let (up, _) = block(0.3, "", "*SURFACE CONTACT, SOFTENED\n0.01, 5.0\n", HELD);
    let exact = incline::raising(0.1, 0.3).unwrap();
    assert!((up - exact).abs() < 1e-9, "{up} {exact}");
}

#[test]
fn parabola_pushes_along_its_slope() {
    parabola(1.0);
}

/// Requirement: as before; the point belongs to no element but the contact's.
#[test]
fn parabola_pushes_a_point_without_elements() {
    parabola(0.0);
}

/// y = x2 from -1 to 1; the other node of the contact element is far above.
fn parabola(spring: f64) {
    let held = "*ELEMENT, TYPE=SPRING1, ELSET=UP\n21, 1\n*SPRING, ELSET=UP\n2\n1.0\n\
        *ELEMENT, TYPE=SPRING1, ELSET=SIDE\n22, 1\n*SPRING, ELSET=SIDE\n1\n1.0\n";
    let deck = format!(
        "*HEADING\nparabola\n*NODE\n1, -0.5, 0.25\n2, 0.0, 9.0\n99, 0.0, -1.0\n{}\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -1.0, 1.0\n\
         PARAB, 0.0, 0.0, 1.0, 1.0\n*ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 2, 99\n\
         *INTERFACE, ELSET=CONTACT\n1.0\n*STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n\
         *BOUNDARY\n1, 1, 1, 1.0\n1, 6\n2, 1, 6\n99, 1, 6\n*CLOAD\n1, 2, -5.0\n\
         *CONTROLS, PARAMETERS=FIELD\n1.0E-10\n*END STEP\n",
        if spring > 0.0 { held } else { "" }
    );
    let curve = run(&deck).unwrap();
    let (u, v, force) = (curve.displacement(1, 1), curve.displacement(1, 2), curve.reaction(1, 1));
    for (k, row) in curve.rows.iter().enumerate() {
        let (x, y) = (-0.5 + row.time, 0.25 + v[k]);
        assert!((u[k] - row.time).abs() < 1e-12, "moved as prescribed: {} {}", u[k], row.time);
        assert!((y - x * x).abs() < 1e-9, "on the parabola: {x} {y}");
        let exact = 2.0 * x * (5.0 * row.time + spring * v[k]) + spring * u[k];
        assert!((force[k] - exact).abs() < 1e-8, "{x}: {} {exact}", force[k]);
    }
}
