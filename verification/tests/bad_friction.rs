//! Friction cards that make no sense are told, with a code and a place.
//! Source: issue text, bad input.

use slideline::{Diagnostic, Job, ReadOptions, Severity};
use slideline_verification::paper;

fn said(card: &str) -> (bool, Vec<Diagnostic>) {
    let deck = paper::IRS_COARSE.replace("*FRICTION\n0.0", card);
    assert!(deck.contains(card));
    let read = Job::read_text("bad", &deck, &ReadOptions::default());
    (read.model.is_some(), read.diagnostics)
}

#[test]
fn errors_leave_no_model_and_point_at_the_card() {
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
        let codes: Vec<_> = diagnostics.iter().map(|said| said.code.0).collect();
        println!("{card:?}: {codes:?}");
        let found = found.unwrap_or_else(|| panic!("{card:?}: {diagnostics:#?}"));
        assert!(!model && found.severity == Severity::Error, "{card:?}");
        assert!(found.span.is_some(), "{card:?} has a place");
    }
}

#[test]
fn a_large_coefficient_is_a_warning() {
    let (model, diagnostics) = said("*FRICTION\n11.0");
    let found = diagnostics.iter().find(|said| said.code.0 == "SL0217").unwrap();
    assert!(model && found.severity == Severity::Warning);
}

#[test]
fn friction_without_an_owner() {
    let deck = paper::IRS_COARSE.replace("*INTERFACE, ELSET=IRS\n25.0E-3\n", "");
    assert!(deck.len() < paper::IRS_COARSE.len());
    let read = Job::read_text("bad", &deck, &ReadOptions::default());
    assert!(read.model.is_none());
    assert!(read.diagnostics.iter().any(|said| said.code.0 == "SL0213"), "{:?}", read.diagnostics);
}
