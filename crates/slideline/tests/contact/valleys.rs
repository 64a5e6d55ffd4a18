//! A point in the valley between two faces with middle nodes, which nothing smooths.
//!
//! ```text
//!     \        /       driven over the bottom, the face on the left lets the point slide far beyond
//!      \  o   /        its edge, the one on the right hardly beyond its own: only there is an
//!       \/ \_/         equilibrium, which the first one reaches for as long as it may
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use crate::space_decks::solved;
use slideline::mech::element::cell::HEX20;
use slideline::observe::{Event, Observer, Stop};
use slideline::{Job, Quiet, ReadOptions, RunOptions, Status};
use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Slope of both faces.
const SLOPE: f64 = 0.5;
/// Where the spring leads the point, and how deep below the bottom.
const LED: [f64; 2] = [0.08, 0.12];

/// Sections, springs of the point, surfaces and supports.
const BETWEEN: &str = "*SOLID SECTION, ELSET=BRICKS, MATERIAL=M
*MATERIAL, NAME=M
*ELASTIC
1000.0, 0.3
*ELEMENT, TYPE=C3D4, ELSET=TIP
10, 101, 102, 103, 104
*SOLID SECTION, ELSET=TIP, MATERIAL=M
*ELEMENT, TYPE=SPRING2, ELSET=ALONG
11, 101, 105
*SPRING, ELSET=ALONG
1, 1
1.0
*ELEMENT, TYPE=SPRING2, ELSET=DOWN
12, 101, 105
*SPRING, ELSET=DOWN
3, 3
1.0
*SURFACE, NAME=BED
BRICKS, S2
*SURFACE, NAME=POINT
TIP, S1
*SURFACE INTERACTION, NAME=I
*CONTACT PAIR, INTERACTION=I, TYPE=NODE TO SURFACE
POINT, BED
*BOUNDARY
MASTER, 1, 3
101, 2
105, 2
";

/// Where the nodes of the tip stand about the point, and the node that leads it.
const TIP: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [0.1, 0.3, 0.2], [-0.1, 0.3, 0.2], [0.0, 0.1, 0.5], [0.0, 0.0, 0.0]];

/// Two bricks whose upper faces slope down to x = 0: the places of their nodes and the nodes of each.
fn bricks() -> (Vec<[f64; 3]>, [[usize; 20]; 2]) {
    let mut known: Vec<[f64; 3]> = Vec::new();
    let bricks = [-0.5, 0.5].map(|side| {
        let mut nodes = [0; 20];
        for (node, &[x, y, z]) in nodes.iter_mut().zip(HEX20.places) {
            let x = side + 0.5 * x;
            // upper face at SLOPE |x|, lower one at -1, middle nodes half-way
            let place = [x, y, 0.5 * (1.0 + z) * SLOPE * x.abs() - 0.5 * (1.0 - z)];
            let own = known.iter().position(|other| *other == place).unwrap_or(known.len());
            if own == known.len() {
                known.push(place);
            }
            *node = own + 1;
        }
        nodes
    });
    (known, bricks)
}

/// A point on springs above these bricks: the tip of a body that moves with it, led by springs from
/// node 105.
fn valley(write: &str) -> String {
    let mut deck = format!("*HEADING\nvalley\n{write}*NODE, NSET=MASTER\n");
    let (places, bricks) = bricks();
    for (number, [x, y, z]) in places.iter().enumerate() {
        let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", number + 1);
    }
    deck.push_str("*NODE\n");
    for (number, [x, y, z]) in (101..).zip(TIP) {
        let _ = writeln!(deck, "{number}, {:?}, {:?}, {:?}", x - 0.3, y + 0.1, z + 0.2);
    }
    deck.push_str("*ELEMENT, TYPE=C3D20, ELSET=BRICKS\n");
    for (number, brick) in bricks.iter().enumerate() {
        let nodes = brick.map(|node| node.to_string());
        let [first, rest] = [&nodes[..10], &nodes[10..]].map(|nodes| nodes.join(", "));
        let _ = writeln!(deck, "{}, {first},\n{rest}", number + 1);
    }
    deck.push_str(BETWEEN);
    for (node, dof) in (102..=104).flat_map(|node| (1..=3).map(move |dof| (node, dof))) {
        let _ = writeln!(deck, "*EQUATION\n2\n{node}, {dof}, 1.0, 101, {dof}, -1.0");
    }
    for [x, z] in [[0.0, -0.15], [0.0, -0.2], [0.3 + LED[0], -0.2 - LED[1]]] {
        let _ = writeln!(
            deck,
            "*STEP, NLGEOM\n*STATIC\n1.0, 1.0\n*BOUNDARY\n105, 1, 1, {x}\n105, 3, 3, {z}\n\
             *NODE PRINT, NSET=MASTER\nRF\n*END STEP"
        );
    }
    deck
}

/// Requirement: a point that is driven over the bottom of a valley comes to rest on the far side, where
/// the spring lets it: at the foot of the perpendicular from where that leads, by the plane of that
/// side. Held by the face of the commit alone the iteration goes to and fro between both for ever.
/// Tolerance: that of the iteration.
#[test]
fn a_point_crosses_the_bottom_of_a_valley() {
    let last = solved(&valley(""));
    let [x, depth] = LED;
    let along = (x - SLOPE * depth) / (1.0 + SLOPE * SLOPE);
    let (_, from, moved) = last.nodes.iter().find(|(label, ..)| *label == 101).unwrap();
    assert!((from[0] + moved[0] - along).abs() < 1e-9, "{from:?} {moved:?} {along}");
    assert!((from[2] + moved[2] - SLOPE * along).abs() < 1e-9, "{from:?} {moved:?} {along}");
    assert_eq!(last.iterations.len(), 3, "an increment a step");
    assert!(last.most() <= 4, "{:?}", last.iterations);
}

/// Stops a run after its second step.
struct Two(usize);

impl Observer for Two {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        if matches!(event, Event::Committed(_)) {
            self.0 += 1;
        }
        match self.0 {
            2 => ControlFlow::Break(Stop::Interrupted),
            _ => ControlFlow::Continue(()),
        }
    }
}

/// Requirement: what holds a point within an increment begins with the committed state: a run that was
/// left before the increment that crosses the valley ends with the bits of one that was not.
#[test]
fn what_holds_a_point_is_found_again() {
    let read = || Job::read_text("job", &valley("*RESTART, WRITE\n"), &ReadOptions::default());
    let folder = |name: &str| -> PathBuf {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = std::fs::remove_dir_all(&folder);
        folder
    };
    let (left, whole) = (folder("valley_left"), folder("valley_whole"));
    let options = |folder: &Path, restart: bool| RunOptions {
        folder: Some(folder.to_path_buf()),
        restart,
        ..RunOptions::default()
    };
    let run = |options: &RunOptions| slideline::run(&read(), options, &mut Quiet).status;
    assert_eq!(run(&options(&whole, false)), Status::Completed);
    let interrupted = slideline::run(&read(), &options(&left, false), &mut Two(0)).status;
    assert_eq!(interrupted, Status::Interrupted);
    assert_eq!(run(&options(&left, true)), Status::Completed);
    for name in ["job.history.csv", "job.contact.csv", "job.msg"] {
        let of = |folder: &Path| std::fs::read(folder.join(name)).unwrap();
        assert!(of(&left) == of(&whole), "{name}");
    }
}
