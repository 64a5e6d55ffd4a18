//! A block pressed on a plane and driven to and fro through a spring.
//!
//! ```text
//!        N = 10
//!        v       k = 100
//!   A [block]--/\/\/\--o B, U1 = 0 .. 0.1 .. -0.1 .. 0.1
//!   ============ mu = 0.3
//! ```

use slideline::output::plot::Axis;
use slideline_theory::closed::stick_slip::Block;
use slideline_verification::{Claim, Group, Record, run, series, trapezoid, worst};

const LOOP: &str = "The elastic, perfectly plastic loop (closed form).";

pub const GROUP: Group = Group {
    file: "stick_slip",
    claims: &[
        Claim {
            name: "loop_with_lagrange",
            requirement: "The block sticks to mu N/k, slips at mu N, slips back after 2 mu N/k; the \
                          loop's area is 4 mu N (A - mu N/k).",
            source: LOOP,
            tolerance: "1e-8 with LAGRANGE, which sticks exactly.",
            measure: loop_with_lagrange,
        },
        Claim {
            name: "loop_with_elastic_slip",
            requirement: "Elastic slip adds gamma_crit to each onset, exactly.",
            source: LOOP,
            tolerance: "1e-8: backward Euler is exact while the drive keeps its direction within \
                        an increment.",
            measure: loop_with_elastic_slip,
        },
        Claim {
            name: "loop_held_by_contact_alone",
            requirement: "A point that touches from the start may be held across by contact alone: \
                          the same loop.",
            source: LOOP,
            tolerance: "1e-8 with LAGRANGE.",
            measure: loop_held_by_contact_alone,
        },
    ],
};

/// A spring to ground across the plane. It carries nothing, for hard contact
/// lets nothing move across; the block then does not depend on contact alone
/// for being held, and the compressed drive does not buckle without it.
const HELD: &str = "*ELEMENT, TYPE=SPRING1, ELSET=ACROSS\n2, 1\n*SPRING, ELSET=ACROSS\n2\n100.0\n";

fn check(record: &mut Record, stick: &str, elastic_slip: f64, held: &str) {
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
    record.equal("increments, without a cutback", curve.rows.len(), 51);
    let (drive, force) = (curve.displacement(2, 1), curve.reaction(2, 1));
    let exact = |k: usize| match k {
        0..=10 => block.force(&[drive[k]]),
        11..=30 => block.force(&[0.1, drive[k]]),
        _ => block.force(&[0.1, -0.1, drive[k]]),
    };
    let off = worst((1..51).map(|k| (force[k] - exact(k)).abs() / 3.0));
    record.at_most("force, largest error (of mu N)", off, 1e-8);
    // corners of the loop lie on increments where onset is a whole number of them
    if elastic_slip == 0.0 {
        let area = trapezoid(&drive[10..], &force[10..]);
        let off = (area / block.loop_work(0.1) - 1.0).abs();
        record.at_most("area of the loop, error (relative)", off, 1e-8);
    }
    let (x, y) = (Axis::linear("drive U1"), Axis::linear("force RF1"));
    record.chart("The loop", x, y, vec![series(&drive, ("slideline", &force))]);
}

fn loop_with_lagrange(record: &mut Record) {
    check(record, ", LAGRANGE", 0.0, HELD);
}

fn loop_with_elastic_slip(record: &mut Record) {
    check(record, ", ELASTIC SLIP=0.004", 0.004, HELD);
}

fn loop_held_by_contact_alone(record: &mut Record) {
    check(record, ", LAGRANGE", 0.0, "");
}
