//! Blocks pressed on what is as wide as they are, contact at nodes or over faces: what is drawn is
//! judged by forces alone.
//!
//! ```text
//!     |_____|          the corners of the block stand on the edges of what is below: one side of
//!     |     |          an edge looks at them, the other one looks away
//! ```

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::Ending;
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, solve};
use std::fmt::Write;
use std::ops::ControlFlow;

/// How far the block is pressed, a part of its height of 1.
const PRESSED: f64 = 0.02;
/// The modulus.
const STIFF: f64 = 1000.0;

/// What is below, as its surface is named.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Below {
    /// A block, by its top.
    Top,
    /// A block, by its whole outside.
    Outside,
    /// An analytical line that ends where the block ends.
    Line,
    /// An analytical box.
    Box,
}

/// A model: blocks of so many elements across, upper one first.
#[derive(Clone, Copy, Debug)]
struct Drawn {
    below: Below,
    in_space: bool,
    across: [u32; 2],
    /// Whether the whole outside of the upper block is named.
    outside: bool,
    contact: &'static str,
    gap: f64,
    degrees: f64,
    unit: f64,
    friction: f64,
    softened: bool,
}

impl Drawn {
    fn place(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (s, c) = self.degrees.to_radians().sin_cos();
        [c * x - s * y, s * x + c * y, z].map(|x| self.unit * x)
    }

    fn is_rigid(&self) -> bool {
        matches!(self.below, Below::Line | Below::Box)
    }

    /// Nodes, elements and sets HEAD0 or HEAD1, the nodes that are held, and surface S0 or S1.
    fn block(&self, upper: bool, deck: &mut String) {
        let own = usize::from(!upper);
        let (count, base) = (self.across[own], 10_000 * (1 + own as u32));
        let deep = if self.in_space { count } else { 0 };
        let label = |i: u32, j: u32, k: u32| base + 1 + i + 20 * j + 100 * k;
        deck.push_str("*NODE\n");
        for (k, j, i) in grid(deep, 2, count) {
            let [x, z] = [i, k].map(|n| f64::from(n) / f64::from(count));
            let y = f64::from(j) / 2.0 + if upper { self.gap } else { -1.0 };
            let [x, y, z] = self.place([x, y, z]);
            writeln!(deck, "{}, {x:e}, {y:e}, {z:e}", label(i, j, k)).unwrap();
        }
        let kind = if self.in_space { "C3D8" } else { "CPE4" };
        writeln!(deck, "*ELEMENT, TYPE={kind}, ELSET=E{own}").unwrap();
        let mut faces = Vec::new();
        for (number, (k, j, i)) in grid(deep.max(1) - 1, 1, count - 1).into_iter().enumerate() {
            let element = base + number as u32;
            write!(deck, "{element}").unwrap();
            let layers = if self.in_space { 0..2 } else { 0..1 };
            for (dk, (di, dj)) in
                layers.flat_map(|dk| [(0, 0), (1, 0), (1, 1), (0, 1)].map(|at| (dk, at)))
            {
                write!(deck, ", {}", label(i + di, j + dj, k + dk)).unwrap();
            }
            deck.push('\n');
            if j == u32::from(!upper) {
                let face = match (self.in_space, upper) {
                    (false, true) => "S1",
                    (true, false) => "S5",
                    _ => "S3",
                };
                faces.push(format!("{element}, {face}"));
            }
        }
        let thickness = if self.in_space { String::new() } else { format!("{:e}", self.unit) };
        writeln!(deck, "*SOLID SECTION, ELSET=E{own}, MATERIAL=M\n{thickness}").unwrap();
        let whole = if upper { self.outside } else { self.below == Below::Outside };
        let named = if whole { format!("E{own}") } else { faces.join("\n") };
        writeln!(deck, "*SURFACE, NAME=S{own}\n{named}\n*NSET, NSET=HEAD{own}").unwrap();
        for (k, _, i) in grid(deep, 0, count) {
            writeln!(deck, "{}", label(i, if upper { 2 } else { 0 }, k)).unwrap();
        }
    }

    /// The analytical line or box.
    fn profile(&self, deck: &mut String) {
        let at = |x: f64, y: f64| {
            let [x, y, _] = self.place([x, y, 0.0]);
            format!("{x:e}, {y:e}")
        };
        let top = [at(0.0, 0.0), at(1.0, 0.0)];
        let points = match self.below {
            Below::Box => {
                let [first, second] = top;
                vec![at(0.0, -1.0), first, second, at(1.0, -1.0)]
            }
            _ => top.to_vec(),
        };
        writeln!(deck, "*NODE\n9000, {}\n*SURFACE, NAME=S1, TYPE=SEGMENTS", at(0.5, -1.0)).unwrap();
        for (k, point) in points.iter().enumerate() {
            writeln!(deck, "{}, {point}", if k == 0 { "START" } else { "LINE" }).unwrap();
        }
        deck.push_str(
            "*RIGID BODY, ANALYTICAL SURFACE=S1, REF NODE=9000\n*NSET, NSET=HEAD1\n9000\n",
        );
    }

    fn deck(&self) -> String {
        let mut deck = String::new();
        self.block(true, &mut deck);
        if self.is_rigid() {
            self.profile(&mut deck);
        } else {
            self.block(false, &mut deck);
        }
        writeln!(deck, "*MATERIAL, NAME=M\n*ELASTIC\n{STIFF}, .3").unwrap();
        let width = if self.in_space { 1.0 } else { self.unit };
        writeln!(deck, "*SURFACE INTERACTION, NAME=I\n{width:e}").unwrap();
        if self.softened {
            let slope = 20.0 * STIFF / self.unit;
            writeln!(deck, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{slope:e}").unwrap();
        }
        if self.friction > 0.0 {
            writeln!(deck, "*FRICTION\n{}", self.friction).unwrap();
        }
        if self.contact == "GENERAL" {
            deck.push_str("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n");
            deck.push_str("*CONTACT PROPERTY ASSIGNMENT\n, , I\n");
        } else {
            writeln!(deck, "*CONTACT PAIR, INTERACTION=I, TYPE={}\nS0, S1", self.contact).unwrap();
        }
        deck.push_str("*STEP, NLGEOM, INC=300\n*STATIC\n.1, 1.\n*BOUNDARY\n");
        let way = self.place([0.0, -(PRESSED + self.gap.max(0.0)), 0.0]);
        for (k, x) in way.iter().enumerate().take(if self.in_space { 3 } else { 2 }) {
            writeln!(deck, "HEAD0, {0}, {0}, {x:e}", k + 1).unwrap();
        }
        let held = if self.is_rigid() { 6 } else { if self.in_space { 3 } else { 2 } };
        writeln!(deck, "HEAD1, 1, {held}\n*END STEP").unwrap();
        deck
    }

    /// Force of a column of that height without friction at its sides, plane stress or strain aside.
    fn expected(&self) -> f64 {
        let height = if self.is_rigid() { 1.0 } else { 2.0 };
        STIFF * (PRESSED - self.gap.min(0.0)) / height * self.unit * self.unit
    }
}

/// All (k, j, i) up to these counts.
fn grid(deep: u32, high: u32, wide: u32) -> Vec<(u32, u32, u32)> {
    let rows = |k| (0..=high).map(move |j| (k, j));
    (0..=deep).flat_map(rows).flat_map(|(k, j)| (0..=wide).map(move |i| (k, j, i))).collect()
}

/// Reactions of the upper nodes and of all others when the run ends.
#[derive(Default)]
struct Watch {
    reactions: [[f64; 3]; 2],
}

impl Observer for Watch {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        let Event::Committed(frame) = event else { return ControlFlow::Continue(()) };
        self.reactions = [[0.0; 3]; 2];
        let nodes = &frame.model.nodes;
        for node in 0..nodes.len() {
            let label = nodes.label(node);
            let own = usize::from(!(10_000..20_000).contains(&label));
            for (sum, dof) in self.reactions[own].iter_mut().zip([Dof::U1, Dof::U2, Dof::U3]) {
                *sum += frame.nodal.reaction(node, dof);
            }
        }
        ControlFlow::Continue(())
    }
}

/// So many parts of a number, and what is left of it.
fn pick<T: Copy>(number: &mut usize, of: &[T]) -> T {
    let own = of[*number % of.len()];
    *number /= of.len();
    own
}

fn all() -> Vec<Drawn> {
    let mut all = Vec::new();
    for below in [Below::Top, Below::Outside, Below::Line, Below::Box] {
        for number in (0..72_usize).map(|k| 37 * k + 5 * below as usize) {
            let mut rest = number;
            let in_space = pick(&mut rest, &[false, false, true])
                && matches!(below, Below::Top | Below::Outside);
            let mut lower = pick(&mut rest, &[1, 2, 3]);
            let softened = pick(&mut rest, &[false, false, true]);
            let upper = pick(&mut rest, &[1, 2, 3, 4]).max(lower);
            if in_space {
                lower = upper;
            }
            let contact = match (in_space, below) {
                (true, _) => "NODE TO SURFACE",
                (_, Below::Box) => pick(&mut rest, &["NODE TO SURFACE", "SURFACE TO SURFACE"]),
                _ => pick(&mut rest, &["NODE TO SURFACE", "GENERAL", "SURFACE TO SURFACE"]),
            };
            let other = number + number / 7;
            all.push(Drawn {
                below,
                in_space,
                across: [upper, lower],
                outside: number % 2 == 0,
                contact,
                gap: [0.0, 0.004, -0.002][other % 3],
                degrees: [0.0, 17.0, 90.0, -63.0][other % 4],
                unit: [1.0, 1e-3, 1e3][(other / 3) % 3],
                friction: [0.0, 0.3][(other / 2) % 2],
                softened,
            });
        }
    }
    all
}

/// Requirement: blocks that are pressed on what is as wide as they are, blocks by their top or by their
/// whole outside, analytical lines and boxes, of one to four elements, turned, in other units, at nodes
/// and over faces, are carried by the force of a column, 25 % off for friction and plane strain, and
/// balance to 1e-6.
#[test]
fn flush_blocks_are_carried() {
    for drawn in all() {
        let read = Job::read_text("flush", &drawn.deck(), &ReadOptions::default());
        let model = read.model.unwrap_or_else(|| panic!("{drawn:?}\n{:#?}", read.diagnostics));
        let mut watch = Watch::default();
        let ending = solve(&model, &SolveOptions::default(), &mut watch);
        assert!(matches!(ending, Ending::Completed(_)), "{drawn:?}\n{}\n{ending:?}", drawn.deck());
        let size = |way: [f64; 3]| way.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [head, foot] = watch.reactions;
        let (force, expected) = (size(head), drawn.expected());
        let off = size([0, 1, 2].map(|k| head[k] + foot[k]));
        assert!(off < 1e-6 * force, "{drawn:?}: {off:e} of {force:e}");
        assert!((force / expected - 1.05).abs() < 0.3, "{drawn:?}: {force:e}, {expected:e}");
    }
}
