//! Two unit blocks on one another, one element each, and what a run of them leaves.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{ContactRow, Ending};
use slideline::{
    Event, Job, Observer, Quiet, ReadOptions, RunOptions, SolveOptions, Status, Stop, run,
};
use std::ops::ControlFlow;
use std::path::Path;

/// What every increment left.
#[derive(Default)]
pub struct Curve {
    /// Force on the slave, the upper block.
    pub force: Vec<[f64; 3]>,
    pub contact: Vec<ContactRow>,
    /// What is left of the energies, over the strain energy.
    pub balance: f64,
    /// Largest imbalance of force and moment.
    pub imbalance: f64,
}

impl Observer for Curve {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let energy = &frame.energy;
            self.force.extend(frame.pairs.iter().take(1).map(|pair| pair.force));
            self.contact = frame.contact.to_vec();
            self.balance = energy.balance.abs() / energy.strain_energy.max(f64::MIN_POSITIVE);
            for pair in frame.pairs {
                self.imbalance = self.imbalance.max(pair.force_imbalance);
            }
        }
        ControlFlow::Continue(())
    }
}

/// Runs a deck to its end.
pub fn solved(deck: &str) -> Curve {
    let read = Job::read_text("blocks", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let mut curve = Curve::default();
    let ending = slideline::solve(&model, &SolveOptions::default(), &mut curve);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    curve
}

/// Nodes, sets LOW and HIGH, elements, sections and surfaces of two blocks whose faces stand `gap`
/// apart, with E = 1000 and nu = 0; the direction of the gap is the last one.
pub fn mesh(in_space: bool, gap: f64) -> String {
    let top = 1.0 + gap;
    let (nodes, elements, faces) = match in_space {
        true => {
            let square = |first: usize, z: f64| {
                let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
                let line = |(k, [x, y]): (usize, [f64; 2])| {
                    format!("{}, {x:?}, {y:?}, {z:?}\n", first + k)
                };
                corners.into_iter().enumerate().map(line).collect::<String>()
            };
            let nodes =
                square(1, 0.0) + &square(5, 1.0) + &square(11, top) + &square(15, 1.0 + top);
            let elements = "*ELEMENT, TYPE=C3D8, ELSET=BLOCKS\n1, 1, 2, 3, 4, 5, 6, 7, 8\n\
                            2, 11, 12, 13, 14, 15, 16, 17, 18\n*SOLID SECTION, ELSET=BLOCKS, \
                            MATERIAL=M\n";
            (
                nodes + "*NSET, NSET=LOW\n1, 2, 3, 4\n*NSET, NSET=HIGH\n15, 16, 17, 18\n",
                elements,
                "S2",
            )
        }
        false => {
            let row = |first: usize, y: f64, [a, b]: [f64; 2]| {
                format!("{first}, {a:?}, {y:?}\n{}, {b:?}, {y:?}\n", first + 1)
            };
            let nodes = row(1, 0.0, [0.0, 1.0])
                + &row(3, 1.0, [1.0, 0.0])
                + &row(11, top, [0.0, 1.0])
                + &row(13, 1.0 + top, [1.0, 0.0]);
            let elements = "*ELEMENT, TYPE=CPS4, ELSET=BLOCKS\n1, 1, 2, 3, 4\n2, 11, 12, 13, 14\n\
                            *SOLID SECTION, ELSET=BLOCKS, MATERIAL=M\n1.0\n";
            (nodes + "*NSET, NSET=LOW\n1, 2\n*NSET, NSET=HIGH\n13, 14\n", elements, "S3")
        }
    };
    format!(
        "*NODE\n{nodes}{elements}*MATERIAL, NAME=M\n*ELASTIC\n1000.0, 0.0\n*SURFACE, NAME=UPPER\n\
         2, S1\n*SURFACE, NAME=LOWER\n1, {faces}\n"
    )
}

/// Both ways to sample contact, in the plane and in space.
pub const ALL: [(bool, &str); 4] = [
    (false, "NODE TO SURFACE"),
    (false, "SURFACE TO SURFACE"),
    (true, "NODE TO SURFACE"),
    (true, "SURFACE TO SURFACE"),
];

/// `JOB.pair.csv` of a deck that is left after so many increments and continued, and of one that is
/// not.
pub fn left_and_whole(name: &str, deck: &str, after: usize) -> [String; 2] {
    struct Leave(usize);
    impl Observer for Leave {
        fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
            self.0 -= usize::from(matches!(event, Event::Committed(_)));
            match self.0 {
                0 => ControlFlow::Break(Stop::Interrupted),
                _ => ControlFlow::Continue(()),
            }
        }
    }
    let deck = format!("*RESTART, WRITE\n{deck}");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("blocks").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    let read = || Job::read_text("job", &deck, &ReadOptions::default());
    let of = |part: &str| {
        let folder = Some(folder.join(part));
        RunOptions { folder, ..RunOptions::default() }
    };
    assert_eq!(run(&read(), &of("whole"), &mut Quiet).status, Status::Completed);
    assert_eq!(run(&read(), &of("left"), &mut Leave(after)).status, Status::Interrupted);
    let on = RunOptions { restart: true, ..of("left") };
    assert_eq!(run(&read(), &on, &mut Quiet).status, Status::Completed);
    ["left", "whole"]
        .map(|part| std::fs::read_to_string(folder.join(part).join("job.pair.csv")).unwrap())
}
