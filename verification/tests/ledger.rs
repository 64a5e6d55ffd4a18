//! Where the 1995 logic drops friction, none is left, and the ledger says how
//! much was dropped.

use slideline::observe::FrictionCall;
use slideline_verification::{Claim, Group, Method, Push, Record, peak, run, worst};

pub const GROUP: Group = Group {
    file: "ledger",
    claims: &[Claim {
        name: "dropped_means_frictionless",
        requirement: "In an increment in which every closed point's friction was dropped, RF2 is \
                      that of the frictionless curve; where some point called it, it is not. The \
                      ledger counts the points and sums the work of the rows.",
        source: "Diehl (1995), section 2: friction that is not called leaves no history in the \
                 forces, so that the equilibrium is the frictionless one.",
        tolerance: "1e-9 of the peak with residuals held at 1e-12; called friction is above 1e-6; \
                    the sum of the ledger to rounding, 1e-12.",
        measure: dropped_means_frictionless,
    }],
};

fn dropped_means_frictionless(record: &mut Record) {
    for (method, elements) in [(Method::Irs, 24), (Method::Irs, 99), (Method::Isl, 24)] {
        let push =
            |mu, onset| Push { elements, mu, onset, tolerance: Some(1e-12), ..Push::paper(method) };
        let none = run(&push(0.0, "IMMEDIATE").deck()).unwrap().reaction(Push::CIRCLE, 2);
        let lost = run(&push(0.3, "MATFRU").deck()).unwrap();
        let (force, scale) = (lost.reaction(Push::CIRCLE, 2), peak(&none));
        let (mut dropped, mut called) = (Vec::new(), Vec::new());
        for (k, row) in lost.rows.iter().enumerate() {
            let said = |call| row.contact.iter().any(|point| point.friction == call);
            let off = (force[k] - none[k]).abs() / scale;
            if said(FrictionCall::Called) {
                called.push(off);
            } else if said(FrictionCall::Dropped) {
                dropped.push(off);
            }
        }
        let what = |what: &str| format!("{method:?}, {elements} B21: {what}");
        record.at_least(what("increments in which all was dropped"), dropped.len() as f64, 1.0);
        let off = worst(dropped);
        record.at_most(what("their distance from the frictionless curve (of peak)"), off, 1e-9);
        record.tell(what("increments in which some was called"), called.len() as f64);
        record.holds(what("those stand off it"), called.iter().all(|off| *off > 1e-6));
        let points = lost.rows.iter().flat_map(|row| &row.contact);
        let count = points.clone().filter(|p| p.friction == FrictionCall::Dropped).count();
        record.equal(what("dropped points in the ledger"), lost.totals.dropped_points, count);
        let work: f64 = points.map(|point| point.dropped_work).sum();
        let told = lost.rows.last().unwrap().energy.dropped_friction;
        let off = (work / told - 1.0).abs();
        record.at_most(what("dropped work, rows against ledger (relative)"), off, 1e-12);
    }
}
