//! Friction cards that make no sense are told, with a code and a place.

use slideline::{Diagnostic, Job, ReadOptions, Severity};
use slideline_verification::{Claim, Group, Record, paper};

const SOURCE: &str = "The manual's rules of *FRICTION: which parameters exclude one another, \
                      which data it needs.";
const EXACT: &str = "None: a code is there or not.";

pub const GROUP: Group = Group {
    file: "bad_friction",
    claims: &[
        Claim {
            name: "errors_leave_no_model_and_point_at_the_card",
            requirement: "A friction card without meaning is an error of its own code that points \
                          at its line, and leaves no model to be solved.",
            source: SOURCE,
            tolerance: EXACT,
            measure: errors_leave_no_model_and_point_at_the_card,
        },
        Claim {
            name: "a_large_coefficient_is_a_warning",
            requirement: "A coefficient of friction of 11 is believed, but warned of (SL0217).",
            source: SOURCE,
            tolerance: EXACT,
            measure: a_large_coefficient_is_a_warning,
        },
        Claim {
            name: "friction_without_an_owner",
            requirement: "Friction without an interface to own it is an error (SL0213).",
            source: SOURCE,
            tolerance: EXACT,
            measure: friction_without_an_owner,
        },
    ],
};

fn said(card: &str) -> (bool, Vec<Diagnostic>) {
    let deck = paper::IRS_COARSE.replace("*FRICTION\n0.0", card);
    assert!(deck.contains(card));
    let read = Job::read_text("bad", &deck, &ReadOptions::default());
    (read.model.is_some(), read.diagnostics)
}

fn errors_leave_no_model_and_point_at_the_card(record: &mut Record) {
    for (card, code) in [
        ("*FRICTION\n-0.3", "SL0216"),
        ("*FRICTION\nNaN", "SL0116"),
        ("*FRICTION\ninf", "SL0116"),
        ("*FRICTION\n1.0E999", "SL0118"),
        ("*FRICTION", "SL0208"),
        ("*FRICTION, ELASTIC SLIP=1.0E-6, SLIP TOLERANCE=0.005\n0.3", "SL0215"),
        ("*FRICTION, LAGRANGE, ROUGH", "SL0215"),
        ("*FRICTION, ELASTIC SLIP=-1.0\n0.3", "SL0210"),
        ("*FRICTION, EXPONENTIAL DECAY, TAUMAX=1.0\n0.3, 0.2, 1.0", "SL0215"),
        ("*FRICTON\n0.3", "SL0201"),
    ] {
        let (model, diagnostics) = said(card);
        let found = diagnostics.iter().find(|said| said.code.0 == code);
        let told =
            found.is_some_and(|said| said.severity == Severity::Error && said.span.is_some());
        let card = card.replace('\n', " / ");
        record.holds(format!("{card}: {code} with its place, no model"), told && !model);
    }
}

fn a_large_coefficient_is_a_warning(record: &mut Record) {
    let (model, diagnostics) = said("*FRICTION\n11.0");
    let found = diagnostics.iter().find(|said| said.code.0 == "SL0217");
    record.holds("there is a model", model);
    record.holds("SL0217 warns", found.is_some_and(|said| said.severity == Severity::Warning));
}

fn friction_without_an_owner(record: &mut Record) {
    let deck = paper::IRS_COARSE.replace("*INTERFACE, ELSET=IRS\n25.0E-3\n", "");
    assert!(deck.len() < paper::IRS_COARSE.len());
    let read = Job::read_text("bad", &deck, &ReadOptions::default());
    record.holds("there is no model", read.model.is_none());
    record.holds("SL0213 is told", read.diagnostics.iter().any(|said| said.code.0 == "SL0213"));
}
