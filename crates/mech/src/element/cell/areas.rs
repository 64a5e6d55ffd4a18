//! Cells of the plane, counter-clockwise.

use super::reference::{Cell, piece};
use super::{cube, simplex};

/// Three corners. Faces: S1 from node 1 to 2, S2 from 2 to 3, S3 from 3 to 1.
pub static TRI3: Cell = Cell {
    name: "tri3",
    dimension: 2,
    nodes: 3,
    faces: &[&[0, 1], &[1, 2], &[2, 0]],
    pieces: &[piece(5, 7, &[0, 1, 2])],
    places: &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    shapes: simplex::tri3_shapes,
    slopes: simplex::tri3_slopes,
};

/// Three corners, then the middles of the faces.
pub static TRI6: Cell = Cell {
    name: "tri6",
    dimension: 2,
    nodes: 6,
    faces: &[&[0, 3, 1], &[1, 4, 2], &[2, 5, 0]],
    pieces: &[piece(22, 8, &[0, 1, 2, 3, 4, 5])],
    places: &[
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.5, 0.0, 0.0],
        [0.5, 0.5, 0.0],
        [0.0, 0.5, 0.0],
    ],
    shapes: simplex::tri6_shapes,
    slopes: simplex::tri6_slopes,
};

/// Four corners counter-clockwise. Faces: S1 from node 1 to 2, S2 from 2 to 3, S3 from 3 to 4, S4
/// from 4 to 1.
pub static QUAD4: Cell = Cell {
    name: "quad4",
    dimension: 2,
    nodes: 4,
    faces: &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
    pieces: &[piece(9, 9, &[0, 1, 2, 3])],
    places: cube::QUAD4,
    shapes: cube::quad4_shapes,
    slopes: cube::quad4_slopes,
};

/// Four corners, then the middles of the faces.
pub static QUAD8: Cell = Cell {
    name: "quad8",
    dimension: 2,
    nodes: 8,
    faces: &[&[0, 4, 1], &[1, 5, 2], &[2, 6, 3], &[3, 7, 0]],
    pieces: &[piece(23, 10, &[0, 1, 2, 3, 4, 5, 6, 7])],
    places: cube::QUAD8,
    shapes: cube::quad8_shapes,
    slopes: cube::quad8_slopes,
};
