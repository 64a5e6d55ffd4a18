//! A weight pushed up and let down a slope; a point on a parabola.
//!
//! ```text
//!        G
//!        v __--
//!   F ->[-]      tan a = 0.1
//! ```

use slideline::output::plot::Axis;
use slideline_theory::closed::incline;
use slideline_verification::{Claim, Group, Record, run, series, worst};

const STATICS: &str = "NAFEMS CGS-4 asks 0.1 %; the statics of a point is exact, so that 1e-9 is \
                       asked here.";

pub const GROUP: Group = Group {
    file: "incline",
    claims: &[
        Claim {
            name: "nafems_cgs_4",
            requirement: "F/G = (tan a + mu)/(1 - mu tan a) upwards and (mu - tan a)/(1 + mu tan \
                          a) against it downwards, for mu 0, 0.1, 0.3.",
            source: "NAFEMS CGS-4 (R0081).",
            tolerance: STATICS,
            measure: nafems_cgs_4,
        },
        Claim {
            name: "parabola_pushes_along_its_slope",
            requirement: "On a frictionless parabola F/G is its slope.",
            source: "Statics of a point (derived).",
            tolerance: "1e-9 for the height, 1e-8 for the force.",
            measure: parabola_pushes_along_its_slope,
        },
        Claim {
            name: "parabola_pushes_a_point_without_elements",
            requirement: "The same where the point belongs to no element but the contact's.",
            source: "Statics of a point (derived).",
            tolerance: "1e-9 for the height, 1e-8 for the force.",
            measure: parabola_pushes_a_point_without_elements,
        },
        Claim {
            name: "block_held_by_contact_alone",
            requirement: "A block on two rigidly linked points that touch from the start may be \
                          held by contact alone, hard or softened; CGS-4 once more.",
            source: "NAFEMS CGS-4 (R0081).",
            tolerance: "1e-5: the default residual tolerance.",
            measure: block_held_by_contact_alone,
        },
    ],
};

/// Springs of 1 to ground, up and to the side, so that the point has a
/// stiffness of its own; what they carry is taken off the balance.
const SPRINGS: &str = "*ELEMENT, TYPE=SPRING1, ELSET=UP\n21, 1\n*SPRING, ELSET=UP\n2\n1.0\n\
    *ELEMENT, TYPE=SPRING1, ELSET=SIDE\n22, 1\n*SPRING, ELSET=SIDE\n1\n1.0\n";
const WEIGHT: f64 = 5.0;

/// Moves node 1 from `start` along `surface` by 1 and back; the contact
/// element's other node is far above.
fn deck(start: [f64; 2], surface: &str, laws: &str, springs: &str) -> String {
    let step = |end: f64| {
        format!(
            "*STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n1, 1, 1, {end:?}\n1, 6\n\
             2, 1, 6\n99, 1, 6\n*CLOAD\n1, 2, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-11\n\
             *END STEP\n",
            -WEIGHT
        )
    };
    format!(
        "*HEADING\npoint on a surface\n*NODE\n1, {:?}, {:?}\n2, 0.0, 9.0\n99, 0.0, -1.0\n{springs}\
         *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\n{surface}\n\
         *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 2, 99\n*INTERFACE, ELSET=CONTACT\n1.0\n\
         {laws}{}{}",
        start[0],
        start[1],
        step(1.0),
        step(0.0)
    )
}

/// (time, place along x, height, horizontal force, vertical force) of the contact.
fn forces(deck: &str, start: [f64; 2], spring: f64) -> Vec<[f64; 5]> {
    let curve = run(deck).unwrap();
    let (u, v, force) = (curve.displacement(1, 1), curve.displacement(1, 2), curve.reaction(1, 1));
    let row = |k: usize| {
        let time = curve.rows[k].time;
        let moved = if time <= 1.0 { time } else { 2.0 - time };
        assert!((u[k] - moved).abs() < 1e-12, "moved as prescribed: {} {moved}", u[k]);
        let weight = WEIGHT * time.min(1.0) + spring * v[k];
        [time, start[0] + u[k], start[1] + v[k], force[k] - spring * u[k], weight]
    };
    (0..curve.rows.len()).map(row).collect()
}

const SLOPE: &str = "START, -1.0, -0.1\nLINE, 2.0, 0.2";
const SOFTENED: &str = "*SURFACE CONTACT, SOFTENED\n0.01, 5.0\n";

fn nafems_cgs_4(record: &mut Record) {
    for stick in [", ELASTIC SLIP=1.0E-4", ", LAGRANGE"] {
        for (name, law) in [("hard", ""), ("softened", SOFTENED)] {
            for mu in [0.0, 0.1, 0.3] {
                let laws = format!("*FRICTION{stick}\n{mu:?}\n{law}");
                let rows = forces(&deck([0.0; 2], SLOPE, &laws, SPRINGS), [0.0; 2], 1.0);
                let (up, down) = (incline::raising(0.1, mu).unwrap(), -incline::lowering(0.1, mu));
                let exact = |time: f64| if time < 1.0 + 1e-9 { up } else { down };
                let off = rows
                    .iter()
                    .map(|[time, _, _, force, weight]| (force / weight - exact(*time)).abs());
                record.at_most(
                    format!("{name}{stick}, mu {mu}: F/G, largest error"),
                    worst(off),
                    1e-9,
                );
                if stick == ", LAGRANGE" && law.is_empty() && mu == 0.3 {
                    let of = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
                    let ratio: Vec<f64> = rows.iter().map(|row| row[3] / row[4]).collect();
                    let curves = vec![series(&of(0), ("slideline", &ratio))];
                    let (x, y) = (Axis::linear("time"), Axis::linear("F/G"));
                    record.chart("Up the slope, then down, mu 0.3", x, y, curves);
                }
            }
        }
    }
}

/// y = x2 from -1 to 1.
fn parabola(record: &mut Record, springs: &str, spring: f64) {
    let start = [-0.5, 0.25];
    let text = deck(start, "START, -1.0, 1.0\nPARAB, 0.0, 0.0, 1.0, 1.0", "", springs);
    let rows = forces(&text, start, spring);
    let height = worst(rows.iter().map(|[_, x, y, ..]| (y - x * x).abs()));
    record.at_most("height above the parabola, largest", height, 1e-9);
    let force = rows.iter().map(|[_, x, _, force, weight]| (force - 2.0 * x * weight).abs());
    record.at_most("force less slope times weight, largest", worst(force), 1e-8);
}

fn parabola_pushes_along_its_slope(record: &mut Record) {
    parabola(record, SPRINGS, 1.0);
}

fn parabola_pushes_a_point_without_elements(record: &mut Record) {
    parabola(record, "", 0.0);
}

fn block_held_by_contact_alone(record: &mut Record) {
    for (name, law) in [("hard", ""), ("softened", SOFTENED)] {
        let text = format!(
            "*HEADING\nblock\n*NODE\n1, -0.5, -0.05\n2, 0.5, 0.05\n9, 0.0, 0.0\n99, 0.0, -1.0\n\
             *MPC\nBEAM, 1, 9\nBEAM, 2, 9\n\
             *RIGID SURFACE, ELSET=CONTACT, TYPE=SEGMENTS\nSTART, -10.0, -1.0\nLINE, 10.0, 1.0\n\
             *ELEMENT, TYPE=IRS21, ELSET=CONTACT\n11, 1, 2, 99\n*INTERFACE, ELSET=CONTACT\n1.0\n\
             *FRICTION\n0.3\n{law}*STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n\
             9, 1, 1, 2.0\n99, 1, 6\n*CLOAD\n9, 2, -5.0\n*END STEP\n"
        );
        let curve = run(&text).unwrap();
        let ratio = curve.reaction(9, 1).last().unwrap() / 5.0;
        let exact = incline::raising(0.1, 0.3).unwrap();
        record.at_most(format!("{name}: F/G, error at the end"), (ratio - exact).abs(), 1e-5);
    }
}
