//! Masters of elements that would pass a part within one increment.
//!
//! ```text
//!     +--+      |          +--+     at both ends of the increment nothing touches: the way between
//!     |  | ==>  |  leaf    |  |     tells that the block went through the leaf
//!     +--+      |          +--+
//! ```
//!
//! docs/theory.md section 5.8

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::plane_blocks::block;
use crate::space_decks::solved;
use slideline::{Job, Quiet, ReadOptions, RunOptions, Status, run};
use std::fmt::Write as _;
use std::path::Path;

/// A leaf and a block that is moved past its end in one increment, if it is let; `rigid`: as a rigid body of line elements.
fn deck(contact: &str, rigid: bool) -> String {
    let mut text = "*HEADING\njump\n".to_owned();
    block(&mut text, ("LEAF", 1), [1, 20], [[0.0, 0.0], [0.2, 4.0]]);
    let moved = match rigid {
        true => {
            text += "*NODE\n1001, -1.5, 3.5\n1002, -.5, 3.5\n1003, -.5, 4.5\n1004, -1.5, 4.5\n9000, -1., 4.\n\
                     *ELEMENT, TYPE=R2D2, ELSET=BLOCK\n1001, 1001, 1002\n1002, 1002, 1003\n1003, 1003, 1004\n1004, 1004, 1001\n\
                     *RIGID BODY, REF NODE=9000, ELSET=BLOCK\n*SURFACE, NAME=B\nBLOCK, SNEG\n*NSET, NSET=MOVED\n9000\n";
            "9000, 6\n"
        }
        false => {
            block(&mut text, ("BLOCK", 1001), [2, 2], [[-1.5, 3.5], [-0.5, 4.5]]);
            text += "*SURFACE, NAME=B\nBLOCK,\n*NSET, NSET=MOVED, GENERATE\n1001, 1009\n";
            ""
        }
    };
    format!(
        "{text}*MATERIAL, NAME=M\n*ELASTIC\n1000., .3\n*SURFACE INTERACTION, NAME=I\n*SURFACE, NAME=A\nLEAF,\n{contact}\
         *BOUNDARY\n1, 1, 2\n2, 1, 2\n{moved}MOVED, 2\n*STEP, NLGEOM, INC=1000\n*STATIC\n1., 1., 1e-7, 1.\n*BOUNDARY\nMOVED, 1, 1, 3.\n*END STEP\n"
    )
}

/// Requirement: a block that goes past a leaf by more than both are wide in the only increment asked for is met on the way, with the
/// leaf or the block as the slave, over faces and at nodes, of solids and of rigid lines. Before, the run was complete with exactly no force.
#[test]
fn a_master_of_elements_is_not_passed_in_one_increment() {
    let pair = |kind: &str, roles: &str| {
        format!("*CONTACT PAIR, INTERACTION=I, TYPE={kind} TO SURFACE\n{roles}\n")
    };
    let general =
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n"
            .to_owned();
    let mut peaks = Vec::new();
    for (contact, rigid) in [
        (pair("SURFACE", "A, B"), false),
        (pair("NODE", "A, B"), false),
        (pair("SURFACE", "A, B"), true),
        (pair("NODE", "A, B"), true),
        (pair("SURFACE", "B, A"), false),
        (general, false),
    ] {
        let last = solved(&deck(&contact, rigid));
        assert!(last.given_up > 0, "{contact}");
        peaks.push(last.forces.iter().map(|force| force[0].abs()).fold(0.0, f64::max));
    }
    assert!(peaks.iter().all(|peak| *peak > 0.01), "{peaks:?}");
}

/// Requirement: where motions are there at once, whatever the increment, the end says so and names the card that lets them grow, and
/// with that the same block is met on the way. It was told to round an edge.
#[test]
fn motions_that_are_there_at_once_are_told() {
    let pair = "*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\nA, B\n";
    let at_once = deck(pair, false).replace("NLGEOM, INC=1000", "NLGEOM, INC=1000, AMPLITUDE=STEP");
    let read = Job::read_text("at_once", &at_once, &ReadOptions::default());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("motions-at-once");
    let options = RunOptions { folder: Some(folder), ..RunOptions::default() };
    let outcome = run(&read, &options, &mut Quiet);
    assert_ne!(outcome.status, Status::Completed);
    let said = outcome.diagnostics.iter().find(|own| own.code.0 == "SL0519");
    let help = said
        .and_then(|own| own.help.clone())
        .unwrap_or_else(|| panic!("{:#?}", outcome.diagnostics));
    assert!(help.contains("*STEP, AMPLITUDE=RAMP"), "{help}");
    let grows = solved(&at_once.replace("AMPLITUDE=STEP", "AMPLITUDE=RAMP"));
    assert!(grows.given_up > 0 && grows.forces.iter().any(|force| force[0].abs() > 0.01));
}

/// Two plates of one length with a thin strip between them, folded until their end corners meet and a little further.
fn fold() -> String {
    let mut text = "*HEADING\nfold\n".to_owned();
    let ends = [-10.0, -2.6, -2.0, 2.0, 2.6, 10.0];
    let mut across: Vec<f64> = Vec::new();
    for (k, cells) in [12, 5, 40, 5, 12].into_iter().enumerate() {
        let part = (ends[k + 1] - ends[k]) / f64::from(cells);
        across.extend((0..cells).map(|cell| ends[k] + part * f64::from(cell)));
    }
    across.push(10.0);
    let thick = |x: f64| {
        let q = ((x.abs() - 2.0) / 0.6).clamp(0.0, 1.0);
        0.4 + 1.2 * (3.0 * q * q - 2.0 * q * q * q)
    };
    let (columns, rows) = (across.len(), 3);
    text += "*NODE\n";
    for j in 0..=rows {
        for (i, x) in across.iter().enumerate() {
            let y = thick(*x) * j as f64 / rows as f64;
            let _ = writeln!(text, "{}, {x:?}, {y:?}", 1 + i + columns * j);
        }
    }
    text += "9001, -12., 5.\n9002, 0., .4\n*ELEMENT, TYPE=CPE4I, ELSET=H\n";
    for j in 0..rows {
        for i in 0..columns - 1 {
            let n = 1 + i + columns * j;
            let _ = writeln!(text, "{n}, {n}, {}, {}, {}", n + 1, n + columns + 1, n + columns);
        }
    }
    for (name, column) in [("A", 1), ("B", columns)] {
        let _ = writeln!(text, "*NSET, NSET={name}");
        (0..=rows).for_each(|j| text += &format!("{}\n", column + columns * j));
    }
    text + "*RIGID BODY, REF NODE=9001, TIE NSET=A\n*RIGID BODY, REF NODE=9002, TIE NSET=B\n*SOLID SECTION, ELSET=H, MATERIAL=M\n1.\n\
            *MATERIAL, NAME=M\n*ELASTIC\n2000., .4\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n.2\n\
            *CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , I\n*BOUNDARY\n9001, 1, 2\n9001, 6\n\
            *STEP, NLGEOM, INC=1000\n*STATIC\n.0166667, 1., 1e-7, .0166667\n*BOUNDARY\n9002, 6, 6, 3.3\n*END STEP\n"
}

/// Requirement: a fold of equal halves, whose end corners meet one another exactly, closes, and the corners press: no node has gone through
/// its own surface there (SL0519).
#[test]
fn corners_of_a_fold_meet() {
    let last = solved(&fold());
    let pressed: f64 = last.contact.iter().map(|row| row.pressure).sum();
    assert!(pressed > 0.0);
}
