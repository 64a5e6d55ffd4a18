//! Simo and Vu-Quoc's roll-up: a cantilever under a moment at its end.

use slideline::output::plot::{Axis, Mark, Series};
use slideline_theory::closed::roll_up;
use slideline_verification::{Claim, Group, Record, run, worst};
use std::f64::consts::PI;

pub const GROUP: Group = Group {
    file: "beams_roll_up",
    claims: &[Claim {
        name: "polygon_at_every_load_and_closed_at_the_last",
        requirement: "Curvature is exact in the two-node one-point element, so that the nodes lie \
                      on a regular polygon at every load and close at 2 pi, within ten increments.",
        source: "Simo and Vu-Quoc (1986); the polygon is derived.",
        tolerance: "1e-10 of the length: no discretisation error is left, only the residual at \
                    which Newton stops.",
        measure: polygon_at_every_load_and_closed_at_the_last,
    }],
};

const ELEMENTS: usize = 10;

/// EI = 1, L = 1, end moment 2 pi.
fn deck() -> String {
    format!(
        "*HEADING\nroll-up\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n11, 1.0, 0.0\n*NGEN, NSET=BEAM\n\
         1, 11, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, {ELEMENTS}, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n1.0, 0.1\n\
         *MATERIAL, NAME=M\n*ELASTIC\n12000.0, 0.0\n\
         *STEP, NLGEOM\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n1, ENCASTRE\n\
         *CLOAD\n11, 6, {:?}\n*CONTROLS, PARAMETERS=FIELD\n1.0E-11\n*END STEP\n",
        2.0 * PI
    )
}

fn polygon_at_every_load_and_closed_at_the_last(record: &mut Record) {
    let curve = run(&deck()).unwrap();
    record.equal("increments", curve.rows.len(), 10);
    let (x, y) = (curve.displacement(11, 1), curve.displacement(11, 2));
    let off = curve.rows.iter().enumerate().map(|(k, row)| {
        let [tip_x, tip_y] = roll_up::polygon_tip(2.0 * PI * row.time, ELEMENTS);
        (1.0 + x[k] - tip_x).hypot(y[k] - tip_y)
    });
    record.at_most("tip from the polygon's, largest (of L)", worst(off), 1e-10);
    record.at_most("tip from the clamp at 2 pi (of L)", (1.0 + x[9]).hypot(y[9]), 1e-10);
    let turn = (curve.displacement(11, 6)[9] - 2.0 * PI).abs();
    record.at_most("rotation of the tip less 2 pi", turn, 1e-10);
    record.tell("iterations an increment", curve.mean_iterations());
    let shape = |k: usize| Series {
        name: format!("load {}0 %", k + 1),
        points: (1..=11)
            .map(|label| {
                let [u, v] = [1, 2].map(|dof| curve.displacement(label, dof)[k]);
                [0.1 * (label - 1) as f64 + u, v]
            })
            .collect(),
        mark: Mark::Curve,
        colour: 0,
    };
    let shapes = [0, 2, 4, 6, 9].map(shape).to_vec();
    let (x, y) = (Axis::linear("x / L"), Axis::linear("y / L"));
    record.chart("Rolled up by a moment at the tip", x, y, shapes);
}
