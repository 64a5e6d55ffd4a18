//! Words that a user gives, as the library has them.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use slideline::output::onset_word;
use slideline::{Dialect, Onset, ReadOptions};

/// How a deck is read.
pub(crate) fn read_options(
    parameters: Vec<(String, String)>,
    dialect: Option<&str>,
    friction_onset: Option<&str>,
) -> PyResult<ReadOptions> {
    let dialects = [Dialect::Abaqus, Dialect::Calculix].map(|own| (own.word(), own));
    let onsets =
        [Onset::Immediate, Onset::Delayed, Onset::Matfru].map(|own| (onset_word(own), own));
    Ok(ReadOptions {
        dialect: dialect.map(|word| named("dialect", word, &dialects)).transpose()?,
        friction_onset: friction_onset
            .map(|word| named("friction_onset", word, &onsets))
            .transpose()?,
        parameters,
        ..ReadOptions::default()
    })
}

fn named<T: Copy>(what: &str, word: &str, known: &[(&str, T)]) -> PyResult<T> {
    let found = known.iter().find(|(own, _)| own.eq_ignore_ascii_case(word));
    found.map(|(_, own)| *own).ok_or_else(|| {
        let words: Vec<&str> = known.iter().map(|(own, _)| *own).collect();
        PyValueError::new_err(format!("{what} is one of {}, not {word}", words.join(", ")))
    })
}
