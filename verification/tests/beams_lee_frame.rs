//! Lee's frame, brought through its limit load by displacement.
//!
//! ```text
//!       v
//!   +---o-----------^   beam, hinged at its end, load at a fifth
//!   |
//!   |   column, hinged at its foot
//!   ^
//! ```

use slideline::output::plot::{Axis, Mark, Series};
use slideline_verification::{Claim, Group, Record, run};

pub const GROUP: Group = Group {
    file: "beams_lee_frame",
    claims: &[Claim {
        name: "limit_load",
        requirement: "The limit load of the frame, and the deflection under it, by 20 B23 and by \
                      40 B21 a member.",
        source: "Lee, Manuel and Rossow (1968): 18.552 EI/L2; the inextensible elastica of both \
                 members by shooting: 18.55875 EI/L2 at v = 0.40615 L (derived).",
        tolerance: "0.1 % of the load; 18.552 is itself 0.04 % below the elastica. 0.5 % of the \
                    deflection, for the load hardly changes about its maximum. With 20 B21 a \
                    member four elements lie between corner and load, and one-point elements lack \
                    bending flexibility: that is told.",
        measure: limit_load,
    }],
};

const STEPS: usize = 90;

/// L = 1, EI = 1; EA = 1.2e7, so that nothing stretches. Both members have `n`
/// elements, a multiple of five.
fn deck(kind: &str, n: usize) -> String {
    format!(
        "*HEADING\nLee's frame\n*NODE, NSET=FRAME\n1, 0.0, 0.0\n{corner}, 0.0, 1.0\n\
         {last}, 1.0, 1.0\n*NGEN, NSET=FRAME\n1, {corner}, 1\n{corner}, {last}, 1\n\
         *ELEMENT, TYPE={kind}, ELSET=FRAME\n1, 1, 2\n*ELGEN, ELSET=FRAME\n1, {both}, 1, 1\n\
         *BEAM SECTION, ELSET=FRAME, SECTION=RECT, MATERIAL=M\n12.0, 1.0E-3\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1.0E9, 0.0\n*STEP, NLGEOM, INC=1000\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n\
         *BOUNDARY\n1, 1, 2\n{last}, 1, 2\n{loaded}, 2, 2, -0.45\n*END STEP\n",
        corner = n + 1,
        last = 2 * n + 1,
        both = 2 * n,
        loaded = loaded(n),
        dt = 1.0 / STEPS as f64
    )
}

/// Label of the node under the load.
fn loaded(n: usize) -> u64 {
    (n + 1 + n / 5) as u64
}

/// Deflection and load of every increment.
fn path(kind: &str, n: usize) -> Vec<[f64; 2]> {
    let curve = run(&deck(kind, n)).unwrap();
    assert_eq!(curve.rows.len(), STEPS, "no cutback");
    let (u, reaction) = (curve.displacement(loaded(n), 2), curve.reaction(loaded(n), 2));
    u.iter().zip(reaction).map(|(u, rf)| [-u, -rf]).collect()
}

/// Deflection and load at the largest load, by a parabola through three.
fn limit(path: &[[f64; 2]]) -> [f64; 2] {
    let k = (1..STEPS - 1).max_by(|&a, &b| path[a][1].total_cmp(&path[b][1])).unwrap();
    let [a, b, c] = [k - 1, k, k + 1].map(|k| path[k][1]);
    let s = 0.5 * (a - c) / (a - 2.0 * b + c);
    [path[k][0] + s * (path[k + 1][0] - path[k][0]), b - 0.25 * (a - c) * s]
}

fn limit_load(record: &mut Record) {
    let mut paths = Vec::new();
    for (kind, n) in [("B23", 20), ("B21", 40), ("B21", 20)] {
        let points = path(kind, n);
        let [at, load] = limit(&points);
        let what = |what: &str| format!("{n} {kind} a member, {what}");
        let off = |exact: f64| 100.0 * (load / exact - 1.0).abs();
        if (kind, n) == ("B21", 20) {
            record.tell(what("limit load, error against the elastica (%)"), off(18.55875));
        } else {
            record.at_most(what("limit load, error against the elastica (%)"), off(18.55875), 0.1);
            record.at_most(what("limit load, error against the paper (%)"), off(18.552), 0.1);
            let off = 100.0 * (at / 0.40615 - 1.0).abs();
            record.at_most(what("deflection under it, error (%)"), off, 0.5);
        }
        paths.push(Series {
            name: format!("{n} {kind} a member"),
            points,
            mark: Mark::Curve,
            colour: 0,
        });
    }
    let (x, y) = (Axis::linear("v / L"), Axis::linear("P L2/EI"));
    record.chart("Lee's frame", x, y, paths);
}
