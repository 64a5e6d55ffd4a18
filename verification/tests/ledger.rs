//! Where the 1995 logic drops friction, none is left.
//!
//! Requirement: in an increment in which every closed point's friction was
//! dropped, RF2 equals the frictionless curve; where some point called it, it
//! does not. Source: the issue; the paper's section 2. Friction that is not
//! called leaves no history in the forces, so that the equilibrium is the
//! frictionless one: 1e-9 of the peak with residuals held at 1e-12.

use slideline::observe::FrictionCall;
use slideline_verification::{Method, Push, peak, run};

#[test]
fn dropped_means_frictionless() {
    for (method, elements) in [(Method::Irs, 24), (Method::Irs, 99), (Method::Isl, 24)] {
        let push =
            |mu, onset| Push { elements, mu, onset, tolerance: Some(1e-12), ..Push::paper(method) };
        let none = run(&push(0.0, "IMMEDIATE").deck()).unwrap().reaction(Push::CIRCLE, 2);
        let lost = run(&push(0.3, "MATFRU").deck()).unwrap();
        let (force, scale) = (lost.reaction(Push::CIRCLE, 2), peak(&none));
        let (mut dropped, mut called, mut worst) = (0, 0, 0.0_f64);
        for (k, row) in lost.rows.iter().enumerate() {
            let said = |call| row.contact.iter().any(|point| point.friction == call);
            let off = (force[k] - none[k]).abs() / scale;
            if said(FrictionCall::Called) {
                called += 1;
                assert!(off > 1e-6, "{method:?} {elements}, row {k}: called, and no friction");
            } else if said(FrictionCall::Dropped) {
                dropped += 1;
                worst = worst.max(off);
            }
        }
        println!(
            "{method:?} {elements}: {dropped} increments all dropped, {called} called; off by {worst:.1e}"
        );
        assert!(worst < 1e-9, "{method:?} {elements}: {worst:e}");
        assert!(dropped > 0, "{method:?} {elements}");
        let points: usize = lost
            .rows
            .iter()
            .map(|row| row.contact.iter().filter(|p| p.friction == FrictionCall::Dropped).count())
            .sum();
        assert_eq!(points, lost.totals.dropped_points, "the ledger counts the rows");
        let work: f64 = lost.rows.iter().flat_map(|row| &row.contact).map(|p| p.dropped_work).sum();
        let told = lost.rows.last().unwrap().energy.dropped_friction;
        assert!((work - told).abs() <= 1e-12 * told, "{work} {told}");
    }
}
