//! A round bar of rubber, twisted between plates.
//!
//! ```text
//!   (____)  turns by 1 rad a length, in steps of a fifth
//!   |    |  radius 1, length 1; the side is free
//!   (____)  held
//! ```

use slideline_theory::closed::torsion::RubberBar;
use slideline_verification::{Claim, Group, Record, Solid, run};
use std::fmt::Write as _;

pub const GROUP: Group = Group {
    file: "solids_torsion",
    claims: &[Claim {
        name: "twisted_rubber",
        requirement: "torque and axial force of a twisted bar, of neo-Hooke and of Mooney and Rivlin, \
                      are those of the closed form.",
        source: "R. S. Rivlin, Large elastic deformations of isotropic materials VI, Phil. Trans. A \
                 242 (1949): every section turns as a whole, which loads no free side.",
        tolerance: "0.5 % quadratic hexahedra; 1.5 % linear ones, whose circle is a polygon of 32 \
                    sides and whose fibres are straight between sections. K = 2000 G.",
        measure: twist,
    }],
};

const TURN: f64 = 1.0;
const STEPS: usize = 5;

/// From a square to a disc, a length of 1.
fn bar([x, y, z]: [f64; 3]) -> [f64; 3] {
    let [s, t] = [2.0 * x - 1.0, 2.0 * y - 1.0];
    [s * (1.0 - 0.5 * t * t).sqrt(), t * (1.0 - 0.5 * s * s).sqrt(), z]
}

/// Torque and force.
fn twisted(element: &str, cells: [usize; 3], [c10, c01]: [f64; 2]) -> Result<[f64; 2], String> {
    let soft = 1.0 / (2000.0 * (c10 + c01));
    let material = format!("*HYPERELASTIC, MOONEY-RIVLIN\n{c10:?}, {c01:?}, {soft:?}\n");
    let solid = Solid { element, cells, map: bar, material: &material };
    let mesh = solid.curved();
    let mut deck = format!("*HEADING\ntwist\n{}", mesh.text);
    let top: Vec<&(u64, [f64; 3], [f64; 3])> =
        mesh.nodes.iter().filter(|(_, at, _)| at[2] == 1.0).collect();
    for step in 1..=STEPS {
        deck.push_str("*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n");
        (1..=3).for_each(|axis| deck.push_str(&mesh.hold(|at| at[2] == 0.0, axis, 0.0)));
        let (sine, cosine) = (TURN * step as f64 / STEPS as f64).sin_cos();
        for (label, _, [x, y, _]) in &top {
            let moved = [(cosine - 1.0) * x - sine * y, sine * x + (cosine - 1.0) * y, 0.0];
            for (axis, value) in moved.iter().enumerate() {
                let _ = writeln!(deck, "{label}, {0}, {0}, {value:?}", axis + 1);
            }
        }
        deck.push_str("*END STEP\n");
    }
    let curve = run(&deck)?;
    let row = curve.rows.last().ok_or("no increment")?;
    let (sine, cosine) = TURN.sin_cos();
    let mut found = [0.0; 2];
    for (label, _, [x, y, _]) in top {
        let force = row.reaction[curve.model.nodes.find(*label).ok_or("no node")?];
        found[0] += (cosine * x - sine * y) * force[1] - (sine * x + cosine * y) * force[0];
        found[1] += force[2];
    }
    Ok(found)
}

fn twist(record: &mut Record) {
    const NEO_HOOKE: [f64; 2] = [0.5, 0.0];
    for (element, cells, [c10, c01], tolerance) in [
        ("C3D8", [8, 8, 8], NEO_HOOKE, 0.015),
        ("C3D20R", [4, 4, 2], NEO_HOOKE, 0.005),
        ("C3D20R", [4, 4, 2], [0.3, 0.2], 0.005),
    ] {
        let exact = RubberBar { radius: 1.0, c10, c01 };
        let name = if c01 == 0.0 { "neo-Hooke" } else { "Mooney" };
        match twisted(element, cells, [c10, c01]) {
            Ok([torque, force]) => {
                let off = (torque / exact.torque(TURN) - 1.0).abs();
                record.at_most(format!("{element} {name}, torque"), off, tolerance);
                let off = (force / exact.force(TURN) - 1.0).abs();
                record.at_most(format!("{element} {name}, force"), off, tolerance);
            }
            Err(why) => record.holds(format!("{element} {name}: {why}"), false),
        }
    }
}
