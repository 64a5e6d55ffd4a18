//! The paper's ISL deck exactly as printed.

use slideline::{Job, ReadOptions, Severity};
use slideline_verification::{Claim, Group, Record, paper};

pub const GROUP: Group = Group {
    file: "literal_deck",
    claims: &[Claim {
        name: "is_rejected_with_named_reasons",
        requirement: "`**INTERFACE` is a comment, page furniture stands among the data: each is a \
                      named diagnostic, the deck has errors, nothing is solved.",
        source: "Diehl (1995), appendix, as printed.",
        tolerance: "None: a code is there or not.",
        measure: is_rejected_with_named_reasons,
    }],
};

fn is_rejected_with_named_reasons(record: &mut Record) {
    let read = Job::read_text("isl", paper::ISL_AS_PRINTED, &ReadOptions::default());
    record.holds("there is no model to solve", read.model.is_none());
    let errors = read.diagnostics.iter().filter(|said| said.severity == Severity::Error).count();
    record.at_least("errors", errors as f64, 1.0);
    let told = |code: &str| read.diagnostics.iter().any(|said| said.code.0 == code);
    record.holds("SL0212: text among the data", told("SL0212"));
    record.holds("SL0211: a keyword hidden behind two stars", told("SL0211"));
}
