//! Blocks in space whose mesh lines lie on one another, hard contact spread over faces.
//!
//! ```text
//!        +--+--+          pressed by a tenth of an edge to half an edge, then drawn along: nodes stand upon nodes
//!     +--+--+--+--+       at the start and edges upon edges, and by symmetry some stay there
//!     +--+--+--+--+
//! ```
//!
//! What stopped them: docs/theory.md 5.11, edges upon edges and the rule of integration.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{Ending, Event, Observer, Stop};
use slideline::{Job, ReadOptions, SolveOptions, solve};
use std::ops::ControlFlow;

/// A block of unit bricks: its faces a side, layers, corner, first label, name.
struct Block {
    side: usize,
    layers: usize,
    corner: [f64; 3],
    first: usize,
    name: &'static str,
}

impl Block {
    fn label(&self, [i, j, k]: [usize; 3]) -> usize {
        self.first + i + (self.side + 1) * (j + (self.side + 1) * k)
    }

    fn element(&self, [i, j, k]: [usize; 3]) -> usize {
        self.first + i + self.side * (j + self.side * k)
    }

    fn cards(&self, modulus: f64) -> String {
        let mut text = String::from("*NODE\n");
        let (n, name) = (self.side, self.name);
        for (k, j, i) in every([self.layers + 1, n + 1, n + 1]) {
            let [x, y, z] = self.corner;
            let at = [x + i as f64, y + j as f64, z + k as f64];
            text += &format!("{}, {:?}, {:?}, {:?}\n", self.label([i, j, k]), at[0], at[1], at[2]);
        }
        text += &format!("*ELEMENT, TYPE=C3D8, ELSET={name}\n");
        for (k, j, i) in every([self.layers, n, n]) {
            let around = [[0, 0], [1, 0], [1, 1], [0, 1]];
            let nodes = [0, 1].map(|up| around.map(|[a, b]| self.label([i + a, j + b, k + up])));
            let nodes: Vec<String> = nodes.as_flattened().iter().map(usize::to_string).collect();
            text += &format!("{}, {}\n", self.element([i, j, k]), nodes.join(", "));
        }
        for (set, k) in [("LOW", 0), ("TOP", self.layers)] {
            text += &format!("*NSET, NSET={name}{set}\n");
            for (_, j, i) in every([1, n + 1, n + 1]) {
                text += &format!("{},\n", self.label([i, j, k]));
            }
        }
        for (set, k, face) in [("LOW", 0, 1), ("TOP", self.layers - 1, 2)] {
            text += &format!("*SURFACE, NAME={name}{set}\n");
            for (_, j, i) in every([1, n, n]) {
                text += &format!("{}, S{face}\n", self.element([i, j, k]));
            }
        }
        text + &format!(
            "*SOLID SECTION, ELSET={name}, MATERIAL={name}\n*MATERIAL, NAME={name}\n*ELASTIC\n{modulus:?}, 0.3\n"
        )
    }
}

fn every([a, b, c]: [usize; 3]) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..a).flat_map(move |i| (0..b).flat_map(move |j| (0..c).map(move |k| (i, j, k))))
}

#[derive(Default)]
struct Watch {
    given_up: usize,
    most_iterations: usize,
    imbalance: f64,
    /// Sum of the reactions of all nodes, and the largest one.
    left: f64,
    largest: f64,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::AttemptFailed(_) => self.given_up += 1,
            Event::Committed(frame) => {
                let iterations = frame.severe_iterations + frame.equilibrium_iterations;
                self.most_iterations = self.most_iterations.max(iterations);
                for pair in frame.pairs {
                    let off = pair.force_imbalance.max(pair.moment_imbalance);
                    self.imbalance = self.imbalance.max(off);
                }
                for dof in [Dof::U1, Dof::U2, Dof::U3] {
                    let own =
                        (0..frame.model.nodes.len()).map(|node| frame.nodal.reaction(node, dof));
                    let (sum, most) = own.fold((0.0, 0.0_f64), |(sum, most), own: f64| {
                        (sum + own, most.max(own.abs()))
                    });
                    self.left = self.left.max(f64::abs(sum));
                    self.largest = self.largest.max(most);
                }
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

/// Requirement: a block of 2 x 2 faces in the middle of, or at a corner of, 4 x 4 faces, stiffer, equal or softer,
/// either of them the slave, with and without friction, completes with no attempt given up and at most six
/// iterations an increment; pair and supports balance.
#[test]
fn aligned_blocks_are_pressed_and_drawn() {
    for (ratio, corner) in [(1.0, 1.0), (10.0, 1.0), (0.1, 1.0), (10.0, 0.0)] {
        for (friction, pair) in [(0.0, "ALOW, BTOP"), (0.2, "ALOW, BTOP"), (0.2, "BTOP, ALOW")] {
            let below = Block { side: 4, layers: 2, corner: [0.0; 3], first: 1, name: "B" };
            let above =
                Block { side: 2, layers: 2, corner: [corner, corner, 2.0], first: 1001, name: "A" };
            let rubs =
                if friction > 0.0 { format!("*FRICTION\n{friction:?}\n") } else { String::new() };
            let deck = format!(
                "*HEADING\nblocks\n{}{}*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n\
                 {rubs}*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE\n{pair}\n*BOUNDARY\nBLOW, 1, 3\n\
                 ATOP, 1, 2\n*STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*BOUNDARY\nATOP, 3, 3, -0.2\n*END STEP\n\
                 *STEP, NLGEOM\n*STATIC\n0.25, 1.0\n*BOUNDARY\nATOP, 1, 1, 0.3\nATOP, 2, 2, 0.1\nATOP, 3, 3, -0.2\n\
                 *END STEP\n",
                below.cards(1000.0),
                above.cards(1000.0 * ratio),
            );
            let what = format!("{ratio} {corner} {friction} {pair}");
            let read = Job::read_text("blocks", &deck, &ReadOptions::default());
            let model = read.model.unwrap_or_else(|| panic!("{what}\n{:#?}", read.diagnostics));
            let mut watch = Watch::default();
            let ending = solve(&model, &SolveOptions::default(), &mut watch);
            assert!(matches!(ending, Ending::Completed(_)), "{what}: {ending:?}");
            assert_eq!(watch.given_up, 0, "{what}");
            assert!(watch.most_iterations <= 6, "{what}: {}", watch.most_iterations);
            assert!(watch.imbalance < 1e-9, "{what}: {:e}", watch.imbalance);
            assert!(
                watch.left < 1e-5 * watch.largest,
                "{what}: {:e} of {:e}",
                watch.left,
                watch.largest
            );
        }
    }
}
