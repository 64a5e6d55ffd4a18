//! See `slideline_fuzz::restart`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slideline_fuzz::restart::check(bytes));
