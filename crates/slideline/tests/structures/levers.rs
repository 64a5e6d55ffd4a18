//! Solids with an end that is rigid and free to turn, loaded on a lever.
//!
//! ```text
//!   /|-+-+-+-+-+
//!   /|-+-+-+-+-+=================o  reference node
//!   /|-+-+-+-+-+                 | P
//!        L             D         v
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::fmt::Write as _;
use std::ops::ControlFlow;

const LENGTH: f64 = 20.0;
const HEIGHT: f64 = 2.0;
const YOUNG: f64 = 1000.0;
/// Turn of the end [rad].
const TURN: f64 = 1e-3;

/// The turn of the reference node at the end, and the iterations of all increments.
#[derive(Default)]
struct Watch {
    turn: f64,
    iterations: usize,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let reference = frame.model.nodes.find(9000).unwrap();
            self.turn = frame.nodal.displacement(reference, Dof::UR3);
            self.iterations += frame.severe_iterations + frame.equilibrium_iterations;
        }
        ControlFlow::Continue(())
    }
}

/// A strip of 40 x 4 elements whose end turns by [`TURN`] under a load at the end of a lever, by five increments.
fn strip(joint: &str, lever: f64, unit: f64, nlgeom: &str) -> Watch {
    let mut deck = "*NODE\n".to_owned();
    for (i, j) in (0..=40).flat_map(|i| (0..=4).map(move |j| (i, j))) {
        let (x, y) = (LENGTH * f64::from(i) / 40.0, HEIGHT * (f64::from(j) / 4.0 - 0.5));
        writeln!(deck, "{}, {:?}, {:?}", 1 + 10 * i + j, unit * x, unit * y).unwrap();
    }
    writeln!(deck, "9000, {:?}, 0.\n*ELEMENT, TYPE=CPS4I, ELSET=E", unit * (LENGTH + lever))
        .unwrap();
    for (i, j) in (0..40).flat_map(|i| (0..4).map(move |j| (i, j))) {
        let n = 1 + 10 * i + j;
        writeln!(deck, "{n}, {n}, {}, {}, {}", n + 10, n + 11, n + 1).unwrap();
    }
    let (young, bending) = (YOUNG / (unit * unit), YOUNG * HEIGHT.powi(3) / 12.0);
    let load = TURN * bending / (0.5 * LENGTH * LENGTH + lever * LENGTH);
    write!(
        deck,
        "*SOLID SECTION, ELSET=E, MATERIAL=M\n{unit:?}\n*MATERIAL, NAME=M\n*ELASTIC\n{young:?}, 0.\n*NSET, NSET=ROOT\n\
         1, 2, 3, 4, 5\n*NSET, NSET=END\n401, 402, 403, 404, 405\n*SURFACE, NAME=ENDS, TYPE=NODE\nEND\n{joint}\
         *BOUNDARY\nROOT, 1, 2\n*STEP{nlgeom}\n*STATIC, DIRECT\n0.2, 1.\n*CLOAD\n9000, 2, {load:?}\n*END STEP\n"
    )
    .unwrap();
    let read = Job::read_text("lever", &deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{deck}\n{:#?}", read.diagnostics));
    let mut watch = Watch::default();
    let ending = solve(&model, &SolveOptions::default(), &mut watch);
    assert!(matches!(ending, Ending::Completed(_)), "{joint} {lever}: {ending:?}");
    watch
}

/// Requirement: the end turns by P (L^2/2 + L D)/EI, in an iteration an increment and two more with large
/// displacements, or on a very long lever. Solids have no moments that a residual at the reference node is small against: what rounding leaves of
/// the forces arrives there with the lever, and the iterations went on until no attempt was left, or crawled. Tolerance:
/// 0.5 %, of the mesh.
#[test]
fn what_turns_on_a_long_lever_converges() {
    let rigid = "*RIGID BODY, REF NODE=9000, TIE NSET=END\n";
    let coupled = "*COUPLING, CONSTRAINT NAME=C, REF NODE=9000, SURFACE=ENDS\n*KINEMATIC\n";
    for joint in [rigid, coupled] {
        for (lever, unit) in [(5.0, 1.0), (80.0, 1.0), (80.0, 1e-3), (80.0, 1e3), (400.0, 1.0)] {
            for (nlgeom, most) in [("", 1), (", NLGEOM", 3)] {
                let run = strip(joint, lever, unit, nlgeom);
                let most = if lever > 100.0 { most + 1 } else { most };
                let of = format!("{joint} {lever} {unit} {nlgeom}");
                assert!((run.turn / TURN - 1.0).abs() < 5e-3, "{of}: {}", run.turn);
                assert!(run.iterations <= 5 * most, "{of}: {} iterations", run.iterations);
            }
        }
    }
}
