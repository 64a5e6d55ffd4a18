//! A small deck of any bytes: read, advised on, mended, run for some
//! iterations.

use super::bounded::{Bounded, is_small};
use slideline::{Job, ReadOptions, SolveOptions, advise, initial_gaps, mended, solve};

/// Everything that is done with a deck but for its files.
pub fn check(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let read = Job::read_text("small", &text, &ReadOptions::default());
    let Some(model) = read.model.as_ref().filter(|model| is_small(model)) else { return };
    let _ = mended(&read, &advise(&read));
    let options = SolveOptions::default();
    let _ = initial_gaps(model, &options, None);
    let _ = solve(model, &options, &mut Bounded::default());
}
