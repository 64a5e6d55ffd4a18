//! Blocks of solids with faces, and what a run of them leaves.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::observe::{ContactRow, Ending, Frame};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, TangentCheck};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// What the last increment left.
#[derive(Default)]
pub struct Last {
    /// Label, position and displacement of every node.
    pub nodes: Vec<(u64, [f64; 2], [f64; 2])>,
    /// Reactions of every node.
    pub reactions: Vec<(u64, [f64; 2])>,
    pub contact: Vec<ContactRow>,
    pub imbalance: [f64; 2],
    pub force: [f64; 3],
    /// Iterations of every increment.
    pub iterations: Vec<usize>,
    /// Sum of reactions over the nodes from `watched` on, of every increment.
    pub watched: u64,
    pub curve: Vec<[f64; 2]>,
    /// Largest disagreement of a tangent with differences.
    pub off: f64,
    pub told: String,
    /// Largest imbalance of force and moment over the increments, over the force.
    pub worst: f64,
    /// Energies.
    pub balance: f64,
    pub work: f64,
}

impl Observer for Last {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => self.take(frame),
            Event::Tangent(report) => {
                if report.off > self.off {
                    self.told = format!("{report:?}");
                }
                self.off = self.off.max(report.off);
            }
            _ => {}
        }
        ControlFlow::Continue(())
    }
}

impl Last {
    fn take(&mut self, frame: &Frame<'_>) {
        use slideline::model::Dof;
        let nodes = &frame.model.nodes;
        let both = |node: usize, read: &dyn Fn(usize, Dof) -> f64| {
            [Dof::U1, Dof::U2].map(|dof| read(node, dof))
        };
        self.nodes.clear();
        self.reactions.clear();
        let mut sum = [0.0; 2];
        for node in 0..nodes.len() {
            let [x, y, _] = nodes.position(node);
            let label = nodes.label(node);
            let moved = both(node, &|node, dof| frame.nodal.displacement(node, dof));
            let reaction = both(node, &|node, dof| frame.nodal.reaction(node, dof));
            self.nodes.push((label, [x, y], moved));
            self.reactions.push((label, reaction));
            if label >= self.watched {
                sum = [sum[0] + reaction[0], sum[1] + reaction[1]];
            }
        }
        self.curve.push(sum);
        self.contact = frame.contact.to_vec();
        let pair = &frame.pairs[0];
        self.imbalance = [pair.force_imbalance, pair.moment_imbalance];
        self.force = pair.force;
        let size = pair.force[0].hypot(pair.force[1]);
        let off = self.imbalance[0].max(self.imbalance[1]);
        self.worst = self.worst.max(if size > 0.0 { off / size } else { off });
        (self.balance, self.work) = (frame.energy.balance, frame.energy.external_work);
        self.iterations.push(frame.severe_iterations + frame.equilibrium_iterations);
    }
}

/// The last state of a deck that must be solved.
pub fn solved(deck: &str) -> Last {
    watched(deck, u64::MAX)
}

/// The same with the sum of reactions of nodes from a label on.
pub fn watched(deck: &str, from: u64) -> Last {
    run(deck, from, &SolveOptions::default())
}

/// The same with every tangent held against differences; with the largest disagreement.
pub fn checked(deck: &str, from: u64) -> (Last, f64) {
    let options = SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() };
    let last = run(deck, from, &options);
    let off = last.off;
    (last, off)
}

pub fn run(deck: &str, from: u64, options: &SolveOptions) -> Last {
    let read = Job::read_text("mortar", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let mut last = Last { watched: from, ..Last::default() };
    let ending = slideline::solve(&model, options, &mut last);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{deck}");
    last
}

/// Elements of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Cpe3,
    Cpe4,
    Cpe6,
    Cpe8,
    Cps4,
    Cax4,
    Cax8,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Cpe3 => "CPE3",
            Self::Cpe4 => "CPE4",
            Self::Cpe6 => "CPE6",
            Self::Cpe8 => "CPE8",
            Self::Cps4 => "CPS4",
            Self::Cax4 => "CAX4",
            Self::Cax8 => "CAX8",
        }
    }

    fn is_quadratic(self) -> bool {
        matches!(self, Self::Cpe6 | Self::Cpe8 | Self::Cax8)
    }

    fn is_triangle(self) -> bool {
        matches!(self, Self::Cpe3 | Self::Cpe6)
    }
}

/// A block of so many cells, numbered from a base on, over the unit square.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    pub base: usize,
    pub cells: [usize; 2],
    pub kind: Kind,
}

impl Block {
    /// Grid lines a cell.
    fn fine(&self) -> usize {
        if self.kind.is_quadratic() { 2 } else { 1 }
    }

    fn columns(&self) -> usize {
        self.cells[0] * self.fine() + 1
    }

    fn rows(&self) -> usize {
        self.cells[1] * self.fine() + 1
    }

    /// Number of a node of the grid.
    pub fn node(&self, i: usize, j: usize) -> usize {
        self.base + 1 + i + self.columns() * j
    }

    fn exists(&self, i: usize, j: usize) -> bool {
        !self.kind.is_quadratic()
            || self.kind.is_triangle()
            || i.is_multiple_of(2)
            || j.is_multiple_of(2)
    }

    fn unit(&self, i: usize, j: usize) -> [f64; 2] {
        let of = |k: usize, most: usize| k as f64 / (most - 1) as f64;
        [of(i, self.columns()), of(j, self.rows())]
    }

    /// Nodes and elements; corners stand where `place` has them, middle nodes between them unless
    /// `curved`.
    pub fn write(&self, deck: &mut String, set: &str, place: impl Fn([f64; 2]) -> [f64; 2]) {
        self.write_as(deck, set, false, place);
    }

    pub fn write_as(
        &self,
        deck: &mut String,
        set: &str,
        curved: bool,
        place: impl Fn([f64; 2]) -> [f64; 2],
    ) {
        let fine = self.fine();
        deck.push_str("*NODE\n");
        for j in 0..self.rows() {
            for i in (0..self.columns()).filter(|&i| self.exists(i, j)) {
                let at = |i: usize, j: usize| place(self.unit(i, j));
                let ends = |k: usize| (k - k % fine, k + k % fine);
                let ((a, b), (c, d)) = (ends(i), ends(j));
                // the middle node of a diagonal lies between its own corners
                let (p, q) = (at(a, c), at(b, d));
                let [x, y] = match curved {
                    true => at(i, j),
                    false => [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])],
                };
                let _ = writeln!(deck, "{}, {x:?}, {y:?}", self.node(i, j));
            }
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE={}, ELSET={set}", self.kind.name());
        let mut label = self.base;
        for j in 0..self.cells[1] {
            for i in 0..self.cells[0] {
                let n = |a: usize, b: usize| self.node(fine * i + a, fine * j + b);
                for nodes in self.of_cell(n) {
                    label += 1;
                    let list: Vec<String> = nodes.iter().map(ToString::to_string).collect();
                    let _ = writeln!(deck, "{label}, {}", list.join(", "));
                }
            }
        }
    }

    fn of_cell(&self, n: impl Fn(usize, usize) -> usize) -> Vec<Vec<usize>> {
        match (self.kind.is_triangle(), self.kind.is_quadratic()) {
            (false, false) => vec![vec![n(0, 0), n(1, 0), n(1, 1), n(0, 1)]],
            (false, true) => {
                let corners = [n(0, 0), n(2, 0), n(2, 2), n(0, 2)];
                let middles = [n(1, 0), n(2, 1), n(1, 2), n(0, 1)];
                vec![corners.into_iter().chain(middles).collect()]
            }
            (true, false) => {
                vec![vec![n(0, 0), n(1, 0), n(1, 1)], vec![n(0, 0), n(1, 1), n(0, 1)]]
            }
            (true, true) => vec![
                vec![n(0, 0), n(2, 0), n(2, 2), n(1, 0), n(2, 1), n(1, 1)],
                vec![n(0, 0), n(2, 2), n(0, 2), n(1, 1), n(1, 2), n(0, 1)],
            ],
        }
    }

    /// The surface of a side: `top`, `bottom`, `left` or `right`.
    pub fn surface(&self, name: &str, side: &str) -> String {
        let [columns, rows] = self.cells;
        let cells: Vec<usize> = match side {
            "bottom" => (0..columns).collect(),
            "top" => (0..columns).map(|i| columns * (rows - 1) + i).collect(),
            "left" => (0..rows).map(|j| columns * j).collect(),
            _ => (0..rows).map(|j| columns * j + columns - 1).collect(),
        };
        let (triangle, of_square, of_triangle) = match side {
            "bottom" => (0, 1, 1),
            "right" => (0, 2, 2),
            "top" => (1, 3, 2),
            _ => (1, 4, 3),
        };
        let mut text = format!("*SURFACE, NAME={name}\n");
        for cell in cells {
            let (label, face) = match self.kind.is_triangle() {
                true => (self.base + 2 * cell + 1 + triangle, of_triangle),
                false => (self.base + cell + 1, of_square),
            };
            let _ = writeln!(text, "{label}, S{face}");
        }
        text
    }

    /// The set of nodes of the unit square that `is_in`.
    pub fn set(&self, name: &str, is_in: impl Fn(f64, f64) -> bool) -> String {
        let mut text = format!("*NSET, NSET={name}\n");
        for j in 0..self.rows() {
            for i in (0..self.columns()).filter(|&i| self.exists(i, j)) {
                let [x, y] = self.unit(i, j);
                if is_in(x, y) {
                    let _ = writeln!(text, "{}", self.node(i, j));
                }
            }
        }
        text
    }
}
