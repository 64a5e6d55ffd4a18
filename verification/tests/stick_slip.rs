//! A block pressed on a plane and driven to and fro through a spring.
//!
//! ```text
//!        N = 10
//!        v       k = 100
//!   A [block]--/\/\/\--o B, U1 = 0 .. 0.1 .. -0.1 .. 0.1
//!   ============ mu = 0.3
//! ```
//!
//! Requirement: the elastic, perfectly plastic loop of verification section 6:
//! sticks to mu N/k, slips at mu N, slips back after 2 mu N/k, area
//! 4 mu N (A - mu N/k). Tolerance 1e-8 with LAGRANGE; elastic slip adds
//! gamma_crit to each onset, exactly too, for backward Euler is exact while
//! the drive keeps its direction within an increment.

use slideline_theory::closed::stick_slip::Block;
use slideline_verification::{run, trapezoid};

/// A spring to ground across the plane. It carries nothing, for hard contact
/// lets nothing move across; the block then does not depend on contact alone
/// for being held, and the compressed drive does not buckle without it.
const HELD: &str = "*ELEMENT, TYPE=SPRING1, ELSET=ACROSS\n2, 1\n*SPRING, ELSET=ACROSS\n2\n100.0\n";

fn check(stick: &str, elastic_slip: f64, held: &str) {
    let deck = format!(
        "*HEADING\nblock\n*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n3, 0.0, 1.0\n99, 0.0, -1.0\n\
         *ELEMENT, TYPE=SPRINGA, ELSET=SPRING\n1, 1, 2\n*SPRING, ELSET=SPRING\n\n100.0\n{held}\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -5.0, 0.0\nLINE, 5.0, 0.0\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 3, 99\n\
         *INTERFACE, ELSET=CONTACT\n1.0\n*FRICTION{stick}\n0.3\n\
         *AMPLITUDE, NAME=CYCLE\n0.0, 0.0, 1.0, 1.0, 3.0, -1.0, 5.0, 1.0\n\
         *STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n1, 6\n2, 1, 6\n3, 1, 6\n99, 1, 6\n\
         *CLOAD\n1, 2, -10.0\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n\
         *STEP, NLGEOM, INC=1000\n*STATIC\n0.1, 5.0, 1.0E-6, 0.1\n\
         *BOUNDARY, AMPLITUDE=CYCLE\n2, 1, 1, 0.1\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n"
    );
    let block = Block { stiffness: 100.0, normal: 10.0, mu: 0.3, elastic_slip };
    let curve = run(&deck).unwrap();
    assert_eq!(curve.rows.len(), 51, "no cutback");
    let (drive, force) = (curve.displacement(2, 1), curve.reaction(2, 1));
    for k in 1..51 {
        let path: &[f64] = match k {
            0..=10 => &[drive[k]],
            11..=30 => &[0.1, drive[k]],
            _ => &[0.1, -0.1, drive[k]],
        };
        let exact = block.force(path);
        assert!((force[k] - exact).abs() < 1e-8 * 3.0, "{stick} row {k}: {} {exact}", force[k]);
    }
    // corners of the loop lie on increments where onset is a whole number of them
    let area = trapezoid(&drive[10..], &force[10..]);
    println!("stick-slip{stick}: loop {area:.9}, exact {:.9}", block.loop_work(0.1));
    if elastic_slip == 0.0 {
        assert!((area / block.loop_work(0.1) - 1.0).abs() < 1e-8, "{area}");
    }
}

#[test]
fn loop_with_lagrange() {
    check(", LAGRANGE", 0.0, HELD);
}

#[test]
fn loop_with_elastic_slip() {
    check(", ELASTIC SLIP=0.004", 0.004, HELD);
}

/// Requirement: a point that touches from the start may be held across by
/// contact alone.
#[test]
fn loop_held_by_contact_alone() {
    check(", LAGRANGE", 0.0, "");
}
