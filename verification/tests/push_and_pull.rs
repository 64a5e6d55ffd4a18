//! There and back with friction: the shipped push-and-pull decks of both
//! problems, and the stick transition at the turn.
//!
//! Requirement: while the circle goes back the friction is reversed, for
//! problem 1 RF2 = -F [sin(a - theta) - mu cos(a - theta)]. Source: issue text
//! and the paper's eq. (8) with the sign of mu changed (derived).
//!
//! Tolerances: those of the push, 1 % (circle) and 1.5 % (cam) RMS of the
//! push's peak against linear theory, whose own error is of that size; 0.5 %
//! for the circle against the softened shear-flexible beam. Slaves 3 degrees
//! apart carry the cam's force up to 0.24 mm beside the true point of contact;
//! spread evenly that is 0.14 mm times 12 N, 2.1 % of the peak moment. On the
//! push, increments and slaves keep step and it is less; on the way back it is
//! not, so that 2.5 % is asked of it. The first
//! increment after the turn belongs to the stick transition and is not
//! compared: how far the elastic slip has turned is not in the theory.

use slideline::observe::Status;
use slideline_theory::{FirstProblem, Reference, SecondProblem, Stroke};
use slideline_verification::{Cam, Curve, Push, paper, peak, run};

/// Increments of a stroke.
const N: usize = 20;

fn rms(found: &[f64], theory: &[f64], scale: f64) -> f64 {
    assert_eq!(found.len(), theory.len());
    let squares: f64 = found.iter().zip(theory).map(|(a, b)| (a - b) * (a - b)).sum();
    (squares / found.len() as f64).sqrt() / scale
}

/// Rows of a stroke back: from the increment after the turn to the start.
fn backwards(of_push: &[f64]) -> Vec<f64> {
    of_push.iter().rev().skip(1).copied().collect()
}

fn run_both_ways(deck: &str) -> Curve {
    let curve = run(deck).unwrap();
    assert_eq!((curve.rows.len(), curve.totals.cutbacks), (2 * N, 0), "no cutback");
    println!("{:.2} iterations an increment", curve.mean_iterations());
    assert!(curve.mean_iterations() <= 8.0);
    curve
}

#[test]
fn circle_follows_theory_both_ways() {
    for (deck, mu) in [(paper::ISL_PUSH_PULL_SMOOTH, 0.0), (paper::ISL_PUSH_PULL, 0.3)] {
        let found = run_both_ways(deck).reaction(Push::CIRCLE, 2);
        for (reference, limit) in [
            (Reference::Linear, if mu > 0.0 { 0.01 } else { 0.02 }),
            (Reference::Softened { area: 1.570_477e-5 }, 0.005),
        ] {
            let rows = |stroke| -> Vec<f64> {
                let rows = FirstProblem::diehl().stroke_rows(mu, N, reference, stroke).unwrap();
                rows.iter().map(|row| row.rf2).collect()
            };
            let (push, back) = (rows(Stroke::Push), backwards(&rows(Stroke::Return)));
            let scale = peak(&push);
            let there = rms(&found[..N], &push[1..], scale);
            let home = rms(&found[N + 1..], &back[1..], scale);
            // the way back against its own, smaller peak
            let own = rms(&found[N + 1..], &back[1..], peak(&back));
            println!(
                "circle mu {mu} {reference:?}: push {:.3} %, back {:.3} % ({:.3} % of its own peak)",
                100.0 * there,
                100.0 * home,
                100.0 * own
            );
            assert!(there <= limit && home <= limit, "mu {mu}: {there} {home}");
        }
    }
}

#[test]
fn cam_follows_theory_both_ways() {
    let found = run_both_ways(paper::CAM_PUSH_PULL).reaction(Cam::PIVOT, 6);
    let rows = |stroke| -> Vec<f64> {
        let rows = SecondProblem::project().stroke_rows(0.3, N, Reference::Linear, stroke).unwrap();
        rows.iter().map(|row| row.rm3).collect()
    };
    let (push, back) = (rows(Stroke::Push), backwards(&rows(Stroke::Return)));
    let scale = peak(&push);
    let there = rms(&found[..N], &push[1..], scale);
    let home = rms(&found[N + 1..], &back[1..], scale);
    println!("cam: push {:.3} %, back {:.3} %", 100.0 * there, 100.0 * home);
    assert!(there <= 0.015, "{there}");
    assert!(home <= 0.025, "{home}");
}

/// Requirement: with slaves every degree the polygon is gone: 0.5 % against the
/// softened beam both ways, and against linear theory 0.5 % for the push as in
/// Fig. 8; on the way back that is 0.6 % off itself, so that 0.8 % is asked.
#[test]
fn fine_cam_follows_theory_both_ways() {
    let cam = Cam { increments: N, mu: 0.3, onset: "IMMEDIATE", spacing: 1.0 };
    let deck = format!(
        "{}*STEP, NLGEOM\n*STATIC\n0.05, 1.0, 1.0E-6, 0.05\n*BOUNDARY\n9999, 6, 6, 0.0\n*END STEP\n",
        cam.deck()
    );
    let found = run_both_ways(&deck).reaction(Cam::PIVOT, 6);
    let problem = SecondProblem::project();
    let area = problem.slave_area(1f64.to_radians());
    for (reference, limit) in [(Reference::Linear, 0.008), (Reference::Softened { area }, 0.005)] {
        let rows = |stroke| -> Vec<f64> {
            let rows = problem.stroke_rows(0.3, N, reference, stroke).unwrap();
            rows.iter().map(|row| row.rm3).collect()
        };
        let (push, back) = (rows(Stroke::Push), backwards(&rows(Stroke::Return)));
        let there = rms(&found[..N], &push[1..], peak(&push));
        let home = rms(&found[N + 1..], &back[1..], peak(&push));
        println!(
            "cam 1 deg {reference:?}: push {:.3} %, back {:.3} %",
            100.0 * there,
            100.0 * home
        );
        assert!(there <= 0.005 && home <= limit, "{there} {home}");
    }
}

/// Requirement: a point that slid one way sticks before it slides the other
/// way; its traction goes from one limit to the other without leaving the band
/// |tau| <= mu p. Within a stroke no point sticks that slid at the commit
/// before. Seen in increments so small that the transition takes several.
fn transition(name: &str, deck: &str, (node, dof): (u64, usize)) {
    let mu = 0.3;
    let title =
        if deck.contains("PULL BEARING BACK") { "PULL BEARING BACK" } else { "TURN CAM BACK" };
    let (push, back) = deck.split_once(title).unwrap();
    // the way back ends after 1/1500 and 1/3000 of the stroke, in 40 increments
    let turned = format!("9999, 6,, {:?}", -1.047_197_551_196_597_6 * (1.0 - 1.0 / 3000.0));
    let back = back
        .replace("0.05, 1.0, 1.0E-6, 0.05", "0.025, 1.0, 1.0E-6, 0.025")
        .replace("9999, 2,, 0.0", "9999, 2,, -29.98E-3")
        .replace("9999, 6,, 0.0", &turned);
    let curve = run(&format!("{push}{title}{back}")).unwrap();
    assert_eq!(curve.rows.len(), N + 40, "no cutback");
    let (mut stuck, mut slid) = (0, 0);
    for row in &curve.rows[N..] {
        for point in row.contact.iter().filter(|point| point.status != Status::Open) {
            let limit = mu * point.pressure;
            assert!(point.shear.abs() <= limit * (1.0 + 1e-9), "{point:?}");
            match point.status {
                Status::Stick => stuck += 1,
                _ => slid += 1,
            }
        }
    }
    let loaded = |row: usize| {
        let points = curve.rows[row].contact.iter();
        points.max_by(|a, b| a.pressure.total_cmp(&b.pressure)).unwrap().shear
    };
    let force = curve.reaction(node, dof);
    println!(
        "{name}: {stuck} stick, {slid} slip; traction {:.4e} to {:.4e}, reaction {:.4} to {:.4}",
        loaded(N - 1),
        loaded(N + 39),
        force[N - 1],
        force[N + 39]
    );
    assert!(stuck >= 3, "the transition is seen");
    assert!(loaded(N - 1) * loaded(N + 39) < 0.0, "the traction has turned");
    let last = curve.rows[N + 39].contact.iter().filter(|p| p.pressure > 0.0);
    assert!(last.clone().all(|point| point.status == Status::Slip), "and slides again");
    // between the limits the reaction moves one way only
    let moves: Vec<f64> = force[N - 1..].windows(2).map(|pair| pair[1] - pair[0]).collect();
    let first = moves.iter().position(|m| m.abs() > 1e-12 * peak(&force)).unwrap_or(0);
    let turned =
        (0..40).find(|&k| curve.rows[N + k].contact.iter().all(|p| p.status != Status::Stick));
    let until = moves.len().min(turned.map_or(40, |k| k.max(1)));
    assert!(moves[first..until].iter().all(|m| m * moves[first] > 0.0), "{moves:?}");
}

#[test]
fn circle_sticks_at_the_turn() {
    transition("circle", paper::ISL_PUSH_PULL, (Push::CIRCLE, 2));
}

#[test]
fn cam_sticks_at_the_turn() {
    transition("cam", paper::CAM_PUSH_PULL, (Cam::PIVOT, 6));
}

/// Requirement: with LAGRANGE the same curves, for in both strokes the slip is
/// far beyond the elastic one. At the turn the elastic slip (3.9 um of 1.5 mm)
/// has long reversed. Tolerance: 1e-6 of the peak, at which Newton stops.
#[test]
fn lagrange_agrees_both_ways() {
    let rubbed = "*FRICTION\n0.3";
    for (name, deck, node, dof) in [
        ("circle", paper::ISL_PUSH_PULL, Push::CIRCLE, 2),
        ("cam", paper::CAM_PUSH_PULL, Cam::PIVOT, 6),
    ] {
        assert!(deck.contains(rubbed));
        let exact = run_both_ways(&deck.replace(rubbed, "*FRICTION, LAGRANGE\n0.3"));
        let [a, b] = [run_both_ways(deck), exact].map(|curve| curve.reaction(node, dof));
        let off = slideline_verification::largest_difference(&a, &b) / peak(&a);
        println!("{name}: penalty against LAGRANGE, both ways {off:.1e}");
        assert!(off <= 1e-6, "{name}: {off:e}");
    }
}
