//! See `slideline_fuzz::contact_point`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| slideline_fuzz::contact_point::check(bytes));
