//! Springs and loads that follow an amplitude.

use slideline::output::plot::Axis;
use slideline_verification::{Claim, Group, Record, run, series, worst};

pub const GROUP: Group = Group {
    file: "amplitudes_and_springs",
    claims: &[
        Claim {
            name: "load_follows_its_amplitude",
            requirement: "A load with an amplitude on springs in series with ground follows it, \
                          linear between its points and constant outside them.",
            source: "Hooke's law (derived).",
            tolerance: "1e-12 m: a linear problem, rounding only.",
            measure: load_follows_its_amplitude,
        },
        Claim {
            name: "motion_follows_its_amplitude",
            requirement: "A prescribed motion follows its amplitude, and the spring its motion.",
            source: "Hooke's law (derived).",
            tolerance: "1e-14 m and 1e-12 N: nothing is solved for, rounding only.",
            measure: motion_follows_its_amplitude,
        },
        Claim {
            name: "truss_snaps_through",
            requirement: "An axial spring turns with its nodes: the load of a shallow truss under \
                          a prescribed deflection v is 2 k (L0 - L)(h - v)/L.",
            source: "Geometry of an axial spring (derived).",
            tolerance: "1e-9 N of some 5 N: residuals are held at 1e-12.",
            measure: truss_snaps_through,
        },
    ],
};

fn load_follows_its_amplitude(record: &mut Record) {
    let deck = "*HEADING\namplitude\n*NODE\n1, 0.0, 0.0\n2, 1.0, 0.0\n\
        *ELEMENT, TYPE=SPRING1, ELSET=GROUND\n1, 1\n*SPRING, ELSET=GROUND\n1\n50.0\n\
        *ELEMENT, TYPE=SPRINGA, ELSET=LINK\n2, 1, 2\n*SPRING, ELSET=LINK\n\n200.0\n\
        *AMPLITUDE, NAME=A\n0.0, 0.0, 1.0, 1.0, 2.0, -0.5, 3.0, 0.25\n\
        *STEP, NLGEOM\n*STATIC\n0.25, 4.0, 1.0E-6, 0.25\n*BOUNDARY\n1, 2\n1, 6\n2, 2\n2, 6\n\
        *CLOAD, AMPLITUDE=A\n2, 1, 10.0\n*CONTROLS, PARAMETERS=FIELD\n1.0E-13\n*END STEP\n";
    let curve = run(deck).unwrap();
    let (first, second) = (curve.displacement(1, 1), curve.displacement(2, 1));
    record.equal("increments", curve.rows.len(), 16);
    let force = |t: f64| {
        10.0 * match t {
            t if t <= 1.0 => t,
            t if t <= 2.0 => 1.0 - 1.5 * (t - 1.0),
            t if t <= 3.0 => -0.5 + 0.75 * (t - 2.0),
            _ => 0.25,
        }
    };
    let forces: Vec<f64> = curve.rows.iter().map(|row| force(row.time)).collect();
    let off = |found: &[f64], flexibility: f64| {
        worst(found.iter().zip(&forces).map(|(u, force)| (u - force * flexibility).abs()))
    };
    record.at_most("first node, largest difference (m)", off(&first, 1.0 / 50.0), 1e-12);
    let both = 1.0 / 50.0 + 1.0 / 200.0;
    record.at_most("second node, largest difference (m)", off(&second, both), 1e-12);
}

fn motion_follows_its_amplitude(record: &mut Record) {
    let deck = "*HEADING\namplitude\n*NODE\n1, 0.0, 0.0\n*ELEMENT, TYPE=SPRING1, ELSET=GROUND\n\
        1, 1\n*SPRING, ELSET=GROUND\n1\n50.0\n*AMPLITUDE, NAME=A\n0.0, 1.0, 1.0, -1.0\n\
        *STEP\n*STATIC\n0.25, 1.0, 1.0E-6, 0.25\n*BOUNDARY, AMPLITUDE=A\n1, 1, 1, 0.1\n\
        *BOUNDARY\n1, 2\n1, 6\n*END STEP\n";
    let curve = run(deck).unwrap();
    let (u, force) = (curve.displacement(1, 1), curve.reaction(1, 1));
    let exact: Vec<f64> = curve.rows.iter().map(|row| 0.1 * (1.0 - 2.0 * row.time)).collect();
    let off = |found: &[f64], scale: f64| {
        worst(found.iter().zip(&exact).map(|(found, exact)| (found - scale * exact).abs()))
    };
    record.at_most("motion, largest difference (m)", off(&u, 1.0), 1e-14);
    record.at_most("reaction, largest difference (N)", off(&force, 50.0), 1e-12);
}

fn truss_snaps_through(record: &mut Record) {
    let deck = "*HEADING\ntruss\n*NODE\n1, -1.0, 0.0\n2, 0.0, 0.2\n3, 1.0, 0.0\n\
        *ELEMENT, TYPE=SPRINGA, ELSET=BARS\n1, 1, 2\n2, 2, 3\n*SPRING, ELSET=BARS\n\n1000.0\n\
        *STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n1, 1, 6\n3, 1, 6\n2, 6\n\
        2, 2, 2, -0.5\n*CONTROLS, PARAMETERS=FIELD\n1.0E-12\n*END STEP\n";
    let curve = run(deck).unwrap();
    let (v, force) = (curve.displacement(2, 2), curve.reaction(2, 2));
    let natural = 1f64.hypot(0.2);
    let exact: Vec<f64> = v
        .iter()
        .map(|v| {
            let height = 0.2 + v;
            let length = 1f64.hypot(height);
            -2.0 * 1000.0 * (natural - length) * height / length
        })
        .collect();
    let off = worst(force.iter().zip(&exact).map(|(found, exact)| (found - exact).abs()));
    record.at_most("largest difference (N)", off, 1e-9);
    record.chart(
        "Load of the truss",
        Axis::linear("deflection U2 (m)"),
        Axis::linear("RF2 (N)"),
        vec![series(&v, ("slideline", &force)), series(&v, ("closed form", &exact))],
    );
}
