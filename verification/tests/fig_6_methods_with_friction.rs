//! Diehl (1995) Fig. 6: the three models with mu = 0.3, both friction logics.

use crate::references::{of_first, travel};
use slideline_theory::{FirstProblem, Reference};
use slideline_verification::{
    Claim, Curve, Group, Method, Push, Record, differ, largest_difference, peak, run, trapezoid,
};

const FIGURE: &str = "Diehl (1995), Fig. 6 and its text.";

pub const GROUP: Group = Group {
    file: "fig_6_methods_with_friction",
    claims: &[
        Claim {
            name: "isl_immediate_follows_theory",
            requirement: "With the paper's logic (friction called at once) the ISL model follows \
                          theory.",
            source: FIGURE,
            tolerance: "1 % against linear theory, which is 1 % off at the end; 0.5 % against the \
                        softened shear-flexible beam.",
            measure: isl_immediate_follows_theory,
        },
        Claim {
            name: "irs_immediate_is_half_as_noisy_as_without_friction",
            requirement: "The signal grows with friction, the noise of IRS does not: the relative \
                          RMS is about half.",
            source: FIGURE,
            tolerance: "0.3 to 0.75 for \"about half\".",
            measure: irs_immediate_is_half_as_noisy_as_without_friction,
        },
        Claim {
            name: "irs_coarse_matfru_loses_most_friction",
            requirement: "With the logic of 1995 the coarse IRS model keeps friction only where a \
                          slave stays in contact over successive increments.",
            source: FIGURE,
            tolerance: "The bands are those of an independent trial computation.",
            measure: irs_coarse_matfru_loses_most_friction,
        },
        Claim {
            name: "irs_fine_matfru_loses_all_friction",
            requirement: "The fine IRS model loses practically all friction: its curve is the one \
                          without.",
            source: FIGURE,
            tolerance: "1 % of the work of friction.",
            measure: irs_fine_matfru_loses_all_friction,
        },
        Claim {
            name: "isl_matfru_keeps_nearly_all",
            requirement: "The ISL model keeps nearly all friction; where a second slave closes \
                          beside the first, part is lost.",
            source: FIGURE,
            tolerance: "15 of 20 increments keep 95 %, and 85 % of the work is kept; the paper saw \
                        one increment with a partial loss.",
            measure: isl_matfru_keeps_nearly_all,
        },
        Claim {
            name: "delayed_is_matfru",
            requirement: "DELAYED and MATFRU are one table on converged states.",
            source: "The table of friction onset (derived, docs/theory.md).",
            tolerance: "None: every number is the same.",
            measure: delayed_is_matfru,
        },
        Claim {
            name: "penalty_and_lagrange_agree",
            requirement: "In steady sliding the slip is far beyond the elastic one: penalty and \
                          Lagrange give the same forces.",
            source: FIGURE,
            tolerance: "1e-6 of the peak: the residual at which Newton stops.",
            measure: penalty_and_lagrange_agree,
        },
    ],
};

const AREA: f64 = 1.570_477e-5;
const AXES: [&str; 2] = ["travel of the circle (mm)", "RF2 (N)"];

fn force(curve: &Curve) -> Vec<f64> {
    curve.reaction(Push::CIRCLE, 2)
}

fn of(push: Push) -> Vec<f64> {
    let curve = run(&push.deck()).unwrap();
    assert_eq!(curve.rows.len(), push.increments, "no cutback: {push:?}");
    force(&curve)
}

fn model(method: Method, elements: usize, mu: f64, onset: &'static str) -> Push {
    Push { elements, mu, onset, ..Push::paper(method) }
}

fn theory(mu: f64, reference: Reference) -> Vec<f64> {
    of_first(&FirstProblem::diehl(), mu, 20, reference)
}

fn work(force: &[f64]) -> f64 {
    trapezoid(&travel(20), force)
}

fn isl_immediate_follows_theory(record: &mut Record) {
    let found = of(model(Method::Isl, 24, 0.3, "IMMEDIATE"));
    let linear = differ(&found, &theory(0.3, Reference::Linear));
    let softened = theory(0.3, Reference::Softened { area: AREA });
    let exact = differ(&found, &softened);
    record.at_most("RMS against linear theory (% of peak)", 100.0 * linear.rms, 1.0);
    record.at_most("RMS against the softened beam (% of peak)", 100.0 * exact.rms, 0.5);
    record.tell("largest error against the softened beam (% of peak)", 100.0 * exact.max);
    let title = "ISL, mu 0.3, friction called at once";
    record.comparison(
        title,
        AXES,
        &travel(20),
        &[("ISL", &found)],
        ("softened Reissner", &softened),
    );
}

fn irs_immediate_is_half_as_noisy_as_without_friction(record: &mut Record) {
    let reference = Reference::Softened { area: 5.213_474e-5 };
    let [without, with] = [0.0, 0.3]
        .map(|mu| differ(&of(model(Method::Irs, 24, mu, "IMMEDIATE")), &theory(mu, reference)).rms);
    record.tell("RMS, mu 0 (% of peak)", 100.0 * without);
    record.tell("RMS, mu 0.3 (% of peak)", 100.0 * with);
    record.within("their ratio", with / without, [0.3, 0.75]);
}

/// Forces without friction, with friction called at once, and with MATFRU.
fn three(record: &mut Record, title: &str, method: Method, elements: usize) -> [Vec<f64>; 3] {
    let [none, full, lost] = [(0.0, "IMMEDIATE"), (0.3, "IMMEDIATE"), (0.3, "MATFRU")]
        .map(|(mu, onset)| of(model(method, elements, mu, onset)));
    let curves: [(&str, &[f64]); 2] = [("MATFRU (1995)", &lost), ("no friction", &none)];
    record.comparison(title, AXES, &travel(20), &curves, ("IMMEDIATE", &full));
    [none, full, lost]
}

fn irs_coarse_matfru_loses_most_friction(record: &mut Record) {
    let [_, full, lost] = three(record, "IRS, 24 B21, mu 0.3", Method::Irs, 24);
    record.within("work over that with friction", work(&lost) / work(&full), [0.40, 0.50]);
    record.within("peak over that with friction", peak(&lost) / peak(&full), [0.6, 0.7]);
}

fn irs_fine_matfru_loses_all_friction(record: &mut Record) {
    let [none, full, lost] = three(record, "IRS, 99 B21, mu 0.3", Method::Irs, 99);
    let kept = (work(&lost) - work(&none)) / (work(&full) - work(&none));
    record.within("work of friction that is kept (%)", 100.0 * kept, [-1.0, 1.0]);
}

fn isl_matfru_keeps_nearly_all(record: &mut Record) {
    let [none, full, lost] = three(record, "ISL, 24 B21, mu 0.3", Method::Isl, 24);
    let kept = (0..20).map(|k| (lost[k] - none[k]) / (full[k] - none[k]));
    let whole = kept.filter(|kept| *kept > 0.95).count();
    record.at_least("increments that keep 95 %, of 20", whole as f64, 15.0);
    let total = (work(&lost) - work(&none)) / (work(&full) - work(&none));
    record.at_least("work of friction that is kept (%)", 100.0 * total, 85.0);
}

fn delayed_is_matfru(record: &mut Record) {
    for method in [Method::Irs, Method::Isl] {
        let [a, b] = ["DELAYED", "MATFRU"].map(|onset| of(model(method, 24, 0.3, onset)));
        record.holds(format!("{method:?}: the same numbers"), a == b);
    }
}

fn penalty_and_lagrange_agree(record: &mut Record) {
    for method in [Method::Irs, Method::Isl, Method::Surface] {
        let penalty = of(model(method, 24, 0.3, "IMMEDIATE"));
        let push = Push { friction: ", LAGRANGE", ..model(method, 24, 0.3, "IMMEDIATE") };
        let off = largest_difference(&penalty, &of(push)) / peak(&penalty);
        record.at_most(format!("{method:?}, largest difference (of peak)"), off, 1e-6);
    }
}
