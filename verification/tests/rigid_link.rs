//! Finite rotation of a rigid link.

use slideline_verification::{Claim, Group, Record, run, worst};

pub const GROUP: Group = Group {
    file: "rigid_link",
    claims: &[Claim {
        name: "turns_on_a_circle_and_hands_its_force_over",
        requirement: "The dependent node of an MPC of type BEAM turns with its master on a circle, \
                      and a force on it reaches the master's support with its moment.",
        source: "Rigid-body kinematics and statics (docs/theory.md, rigid links).",
        tolerance: "1e-12, 1e-11 for the moment: a formula, no solution.",
        measure: turns_on_a_circle_and_hands_its_force_over,
    }],
};

const TURN: f64 = 2.5;

fn turns_on_a_circle_and_hands_its_force_over(record: &mut Record) {
    let deck = format!(
        "*HEADING\nlink\n*NODE\n1, 1.0, 2.0\n2, 4.0, 6.0\n*MPC\nBEAM, 2, 1\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n1, 1, 2\n1, 6, 6, {TURN:?}\n\
         *CLOAD\n2, 1, 3.0\n2, 2, -7.0\n*END STEP\n*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n\
         *BOUNDARY\n1, 1, 1, 0.25\n*END STEP\n"
    );
    let curve = run(&deck).unwrap();
    let [u, v, turn] = [1, 2, 6].map(|dof| curve.displacement(2, dof));
    let [fx, fy, m] = [1, 2, 6].map(|dof| curve.reaction(1, dof));
    let shift = curve.displacement(1, 1);
    let mut off = [const { Vec::new() }; 4];
    for (k, row) in curve.rows.iter().enumerate() {
        let share = row.time.min(1.0);
        let (s, c) = (TURN * share).sin_cos();
        let arm = [3.0 * c - 4.0 * s, 3.0 * s + 4.0 * c];
        let force = [3.0 * share, -7.0 * share];
        off[0].push((turn[k] - TURN * share).abs());
        off[1].push((u[k] - (shift[k] + arm[0] - 3.0)).hypot(v[k] - (arm[1] - 4.0)));
        off[2].push((fx[k] + force[0]).hypot(fy[k] + force[1]));
        off[3].push((m[k] + arm[0] * force[1] - arm[1] * force[0]).abs());
    }
    record.equal("increments", curve.rows.len(), 11);
    let names = ["rotation", "place", "reaction", "moment"];
    for ((name, off), limit) in names.iter().zip(off).zip([1e-12, 1e-12, 1e-12, 1e-11]) {
        record.at_most(format!("{name}, largest error"), worst(off), limit);
    }
}
