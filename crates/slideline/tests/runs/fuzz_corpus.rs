//! The kept inputs of the fuzz targets through the same entry points.
//!
//! Requirement (architecture, Tests): parse and interpret never panic, a
//! contact point never gives NaN; nor does a saved state, a result file or a
//! small deck of any bytes make the library panic, hang or commit NaN.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop

use std::path::Path;

#[path = "../../../../fuzz/src/lib.rs"]
mod fuzz;

/// Every input of a target.
fn replay(target: &str, check: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    let mut files: Vec<_> =
        std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty(), "{} holds inputs", folder.display());
    for file in &files {
        let bytes = std::fs::read(file).unwrap();
        if std::panic::catch_unwind(|| check(&bytes)).is_err() {
            panic!("{} fails", file.display());
        }
    }
    println!("{target}: {} inputs", files.len());
}

#[test]
fn decks() {
    replay("deck", fuzz::deck::check);
}

#[test]
fn keywords() {
    replay("keywords", fuzz::keywords::check);
}

#[test]
fn contact_points() {
    replay("contact_point", fuzz::contact_point::check);
}

#[test]
fn saved_states() {
    replay("restart", fuzz::restart::check);
}

#[test]
fn result_files() {
    replay("results", fuzz::results::check);
}

#[test]
fn small_decks() {
    replay("whole_run", fuzz::whole_run::check);
}
