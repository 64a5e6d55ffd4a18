//! Push and return in two steps.
//!
//! Requirement: without friction the return retraces the push, force by force,
//! for smooth and for noisy models alike; with friction it does not, and the
//! driver's work over the whole stroke is positive. Source: path independence
//! of a problem with a potential (derived); verification section 7.
//! Tolerance 1e-8 of the peak at R_n = 1e-11.

use slideline_verification::{Method, Push, largest_difference, peak, run, trapezoid};

#[test]
fn retraces_the_push_without_friction() {
    for method in [Method::Irs, Method::Isl] {
        let push = Push { returns: true, tolerance: Some(1e-11), ..Push::paper(method) };
        let curve = run(&push.deck()).unwrap();
        assert_eq!(curve.rows.len(), 40);
        let force = curve.reaction(Push::CIRCLE, 2);
        let back: Vec<f64> = force[20..39].iter().rev().copied().collect();
        let off = largest_difference(&force[..19], &back) / peak(&force);
        println!("return {method:?}: {off:.1e}");
        assert!(off < 1e-8, "{method:?}: {off:e}");
    }
}

#[test]
fn friction_opens_a_loop() {
    let push = Push { returns: true, mu: 0.3, ..Push::paper(Method::Isl) };
    let curve = run(&push.deck()).unwrap();
    let (force, travel) = (curve.reaction(Push::CIRCLE, 2), curve.displacement(Push::CIRCLE, 2));
    let work = trapezoid(&travel, &force);
    println!("loop: work {work:.5}, force at the turn {:.3} {:.3}", force[19], force[20]);
    assert!(work > 0.0);
    // pushing down against friction, then pulled back by it
    assert!(force[18] < 0.0 && force[20] > force[18]);
}
