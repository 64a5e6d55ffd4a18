//! The paper's ISL deck exactly as printed.
//!
//! Requirement: `**INTERFACE` is a comment, page furniture stands among the
//! data: each is a named diagnostic, the deck has errors, nothing is solved. Source: semantics section 1.3, verification 7.

use slideline::{Job, ReadOptions, Severity};
use slideline_verification::paper;

#[test]
fn is_rejected_with_named_reasons() {
    let read = Job::read_text("isl", paper::ISL_AS_PRINTED, &ReadOptions::default());
    assert!(read.model.is_none(), "nothing may be solved");
    let errors: Vec<&str> = read
        .diagnostics
        .iter()
        .filter(|said| said.severity == Severity::Error)
        .map(|said| said.code.0)
        .collect();
    println!("literal deck: {errors:?}");
    // prose among data; a keyword hidden behind two stars, with what it leaves ownerless
    for code in ["SL0212", "SL0211"] {
        assert!(
            read.diagnostics.iter().any(|said| said.code.0 == code),
            "{code} is missing in {errors:?}"
        );
    }
    assert!(!errors.is_empty());
}
