//! Springs and loads that follow an amplitude.
//!
//! Source: Hooke's law and the geometry of an axial spring (derived).
//! Tolerance 1e-12 for the linear ones; 1e-9 for the snapping truss, whose
//! residual is held at 1e-12.

use slideline_verification::run;

/// Requirement: a load with an amplitude on springs in series with ground
/// follows it, linear between its points and constant outside them.
#[test]
fn load_follows_its_amplitude() {
    let deck = "*HEADING\namplitude\n*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n\
        *ELEMENT, TYPE=SPRING1, ELSET=GROUND\n1, 1\n*SPRING, ELSET=GROUND\n1\n50.0\n\
        *ELEMENT, TYPE=SPRINGA, ELSET=LINK\n2, 1, 2\n*SPRING, ELSET=LINK\n\n200.0\n\
        *AMPLITUDE, NAME=A\n0.0, 0.0, 1.0, 1.0, 2.0, -0.5, 3.0, 0.25\n\
        *STEP, NLGEOM\n*STATIC\n0.25, 4.0, 1.0E-6, 0.25\n*BOUNDARY\n1, 2\n1, 6\n2, 2\n2, 6\n\
        *CLOAD, AMPLITUDE=A\n2, 1, 10.0\n*CONTROLS, PARAMETERS=FIELD\n1.0E-13\n*END STEP\n";
    let curve = run(deck).unwrap();
    let (first, second) = (curve.displacement(1, 1), curve.displacement(2, 1));
    assert_eq!(curve.rows.len(), 16);
    for (k, row) in curve.rows.iter().enumerate() {
        let t = row.time;
        let factor = match t {
            t if t <= 1.0 => t,
            t if t <= 2.0 => 1.0 - 1.5 * (t - 1.0),
            t if t <= 3.0 => -0.5 + 0.75 * (t - 2.0),
            _ => 0.25,
        };
        let force = 10.0 * factor;
        assert!((first[k] - force / 50.0).abs() < 1e-12, "{t}: {} {}", first[k], force / 50.0);
        let exact = force / 50.0 + force / 200.0;
        assert!((second[k] - exact).abs() < 1e-12, "{t}: {} {exact}", second[k]);
    }
}

/// Requirement: a prescribed motion follows its amplitude too.
#[test]
fn motion_follows_its_amplitude() {
    let deck = "*HEADING\namplitude\n*NODE\n1, 0.0, 0.0\n*ELEMENT, TYPE=SPRING1, ELSET=GROUND\n\
        1, 1\n*SPRING, ELSET=GROUND\n1\n50.0\n*AMPLITUDE, NAME=A\n0.0, 1.0, 1.0, -1.0\n\
        *STEP\n*STATIC\n0.25, 1.0, 1.0E-6, 0.25\n*BOUNDARY, AMPLITUDE=A\n1, 1, 1, 0.1\n\
        *BOUNDARY\n1, 2\n1, 6\n*END STEP\n";
    let curve = run(deck).unwrap();
    let (u, force) = (curve.displacement(1, 1), curve.reaction(1, 1));
    for (k, row) in curve.rows.iter().enumerate() {
        let exact = 0.1 * (1.0 - 2.0 * row.time);
        assert!((u[k] - exact).abs() < 1e-14, "{} {exact}", u[k]);
        assert!((force[k] - 50.0 * exact).abs() < 1e-12, "{}", force[k]);
    }
}

/// Requirement: an axial spring turns with its nodes: the load of a shallow
/// truss under a prescribed deflection v is 2 k (L0 - L)(h - v)/L.
#[test]
fn truss_snaps_through() {
    let deck = "*HEADING\ntruss\n*NODE\n1, -1.0, 0.0\n2, 0.0, 0.2\n3, 1.0, 0.0\n\
        *ELEMENT, TYPE=SPRINGA, ELSET=BARS\n1, 1, 2\n2, 2, 3\n*SPRING, ELSET=BARS\n\n1000.0\n\
        *STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n1, 1, 6\n3, 1, 6\n2, 6\n\
        2, 2, 2, -0.5\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n";
    let curve = run(deck).unwrap();
    let (v, force) = (curve.displacement(2, 2), curve.reaction(2, 2));
    let natural = 1f64.hypot(0.2);
    for k in 0..curve.rows.len() {
        let height = 0.2 + v[k];
        let length = 1f64.hypot(height);
        let exact = -2.0 * 1000.0 * (natural - length) * height / length;
        assert!((force[k] - exact).abs() < 1e-9, "{height}: {} {exact}", force[k]);
    }
}
