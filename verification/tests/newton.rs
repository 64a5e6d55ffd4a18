//! Newton's order, and how many iterations the paper's decks take.
//!
//! Source: verification section 7. Order: with the active set fixed the
//! residual falls as the square of the one before, >= 1.8 measured on the
//! pairs of ratios that lie above the floor of rounding. Iterations: <= 8 on
//! average, no cutback, 20 increments.

use slideline::observe::IterationReport;
use slideline_verification::{Method, Push, paper, run};

/// ln(r3/r2)/ln(r2/r1) of the last three residuals above the floor of every
/// increment, where contact did not change.
fn orders(iterations: &[IterationReport]) -> Vec<f64> {
    let mut orders = Vec::new();
    for increment in iterations.chunk_by(|a, b| (a.step, a.increment) == (b.step, b.increment)) {
        let clean: Vec<f64> = increment
            .iter()
            .skip_while(|report| report.severe || !report.contact_changes.is_empty())
            .map(|report| report.force.residual)
            .filter(|&residual| residual > 1e3 * increment[0].force.allowed)
            .collect();
        // asymptotic only where the residual has begun to fall fast
        for three in clean.windows(3).rev().take(1) {
            if three[2] < 1e-2 * three[1] && three[1] < 0.1 * three[0] {
                orders.push((three[2] / three[1]).ln() / (three[1] / three[0]).ln());
            }
        }
    }
    orders
}

#[test]
fn quadratic_to_the_floor() {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            // few large increments leave Newton something to do
            let push =
                Push { increments: 12, mu, tolerance: Some(1e-13), ..Push::paper(method) };
            let curve = run(&push.deck()).unwrap();
            let orders = orders(&curve.iterations);
            let worst = orders.iter().copied().fold(f64::INFINITY, f64::min);
            println!("order {method:?} mu {mu}: {:?}", orders);
            assert!(!orders.is_empty(), "nothing to measure");
            assert!(worst >= 1.8, "{method:?} mu {mu}: {orders:?}");
        }
    }
}

#[test]
fn few_iterations_and_no_cutback() {
    for (name, deck) in [
        ("IRS coarse", paper::IRS_COARSE),
        ("IRS fine", paper::IRS_FINE),
        ("ISL coarse", paper::ISL_COARSE),
    ] {
        for mu in ["0.0", "0.3"] {
            let deck = deck.replace("*FRICTION\n0.0", &format!("*FRICTION\n{mu}"));
            let curve = run(&deck).unwrap();
            println!(
                "{name}, mu {mu}: {:.2} iterations, {} cutbacks",
                curve.mean_iterations(),
                curve.totals.cutbacks
            );
            assert_eq!(curve.totals.cutbacks, 0, "{name} mu {mu}");
            assert_eq!(curve.rows.len(), 20, "{name} mu {mu}");
            assert!(curve.mean_iterations() <= 8.0, "{name}: {}", curve.mean_iterations());
        }
    }
}
