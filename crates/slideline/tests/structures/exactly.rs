//! Runs whose increments end at rounding: what differs is not where they stopped.

#![allow(clippy::panic)] // a test may fail where it stands

use slideline::observe::{Ending, Totals};
use slideline::{Job, Observer, ReadOptions, SolveOptions, solve};

/// Largest residual over the largest force of an increment that ends [1].
const RESIDUAL: f64 = 1e-11;

/// What watched the run of a deck, and its totals.
pub fn solved<O: Observer + Default>(deck: &str) -> (O, Totals) {
    let read = Job::read_text("deck", deck, &ReadOptions::default());
    let mut model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    for step in &mut model.steps {
        step.controls.field.r_n = RESIDUAL;
    }
    let mut watch = O::default();
    match solve(&model, &SolveOptions::default(), &mut watch) {
        Ending::Completed(totals) => (watch, totals),
        other => panic!("{deck}\n{other:?}"),
    }
}
