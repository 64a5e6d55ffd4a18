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

/// States from which a run can go on: all of them, or the first alone.
struct Saved(Vec<Checkpoint<'static>>, bool);

impl Observer for Saved {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Checkpoint(checkpoint) = event {
            self.0.push(checkpoint.owned());
            if self.1 {
                return ControlFlow::Break(Stop::Interrupted);
            }
        }
        ControlFlow::Continue(())
    }
}

/// A grid of elements in the plane, `cells` of a size along and up, from a corner, its nodes and
/// elements numbered from `first` on.
fn grid(
    deck: &mut String,
    (first, name): (usize, &str),
    (from, size): ([f64; 2], f64),
    cells: [usize; 2],
) {
    let width = cells[0] + 1;
    *deck += "*NODE\n";
    for (row, column) in (0..=cells[1]).flat_map(|row| (0..width).map(move |c| (row, c))) {
        let (x, y) = (from[0] + size * column as f64, from[1] + size * row as f64);
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

/// A block that is pressed on a long strip, of so many elements over half a unit, and slid over half
/// of it; then pressed all around by what follows it: the kind of the linear system changes.
fn slid_block(kind: &str, fine: usize) -> Model {
    let (mut deck, size) = (String::new(), 0.5 / fine as f64);
    grid(&mut deck, (1, "STRIP"), ([0.0, 0.0], size), [12 * fine, fine]);
    grid(&mut deck, (10_001, "BLOCK"), ([0.6, 0.51], size), [5 * fine / 2, 3 * fine / 2]);
    write!(
        deck,
        "*SOLID SECTION, ELSET=STRIP, MATERIAL=M\n1.\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n1.\n\
         *MATERIAL, NAME=M\n*ELASTIC\n100., 0.3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n\
         *CONTACT PAIR, INTERACTION=I{kind}\nBLOCK, STRIP\n*STEP, NLGEOM\n*STATIC\n0.1, 1., 1e-5, \
         0.1\n*BOUNDARY\nSTRIPLOW, 1, 2\nBLOCKHIGH, 2, 2, -0.03\nBLOCKHIGH, 1, 1, 3.\n*END STEP\n\
         *STEP, NLGEOM\n*STATIC, DIRECT\n0.2, 1.\n*DSLOAD\nBLOCK, P, 1.\n*END STEP\n"
    )
    .unwrap();
    read(&deck)
}

fn read(deck: &str) -> Model {
    let read = Job::read_text("taken", deck, &ReadOptions::default());
    read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics))
}

/// Taken up at any state, the run finds the next one to the last bit.
fn goes_on_alike(of: &str, model: &Model) {
    let mut whole = Saved(Vec::new(), false);
    let ending = solve(model, &SolveOptions::default(), &mut whole);
    assert!(matches!(ending, Ending::Completed(_)), "{of}: {ending:?}");
    assert!(whole.0.len() > 12, "{of}: {} increments", whole.0.len());
    for (from, next) in whole.0.iter().zip(&whole.0[1..]) {
        let mut rest = Saved(Vec::new(), true);
        resume(model, &SolveOptions::default(), from.clone(), &mut rest).unwrap();
        let at = (from.step, from.increment);
        assert!(rest.0[0] == *next, "{of}: taken up at {at:?}");
    }
}

/// Requirement: a run over faces has the same bits, wherever it was left: the pattern of the tangent
/// is that which it had, and the linear system that of its step.
#[test]
fn what_slides_goes_on_alike() {
    for (kind, fine) in [("SURFACE TO SURFACE", 2), ("NODE TO SURFACE", 2), ("NODE TO SURFACE", 6)]
    {
        let model = slid_block(&format!(", TYPE={kind}"), fine);
        goes_on_alike(&format!("{kind}, {fine}"), &model);
    }
}

/// Requirement: so does a snap that slides off the ends of its faces and edges: what faces nothing
/// has no history of it.
#[test]
fn what_snaps_goes_on_alike() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../corpus/new/annular.inp");
    goes_on_alike("annular", &read(&std::fs::read_to_string(path).unwrap()));
}

/// A square on a soft law that is tipped over its corner, from 10 degrees to 40: the side comes to count at it.
fn tipped_block() -> Model {
    let at = |degrees: f64, along: f64, up: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [along * cosine - up * sine, along * sine + up * cosine - 0.01]
    };
    let corners = [(102, 1.0, 0.0), (103, 1.0, 1.0), (104, 0.0, 1.0)];
    let mut deck = String::from("*NODE\n101, 0.0, -0.01\n");
    for (node, along, up) in corners {
        let [x, y] = at(10.0, along, up);
        writeln!(deck, "{node}, {x:?}, {y:?}").unwrap();
    }
    deck +=
        "*ELEMENT, TYPE=CPE4, ELSET=BLOCK\n101, 101, 102, 103, 104\n*SURFACE, NAME=BLOCK\nBLOCK\n";
    grid(&mut deck, (1, "STRIP"), ([-1.6, -0.5], 0.5), [6, 1]);
    deck += "*SOLID SECTION, ELSET=STRIP, MATERIAL=M\n1.\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=M\n1.\n\
             *MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*SURFACE INTERACTION, NAME=I\n*FRICTION\n0.2\n\
             *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n500.\n\
             *CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE\nBLOCK, STRIP\n\
             *STEP, NLGEOM\n*STATIC, DIRECT\n0.0625, 1.\n*BOUNDARY\nSTRIPLOW, 1, 2\n";
    for (node, along, up) in corners {
        let [from, to] = [10.0, 40.0].map(|degrees| at(degrees, along, up));
        for axis in 0..2 {
            writeln!(deck, "{node}, {0}, {0}, {1:?}", axis + 1, to[axis] - from[axis]).unwrap();
        }
    }
    read(&(deck + "*END STEP\n"))
}

/// Requirement: so does a block whose faces at a slave node come to count one after the other: their areas are those against
/// the last commit. Source: docs/theory.md 5.21.
#[test]
fn what_tips_over_goes_on_alike() {
    goes_on_alike("tipped", &tipped_block());
}
