//! A thin ring of solids between two forces, small and large.
//!
//! ```text
//!        ^ P/2
//!   .---o      quarter: x = 0 and y = 0 are planes of symmetry;
//!  /           R = 10, t = 0.25, force at the middle of the section
//! o->
//! ```

use slideline_theory::closed::ring;
use slideline_verification::{Claim, Curve, Group, Meshed, Record, Solid, run};

pub const GROUP: Group = Group {
    file: "solids_ring",
    claims: &[
        Claim {
            name: "pinched_ring",
            requirement: "the diameter along two small forces changes by P R^3/EI (pi/4 - 2/pi).",
            source: "S. Timoshenko, Strength of Materials II, bending of rings.",
            tolerance: "1 %: shear and stretching add 0.2 % at R/t = 40; linear types have chords for \
                        arcs.",
            measure: pinched,
        },
        Claim {
            name: "ring_pulled_far",
            requirement: "height and width of a ring pulled to 1.35 times its diameter, over the \
                          force.",
            source: "inextensible elastica of a ring (R. Frisch-Fay, Flexible Bars, 1962), derived in \
                     crates/theory, closed::ring.",
            tolerance: "1.5 % of the change of height and of width at the same force: thickness as \
                        above, and strains of 4 % at the force.",
            measure: pulled,
        },
    ],
};

const RADIUS: f64 = 10.0;
const THICKNESS: f64 = 0.25;
const MODULUS: f64 = 1.0e5;
const BENDING: f64 = MODULUS * THICKNESS * THICKNESS * THICKNESS / 12.0;

/// A quarter, from the x axis round to the y axis.
fn quarter([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = (std::f64::consts::FRAC_PI_2 * y).sin_cos();
    let radius = RADIUS + THICKNESS * (x - 0.5);
    [radius * cosine, radius * sine, z]
}

/// The quarter whose top is moved up by `moved`, in steps of so much time.
fn moved(
    element: &str,
    cells: [usize; 3],
    step: &str,
    moved: f64,
) -> Result<(Curve, Meshed), String> {
    let material = format!("*ELASTIC\n{MODULUS:?}, 0.0\n");
    let solid = Solid { element, cells, map: quarter, material: &material };
    let mesh = solid.curved();
    let mut deck = format!("*HEADING\nring\n{}*STEP{step}\n*BOUNDARY\n", mesh.text);
    deck.push_str(&mesh.hold(|at| at[1] == 0.0, 2, 0.0));
    deck.push_str(&mesh.hold(|at| at[1] == 1.0, 1, 0.0));
    deck.push_str(&mesh.hold(|at| at[1] == 1.0 && at[0] == 0.5, 2, moved));
    if solid.is_spatial() {
        deck.push_str(&mesh.hold(|at| at[2] == 0.0, 3, 0.0));
    }
    deck.push_str("*END STEP\n");
    Ok((run(&deck)?, mesh))
}

/// Force P of every increment.
fn forces(curve: &Curve, mesh: &Meshed) -> Vec<f64> {
    let top = mesh.labels(|at| at[1] == 1.0 && at[0] == 0.5);
    let columns: Vec<Vec<f64>> = top.iter().map(|&label| curve.reaction(label, 2)).collect();
    (0..curve.rows.len())
        .map(|k| 2.0 * columns.iter().map(|column| column[k]).sum::<f64>())
        .collect()
}

/// Types, with cells through the thickness, around and across.
const MESHES: [(&str, [usize; 3]); 5] = [
    ("CPS4I", [2, 48, 1]),
    ("CPS8", [2, 24, 1]),
    ("CPS8R", [2, 24, 1]),
    ("C3D8I", [2, 48, 1]),
    ("C3D20R", [2, 24, 1]),
];

fn pinched(record: &mut Record) {
    for (element, cells) in MESHES {
        match moved(element, cells, "\n*STATIC\n1.0, 1.0", -1e-3) {
            Ok((curve, mesh)) => {
                let force = forces(&curve, &mesh)[0];
                let exact = ring::growth(force, RADIUS, BENDING);
                let off = (2e-3 / -exact - 1.0).abs();
                record.at_most(format!("{element}, change of the diameter"), off, 0.01);
            }
            Err(why) => record.holds(format!("{element}: {why}"), false),
        }
    }
}

fn pulled(record: &mut Record) {
    for (element, cells) in [MESHES[0], MESHES[2], MESHES[4]] {
        let step = ", NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-5, 0.1";
        match moved(element, cells, step, 0.35 * RADIUS) {
            Ok((curve, mesh)) => compare(record, element, &curve, &mesh),
            Err(why) => record.holds(format!("{element}: {why}"), false),
        }
    }
}

/// Height and width at half and at the whole of the travel.
fn compare(record: &mut Record, element: &str, curve: &Curve, mesh: &Meshed) {
    let all = forces(curve, mesh);
    let top = curve.displacement(mesh.nearest([0.5, 1.0, 0.0]), 2);
    let side = curve.displacement(mesh.nearest([0.5, 0.0, 0.0]), 1);
    let last = all.len() - 1;
    for k in [last / 2, last] {
        let q = all[k] * RADIUS * RADIUS / BENDING;
        let Ok([height, width]) = ring::pulled(q) else {
            record.holds(format!("{element}: a force of {q}"), false);
            continue;
        };
        let what = |what: &str| format!("{element}, {what} at {q:.2} EI/R2");
        let off = |moved: f64, exact: f64| (moved / RADIUS / (exact - 1.0) - 1.0).abs();
        record.at_most(what("change of height"), off(top[k], height), 0.015);
        record.at_most(what("change of width"), off(side[k], width), 0.015);
    }
}
