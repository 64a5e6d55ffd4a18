//! See `slideline_fuzz::results`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slideline_fuzz::results::check(bytes));
