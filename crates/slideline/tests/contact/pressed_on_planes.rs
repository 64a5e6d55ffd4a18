//! Blocks pressed on rigid planes in general contact, wherever both end: what is drawn is judged by
//! forces and places alone.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::fmt::Write;
use std::ops::ControlFlow;

/// How far the block is pressed, a part of its height of 1.
const PRESSED: f64 = 0.04;
/// The number of the reference node.
const REFERENCE: u32 = 9000;

/// How the rigid plane is described.
const DESCRIPTIONS: [&str; 3] = ["profile", "lines", "block"];
/// Where it begins and ends; the block lies from 0 to 2.
const ENDS: [[f64; 2]; 6] =
    [[0.0, 2.0], [0.0, 3.4], [-2.6, 2.0], [0.74, 4.0], [0.42, 1.66], [-1.8, 3.8]];

/// A model: its plane, turn, unit of length and friction.
#[derive(Clone, Copy, Debug)]
struct Drawn {
    plane: &'static str,
    ends: [f64; 2],
    parts: usize,
    element: &'static str,
    across: usize,
    gap: f64,
    degrees: f64,
    unit: f64,
    friction: f64,
}

impl Drawn {
    fn place(&self, x: f64, y: f64) -> [f64; 2] {
        let (s, c) = self.degrees.to_radians().sin_cos();
        [self.unit * (c * x - s * y), self.unit * (s * x + c * y)]
    }

    fn node(&self, deck: &mut String, label: u32, x: f64, y: f64) {
        let [x, y] = self.place(x, y);
        writeln!(deck, "{label}, {x:e}, {y:e}").unwrap();
    }

    /// The rigid plane; its upper side is what the block meets.
    fn plane(&self, deck: &mut String) {
        let [from, to] = self.ends;
        let at = |k: usize| from + (to - from) * k as f64 / self.parts as f64;
        if self.plane == "profile" {
            deck.push_str("*SURFACE, NAME=R, TYPE=SEGMENTS\n");
            for k in 0..=self.parts {
                let [x, y] = self.place(at(k), 0.0);
                let word = if k == 0 { "START" } else { "LINE" };
                writeln!(deck, "{word}, {x:e}, {y:e}").unwrap();
            }
            writeln!(deck, "*RIGID BODY, ANALYTICAL SURFACE=R, REF NODE={REFERENCE}").unwrap();
            return;
        }
        deck.push_str("*NODE\n");
        let depths = if self.plane == "block" { 2 } else { 1 };
        for (row, k) in (0..depths).flat_map(|row| (0..=self.parts).map(move |k| (row, k))) {
            self.node(deck, 5001 + 100 * row + k as u32, at(k), -0.7 * f64::from(row));
        }
        let kind = if depths == 2 { "CPE4" } else { "R2D2" };
        writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET=RG").unwrap();
        for own in (0..self.parts).map(|k| 5001 + k as u32) {
            if depths == 2 {
                writeln!(deck, "{own}, {}, {}, {}, {own}", own + 100, own + 101, own + 1).unwrap();
            } else {
                writeln!(deck, "{own}, {own}, {}", own + 1).unwrap();
            }
        }
        if depths == 2 {
            deck.push_str("*SOLID SECTION, ELSET=RG, MATERIAL=M\n1.\n");
        }
        writeln!(deck, "*RIGID BODY, ELSET=RG, REF NODE={REFERENCE}").unwrap();
    }

    fn deck(&self) -> String {
        let mut deck = String::from("*NODE\n");
        let (rows, columns) = (2_u32, self.across as u32);
        for (row, k) in (0..=rows).flat_map(|row| (0..=columns).map(move |k| (row, k))) {
            let (x, y) = (2.0 * f64::from(k) / f64::from(columns), f64::from(row) * 0.5);
            self.node(&mut deck, 1 + k + 100 * row, x, self.gap + y);
        }
        self.node(&mut deck, REFERENCE, 1.0, -1.0);
        writeln!(deck, "*ELEMENT, TYPE={}, ELSET=E", self.element).unwrap();
        for own in (0..rows).flat_map(|row| (0..columns).map(move |k| 1 + k + 100 * row)) {
            writeln!(deck, "{own}, {own}, {}, {}, {}", own + 1, own + 101, own + 100).unwrap();
        }
        deck.push_str("*SOLID SECTION, ELSET=E, MATERIAL=M\n1.\n*MATERIAL, NAME=M\n*ELASTIC\n");
        deck.push_str("1000., .3\n");
        self.plane(&mut deck);
        deck.push_str("*SURFACE INTERACTION, NAME=I\n1.\n");
        if self.friction > 0.0 {
            writeln!(deck, "*FRICTION\n{}", self.friction).unwrap();
        }
        deck.push_str("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ");
        deck.push_str("ASSIGNMENT\n, , I\n*STEP, NLGEOM, INC=300\n*STATIC\n.1, 1.\n*BOUNDARY\n");
        let [x, y] = self.place(0.0, -(PRESSED + self.gap.max(0.0)));
        for label in (0..=columns).map(|k| 201 + k) {
            writeln!(deck, "{label}, 1, 1, {x:e}\n{label}, 2, 2, {y:e}").unwrap();
        }
        writeln!(deck, "{REFERENCE}, 1, 6\n*END STEP").unwrap();
        deck
    }
}

/// What the last increment leaves.
#[derive(Default)]
struct Left {
    /// Sums of reactions: of the head, and of the plane.
    reactions: [[f64; 2]; 2],
    /// Of the pairs together.
    pressed: f64,
    /// Where the nodes of the foot stand.
    foot: Vec<[f64; 2]>,
}

struct Watch {
    foot: u32,
    left: Left,
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        let Event::Committed(frame) = event else { return ControlFlow::Continue(()) };
        let nodes = &frame.model.nodes;
        let mut left = Left::default();
        for node in 0..nodes.len() {
            let label = nodes.label(node);
            let reaction = [Dof::U1, Dof::U2].map(|dof| frame.nodal.reaction(node, dof));
            let own = usize::from(label == u64::from(REFERENCE));
            left.reactions[own] = [0, 1].map(|k| left.reactions[own][k] + reaction[k]);
            if label <= u64::from(self.foot) {
                let at = nodes.position(node);
                let [x, y] = [Dof::U1, Dof::U2].map(|dof| frame.nodal.displacement(node, dof));
                left.foot.push([at[0] + x, at[1] + y]);
            }
        }
        let sizes = frame.pairs.iter().map(|pair| pair.force[0].hypot(pair.force[1]));
        left.pressed = sizes.sum();
        self.left = left;
        ControlFlow::Continue(())
    }
}

fn all() -> Vec<Drawn> {
    let mut all = Vec::new();
    for (number, ends) in (0..3).flat_map(|_| ENDS).enumerate() {
        for (k, plane) in DESCRIPTIONS.into_iter().enumerate() {
            for (turn, degrees) in [0.0, 17.0, 90.0].into_iter().enumerate() {
                let pick = number + 2 * k + turn;
                all.push(Drawn {
                    plane,
                    ends,
                    parts: 1 + (number + k) % 3,
                    element: ["CPE4", "CPE4I", "CPS4"][(number / 6 + turn) % 3],
                    across: [1, 2, 3, 4][pick % 4],
                    gap: [0.0, 0.03, -0.002][number / 6],
                    degrees,
                    unit: [1.0, 1e-3, 1e3][pick % 3],
                    friction: [0.3, 0.0, 0.1][(pick / 2) % 3],
                });
            }
        }
    }
    all
}

/// Requirement: blocks pressed on rigid planes that end with them, before or behind them, described in
/// three ways, turned, in other units, with gaps and overclosures, converge; what presses is what holds,
/// 1e-6; and no foot stands deeper in the plane than a fourth of how far it was pressed: over faces the mean gap is held.
#[test]
fn blocks_are_carried_wherever_planes_end() {
    for drawn in all() {
        let read = Job::read_text("plane", &drawn.deck(), &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{drawn:?}\n{:#?}", read.diagnostics));
        let mut watch = Watch { foot: 1 + drawn.across as u32, left: Left::default() };
        let ending = solve(&model, &SolveOptions::default(), &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{drawn:?}\n{}\n{ending:?}", drawn.deck());
        let Left { reactions: [head, plane], pressed, foot } = watch.left;
        let size = head[0].hypot(head[1]);
        // the strain of the press over a third of the width, at least
        assert!(size > 0.3 * 1000.0 * PRESSED * drawn.unit, "{drawn:?}: {size:e}");
        let off = (head[0] + plane[0]).hypot(head[1] + plane[1]);
        assert!(off < 1e-6 * size, "{drawn:?}: {off:e} of {size:e}");
        assert!((pressed - size).abs() < 1e-4 * size, "{drawn:?}: {pressed:e}, {size:e}");
        let (s, c) = drawn.degrees.to_radians().sin_cos();
        for [x, y] in foot {
            let along = (c * x + s * y) / drawn.unit;
            let above = (c * y - s * x) / drawn.unit;
            let over = drawn.ends[0] < along && along < drawn.ends[1];
            assert!(!over || above > -0.25 * PRESSED, "{drawn:?}: {above} at {along}");
        }
    }
}
