//! Any bytes are interpreted to their end.
#![no_main]

use libfuzzer_sys::fuzz_target;
use slideline_deck::NoFiles;
use slideline_diag::Sources;
use slideline_model::Dialect;

fuzz_target!(|bytes: &[u8]| {
    let _ = slideline_keywords::read(&mut Sources::default(), "a.inp", bytes, &NoFiles, Dialect::Abaqus);
});
