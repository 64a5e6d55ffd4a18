//! Couplings of some displacements: what they leave free stays free.
//!
//! ```text
//!     +-----+   R           sides along x follow R in some displacements; the block comes
//!     |     | o             down upon what is below
//!     +-----+
//!   -----------
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// What is said, and the last displacements of the reference node and of all others.
#[derive(Default)]
struct Watch {
    codes: Vec<&'static str>,
    reference: [f64; 3],
    ends: Vec<[f64; 3]>,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Diagnosed(said) => self.codes.push(said.code.0),
            Event::Committed(frame) => {
                let dofs = [Dof::U1, Dof::U2, Dof::U3];
                let mut all = (0..frame.model.nodes.len())
                    .map(|node| dofs.map(|dof| frame.nodal.displacement(node, dof)));
                self.reference = all.next().unwrap_or_default();
                self.ends = all.collect();
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// A cube of one element above another one, with the reference node 100 that its sides along x
/// follow.
fn deck(dofs: &str, cards: &str, step: &str) -> String {
    let mut deck = String::from("*NODE\n100, 0.5, 0.5, 0.5\n");
    for (first, at, width) in [(1, [-0.5, -0.5, -1.0], 2.0), (11, [0.0, 0.0, 0.01], 1.0)] {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let all = [0.0, 1.0].into_iter().flat_map(|z| corners.map(|[x, y]| [x, y, z]));
        for (node, [x, y, z]) in (first..).zip(all) {
            let [x, y] = [at[0] + width * x, at[1] + width * y];
            let _ = writeln!(deck, "{node}, {x:?}, {y:?}, {:?}", at[2] + z);
        }
    }
    let _ = write!(
        deck,
        "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n2, 11, 12, 13, 14, 15, 16, 17, 18\n\
         *SOLID SECTION, ELSET=E, MATERIAL=M\n*MATERIAL, NAME=M\n*ELASTIC\n1000., 0.3\n*NSET, NSET=LOW\n1, 2, 3, 4\n\
         *NSET, NSET=UP\n15, 16, 17, 18\n*SURFACE, NAME=TOP\n1, S2\n*SURFACE, NAME=FOOT\n2, S1\n\
         *SURFACE, NAME=SIDES\n2, S3\n2, S5\n*COUPLING, CONSTRAINT NAME=C, REF NODE=100, SURFACE=SIDES\n\
         *KINEMATIC\n{dofs}\n*BOUNDARY\nLOW, 1, 3\n{cards}*STEP, NLGEOM\n*STATIC\n{step}*END STEP\n"
    );
    deck
}

fn run(deck: &str) -> (Watch, Ending) {
    let read = Job::read_text("deck", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    let mut watch = Watch::default();
    let ending = solve(&model, &SolveOptions::default(), &mut watch);
    (watch, ending)
}

/// Requirement: a displacement of the reference node that nothing follows, loads or holds stays where it is, and
/// the others balance their springs; loaded it is unheld.
#[test]
fn what_nothing_follows_stays() {
    let held = "11, 3\n12, 3\n13, 3\n14, 3\n100, 4, 6\n*ELEMENT, TYPE=SPRING1, ELSET=K1\n3, 100\n\
                *ELEMENT, TYPE=SPRING1, ELSET=K2\n4, 100\n*SPRING, ELSET=K1\n1\n50.\n*SPRING, ELSET=K2\n2\n60.\n";
    let load = "*CLOAD\n100, 1, 5.\n100, 2, 3.\n";
    let (watch, ending) = run(&deck("1, 2", held, load));
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?} {:?}", watch.codes);
    for [x, y, z] in &watch.ends[8..] {
        assert!((x - 0.1).abs() < 1e-12 && (y - 0.05).abs() < 1e-12 && z.abs() < 1e-12);
    }
    assert_eq!(watch.reference[2], 0.0);
    let (watch, ending) = run(&deck("1, 2", held, &format!("{load}100, 3, 1.\n")));
    assert!(!matches!(ending, Ending::Completed(_)) && watch.codes.contains(&"SL0503"));
}

/// Requirement: a body that a coupling holds in one direction alone is loose in the others: it falls until contact holds it,
/// stabilised (SL0517) or not. It was taken for held (SL0503).
#[test]
fn what_is_left_free_is_loose() {
    let contact =
        "100, 1, 6\n*SURFACE INTERACTION, NAME=I\n*CONTACT PAIR, INTERACTION=I\nFOOT, TOP\n";
    let (watch, ending) = run(&deck("1, 1", contact, "*CLOAD\nUP, 3, -1.\n"));
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?} {:?}", watch.codes);
    assert!(watch.ends.iter().any(|u| u[2] < -0.01), "{:?}", watch.ends);
}
