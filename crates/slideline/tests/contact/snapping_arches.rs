//! Arches that a round nose presses through their limit, as a snap dome.
//!
//! ```text
//!        ( o )            the nose, under a force that grows; short increments end close before
//!      .---+---.          the limit point, where next to nothing drives the arch away, and the
//!    /           \        jump that follows tells no rate to go on with
//!   ^             ^
//! ```
//!
//! Source: docs/theory.md, section 9, Downhill.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// Radius of the nose.
const NOSE: f64 = 0.3;

#[derive(Clone, Copy, Debug)]
struct Arch {
    elements: usize,
    rise: f64,
    friction: f64,
    pressed: Pressed,
}

#[derive(Clone, Copy, Debug)]
enum Pressed {
    /// At the top, by a force.
    ByForce(f64),
    /// By a motion, so far beside the top.
    Beside(f64),
}

impl Arch {
    fn deck(&self, first: f64) -> String {
        let Self { elements, rise, friction, pressed } = *self;
        let last = elements + 1;
        let (beside, over, held, moved) = match pressed {
            Pressed::ByForce(force) => {
                let spring = "*ELEMENT, TYPE=SPRING1, ELSET=HELD\n1000, 99\n*SPRING, ELSET=HELD\n2\n1.0E-3\n";
                (0.0, 0.0, spring, format!("*CLOAD\n99, 2, {:?}\n", -force))
            }
            Pressed::Beside(way) => {
                (way, 0.02, "", format!("*BOUNDARY\n99, 2, 2, {:?}\n", -2.2 * rise - 0.02))
            }
        };
        // where it touches the parabola
        let centre =
            rise * (1.0 - beside * beside) + NOSE * (2.0 * rise * beside).hypot(1.0) + over;
        let (left, right, low) = (beside - NOSE, beside + NOSE, centre - NOSE);
        let mut deck = String::from("*NODE\n");
        for node in 1..=last {
            let x = -1.0 + 2.0 * (node - 1) as f64 / elements as f64;
            let _ = writeln!(deck, "{node}, {x:?}, {:?}", rise * (1.0 - x * x));
        }
        let _ = write!(deck, "99, {beside:?}, {centre:?}\n*ELEMENT, TYPE=B21, ELSET=ARCH\n");
        for element in 1..=elements {
            let _ = writeln!(deck, "{element}, {element}, {}", element + 1);
        }
        let friction = match friction {
            0.0 => String::new(),
            mu => format!("*FRICTION\n{mu:?}\n"),
        };
        let _ = write!(
            deck,
            "*BEAM SECTION, ELSET=ARCH, SECTION=RECT, MATERIAL=M\n1.0, 0.05\n*MATERIAL, NAME=M\n\
             *ELASTIC\n1000.0, 0.3\n*NSET, NSET=ALL, GENERATE\n1, {last}, 1\n*SURFACE, TYPE=NODE, \
             NAME=BELOW\nALL,\n*SURFACE, TYPE=SEGMENTS, NAME=NOSE\nSTART, {right:?}, {centre:?}\n\
             CIRCL, {beside:?}, {low:?}, {beside:?}, {centre:?}\n\
             CIRCL, {left:?}, {centre:?}, {beside:?}, {centre:?}\n\
             *RIGID BODY, REF NODE=99, ANALYTICAL SURFACE=NOSE\n*SURFACE INTERACTION, NAME=I\n1.0\n\
             {friction}*CONTACT PAIR, INTERACTION=I\nBELOW, NOSE\n*BOUNDARY\n1, 1, 2\n{last}, 1, 2\n\
             99, 1\n99, 6\n{held}*STEP, NLGEOM, INC=1000\n*STATIC\n{first:?}, 1.0, 1.0E-7\n{moved}\
             *END STEP\n"
        );
        deck
    }

    /// How far the nose moves in the whole step.
    fn way(&self, first: f64) -> f64 {
        let read = Job::read_text("arch", &self.deck(first), &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
        let mut nose = Nose::default();
        let ending = slideline::solve(&model, &SolveOptions::default(), &mut nose);
        assert!(matches!(ending, Ending::Completed(_)), "{self:?} from {first}: {ending:?}");
        nose.at
    }
}

/// How far the nose has come.
#[derive(Default)]
struct Nose {
    at: f64,
}

impl Observer for Nose {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if let Event::Committed(frame) = event {
            let node = frame.model.nodes.find(99).unwrap();
            self.at = frame.nodal.displacement(node, slideline::model::Dof::U2);
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: the run goes through the jump to the end, whatever the increments before it were; the
/// arch hangs below its feet, and the same force holds it at the same place. Reference: without friction
/// the state at the end does not know of the way. Tolerance: that of the equilibrium.
#[test]
fn an_arch_that_jumps_is_pressed_on_to_the_end() {
    let shapes = [(8, 0.1, 3.0), (8, 0.2, 1.0), (9, 0.1, 1.0), (9, 0.1, 3.0), (12, 0.1, 1.0)];
    for (elements, rise, force) in shapes {
        let arch = Arch { elements, rise, friction: 0.0, pressed: Pressed::ByForce(force) };
        let ends = [arch.way(0.1), arch.way(0.04)];
        assert!(ends.iter().all(|end| *end < -rise), "{arch:?}: {ends:?}");
        assert!((ends[0] - ends[1]).abs() < 1e-5 * rise, "{arch:?}: {ends:?}");
    }
    for (elements, rise, force) in [(8, 0.1, 3.0), (8, 0.2, 1.0), (9, 0.1, 3.0), (12, 0.1, 1.0)] {
        let arch = Arch { elements, rise, friction: 0.3, pressed: Pressed::ByForce(force) };
        assert!(arch.way(0.1) < -rise, "{arch:?}");
    }
}

/// Requirement: beside the top, where friction of 1.2 jams the contact before the arch gives way, the run looks
/// for the state beyond and goes on to the end of the motion.
#[test]
fn a_jam_is_left_where_the_arch_snaps_through() {
    for (elements, rise) in [(16, 0.3), (9, 0.4), (12, 0.4)] {
        let arch = Arch { elements, rise, friction: 1.2, pressed: Pressed::Beside(0.25) };
        assert!((arch.way(0.1) + 2.2 * rise + 0.02).abs() < 1e-12, "{arch:?}");
    }
}
