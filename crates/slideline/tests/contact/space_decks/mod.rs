//! Blocks of solids in space with faces, and what a run of them leaves.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use slideline::model::Dof;
use slideline::observe::{ContactRow, Ending, Frame};
use slideline::{Event, Job, Observer, ReadOptions, SolveOptions, Stop, TangentCheck};
use std::fmt::Write as _;
use std::ops::ControlFlow;

/// What increments left.
#[derive(Default)]
pub struct Last {
    /// Label, position and displacement of every node.
    pub nodes: Vec<(u64, [f64; 3], [f64; 3])>,
    pub contact: Vec<ContactRow>,
    /// Force of the pair on the slaves, an increment each.
    pub forces: Vec<[f64; 3]>,
    /// Largest imbalance of force and moment over the force.
    pub worst: f64,
    /// Iterations of every increment.
    pub iterations: Vec<usize>,
    /// Attempts at increments that were given up.
    pub given_up: usize,
    /// Largest disagreement of a tangent with differences.
    pub off: f64,
    pub told: String,
}

impl Observer for Last {
    fn event(&mut self, event: Event<'_>) -> ControlFlow<Stop> {
        match event {
            Event::Committed(frame) => self.take(frame),
            Event::AttemptFailed(_) => self.given_up += 1,
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
        let nodes = &frame.model.nodes;
        self.nodes.clear();
        for node in 0..nodes.len() {
            let moved = [Dof::U1, Dof::U2, Dof::U3].map(|dof| frame.nodal.displacement(node, dof));
            self.nodes.push((nodes.label(node), nodes.position(node), moved));
        }
        self.contact = frame.contact.to_vec();
        let pair = &frame.pairs[0];
        self.forces.push(pair.force);
        let off = pair.force_imbalance.max(pair.moment_imbalance);
        let whole = size(pair.force);
        self.worst = self.worst.max(if whole > 0.0 { off / whole } else { off });
        self.iterations.push(frame.severe_iterations + frame.equilibrium_iterations);
    }

    /// The force on the slaves at the end.
    pub fn force(&self) -> [f64; 3] {
        self.forces.last().copied().unwrap_or_default()
    }

    /// Iterations of the increment that took most.
    pub fn most(&self) -> usize {
        self.iterations.iter().copied().max().unwrap_or(0)
    }
}

pub fn size(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

/// The last state of a deck that must be solved.
pub fn solved(deck: &str) -> Last {
    run(deck, &SolveOptions::default())
}

/// The same with every tangent held against differences.
pub fn checked(deck: &str) -> Last {
    run(deck, &SolveOptions { check_tangent: TangentCheck::Every, ..SolveOptions::default() })
}

pub fn run(deck: &str, options: &SolveOptions) -> Last {
    let (ending, last) = ended(deck, options);
    assert!(matches!(ending, Ending::Completed(_)), "{ending:?}\n{:?}", last.iterations);
    last
}

/// How a deck ends, and what it left.
pub fn ended(deck: &str, options: &SolveOptions) -> (Ending, Last) {
    let read = Job::read_text("mortar", deck, &ReadOptions::default());
    let model = read.model.unwrap_or_else(|| panic!("{:#?}", read.diagnostics));
    let mut last = Last::default();
    (slideline::solve(&model, options, &mut last), last)
}

/// A rotation about an oblique axis.
pub fn turn(x: [f64; 3], angle: f64) -> [f64; 3] {
    let axis = [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0];
    let (s, c) = angle.sin_cos();
    let along: f64 = (0..3).map(|k| axis[k] * x[k]).sum();
    let cross = [
        axis[1] * x[2] - axis[2] * x[1],
        axis[2] * x[0] - axis[0] * x[2],
        axis[0] * x[1] - axis[1] * x[0],
    ];
    std::array::from_fn(|k| c * x[k] + s * cross[k] + (1.0 - c) * along * axis[k])
}

/// Elements of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    C3d4,
    C3d8,
    C3d8i,
    C3d10,
    C3d20,
    C3d20r,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::C3d4 => "C3D4",
            Self::C3d8 => "C3D8",
            Self::C3d8i => "C3D8I",
            Self::C3d10 => "C3D10",
            Self::C3d20 => "C3D20",
            Self::C3d20r => "C3D20R",
        }
    }

    fn is_quadratic(self) -> bool {
        matches!(self, Self::C3d10 | Self::C3d20 | Self::C3d20r)
    }

    fn is_tetrahedron(self) -> bool {
        matches!(self, Self::C3d4 | Self::C3d10)
    }
}

/// A block of cells in a grid; a cell is a hexahedron, or six tetrahedra.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    pub name: &'static str,
    pub base: u64,
    pub cells: [usize; 3],
    pub kind: Kind,
}

/// Corners of a hexahedron, by halves of its cell.
const CORNERS: [[usize; 3]; 8] =
    [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [0, 0, 2], [2, 0, 2], [2, 2, 2], [0, 2, 2]];
/// Edges of a hexahedron that have middle nodes, those of its lower face first.
pub const EDGES: [[usize; 2]; 12] = [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
    [4, 5],
    [5, 6],
    [6, 7],
    [7, 4],
    [0, 4],
    [1, 5],
    [2, 6],
    [3, 7],
];
const HEX_FACES: [&[usize]; 6] =
    [&[0, 1, 2, 3], &[4, 7, 6, 5], &[0, 4, 5, 1], &[1, 5, 6, 2], &[2, 6, 7, 3], &[3, 7, 4, 0]];
const TET_EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
const TET_FACES: [&[usize]; 4] = [&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]];
const WAYS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

fn sum(a: [usize; 3], b: [usize; 3]) -> [usize; 3] {
    std::array::from_fn(|k| a[k] + b[k])
}

impl Block {
    fn label(&self, [i, j, k]: [usize; 3]) -> u64 {
        let [nx, ny, _] = self.cells.map(|n| 2 * n + 1);
        self.base + 1 + (i + nx * (j + ny * k)) as u64
    }

    /// Corners of all elements, in halves of cells.
    fn elements(&self) -> Vec<Vec<[usize; 3]>> {
        let [nx, ny, nz] = self.cells;
        let mut all = Vec::new();
        for [i, j, k] in (0..nz)
            .flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [2 * i, 2 * j, 2 * k])))
        {
            if !self.kind.is_tetrahedron() {
                all.push(CORNERS.iter().map(|&at| sum([i, j, k], at)).collect());
                continue;
            }
            for (place, way) in WAYS.iter().enumerate() {
                let mut at = [i, j, k];
                let mut corners = vec![at];
                for &axis in way {
                    at[axis] += 2;
                    corners.push(at);
                }
                // an odd permutation has a negative volume
                if matches!(place, 1 | 2 | 5) {
                    corners.swap(2, 3);
                }
                all.push(corners);
            }
        }
        all
    }

    fn nodes(&self, corners: &[[usize; 3]]) -> Vec<[usize; 3]> {
        let edges: &[[usize; 2]] = if self.kind.is_tetrahedron() { &TET_EDGES } else { &EDGES };
        let middle = |&[a, b]: &[usize; 2]| sum(corners[a], corners[b]).map(|twice| twice / 2);
        let middles = edges.iter().filter(|_| self.kind.is_quadratic()).map(middle);
        corners.iter().copied().chain(middles).collect()
    }

    /// Writes nodes and elements; `place` maps the unit cube.
    pub fn write(&self, deck: &mut String, place: impl Fn([f64; 3]) -> [f64; 3]) {
        let elements = self.elements();
        let mut used: Vec<[usize; 3]> =
            elements.iter().flat_map(|corners| self.nodes(corners)).collect();
        used.sort_unstable_by_key(|&at| self.label(at));
        used.dedup();
        deck.push_str("*NODE\n");
        for at in used {
            let [x, y, z] = place(self.unit(at));
            let _ = writeln!(deck, "{}, {x:?}, {y:?}, {z:?}", self.label(at));
        }
        let _ = writeln!(deck, "*ELEMENT, TYPE={}, ELSET={}", self.kind.name(), self.name);
        for (number, corners) in elements.iter().enumerate() {
            let mut line = (self.base + 1 + number as u64).to_string();
            for (place, at) in self.nodes(corners).into_iter().enumerate() {
                line.push_str(if place == 14 { ",\n" } else { ", " });
                let _ = write!(line, "{}", self.label(at));
            }
            let _ = writeln!(deck, "{line}");
        }
    }

    fn unit(&self, at: [usize; 3]) -> [f64; 3] {
        std::array::from_fn(|k| at[k] as f64 / (2 * self.cells[k]) as f64)
    }

    /// A surface of the faces all of whose corners `has` places of the unit cube.
    pub fn surface(&self, name: &str, has: impl Fn([f64; 3]) -> bool) -> String {
        let mut text = format!("*SURFACE, NAME={name}\n");
        let faces: &[&[usize]] = if self.kind.is_tetrahedron() { &TET_FACES } else { &HEX_FACES };
        for (number, corners) in self.elements().iter().enumerate() {
            for (face, own) in faces.iter().enumerate() {
                if own.iter().all(|&corner| has(self.unit(corners[corner]))) {
                    let _ = writeln!(text, "{}, S{}", self.base + 1 + number as u64, face + 1);
                }
            }
        }
        text
    }

    /// A set of the nodes that `has` places of the unit cube.
    pub fn set(&self, name: &str, has: impl Fn([f64; 3]) -> bool) -> String {
        let mut all: Vec<u64> = Vec::new();
        for corners in self.elements() {
            let nodes = self.nodes(&corners);
            all.extend(nodes.into_iter().filter(|&at| has(self.unit(at))).map(|at| self.label(at)));
        }
        all.sort_unstable();
        all.dedup();
        let mut text = format!("*NSET, NSET={name}\n");
        all.iter().for_each(|label| text.push_str(&format!("{label}\n")));
        text
    }
}
