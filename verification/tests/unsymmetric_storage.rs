//! `UNSYMM=NO` symmetrises the tangent and takes the limit traction from the
//! iteration before, so that it converges linearly. Measured in iterations;
//! the time is a bench.

use slideline_verification::{
    Cam, Claim, Curve, Group, Method, Push, Record, largest_difference, peak, run,
};

const REMARK: &str = "Diehl (1995), end of section 3: \"the use of UNSYMM had little influence on \
                      solution speed\".";
const ITERATIONS: &str = "Forces: what both stop at, of the peak. Iterations: at the paper's \
                          tolerance (5e-3) at most two an increment more; at ours (1e-6) each \
                          factor of ten costs one or so, at most twelve more.";

pub const GROUP: Group = Group {
    file: "unsymmetric_storage",
    claims: &[
        Claim {
            name: "circle",
            requirement: "The ISL deck runs through with both settings of UNSYMM, at the paper's \
                          tolerance and at ours, and gives the same forces.",
            source: REMARK,
            tolerance: ITERATIONS,
            measure: circle,
        },
        Claim {
            name: "cam",
            requirement: "The cam deck runs through with both settings of UNSYMM, at the paper's \
                          tolerance and at ours, and gives the same moments.",
            source: REMARK,
            tolerance: ITERATIONS,
            measure: cam,
        },
    ],
};

fn curve(deck: &str, unsymmetric: &str, tolerance: f64) -> Curve {
    let deck = deck
        .replace("*STEP, NLGEOM", &format!("*STEP, NLGEOM, UNSYMM={unsymmetric}"))
        .replace("*END STEP", &format!("*CONTROLS, PARAMETERS=FIELD\n{tolerance:?}\n*END STEP"));
    let curve = run(&deck).unwrap();
    assert_eq!((curve.rows.len(), curve.totals.cutbacks), (20, 0), "UNSYMM={unsymmetric}");
    curve
}

fn compare(record: &mut Record, deck: &str, (node, dof): (u64, usize)) {
    for (tolerance, more) in [(5e-3, 2.0), (1e-6, 12.0)] {
        let [yes, no] = ["YES", "NO"].map(|unsymmetric| curve(deck, unsymmetric, tolerance));
        let (with, without) = (yes.reaction(node, dof), no.reaction(node, dof));
        let off = largest_difference(&with, &without) / peak(&with);
        let [whole, half] = [yes.mean_iterations(), no.mean_iterations()];
        let what = |what: &str| format!("tolerance {tolerance:e}: {what}");
        record.at_most(what("iterations an increment, UNSYMM=YES"), whole, 8.0);
        record.at_most(what("iterations an increment, UNSYMM=NO"), half, whole + more);
        record.at_most(what("largest difference (of peak)"), off, tolerance);
    }
}

fn circle(record: &mut Record) {
    let push = Push { mu: 0.3, ..Push::paper(Method::Isl) };
    compare(record, &push.deck(), (Push::CIRCLE, 2));
}

fn cam(record: &mut Record) {
    let cam = Cam { increments: 20, mu: 0.3, onset: "IMMEDIATE", spacing: 3.0 };
    compare(record, &cam.deck(), (Cam::PIVOT, 6));
}
