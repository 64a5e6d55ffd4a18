//! Cells of space. Face numbers: Abaqus, "Three-dimensional solid element library".

use super::reference::{Cell, Piece, piece};
use super::{cube, simplex, wedge};

/// Four corners; node 4 above the face 1-2-3.
pub static TET4: Cell = Cell {
    name: "tet4",
    dimension: 3,
    nodes: 4,
    faces: &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
    pieces: &[piece(10, 3, &[0, 1, 2, 3])],
    places: &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    shapes: simplex::tet4_shapes,
    slopes: simplex::tet4_slopes,
};

/// Four corners, then middles of 1-2, 2-3, 3-1, 1-4, 2-4, 3-4.
pub static TET10: Cell = Cell {
    name: "tet10",
    dimension: 3,
    nodes: 10,
    faces: &[&[0, 2, 1, 6, 5, 4], &[0, 1, 3, 4, 8, 7], &[1, 2, 3, 5, 9, 8], &[2, 0, 3, 6, 7, 9]],
    pieces: &[piece(24, 6, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9])],
    places: &[
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.5, 0.0, 0.0],
        [0.5, 0.5, 0.0],
        [0.0, 0.5, 0.0],
        [0.0, 0.0, 0.5],
        [0.5, 0.0, 0.5],
        [0.0, 0.5, 0.5],
    ],
    shapes: simplex::tet10_shapes,
    slopes: simplex::tet10_slopes,
};

/// Triangle 1-2-3 below, 4-5-6 above.
pub static WEDGE6: Cell = Cell {
    name: "wedge6",
    dimension: 3,
    nodes: 6,
    faces: &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
    pieces: &[piece(13, 2, &[0, 1, 2, 3, 4, 5])],
    places: &[
        [0.0, 0.0, -1.0],
        [1.0, 0.0, -1.0],
        [0.0, 1.0, -1.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
    ],
    shapes: wedge::wedge6_shapes,
    slopes: wedge::wedge6_slopes,
};

/// Six corners, then middles below, above and of the uprights.
pub static WEDGE15: Cell = Cell {
    name: "wedge15",
    dimension: 3,
    nodes: 15,
    faces: &[
        &[0, 2, 1, 8, 7, 6],
        &[3, 4, 5, 9, 10, 11],
        &[0, 1, 4, 3, 6, 13, 9, 12],
        &[1, 2, 5, 4, 7, 14, 10, 13],
        &[2, 0, 3, 5, 8, 12, 11, 14],
    ],
    pieces: &[Piece {
        vtk: 26,
        frd: 5,
        nodes: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14],
        frd_nodes: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11],
    }],
    places: &[
        [0.0, 0.0, -1.0],
        [1.0, 0.0, -1.0],
        [0.0, 1.0, -1.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
        [0.5, 0.0, -1.0],
        [0.5, 0.5, -1.0],
        [0.0, 0.5, -1.0],
        [0.5, 0.0, 1.0],
        [0.5, 0.5, 1.0],
        [0.0, 0.5, 1.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
    ],
    shapes: wedge::wedge15_shapes,
    slopes: wedge::wedge15_slopes,
};

/// Square 1-2-3-4 below, 5-6-7-8 above.
pub static HEX8: Cell = Cell {
    name: "hex8",
    dimension: 3,
    nodes: 8,
    faces: &[
        &[0, 3, 2, 1],
        &[4, 5, 6, 7],
        &[0, 1, 5, 4],
        &[1, 2, 6, 5],
        &[2, 3, 7, 6],
        &[3, 0, 4, 7],
    ],
    pieces: &[piece(12, 1, &[0, 1, 2, 3, 4, 5, 6, 7])],
    places: cube::HEX8,
    shapes: cube::hex8_shapes,
    slopes: cube::hex8_slopes,
};

/// Eight corners, then middles of the edges below, above and of the uprights.
pub static HEX20: Cell = Cell {
    name: "hex20",
    dimension: 3,
    nodes: 20,
    faces: &[
        &[0, 3, 2, 1, 11, 10, 9, 8],
        &[4, 5, 6, 7, 12, 13, 14, 15],
        &[0, 1, 5, 4, 8, 17, 12, 16],
        &[1, 2, 6, 5, 9, 18, 13, 17],
        &[2, 3, 7, 6, 10, 19, 14, 18],
        &[3, 0, 4, 7, 11, 16, 15, 19],
    ],
    pieces: &[Piece {
        vtk: 25,
        frd: 4,
        nodes: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19],
        frd_nodes: &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15],
    }],
    places: cube::HEX20,
    shapes: cube::hex20_shapes,
    slopes: cube::hex20_slopes,
};
