//! Parts of solid elements on a lattice, bent to shape by a map.
//!
//! ```text
//!   lattice of 2 n intervals -> cells (quads, triangles, bricks, wedges, tetrahedra)
//!   corner at even places, middle node half way between two corners
//! ```

use crate::solids::{Edges, OF_CUBE, OF_SQUARE, OF_TETRAHEDRON, OF_TRIANGLE, OF_WEDGE};
use std::collections::HashMap;

/// Shape of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Three corners in the plane.
    Triangle,
    /// Four corners in the plane.
    Quadrilateral,
    /// Four corners in space.
    Tetrahedron,
    /// Two triangles, one above the other.
    Wedge,
    /// Eight corners.
    Brick,
}

/// A type of element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// Name in the deck.
    pub name: &'static str,
    /// Shape of its cell.
    pub shape: Shape,
    /// Whether edges have middle nodes.
    pub quadratic: bool,
}

const fn linear(name: &'static str, shape: Shape) -> Kind {
    Kind { name, shape, quadratic: false }
}

const fn quadratic(name: &'static str, shape: Shape) -> Kind {
    Kind { name, shape, quadratic: true }
}

use Shape::{Brick, Quadrilateral, Tetrahedron, Triangle, Wedge};

/// Plane strain.
pub const PLANE_STRAIN: [Kind; 7] = [
    linear("CPE4", Quadrilateral),
    linear("CPE4I", Quadrilateral),
    linear("CPE4R", Quadrilateral),
    linear("CPE3", Triangle),
    quadratic("CPE8", Quadrilateral),
    quadratic("CPE8R", Quadrilateral),
    quadratic("CPE6", Triangle),
];

/// Plane stress.
pub const PLANE_STRESS: [Kind; 7] = [
    linear("CPS4", Quadrilateral),
    linear("CPS4I", Quadrilateral),
    linear("CPS4R", Quadrilateral),
    linear("CPS3", Triangle),
    quadratic("CPS8", Quadrilateral),
    quadratic("CPS8R", Quadrilateral),
    quadratic("CPS6", Triangle),
];

/// Rings.
pub const RINGS: [Kind; 7] = [
    linear("CAX4", Quadrilateral),
    linear("CAX4I", Quadrilateral),
    linear("CAX4R", Quadrilateral),
    linear("CAX3", Triangle),
    quadratic("CAX8", Quadrilateral),
    quadratic("CAX8R", Quadrilateral),
    quadratic("CAX6", Triangle),
];

/// Space.
pub const SPACE: [Kind; 9] = [
    linear("C3D8", Brick),
    linear("C3D8I", Brick),
    linear("C3D8R", Brick),
    linear("C3D4", Tetrahedron),
    linear("C3D6", Wedge),
    quadratic("C3D20", Brick),
    quadratic("C3D20R", Brick),
    quadratic("C3D10", Tetrahedron),
    quadratic("C3D15", Wedge),
];

impl Shape {
    /// Whether it lies in space.
    pub fn in_space(self) -> bool {
        matches!(self, Tetrahedron | Wedge | Brick)
    }

    /// Cells of one place of the lattice, as corners of the unit cube.
    fn cells(self) -> Vec<Vec<[usize; 3]>> {
        const FLAT: [[usize; 3]; 4] = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]];
        let above = |corners: &[[usize; 3]]| {
            let top = corners.iter().map(|&[x, y, _]| [x, y, 1]);
            corners.iter().copied().chain(top).collect::<Vec<_>>()
        };
        let halves = [[FLAT[0], FLAT[1], FLAT[2]], [FLAT[0], FLAT[2], FLAT[3]]];
        match self {
            Quadrilateral => vec![FLAT.to_vec()],
            Triangle => halves.iter().map(|half| half.to_vec()).collect(),
            Brick => vec![above(&FLAT)],
            Wedge => halves.iter().map(|half| above(half)).collect(),
            Tetrahedron => tetrahedra(),
        }
    }

    /// Edges that carry middle nodes, in the order of these.
    fn edges(self) -> Edges {
        match self {
            Triangle => OF_TRIANGLE,
            Quadrilateral => OF_SQUARE,
            Tetrahedron => OF_TETRAHEDRON,
            Wedge => OF_WEDGE,
            Brick => OF_CUBE,
        }
    }

    /// Corners of its faces S1, S2, ...
    pub fn faces(self) -> &'static [&'static [usize]] {
        match self {
            Triangle => &[&[0, 1], &[1, 2], &[2, 0]],
            Quadrilateral => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
            Tetrahedron => &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]],
            Wedge => &[&[0, 1, 2], &[3, 5, 4], &[0, 3, 4, 1], &[1, 4, 5, 2], &[2, 5, 3, 0]],
            Brick => &[
                &[0, 1, 2, 3],
                &[4, 7, 6, 5],
                &[0, 4, 5, 1],
                &[1, 5, 6, 2],
                &[2, 6, 7, 3],
                &[3, 7, 4, 0],
            ],
        }
    }

    /// Simplices of its corners, for the judge.
    pub fn simplices(self) -> &'static [&'static [usize]] {
        match self {
            Triangle => &[&[0, 1, 2]],
            Quadrilateral => &[&[0, 1, 2], &[0, 2, 3]],
            Tetrahedron => &[&[0, 1, 2, 3]],
            Wedge => &[&[0, 1, 2, 5], &[0, 1, 5, 4], &[0, 4, 5, 3]],
            Brick => &[
                &[0, 1, 2, 6],
                &[0, 2, 3, 6],
                &[0, 3, 7, 6],
                &[0, 7, 4, 6],
                &[0, 4, 5, 6],
                &[0, 5, 1, 6],
            ],
        }
    }
}

/// Six tetrahedra about the diagonal of a cube, which fit those of its neighbours.
fn tetrahedra() -> Vec<Vec<[usize; 3]>> {
    let ways = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]];
    let walk = |(k, way): (usize, &[usize; 3])| {
        let mut at = [0; 3];
        let mut corners = vec![at];
        for &axis in way {
            at[axis] = 1;
            corners.push(at);
        }
        if k >= 3 {
            corners.swap(2, 3); // an odd order of the axes turns the inside out
        }
        corners
    };
    ways.iter().enumerate().map(walk).collect()
}

/// A part: elements of one kind on a lattice.
#[derive(Clone, Debug)]
pub struct Part {
    /// Type of its elements.
    pub kind: Kind,
    /// Nodes of every cell, corners first.
    pub cells: Vec<Vec<usize>>,
    /// Place of a node in the lattice.
    lattice: HashMap<[usize; 3], usize>,
    /// First and last place of the lattice along each axis.
    ends: [[usize; 2]; 3],
}

/// A side of a part: axis, and whether it is the far one.
pub type SideOf = (usize, bool);

impl Part {
    /// A block of cells, nodes and all; `map` takes the unit cube to its place.
    pub fn block(
        kind: Kind,
        counts: [usize; 3],
        nodes: &mut Vec<[f64; 3]>,
        map: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Self {
        let deep = if kind.shape.in_space() { counts[2] } else { 1 };
        let places = (0..deep)
            .flat_map(|c| (0..counts[1]).flat_map(move |b| (0..counts[0]).map(move |a| [a, b, c])));
        let unit = |at: [f64; 3]| map([0, 1, 2].map(|k| at[k] / counts[k].max(1) as f64));
        Self::of(kind, places, nodes, unit)
    }

    /// Cells at these places of the lattice, nodes and all; `map` takes the lattice, on which a cell is
    /// one wide, to its place.
    pub fn of(
        kind: Kind,
        places: impl Iterator<Item = [usize; 3]>,
        nodes: &mut Vec<[f64; 3]>,
        map: impl Fn([f64; 3]) -> [f64; 3],
    ) -> Self {
        let (cells, lattice) = (Vec::new(), HashMap::new());
        let mut part = Self { kind, cells, lattice, ends: [[usize::MAX, 0]; 3] };
        let patterns = kind.shape.cells();
        for place in places {
            for (ends, at) in part.ends.iter_mut().zip(place) {
                *ends = [ends[0].min(2 * at), ends[1].max(2 * at + 2)];
            }
            for pattern in &patterns {
                let corners = pattern.iter().map(|at| [0, 1, 2].map(|k| 2 * (place[k] + at[k])));
                part.cell(&corners.collect::<Vec<_>>(), nodes, &map);
            }
        }
        part
    }

    fn cell(
        &mut self,
        corners: &[[usize; 3]],
        nodes: &mut Vec<[f64; 3]>,
        map: &impl Fn([f64; 3]) -> [f64; 3],
    ) {
        let edges = if self.kind.quadratic { self.kind.shape.edges() } else { &[] };
        let middle = |[a, b]: [usize; 2]| [0, 1, 2].map(|k| (corners[a][k] + corners[b][k]) / 2);
        let places = corners.iter().copied().chain(edges.iter().map(|&edge| middle(edge)));
        let cell = places.map(|at| {
            *self.lattice.entry(at).or_insert_with(|| {
                nodes.push(map(at.map(|twice| 0.5 * twice as f64)));
                nodes.len() - 1
            })
        });
        self.cells.push(cell.collect());
    }

    fn lies_on(&self, at: [usize; 3], (axis, far): SideOf) -> bool {
        at[axis] == self.ends[axis][usize::from(far)]
    }

    /// Nodes of a side.
    pub fn side(&self, side: SideOf) -> Vec<usize> {
        let on = self.lattice.iter().filter(|(at, _)| self.lies_on(**at, side));
        let mut nodes: Vec<_> = on.map(|(_, &node)| node).collect();
        nodes.sort_unstable();
        nodes
    }

    /// Faces of a side: cell and number of the face from 1.
    pub fn faces(&self, side: SideOf) -> Vec<(usize, usize)> {
        let on = self.side(side);
        let mut found = Vec::new();
        for (k, cell) in self.cells.iter().enumerate() {
            for (face, corners) in self.kind.shape.faces().iter().enumerate() {
                if corners.iter().all(|&corner| on.binary_search(&cell[corner]).is_ok()) {
                    found.push((k, face + 1));
                }
            }
        }
        found
    }

    /// Facets of the whole boundary, by corners.
    pub fn boundary(&self) -> Vec<Vec<usize>> {
        let mut seen: HashMap<Vec<usize>, (usize, Vec<usize>)> = HashMap::new();
        for cell in &self.cells {
            for face in self.kind.shape.faces() {
                let corners: Vec<_> = face.iter().map(|&corner| cell[corner]).collect();
                let mut key = corners.clone();
                key.sort_unstable();
                seen.entry(key).or_insert((0, corners)).0 += 1;
            }
        }
        let mut outer: Vec<_> =
            seen.into_values().filter(|(count, _)| *count == 1).map(|(_, face)| face).collect();
        outer.sort_unstable();
        outer
    }
}
