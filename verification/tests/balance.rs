//! Balance of forces and of moments about the origin, every increment.

use slideline_verification::{Claim, Curve, Group, Method, Push, Record, largest, run};

pub const GROUP: Group = Group {
    file: "balance",
    claims: &[Claim {
        name: "supports_balance_one_another",
        requirement: "RF(clamp) + RF(circle) = 0 in every increment, and the moments of both about \
                      the origin, with and without friction, for contact elements on the beam, on \
                      the circle, and for integrated contact.",
        source: "Action and reaction at any overclosure (docs/theory.md, contact forces).",
        tolerance: "What the free nodes may keep as residual, 1e-12 of the mean force or the floor \
                    of rounding, over a force that grows to 14 N: 1e-9 of the peak. A moment \
                    tau A h handed over wrongly would be 1e-5.",
        measure: supports_balance_one_another,
    }],
};

fn totals(push: &Push) -> (f64, f64) {
    let curve = run(&push.deck()).unwrap();
    let [fx, fy, m] = sums(&curve, &[push.beam_label(0), Push::CIRCLE]);
    let circle = [1, 2].map(|dof| curve.reaction(Push::CIRCLE, dof));
    let force = largest(&circle[0], &circle[1]);
    (largest(&fx, &fy) / force, largest(&m, &m) / (force * 50e-3))
}

/// Sum over the nodes of RF1, RF2 and of the moments about the origin.
fn sums(curve: &Curve, labels: &[u64]) -> [Vec<f64>; 3] {
    let mut sums = [(); 3].map(|()| vec![0.0; curve.rows.len()]);
    for &label in labels {
        let node = curve.model.nodes.find(label).unwrap();
        let start = curve.model.nodes.position(node);
        for (k, row) in curve.rows.iter().enumerate() {
            let ([fx, fy, .., m], u) = (row.reaction[node], row.displacement[node]);
            sums[0][k] += fx;
            sums[1][k] += fy;
            sums[2][k] += m + (start[0] + u[0]) * fy - (start[1] + u[1]) * fx;
        }
    }
    sums
}

fn supports_balance_one_another(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-12), ..Push::paper(method) };
            let (force, moment) = totals(&push);
            record.at_most(format!("forces, {method:?}, mu {mu} (of the peak)"), force, 1e-9);
            record.at_most(format!("moments, {method:?}, mu {mu} (of peak x 50 mm)"), moment, 1e-9);
        }
    }
}
