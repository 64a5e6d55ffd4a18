//! 20 and 200 increments end at the same force.
//!
//! Requirement: without friction, and with friction in steady sliding, the
//! force at a position does not depend on how many increments led there.
//! Source: verification section 7. Tolerance 1e-8 of the peak, at R_n = 1e-11.

use slideline_verification::{Method, Push, largest_difference, peak, run};

#[test]
fn twenty_and_two_hundred() {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-11), ..Push::paper(method) };
            let coarse = run(&push.deck()).unwrap().reaction(Push::CIRCLE, 2);
            let dense = run(&Push { increments: 200, ..push }.deck()).unwrap();
            assert_eq!(dense.rows.len(), 200, "no cutback");
            let dense = dense.reaction(Push::CIRCLE, 2);
            let same: Vec<f64> = dense.iter().skip(9).step_by(10).copied().collect();
            let off = largest_difference(&coarse, &same) / peak(&coarse);
            println!("path {method:?} mu {mu}: {off:.1e}");
            assert!(off < 1e-8, "{method:?} mu {mu}: {off:e}");
        }
    }
}
