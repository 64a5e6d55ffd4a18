//! Friction that decays from or grows to another coefficient.
//!
//! Requirement: Coulomb's law with EXPONENTIAL DECAY is friction as long as one of its coefficients
//! is not zero; far from rest it is the law of the kinetic one. Source: theory, friction. Tolerance:
//! what is left of the exponential.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::path::Path;

/// Friction work of the paper's slide line deck under a law.
fn work(name: &str, law: &str) -> f64 {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("decaying").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let deck = include_str!("../../../../corpus/diehl1995/isl_coarse_mu03.inp");
    let card = "*FRICTION\n0.3";
    assert!(deck.contains(card), "{deck}");
    let read = Job::read_text(name, &deck.replace(card, law), &ReadOptions::default());
    assert!(read.model.is_some(), "{:?}", read.diagnostics);
    let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
    assert_eq!(run(&read, &options, &mut Quiet).status, Status::Completed, "{law}");
    let text = std::fs::read_to_string(folder.join(format!("{name}.energy.csv"))).unwrap();
    let mut lines = text.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = columns.iter().position(|name| *name == "friction_dissipation").unwrap();
    lines.last().unwrap().split(',').nth(place).unwrap().parse().unwrap()
}

#[test]
fn one_coefficient_of_zero_is_not_the_absence_of_friction() {
    let plain = work("plain", "*FRICTION\n0.3");
    assert!(plain > 0.0);
    let grown = work("grown", "*FRICTION, EXPONENTIAL DECAY\n0.0, 0.3, 1.0E6");
    assert!((grown - plain).abs() < 1e-2 * plain, "{grown} {plain}");
    assert_eq!(work("none", "*FRICTION, EXPONENTIAL DECAY\n0.0, 0.3, 0.0"), 0.0);
}
