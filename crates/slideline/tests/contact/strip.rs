//! The paper's first problem with a solid strip in the place of the beam.
//!
//! ```text
//!        .---.  ||
//!       |     | ||   strip: 24 x 2 CPS8, 1.5 thick; the circle of radius 9 - 0.75 touches its face
//!        '---'  ||   and moves down by 30 in 20 increments
//!          v   _||_
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::strip_reference::{BEAM, BEAM_WITH_FRICTION};
use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::ops::ControlFlow;

/// The strip, the circle, their material and surfaces.
const MESH: &str = "*HEADING
Circle on a strip of solids, N and mm
*NODE
1, 6.25073949, 0.033297135
49, 8.47273949, 50.033297135
4001, 7.74926051, -0.033297135
4049, 9.97126051, 49.966702865
99999, 0.0, 45.0
*NGEN
1, 49, 1
4001, 4049, 1
*NSET, NSET=LEFT, GENERATE
1, 49
*NSET, NSET=RIGHT, GENERATE
4001, 4049
*NFILL
LEFT, RIGHT, 4, 1000
*NODE, NSET=DISC
10001, 8.25, -40.0
10101, 8.25, 10.0
12001, 7.25, -40.0
12101, 7.25, 10.0
*NGEN, NSET=DISC
10001, 10101, 1
12001, 12101, 1
*NSET, NSET=OUTSIDE, GENERATE
10001, 10101
*NSET, NSET=INSIDE, GENERATE
12001, 12101
*NFILL, NSET=DISC
OUTSIDE, INSIDE, 2, 1000
*NMAP, NSET=DISC, TYPE=CYLINDRICAL
0.0, 45.0, 0.0, 0.0, 45.0, 1.0
9.0, 45.0, 0.0
1.0, 1.0, 1.0
*ELEMENT, TYPE=CPS8, ELSET=STRIP
1, 1, 2001, 2003, 3, 1001, 2002, 1003, 2
*ELGEN, ELSET=STRIP
1, 24, 2, 1, 2, 2000, 1000
*ELEMENT, TYPE=CPS8, ELSET=DISC
10001, 12001, 10001, 10003, 12003, 11001, 10002, 11003, 12002
*ELGEN, ELSET=DISC
10001, 50, 2, 1
*MATERIAL, NAME=M
*ELASTIC
6900.0, 0.0
*SOLID SECTION, ELSET=STRIP, MATERIAL=M
25.0
*SOLID SECTION, ELSET=DISC, MATERIAL=M
25.0
*RIGID BODY, REF NODE=99999, ELSET=DISC
*ELSET, ELSET=FACING, GENERATE
1, 24
*SURFACE, NAME=FACE
FACING, S4
*SURFACE, NAME=CIRCLE
DISC, S2
";

fn deck(mu: f64) -> String {
    format!(
        "{MESH}*SURFACE INTERACTION, NAME=I
*FRICTION
{mu:?}
*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE
CIRCLE, FACE
*NSET, NSET=CLAMP, GENERATE
1, 4001, 1000
*BOUNDARY
CLAMP, 1, 2
*STEP, NLGEOM, INC=100
*STATIC
0.05, 1.0, 1.0E-6, 0.05
*BOUNDARY
99999, 1
99999, 6
99999, 2, 2, -30.0
*END STEP
"
    )
}

/// What a run leaves.
#[derive(Default)]
struct Watch {
    forces: Vec<f64>,
    iterations: Vec<usize>,
    given_up: usize,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::AttemptFailed(_) => self.given_up += 1,
            Event::Committed(frame) => {
                let driver = frame.model.nodes.find(99999).unwrap();
                self.forces.push(-frame.nodal.reaction(driver, Dof::U2));
                self.iterations.push(frame.severe_iterations + frame.equilibrium_iterations);
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: RMS of the force against the beam at most 0.15 % of the peak without friction and
/// 0.2 % with mu = 0.3 (measured 0.04 and 0.08 %), no increment given up, at most five iterations.
#[test]
fn a_strip_of_quadratic_solids_is_the_beam() {
    for (mu, beam, limit) in [(0.0, &BEAM, 1.5e-3), (0.3, &BEAM_WITH_FRICTION, 2e-3)] {
        let read = Job::read_text("strip", &deck(mu), &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let mut watch = Watch::default();
        let ending = solve(&model, &SolveOptions::default(), &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{ending:?}");
        assert_eq!((watch.given_up, watch.forces.len()), (0, 20));
        assert!(watch.iterations.iter().all(|&own| own <= 5), "{:?}", watch.iterations);
        let off = watch.forces.iter().zip(beam).map(|(own, exact)| (own - exact) / beam[19]);
        let rms = (off.map(|off| off * off).sum::<f64>() / 20.0).sqrt();
        assert!(rms <= limit, "mu = {mu}: {rms} {:?}", watch.forces);
    }
}
