//! Bisshopp and Drucker's cantilever under a dead load at its tip.

use slideline::output::plot::Axis;
use slideline_theory::closed::bisshopp_drucker;
use slideline_verification::{Claim, Group, Record, run, series, worst};

pub const GROUP: Group = Group {
    file: "beams_bisshopp_drucker",
    claims: &[Claim {
        name: "tip_angle_deflection_shortening",
        requirement: "Tip angle, deflection and shortening of the inextensible cantilever under \
                      PL2/EI = 0.25 to 15, by 20 elements.",
        source: "Bisshopp and Drucker (1945), by elliptic integrals.",
        tolerance: "0.1 %: one-point elements lack a fraction 1/(4 n2) = 0.06 % of the bending \
                    flexibility, of which the slenderness compensation gives back about three \
                    quarters; L/t = 1000 keeps stretch and shear below 1e-5.",
        measure: tip_angle_deflection_shortening,
    }],
};

const LOADS: [usize; 12] = [1, 2, 4, 8, 12, 16, 20, 24, 28, 32, 40, 60]; // quarters

/// L = 1, EI = 1, P = 15 in 60 increments.
const DECK: &str = "*HEADING\ndead load\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n21, 1.0, 0.0\n\
    *NGEN, NSET=BEAM\n1, 21, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n\
    *ELGEN, ELSET=BEAM\n1, 20, 1, 1\n*BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n\
    12.0, 1.0E-3\n*MATERIAL, NAME=M\n*ELASTIC\n1.0E9, 0.0\n*STEP, NLGEOM, INC=1000\n*STATIC\n\
    0.25, 15.0, 1.0E-6, 0.25\n*BOUNDARY\n1, ENCASTRE\n*CLOAD\n21, 2, -15.0\n*END STEP\n";

fn tip_angle_deflection_shortening(record: &mut Record) {
    let curve = run(DECK).unwrap();
    let found = [6, 2, 1].map(|dof| -> Vec<f64> {
        let values = curve.displacement(21, dof);
        LOADS.iter().map(|quarters| -values[quarters - 1]).collect()
    });
    let loads = LOADS.map(|quarters| 0.25 * quarters as f64);
    record.holds(
        "an increment ends at every load of the table",
        LOADS.iter().zip(loads).all(|(k, load)| (curve.rows[k - 1].time - load).abs() < 1e-9),
    );
    let exact = loads.map(|load| bisshopp_drucker::tip(load).unwrap());
    let exact = [
        exact.map(|tip| tip.angle).to_vec(),
        exact.map(|tip| tip.deflection).to_vec(),
        exact.map(|tip| tip.shortening).to_vec(),
    ];
    let names = ["angle (rad)", "deflection / L", "shortening / L"];
    for k in 0..3 {
        let off = worst(found[k].iter().zip(&exact[k]).map(|(a, b)| 100.0 * (a / b - 1.0).abs()));
        record.at_most(format!("{}, largest error (%)", names[k]), off, 0.1);
    }
    record.tell("iterations an increment", curve.mean_iterations());
    let curves = (0..3).map(|k| series(&loads, (names[k], &found[k]))).collect();
    let (x, y) = (Axis::linear("PL2/EI"), Axis::linear("tip"));
    record.chart("Tip of the cantilever under a dead load", x, y, curves);
}
