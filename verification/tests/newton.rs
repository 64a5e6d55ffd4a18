//! Newton's order, and how many iterations the paper's decks take.
//!
//! Source: verification section 7. Order: with the active set fixed the
//! residual falls as the square of the one before. Iterations: <= 8 on
//! average, no cutback, 20 increments.

use slideline::observe::IterationReport;
use slideline_verification::{Curve, Method, Push, paper, run};

/// Residuals of every increment from the last change of contact on, down to
/// the first at the floor of rounding.
fn falls(curve: &Curve) -> Vec<Vec<f64>> {
    let by_increment = |a: &IterationReport, b: &IterationReport| a.increment == b.increment;
    let fall = |reports: &[IterationReport]| {
        let clean = reports.iter().rposition(|r| r.severe).map_or(0, |last| last + 1);
        reports[clean..]
            .iter()
            .map(|r| (r.force.residual, r.force.allowed))
            .take_while(|(residual, floor)| *residual > *floor)
            .map(|(residual, _)| residual)
            .collect()
    };
    curve.iterations.chunk_by(by_increment).map(fall).collect()
}

/// (order, constant) of successive residuals r, r' below a twentieth of the
/// load q: ln(r'/q)/ln(r/q), the order in units in which the quadratic term is
/// of the size of one, and r' q/r2.
fn orders(curve: &Curve, load: f64) -> Vec<[f64; 2]> {
    let of = |r: &[f64]| [(r[1] / load).ln() / (r[0] / load).ln(), r[1] * load / (r[0] * r[0])];
    let late = |fall: &Vec<f64>| -> Vec<[f64; 2]> {
        fall.windows(2).filter(|r| r[0] < 0.05 * load).map(of).collect()
    };
    falls(curve).iter().flat_map(late).collect()
}

/// A stubby beam: in slender ones stretch and bending converge by turns, and
/// the largest residual jumps from one to the other down to the floor.
fn dead_load(increments: usize) -> String {
    format!(
        "*HEADING\ndead load\n*NODE, NSET=BEAM\n1, 0.0, 0.0\n11, 1.0, 0.0\n*NGEN, NSET=BEAM\n\
         1, 11, 1\n*ELEMENT, TYPE=B21, ELSET=BEAM\n1, 1, 2\n*ELGEN, ELSET=BEAM\n1, 10, 1, 1\n\
         *BEAM SECTION, ELSET=BEAM, SECTION=RECT, MATERIAL=M\n1.0, 0.5\n*MATERIAL, NAME=M\n\
         *ELASTIC\n96.0, 0.0\n*STEP, NLGEOM\n*STATIC\n{dt:?}, 1.0, 1.0E-6, {dt:?}\n*BOUNDARY\n\
         1, ENCASTRE\n*CLOAD\n11, 2, -5.0\n*CONTROLS, PARAMETERS=FIELD\n1.0E-13\n*END STEP\n",
        dt = 1.0 / increments as f64
    )
}

/// Tolerance: the mean order >= 1.8, and r' q/r2 below 100 for every pair down
/// to the floor; a rate of convergence would make it 1e6 and more there.
#[test]
fn beams_are_quadratic_to_the_floor() {
    for increments in [1, 2, 3] {
        let curve = run(&dead_load(increments)).unwrap();
        let orders = orders(&curve, 5.0);
        println!("order, beam, {increments} increments: {orders:.2?}");
        assert!(!orders.is_empty(), "nothing to measure");
        let mean = orders.iter().map(|[order, _]| order).sum::<f64>() / orders.len() as f64;
        assert!(mean >= 1.8, "{orders:?}");
        assert!(orders.iter().all(|[_, constant]| *constant < 100.0), "{orders:?}");
    }
}

/// With contact only two residuals as a rule lie between the first and the
/// floor, so that r_{i+1}/r_i2 is looked at, the residual at the floor
/// included: bounded by 100 per newton over the whole stroke. With a tangent
/// that is wrong by one part in a thousand it would be 1e-3/r_i, a thousand
/// times as much when the floor of 1e-9 N is near.
#[test]
fn contact_is_quadratic_to_the_floor() {
    for method in [Method::Irs, Method::Isl] {
        for mu in [0.0, 0.3] {
            let push = Push { mu, tolerance: Some(1e-13), ..Push::paper(method) };
            let deck = push.deck().replace("*STEP, NLGEOM", "*STEP, NLGEOM, EXTRAPOLATION=NO");
            let curve = run(&deck).unwrap();
            let falls = falls(&curve);
            let ratios: Vec<f64> = falls
                .iter()
                .flat_map(|fall| fall.windows(2).map(|r| r[1] / (r[0] * r[0])))
                .collect();
            let worst = ratios.iter().copied().fold(0.0, f64::max);
            let longest = falls.iter().map(Vec::len).max().unwrap();
            println!(
                "Newton {method:?} mu {mu}: r2/r1^2 <= {worst:.2e} 1/N, {longest} residuals above the floor"
            );
            assert!(longest >= 2, "{falls:?}");
            assert!(worst < 100.0, "{falls:?}");
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
