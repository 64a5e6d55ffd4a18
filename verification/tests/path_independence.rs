//! 20 and 200 increments end at the same force.

use slideline_verification::{Claim, Group, Method, Push, Record, largest_difference, peak, run};

pub const GROUP: Group = Group {
    file: "path_independence",
    claims: &[Claim {
        name: "twenty_and_two_hundred",
        requirement: "Without friction, and with friction in steady sliding, the force at a \
                      position does not depend on how many increments led there.",
        source: "A potential; rate-independent sliding (derived).",
        tolerance: "1e-8 of the peak, with residuals held at 1e-11.",
        measure: twenty_and_two_hundred,
    }],
};

fn twenty_and_two_hundred(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-11), ..Push::paper(method) };
            let coarse = run(&push.deck()).unwrap().reaction(Push::CIRCLE, 2);
            let dense = run(&Push { increments: 200, ..push }.deck()).unwrap();
            assert_eq!(dense.rows.len(), 200, "no cutback");
            let dense = dense.reaction(Push::CIRCLE, 2);
            let same: Vec<f64> = dense.iter().skip(9).step_by(10).copied().collect();
            let off = largest_difference(&coarse, &same) / peak(&coarse);
            record.at_most(format!("{method:?}, mu {mu}, largest difference (of peak)"), off, 1e-8);
        }
    }
}
