//! Lee's frame of solids, brought through its limit load by displacement.
//!
//! ```text
//!       v
//!   /---o-----------^   members of length 1 and depth 1/60, mitred at the corner,
//!   |                   hinged at the middle of their ends
//!   ^
//! ```

use slideline_verification::{Claim, Group, Record, Solid, run};

pub const GROUP: Group = Group {
    file: "solids_frame",
    claims: &[Claim {
        name: "lees_frame_of_solids",
        requirement: "the limit load of Lee's frame made of solids is that of the elastica.",
        source: "Lee, Manuel and Rossow (1968): 18.552 EI/L2, depth L/60; the inextensible elastica of \
                 both members: 18.55875 EI/L2 at v = 0.40615 L (derived, as in beams_lee_frame).",
        tolerance: "1 % of the load: stretching, shear and the thick corner take 0.4 %; 2 % of the \
                    deflection, for the load hardly changes about its maximum.",
        measure: limit_load,
    }],
};

const DEPTH: f64 = 1.0 / 60.0;
const STEPS: usize = 45;
const MODULUS: f64 = 12.0 / (DEPTH * DEPTH * DEPTH);

/// Up the column and along the beam; sections lie askew, more so towards the corner.
fn frame([x, y, z]: [f64; 3]) -> [f64; 3] {
    let off = DEPTH * (y - 0.5);
    let run = 2.0 * x;
    // the mitre turns the section at the corner by 45 degrees, those at the ends not at all
    if run <= 1.0 {
        [-off, run * (1.0 + off), z]
    } else {
        [1.0 - (2.0 - run) * (1.0 + off), 1.0 + off, z]
    }
}

/// Deflection and load of every increment.
fn path(element: &str, cells: [usize; 3]) -> Result<Vec<[f64; 2]>, String> {
    let material = format!("*ELASTIC\n{MODULUS:?}, 0.0\n");
    let solid = Solid { element, cells, map: frame, material: &material };
    let mesh = solid.mesh();
    let dt = 1.0 / STEPS as f64;
    let mut deck = format!(
        "*HEADING\nLee's frame of solids\n{}*STEP, NLGEOM, INC=1000\n*STATIC\n{dt:?}, 1.0, 1.0E-6, \
         {dt:?}\n*BOUNDARY\n",
        mesh.text
    );
    let ends = |at: [f64; 3]| at[1] == 0.5 && (at[0] == 0.0 || at[0] == 1.0);
    (1..=2).for_each(|axis| deck.push_str(&mesh.hold(ends, axis, 0.0)));
    deck.push_str(&mesh.hold(|at| at[1] == 0.5 && at[0] == 0.6, 2, -0.45));
    deck.push_str("*END STEP\n");
    let curve = run(&deck)?;
    let loaded = mesh.nearest([0.6, 0.5, 0.0]);
    let (u, reaction) = (curve.displacement(loaded, 2), curve.reaction(loaded, 2));
    Ok(u.iter().zip(reaction).map(|(u, rf)| [-u, -rf]).collect())
}

/// Deflection and load at the largest load, by a parabola through three.
fn limit(path: &[[f64; 2]]) -> [f64; 2] {
    let inner = 1..path.len() - 1;
    let k = inner.max_by(|&a, &b| path[a][1].total_cmp(&path[b][1])).unwrap();
    let [a, b, c] = [k - 1, k, k + 1].map(|k| path[k][1]);
    let s = 0.5 * (a - c) / (a - 2.0 * b + c);
    [path[k][0] + s * (path[k + 1][0] - path[k][0]), b - 0.25 * (a - c) * s]
}

fn limit_load(record: &mut Record) {
    for (element, cells) in [("CPS4I", [80, 2, 1]), ("CPS8R", [40, 2, 1])] {
        match path(element, cells) {
            Ok(points) => {
                let [at, load] = limit(&points);
                let off = (load / 18.55875 - 1.0).abs();
                record.at_most(format!("{element}, limit load"), off, 0.01);
                let off = (at / 0.40615 - 1.0).abs();
                record.at_most(format!("{element}, deflection under it"), off, 0.02);
            }
            Err(why) => record.holds(format!("{element}: {why}"), false),
        }
    }
}
