//! Runs that are left and taken up again, where contact roams over its master.
//!
//! ```text
//!        [block] -->              the pattern holds what is near; it was made anew
//!   o---o---o---o---o---o---o     there, and the run goes on from here
//! ```
//!
//! Source: docs/files.md, "Restart": a run that goes on has the bits of one that was never left.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Model;
use slideline::observe::Ending;
use slideline::{Checkpoint, Event, Job, Observer, ReadOptions, SolveOptions, Stop, resume, solve};
use std::fmt::Write;
use std::ops::ControlFlow;

/// Every state from which a run can go on.
#[derive(Default)]
struct Saved(Vec<Checkpoint<'static>>);

impl Observer for Saved {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Checkpoint(checkpoint) = event {
            self.0.push(checkpoint.owned());
        }
        ControlFlow::Continue(())
    }
}

/// A grid of elements in the plane, `cells` along and up, from a corner, its nodes and elements
/// numbered from `first` on.
fn grid(deck: &mut String, (first, name): (usize, &str), from: [f64; 2], cells: [usize; 2]) {
    let width = cells[0] + 1;
    *deck += "*NODE\n";
    for (row, column) in (0..=cells[1]).flat_map(|row| (0..width).map(move |c| (row, c))) {
        let (x, y) = (from[0] + 0.25 * column as f64, from[1] + 0.25 * row as f64);
        writeln!(deck, "{}, {x:?}, {y:?}", first + row * width + column).unwrap();
    }
    writeln!(deck, "*ELEMENT, TYPE=CPE4, ELSET={name}").unwrap();
    for (row, column) in (0..cells[1]).flat_map(|row| (0..cells[0]).map(move |c| (row, c))) {
        let one = first + row * width + column;
        let up = one + width;
        writeln!(deck, "{}, {one}, {}, {}, {up}", first + row * width + column, one + 1, up + 1)
            .unwrap();
    }
    let last = first + cells[1] * width;
    writeln!(deck, "*NSET, NSET={name}LOW, GENERATE\n{first}, {}", first + cells[0]).unwrap();
    writeln!(deck, "*NSET, NSET={name}HIGH, GENERATE\n{last}, {}", last + cells[0]).unwrap();
    writeln!(deck, "*SURFACE, NAME={name}\n{name}").unwrap();
}

/// A block that is pressed on a long strip and slid over twelve of its elements.
fn slid_block(kind: &str) -> Model {
    let mut deck = String::new();
    grid(&mut deck, (1, "STRIP"), [0.0, 0.0], [24, 2]);
    grid(&mut deck, (1001, "BLOCK"), [0.6, 0.51], [5, 3]);
    write!(
        deck,
        "*SOLID SECTION, ELSET=STRIP, MATERIAL=M\n1.\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n1.\n\
         *MATERIAL, NAME=M\n*ELASTIC\n100., 0.3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n\
         *CONTACT PAIR, INTERACTION=I{kind}\nBLOCK, STRIP\n*STEP, NLGEOM\n*STATIC\n0.05, 1., 1e-5, \
         0.05\n*BOUNDARY\nSTRIPLOW, 1, 2\nBLOCKHIGH, 2, 2, -0.03\nBLOCKHIGH, 1, 1, 3.\n*END STEP\n"
    )
    .unwrap();
    let read = Job::read_text("taken", &deck, &ReadOptions::default());
    read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics))
}

/// Requirement: taken up at any increment, a run over faces ends in the state, to the last bit, of
/// the run that was never left: the pattern of the tangent is that which it had.
#[test]
fn a_run_that_was_left_has_the_same_bits() {
    for kind in [", TYPE=SURFACE TO SURFACE", ", TYPE=NODE TO SURFACE"] {
        let model = slid_block(kind);
        let mut whole = Saved::default();
        let ending = solve(&model, &SolveOptions::default(), &mut whole);
        assert!(matches!(ending, Ending::Completed(_)), "{kind}: {ending:?}");
        let (last, before) = whole.0.split_last().unwrap();
        assert!(before.len() > 15, "{kind}: {} increments", before.len());
        for from in before.iter().skip(2).step_by(3) {
            let at = from.increment;
            let mut rest = Saved::default();
            resume(&model, &SolveOptions::default(), from.clone(), &mut rest).unwrap();
            assert!(rest.0.last() == Some(last), "{kind}: taken up at increment {at}");
        }
    }
}
