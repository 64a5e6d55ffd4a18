//! Reference cells: what an element is made of before any physics.
//!
//! ```text
//!   point   1-----2   1--2--3    4-----3      3        4          6      8-----7
//!     o      line2     line3     |     |     / \      /|\        /|\    /|    /|
//!                                1-----2    1---2    1-|-3      4---5  5-----6 |
//!                                 quad4     tri3      \|/       | 3 |  | 4---|-3
//!                                                      2        1---2  1-----2
//!                                                     tet4      wedge6   hex8
//! ```
//!
//! Numbers of nodes, faces and integration points count from 1 in decks and from 0 here. Node and
//! face numbers are those of Abaqus; areas and volumes have a positive Jacobian.

mod areas;
mod cube;
mod line;
mod simplex;
mod volumes;
mod wedge;

pub use areas::{QUAD4, QUAD8, TRI3, TRI6};
pub use line::{line3_shapes, line3_slopes};
pub use volumes::{HEX8, HEX20, TET4, TET10, WEDGE6, WEDGE15};

/// A reference cell as elements, files and surfaces see it.
#[derive(Debug)]
pub struct Cell {
    /// Its name.
    pub name: &'static str,
    /// Dimension of the cell [1]: 0 a point, 1 a line, 2 an area, 3 a volume.
    pub dimension: usize,
    /// Number of nodes.
    pub nodes: usize,
    /// Nodes of each face, in the order in which decks number faces (S1, S2, ...). Of an area each
    /// from its first node to its last with the material on the left; of a volume the corners
    /// counter-clockwise as seen from outside, then the middle nodes, the first one between the
    /// first two corners.
    pub faces: &'static [&'static [usize]],
    /// The pieces that viewers are given.
    pub pieces: &'static [Piece],
    /// Where the nodes stand on the reference cell; none where nothing is interpolated.
    pub places: &'static [[f64; 3]],
    /// Writes the shape functions at a place.
    pub shapes: fn(&[f64; 3], &mut [f64]),
    /// Writes their derivatives by the coordinates of the reference cell.
    pub slopes: fn(&[f64; 3], &mut [[f64; 3]]),
}

impl Cell {
    /// Whether an area or a volume has nodes in the middle of its edges.
    pub fn is_quadratic(&self) -> bool {
        match self.dimension {
            2 => self.nodes > 4,
            3 => self.nodes > 8,
            _ => false,
        }
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// A piece of a cell in files for viewers.
#[derive(Debug, PartialEq)]
pub struct Piece {
    /// Type in VTK files.
    pub vtk: u8,
    /// Type in `.frd` files.
    pub frd: u8,
    /// Its nodes, in the order of VTK files.
    pub nodes: &'static [usize],
    /// Its nodes, in the order of `.frd` files.
    pub frd_nodes: &'static [usize],
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

/// A piece whose nodes stand in the same order in both kinds of file.
const fn piece(vtk: u8, frd: u8, nodes: &'static [usize]) -> Piece {
    Piece { vtk, frd, nodes, frd_nodes: nodes }
}

#[cfg(test)]
mod tests;
