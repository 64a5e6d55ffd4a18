//! Any bytes parse, and the deck prints back to itself.
#![no_main]

use libfuzzer_sys::fuzz_target;
use slideline_deck::{NoFiles, parse};
use slideline_diag::{FileId, Sources};

fuzz_target!(|bytes: &[u8]| {
    let parsed = parse(&mut Sources::default(), "a.inp", bytes, &NoFiles);
    assert_eq!(parsed.deck.print(FileId(0)), bytes);
});
