//! Any bytes parse, and the deck prints back to itself.

use slideline::deck::{NoFiles, apply, parse};
use slideline::diag::{Edit, FileId, Sources};

/// Parses, prints back, and applies every mend that was offered.
pub fn check(bytes: &[u8]) {
    let parsed = parse(&mut Sources::default(), "a.inp", bytes, &NoFiles);
    assert_eq!(parsed.deck.print(FileId(0)), bytes, "the deck does not print back");
    let edits: Vec<Edit> = parsed.diagnostics.iter().filter_map(|said| said.edit.clone()).collect();
    let _ = apply(&parsed.deck, FileId(0), &edits);
}
