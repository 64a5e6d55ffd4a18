//! Push and return in two steps.

use slideline::output::plot::Axis;
use slideline_verification::{
    Claim, Curve, Group, Method, Push, Record, largest_difference, peak, run, series, trapezoid,
};

pub const GROUP: Group = Group {
    file: "return_stroke",
    claims: &[
        Claim {
            name: "retraces_the_push_without_friction",
            requirement: "Without friction the return retraces the push, force by force, for \
                          smooth and for noisy models alike.",
            source: "A problem with a potential does not know its path (derived).",
            tolerance: "1e-8 of the peak, with residuals held at 1e-11.",
            measure: retraces_the_push_without_friction,
        },
        Claim {
            name: "friction_opens_a_loop",
            requirement: "With friction the driver's work over the whole stroke is positive, and \
                          the force turns as the motion does.",
            source: "The second law.",
            tolerance: "None: signs.",
            measure: friction_opens_a_loop,
        },
    ],
};

fn chart(record: &mut Record, title: String, curve: &Curve) {
    let [u, rf] = [curve.displacement(Push::CIRCLE, 2), curve.reaction(Push::CIRCLE, 2)];
    let curves =
        vec![series(&u[..20], ("push", &rf[..20])), series(&u[20..], ("return", &rf[20..]))];
    record.chart(title, Axis::linear("U2 (m)"), Axis::linear("RF2 (N)"), curves);
}

fn retraces_the_push_without_friction(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        let push = Push { returns: true, tolerance: Some(1e-11), ..Push::paper(method) };
        let curve = run(&push.deck()).unwrap();
        record.equal(format!("{method:?}: increments"), curve.rows.len(), 40);
        let force = curve.reaction(Push::CIRCLE, 2);
        let back: Vec<f64> = force[20..39].iter().rev().copied().collect();
        let off = largest_difference(&force[..19], &back) / peak(&force);
        record.at_most(format!("{method:?}: largest difference (of peak)"), off, 1e-8);
    }
}

fn friction_opens_a_loop(record: &mut Record) {
    let push = Push { returns: true, mu: 0.3, ..Push::paper(Method::Isl) };
    let curve = run(&push.deck()).unwrap();
    let (force, travel) = (curve.reaction(Push::CIRCLE, 2), curve.displacement(Push::CIRCLE, 2));
    let work = trapezoid(&travel, &force);
    record.tell("work over the loop (J)", work);
    record.holds("it is positive", work > 0.0);
    // pushing down against friction, then pulled back by it
    record.holds("the force turns", force[18] < 0.0 && force[20] > force[18]);
    chart(record, "There and back, ISL, mu 0.3".to_owned(), &curve);
}
