//! Bodies that contact presses on and that slide along it freely.
//!
//! Source: docs/theory.md, section 8.12; equilibrium of the blocks.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::fmt::Write;
use std::path::PathBuf;

/// Elements on a side of a block: their range, their step, and the side.
type Side = (std::ops::Range<usize>, usize, &'static str);

/// A block of CPE4 between two corners.
fn block(name: &str, first: usize, [low, high]: [[f64; 2]; 2], [across, up]: [usize; 2]) -> String {
    let mut text = format!("*NODE, NSET={name}\n");
    let at = |axis: usize, k: usize, n: usize| {
        low[axis] + (high[axis] - low[axis]) * k as f64 / n as f64
    };
    for j in 0..=up {
        for i in 0..=across {
            let (x, y) = (at(0, i, across), at(1, j, up));
            writeln!(text, "{}, {x:?}, {y:?}", first + i + j * (across + 1)).unwrap();
        }
    }
    writeln!(text, "*ELEMENT, TYPE=CPE4, ELSET={name}").unwrap();
    for j in 0..up {
        for i in 0..across {
            let n = first + i + j * (across + 1);
            let (own, above) = (first + i + j * across, n + across + 1);
            writeln!(text, "{own}, {n}, {}, {}, {above}", n + 1, above + 1).unwrap();
        }
    }
    format!("{text}*SOLID SECTION, ELSET={name}, MATERIAL=M\n1.\n")
}

fn surface(name: &str, (range, step, side): Side) -> String {
    let lines: String = range.step_by(step).map(|element| format!("{element}, {side}\n")).collect();
    format!("*SURFACE, NAME={name}\n{lines}")
}

/// Two blocks on one another beside a wall: the lower one is pressed against the wall, the upper one only down.
fn stack(friction: &str) -> String {
    let mut text = String::new();
    for (name, first, corners, cells) in [
        ("LOW", 1, [[0.0, 0.0], [2.0, 2.0]], [4, 4]),
        ("HIGH", 101, [[0.0, 2.0], [2.0, 3.5]], [3, 3]),
        ("FLOOR", 201, [[-1.0, -1.0], [5.0, 0.0]], [5, 1]),
        ("WALL", 301, [[-1.0, 0.0], [0.0, 5.0]], [1, 5]),
    ] {
        text += &block(name, first, corners, cells);
    }
    for (name, side) in [
        ("FOOT", (1..5, 1, "S1")),
        ("LOWLEFT", (1..17, 4, "S4")),
        ("LOWTOP", (13..17, 1, "S3")),
        ("LOWRIGHT", (4..17, 4, "S2")),
        ("HIGHFOOT", (101..104, 1, "S1")),
        ("HIGHLEFT", (101..110, 3, "S4")),
        ("HIGHTOP", (107..110, 1, "S3")),
        ("GROUND", (201..206, 1, "S3")),
        ("SIDE", (301..306, 1, "S2")),
    ] {
        text += &surface(name, side);
    }
    text +=
        &format!("*MATERIAL, NAME=M\n*ELASTIC\n1e4, 0.3\n*SURFACE INTERACTION, NAME=I\n{friction}");
    for pair in ["FOOT, GROUND", "LOWLEFT, SIDE", "HIGHFOOT, LOWTOP", "HIGHLEFT, SIDE"] {
        text += &format!("*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n");
    }
    text + "*BOUNDARY\nFLOOR, 1, 2\nWALL, 1, 2\n*STEP, NLGEOM, INC=100\n*STATIC\n0.25, 1.\n*DSLOAD\n\
            HIGHTOP, P, 10.\nLOWRIGHT, P, 7.\n*END STEP\n"
}

/// Requirement: without friction nothing but rounding holds the upper block along the lower one: contact is stabilised and
/// the run says so, once, and ends with the forces of equilibrium; with friction nothing is said. The floor carries 10
/// over a width of 2, the wall 7 over a height of 2, of sides that stretch by less than a thousandth.
#[test]
fn a_block_that_slides_freely_is_stabilised_and_told() {
    for (friction, told) in [("", 1), ("*FRICTION\n0.1\n", 0)] {
        let read = Job::read_text("stack", &stack(friction), &ReadOptions::default());
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("unopposed_{told}"));
        let _ = std::fs::remove_dir_all(&folder); // of an earlier run, if there was one
        let options = RunOptions { folder: Some(folder.clone()), ..RunOptions::default() };
        let outcome = run(&read, &options, &mut Quiet);
        assert_eq!(outcome.status, Status::Completed, "{friction} {:?}", outcome.diagnostics);
        let said = outcome.diagnostics.iter().filter(|own| own.code.0 == "SL0517");
        let said: Vec<&str> = said.map(|own| own.message.as_str()).collect();
        assert_eq!(said.len(), told, "{friction} {said:?}");
        assert!(said.iter().all(|own| own.contains("slide along (1.000, 0.000)")), "{said:?}");
        if told == 1 {
            let table = std::fs::read_to_string(folder.join("stack.pair.csv")).unwrap();
            let heads: Vec<&str> = table.lines().next().unwrap().split(',').collect();
            let force = |pair: &str, name: &str| -> f64 {
                let column = heads.iter().position(|own| *own == name).unwrap();
                let last = table.lines().rfind(|line| line.contains(pair)).unwrap();
                last.split(',').nth(column).unwrap().parse().unwrap()
            };
            assert!((force("FOOT/GROUND", "force_y") - 20.0).abs() < 0.02);
            assert!((force("LOWLEFT/SIDE", "force_x") - 14.0).abs() < 0.02);
        }
    }
}
