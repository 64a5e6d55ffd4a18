//! Diehl (1995), end of section 3: "the use of UNSYMM had little influence on
//! solution speed". Measured in iterations; the time is a bench.
//!
//! Requirement: at the paper's tolerance (R_n = 5e-3) and at ours (1e-6) the
//! deck runs through with both settings and gives the same forces. `UNSYMM=NO`
//! symmetrises the tangent and takes the limit traction from the iteration
//! before, so that it converges linearly. The paper's remark holds at the
//! paper's tolerance: at most two iterations an increment more. At ours each
//! factor of ten costs an iteration or so: at most twelve more.
//!
//! Tolerance of the forces: what both stop at, of the peak.

use slideline_verification::{Cam, Curve, Method, Push, largest_difference, peak, run};

fn curve(deck: &str, unsymmetric: &str, tolerance: f64) -> Curve {
    let deck = deck
        .replace("*STEP, NLGEOM", &format!("*STEP, NLGEOM, UNSYMM={unsymmetric}"))
        .replace("*END STEP", &format!("*CONTROLS, PARAMETERS=FIELD\n{tolerance:?}\n*END STEP"));
    let curve = run(&deck).unwrap();
    assert_eq!(
        (curve.rows.len(), curve.totals.cutbacks),
        (20, 0),
        "no cutback: UNSYMM={unsymmetric}"
    );
    curve
}

fn compare(name: &str, deck: &str, (node, dof): (u64, usize)) {
    for (tolerance, more) in [(5e-3, 2.0), (1e-6, 12.0)] {
        let [yes, no] = ["YES", "NO"].map(|unsymmetric| curve(deck, unsymmetric, tolerance));
        let (with, without) = (yes.reaction(node, dof), no.reaction(node, dof));
        let off = largest_difference(&with, &without) / peak(&with);
        let [whole, half] = [yes.mean_iterations(), no.mean_iterations()];
        println!(
            "{name} R_n {tolerance:e}: UNSYMM=YES {whole:.2} iterations, NO {half:.2}; forces to {off:.1e}"
        );
        assert!(whole <= 8.0, "{name} {tolerance:e}: {whole}");
        assert!(half <= whole + more, "{name} {tolerance:e}: {whole} {half}");
        assert!(off <= tolerance, "{name} {tolerance:e}: {off:e}");
    }
}

#[test]
fn circle() {
    let push = Push { mu: 0.3, ..Push::paper(Method::Isl) };
    compare("ISL", &push.deck(), (Push::CIRCLE, 2));
}

#[test]
fn cam() {
    let cam = Cam { increments: 20, mu: 0.3, onset: "IMMEDIATE", spacing: 3.0 };
    compare("cam", &cam.deck(), (Cam::PIVOT, 6));
}
