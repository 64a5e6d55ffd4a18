//! How far a sticking point slips.

use slideline::observe::{ContactRow, Status};
use slideline_verification::{Claim, Curve, Group, Record, paper, run, worst};

pub const GROUP: Group = Group {
    file: "sticking",
    claims: &[
        Claim {
            name: "lagrange_sticks_exactly",
            requirement: "With LAGRANGE a point that sticks over an increment does not slip.",
            source: "The manual: the slip increment of a sticking point is zero.",
            tolerance: "1e-8 of the elastic slip (0.005 of the contact length) or 8 units in the \
                        last place of the largest coordinate, whichever is larger.",
            measure: lagrange_sticks_exactly,
        },
        Claim {
            name: "penalty_slips_elastically",
            requirement: "With penalty the elastic slip of a sticking point stays within \
                          gamma_crit, so that its slip between two sticking states is at most twice \
                          that.",
            source: "The manual's elastic slip (docs/theory.md, friction).",
            tolerance: "Rounding.",
            measure: penalty_slips_elastically,
        },
    ],
};

/// A block on a plane, driven to and fro through a spring; once the force
/// needed exceeds mu N it slides.
fn block(stick: &str) -> String {
    format!(
        "*HEADING\nblock\n*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n3, 0.0, 1.0\n99, 0.0, -1.0\n\
         *ELEMENT, TYPE=SPRINGA, ELSET=SPRING\n1, 1, 2\n*SPRING, ELSET=SPRING\n\n100.0\n\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -5.0, 0.0\nLINE, 5.0, 0.0\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 3, 99\n\
         *INTERFACE, ELSET=CONTACT\n1.0\n*FRICTION{stick}\n0.3\n\
         *AMPLITUDE, NAME=CYCLE\n0.0, 0.0, 1.0, 1.0, 3.0, -1.0, 5.0, 1.0\n\
         *STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n1, 6\n2, 1, 6\n3, 1, 6\n99, 1, 6\n\
         *CLOAD\n1, 2, -10.0\n*END STEP\n\
         *STEP, NLGEOM, INC=1000\n*STATIC\n0.05, 5.0, 1.0E-6, 0.05\n\
         *BOUNDARY, AMPLITUDE=CYCLE\n2, 1, 1, 0.1\n*END STEP\n"
    )
}

/// Largest slip of a point over an increment at whose end it sticks and at
/// whose beginning it was closed, and how many there were.
fn stuck(curve: &Curve) -> (f64, usize) {
    let held = |before: &ContactRow, now: &ContactRow| {
        (before.status != Status::Open && now.status == Status::Stick)
            .then(|| (now.slip - before.slip).size())
    };
    let slips: Vec<f64> = curve
        .rows
        .windows(2)
        .flat_map(|pair| {
            pair[0].contact.iter().zip(&pair[1].contact).filter_map(|(a, b)| held(a, b))
        })
        .collect();
    (slips.iter().copied().fold(0.0, f64::max), slips.len())
}

fn largest_coordinate(curve: &Curve) -> f64 {
    let nodes = &curve.model.nodes;
    let all = (0..nodes.len()).flat_map(|node| nodes.position(node));
    all.fold(0.0, |most, x| x.abs().max(most))
}

/// The circle there, then back by a thousandth of the stroke in 40 increments.
fn turn(friction: &str) -> String {
    let (push, back) = paper::ISL_PUSH_PULL.split_once("PULL BEARING BACK").unwrap();
    let back = back
        .replace("0.05, 1.0, 1.0E-6, 0.05", "0.025, 1.0, 1.0E-6, 0.025")
        .replace("9999, 2,, 0.0", "9999, 2,, -29.97E-3");
    format!("{push}PULL BEARING BACK{back}").replace("*FRICTION", &format!("*FRICTION{friction}"))
}

fn lagrange_sticks_exactly(record: &mut Record) {
    // elastic slip: 0.005 of the length of the contact elements, 1 and 0.785 mm
    for (name, deck, elastic_slip) in
        [("block", block(", LAGRANGE"), 5e-3), ("circle", turn(", LAGRANGE"), 3.9256e-6)]
    {
        let curve = run(&deck).unwrap();
        let (slip, count) = stuck(&curve);
        let ulp = largest_coordinate(&curve) * f64::EPSILON;
        let allowed = f64::max(1e-8 * elastic_slip, 8.0 * ulp);
        record.at_least(format!("{name}: sticking increments"), count as f64, 1.0);
        record.at_most(format!("{name}: slip in one, largest (m)"), slip, allowed);
    }
}

fn penalty_slips_elastically(record: &mut Record) {
    for (name, deck, elastic_slip) in [
        ("block", block(", ELASTIC SLIP=4.0E-3"), 4e-3),
        ("circle", turn(", ELASTIC SLIP=2.0E-6"), 2e-6),
    ] {
        let curve = run(&deck).unwrap();
        let points = curve.rows.iter().flat_map(|row| &row.contact);
        let sticking: Vec<&ContactRow> =
            points.filter(|point| point.status == Status::Stick).collect();
        // elastic slip over gamma_crit, from the law itself
        let elastic = worst(sticking.iter().map(|p| p.shear.size() / (0.3 * p.pressure)));
        let (slip, _) = stuck(&curve);
        record.at_least(format!("{name}: sticking points"), sticking.len() as f64, 1.0);
        let what = format!("{name}: elastic slip, largest (of gamma_crit)");
        record.at_most(what, elastic, 1.0 + 1e-12);
        let what = format!("{name}: slip between sticking states, largest (of gamma_crit)");
        record.at_most(what, slip / elastic_slip, 2.0 * (1.0 + 1e-9));
    }
}
