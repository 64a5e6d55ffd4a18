//! A run that memory cannot hold.
//!
//! Requirement: want of memory is foreseen and said with the size, before the factorisation and
//! before the system ends the program; with room the same deck runs. Source: docs/robustness.md.
//! The limit is one of the process's address space, which `ulimit -v` sets.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::jobs::{PROGRAM, folder};
use std::fmt::Write;
use std::process::{Command, Output};

/// A cube of `side` bricks along each edge, one face held and one moved.
fn cube(side: usize) -> String {
    let node = |i: usize, j: usize, k: usize| 1 + i + (side + 1) * (j + (side + 1) * k);
    let mut deck = String::from("*NODE\n");
    let range = || 0..=side;
    for (k, j, i) in
        range().flat_map(|k| range().flat_map(move |j| range().map(move |i| (k, j, i))))
    {
        writeln!(deck, "{}, {i}., {j}., {k}.", node(i, j, k)).unwrap();
    }
    deck.push_str("*ELEMENT, TYPE=C3D8, ELSET=BODY\n");
    let square = |i: usize, j: usize, k: usize| {
        [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)]
    };
    for cell in 0..side.pow(3) {
        let (i, j, k) = (cell % side, cell / side % side, cell / side.pow(2));
        let corners = [square(i, j, k), square(i, j, k + 1)].concat();
        let corners: Vec<String> = corners.iter().map(ToString::to_string).collect();
        writeln!(deck, "{}, {}", cell + 1, corners.join(", ")).unwrap();
    }
    for (name, level) in [("HELD", 0), ("MOVED", side)] {
        writeln!(deck, "*NSET, NSET={name}, GENERATE").unwrap();
        writeln!(deck, "{}, {}, 1", node(0, 0, level), node(side, side, level)).unwrap();
    }
    deck.push_str(
        "*MATERIAL, NAME=M\n*ELASTIC\n2.0E5, 0.3\n*SOLID SECTION, ELSET=BODY, MATERIAL=M\n\
         *BOUNDARY\nHELD, 1, 3\n*STEP\n*STATIC\n1., 1.\n*BOUNDARY\nMOVED, 3, 3, -0.1\n*END STEP\n",
    );
    deck
}

/// Runs the deck with so much address space [kB].
fn run(name: &str, deck: &str, limit: &str) -> Output {
    let folder = folder(name);
    std::fs::write(folder.join("job.inp"), deck).unwrap();
    let command = format!("ulimit -v {limit}; exec '{PROGRAM}' run job --quiet --no-html");
    Command::new("sh").args(["-c", &command]).current_dir(&folder).output().unwrap()
}

#[test]
fn want_of_memory_is_foreseen() {
    let deck = cube(24);
    let small = run("memory_small", &deck, "360000");
    let said = String::from_utf8_lossy(&small.stderr).into_owned();
    assert!(said.contains("SL0415") && said.contains("the factorised tangent needs"), "{said}");
    assert!(said.contains("GiB"), "{said}");
    assert!(small.status.code().is_some_and(|code| code != 0 && code < 128), "{:?}", small.status);
    let enough = run("memory_enough", &cube(6), "360000");
    assert!(enough.status.success(), "{}", String::from_utf8_lossy(&enough.stderr));
}
