//! A cantilever under a load that turns with its sections.

use slideline_theory::closed::follower;
use slideline_verification::{Claim, Group, Record, run, worst};

pub const GROUP: Group = Group {
    file: "beams_follower_load",
    claims: &[Claim {
        name: "tip_under_a_load_across_it",
        requirement: "Angle, deflection and shortening of the tip under P2 with NLGEOM, q L3/EI = 4 to \
                      20 (the tip turns by up to 149 degrees), by 40 B21, 20 B22, 40 B31 in an oblique \
                      plane (P1 and P2) and 20 B32; at most four iterations an increment.",
        source: "Balance in the axes of the beam, integrated from the tip (derived), docs/theory.md \
                 eqs (4.19), (4.20).",
        tolerance: "0.1 % of the length and of a radian: elements of one point lack a fraction \
                    1/(4 n2) of the bending flexibility, here 0.016 %, and a share of the load at every \
                    node of a bent polygon is as near. A load that stays along y cannot turn the tip beyond 90 degrees.",
        measure: tip_under_a_load_across_it,
    }],
};

/// L = 1, EI = 1, EA = 1.2e5; q = 20 in ten increments along the
/// section's axis of this number.
fn deck(element: &str, axis: usize) -> String {
    let quadratic = element.ends_with('2') && element != "B21";
    let (step, count) = if quadratic { (2, 20) } else { (1, 40) };
    let row = if quadratic { "1, 1, 2, 3" } else { "1, 1, 2" };
    let space = element.starts_with("B3");
    // the beam along (2, 1, 2)/3; it bends towards (1, 2, -2)/3 under either axis
    let end = if space { [2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0] } else { [1.0, 0.0, 0.0] };
    let first = match (space, axis) {
        (true, 1) => "1.0, 2.0, -2.0",
        // n2 = t x n1
        (true, _) => "2.0, -2.0, -1.0",
        _ => "",
    };
    format!(
        "*HEADING\nfollower load\n*NODE, NSET=BEAM\n1, 0.0, 0.0, 0.0\n41, {:?}, {:?}, {:?}\n\
         *NGEN, NSET=BEAM\n1, 41, 1\n*ELEMENT, TYPE={element}, ELSET=BEAM\n{row}\n\
         *ELGEN, ELSET=BEAM\n1, {count}, {step}, 1\n*BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n\
         0.01, 0.01\n{first}\n*MATERIAL, NAME=M\n\
         *ELASTIC\n1.2E9, 0.0\n*STEP, NLGEOM, INC=100\n*STATIC\n0.1, 1.0, 1.0E-6, 0.1\n*BOUNDARY\n\
         1, ENCASTRE\n*DLOAD\nBEAM, P{axis}, 20.0\n*NODE PRINT, NSET=BEAM\nU\n*END STEP\n",
        end[0], end[1], end[2],
    )
}

fn tip_under_a_load_across_it(record: &mut Record) {
    for (element, axis) in [("B21", 2), ("B22", 2), ("B31", 1), ("B31", 2), ("B32", 2)] {
        let curve = run(&deck(element, axis)).unwrap();
        let space = element.starts_with("B3");
        let [along, up] = match space {
            true => [[2.0, 1.0, 2.0], [1.0, 2.0, -2.0]].map(|v| v.map(|x: f64| x / 3.0)),
            false => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        };
        let u: Vec<Vec<f64>> = (1..=3)
            .map(|dof| if dof == 3 && !space { vec![] } else { curve.displacement(41, dof) })
            .collect();
        let off = (0..curve.rows.len()).filter(|k| k % 2 == 1).map(|k| {
            let exact = follower::tip(20.0 * curve.rows[k].time);
            let part = |axis: [f64; 3]| -> f64 {
                u.iter().zip(axis).filter_map(|(u, a)| Some(u.get(k)? * a)).sum()
            };
            let (v, w) = (part(up) - exact.deflection, part(along) + exact.shortening);
            v.hypot(w)
        });
        record.at_most(
            format!("{element}, P{axis}: tip off, largest (% of L)"),
            100.0 * worst(off),
            0.1,
        );
        record.equal(format!("{element}, P{axis}: increments"), curve.rows.len(), 10);
        record.at_most(
            format!("{element}, P{axis}: iterations an increment"),
            curve.mean_iterations(),
            4.0,
        );
    }
}
