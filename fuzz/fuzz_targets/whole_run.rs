//! See `slideline_fuzz::whole_run`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slideline_fuzz::whole_run::check(bytes));
