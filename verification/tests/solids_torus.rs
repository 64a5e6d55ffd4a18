//! A thin torus under pressure from inside.
//!
//! ```text
//!   axis |      .-.      upper half of the section: from the outer equator (r = R + a) over the
//!        |     ( p )     crown to the inner one (r = R - a)
//!        |------+------
//!            R
//! ```

use slideline_verification::{Claim, Group, Record, Solid, run};
use std::f64::consts::PI;

pub const GROUP: Group = Group {
    file: "solids_torus",
    claims: &[Claim {
        name: "torus_under_pressure",
        requirement: "the forces along the meridian at both equators are those of the membrane, \
                      pi p b (2 R + b) and pi p b (2 R - b), b the inner radius, and they hold the \
                      pressure on the half.",
        source: "W. Fluegge, Stresses in Shells (1960), membrane theory of the torus, N = p b (r + \
                 R)/(2 r): at the crown no force along the axis goes from one half to the other.",
        tolerance: "5e-4 of the forces: a wall of 1/40 bends at the crown; 1e-9 of their sum, for \
                    elements of second order take an arc's projection as it is.",
        measure: torus,
    }],
};

const RADIUS: f64 = 4.0;
const WALL: f64 = 0.025;
const PRESSURE: f64 = 0.01;

fn section([x, y, _]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = (PI * y).sin_cos();
    let radius = 1.0 + WALL * (x - 0.5);
    [RADIUS + radius * cosine, radius * sine, 0.0]
}

fn torus(record: &mut Record) {
    for (element, cells) in [("CAX4I", [2, 96, 1]), ("CAX8", [1, 48, 1]), ("CAX8R", [1, 48, 1])] {
        let solid = Solid { element, cells, map: section, material: "*ELASTIC\n1000.0, 0.3\n" };
        let mesh = solid.curved();
        let mut deck =
            format!("*HEADING\ntorus\n{}*STEP\n*STATIC\n1.0, 1.0\n*BOUNDARY\n", mesh.text);
        deck.push_str(&mesh.hold(|at| at[1] == 0.0 || at[1] == 1.0, 2, 0.0));
        deck.push_str("*DLOAD\n");
        deck.push_str(&mesh.press(|at| at[0] == 0.0, PRESSURE));
        deck.push_str("*END STEP\n");
        let curve = match run(&deck) {
            Ok(curve) => curve,
            Err(why) => {
                record.holds(format!("{element}: {why}"), false);
                continue;
            }
        };
        let force = |y: f64| -> f64 {
            let cut = mesh.labels(|at| at[1] == y);
            cut.iter().filter_map(|&label| curve.reaction(label, 2).last().copied()).sum()
        };
        let (outer, inner) = (-force(0.0), -force(1.0));
        let off = |found: f64, exact: f64| (found / exact - 1.0).abs();
        let (unit, inside) = (PI * PRESSURE, 1.0 - 0.5 * WALL);
        let exact = unit * inside * (2.0 * RADIUS + inside);
        record.at_most(format!("{element}, outer equator"), off(outer, exact), 5e-4);
        let exact = unit * inside * (2.0 * RADIUS - inside);
        record.at_most(format!("{element}, inner equator"), off(inner, exact), 5e-4);
        let exact = 4.0 * unit * RADIUS * inside;
        record.at_most(format!("{element}, both"), off(outer + inner, exact), 1e-9);
    }
}
