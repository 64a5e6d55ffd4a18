//! See `slideline_fuzz::deck`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slideline_fuzz::deck::check(bytes));
