//! See `slideline_fuzz::keywords`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slideline_fuzz::keywords::check(bytes));
