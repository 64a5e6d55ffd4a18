//! Points and lines; the line of three nodes: end, middle, end.

use super::reference::{Cell, Piece};

/// Shape functions of the three nodes at xi in [-1, 1]: docs/theory.md eq. (3.9).
pub fn line3_shapes(xi: f64) -> [f64; 3] {
    [0.5 * xi * (xi - 1.0), (1.0 - xi) * (1.0 + xi), 0.5 * xi * (xi + 1.0)]
}

/// Their derivatives by xi.
pub fn line3_slopes(xi: f64) -> [f64; 3] {
    [xi - 0.5, -2.0 * xi, xi + 0.5]
}

/// A single node: nothing to be drawn.
pub static POINT: Cell = Cell { name: "point", nodes: 1, ..NOTHING };

/// Two nodes.
pub static LINE2: Cell =
    Cell { name: "line2", dimension: 1, nodes: 2, pieces: &[line(&[0, 1])], ..NOTHING };

/// End, middle, end; drawn as two straight lines.
pub static LINE3: Cell = Cell {
    name: "line3",
    dimension: 1,
    nodes: 3,
    pieces: &[line(&[0, 1]), line(&[1, 2])],
    ..NOTHING
};

const NOTHING: Cell = Cell {
    name: "",
    dimension: 0,
    nodes: 0,
    faces: &[],
    pieces: &[],
    places: &[],
    shapes: |_, _| {},
    slopes: |_, _| {},
};

const fn line(nodes: &'static [usize]) -> Piece {
    Piece { vtk: 3, frd: 11, nodes, frd_nodes: nodes }
}
