//! Finite rotation of a rigid link.
//!
//! Requirement: the dependent node of an MPC of type BEAM turns with its
//! master on a circle, and a force on it reaches the master's support with its
//! moment. Source: semantics section 8. Tolerance 1e-12: a formula, no solution.

use slideline_verification::run;

const TURN: f64 = 2.5;

#[test]
fn turns_on_a_circle_and_hands_its_force_over() {
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
    for (k, row) in curve.rows.iter().enumerate() {
        let share = row.time.min(1.0);
        let (s, c) = (TURN * share).sin_cos();
        let arm = [3.0 * c - 4.0 * s, 3.0 * s + 4.0 * c];
        assert!((turn[k] - TURN * share).abs() < 1e-12);
        assert!((u[k] - (shift[k] + arm[0] - 3.0)).abs() < 1e-12, "{} {:?}", u[k], arm);
        assert!((v[k] - (arm[1] - 4.0)).abs() < 1e-12, "{} {:?}", v[k], arm);
        let force = [3.0 * share, -7.0 * share];
        assert!((fx[k] + force[0]).abs() < 1e-12, "RF1 {} of load {}", fx[k], force[0]);
        assert!((fy[k] + force[1]).abs() < 1e-12, "RF2 {} of load {}", fy[k], force[1]);
        let moment = arm[0] * force[1] - arm[1] * force[0];
        assert!((m[k] + moment).abs() < 1e-11, "{} {moment}", m[k]);
    }
}
