//! What the report says of claims, in words.

use crate::claim::Outcome;

/// Outcomes in runs of the same chapter.
pub(super) fn chapters(outcomes: &[Outcome]) -> impl Iterator<Item = &[Outcome]> {
    outcomes.chunk_by(|a, b| a.chapter == b.chapter)
}

/// The verdict in a sentence.
pub(super) fn verdict(outcomes: &[Outcome]) -> String {
    let holding = outcomes.iter().filter(|outcome| outcome.holds()).count();
    let numbers: usize = outcomes.iter().map(|outcome| outcome.record.measured().len()).sum();
    match outcomes.len() {
        all if all == holding => format!("All {all} claims hold, by {numbers} measured values."),
        all => format!("{} of {all} claims do not hold.", all - holding),
    }
}

/// Names that are not written in small letters.
const NAMES: [(&str, &str); 10] = [
    ("irs", "IRS"),
    ("isl", "ISL"),
    ("b21", "B21"),
    ("b22", "B22"),
    ("b23", "B23"),
    ("matfru", "MATFRU"),
    ("lagrange", "Lagrange"),
    ("nafems", "NAFEMS"),
    ("cgs", "CGS"),
    ("newton", "Newton"),
];

/// The name of a claim as words.
pub(super) fn words(outcome: &Outcome) -> String {
    let word = |word: &str| {
        let name = NAMES.iter().find(|(small, _)| *small == word);
        name.map_or_else(|| word.to_owned(), |(_, name)| (*name).to_owned())
    };
    let words: Vec<String> = outcome.claim.name.split('_').map(word).collect();
    let words = words.join(" ");
    let mut letters = words.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}
