//! Reference cells: what an element is made of before any physics.
//!
//! ```text
//!   point   1-----2   1--2--3    4-----3      3
//!     o      line2     line3     |     |     / \
//!                                1-----2    1---2
//!                                 quad4     tri3
//! ```
//!
//! Numbers of nodes, faces and integration points count from 1 in decks and from 0 here.

mod line;
mod quad;

pub use line::{line3_shapes, line3_slopes};
pub use quad::{quad4_shapes, quad4_slopes};

/// A reference cell as files and surfaces see it.
#[derive(Debug, PartialEq)]
pub struct Cell {
    /// Its name.
    pub name: &'static str,
    /// Dimension of the cell [1]: 0 a point, 1 a line, 2 an area, 3 a volume.
    pub dimension: usize,
    /// Number of nodes.
    pub nodes: usize,
    /// Nodes of each face, in the order in which decks number faces (S1, S2, ...), each from its
    /// first node to its last with the material on the left.
    pub faces: &'static [&'static [usize]],
    /// The pieces that viewers are given.
    pub pieces: &'static [Piece],
}

/// A piece of a cell in files for viewers.
#[derive(Debug, PartialEq)]
pub struct Piece {
    /// Type in VTK files.
    pub vtk: u8,
    /// Type in `.frd` files.
    pub frd: u8,
    /// Its nodes, in the order of both.
    pub nodes: &'static [usize],
}

/// A single node: nothing to be drawn.
pub static POINT: Cell = Cell { name: "point", dimension: 0, nodes: 1, faces: &[], pieces: &[] };

/// Two nodes.
pub static LINE2: Cell =
    Cell { name: "line2", dimension: 1, nodes: 2, faces: &[], pieces: &[line([0, 1].as_slice())] };

/// End, middle, end; drawn as two straight lines.
pub static LINE3: Cell = Cell {
    name: "line3",
    dimension: 1,
    nodes: 3,
    faces: &[],
    pieces: &[line([0, 1].as_slice()), line([1, 2].as_slice())],
};

/// Four corners counter-clockwise. Faces: S1 from node 1 to 2, S2 from 2 to 3, S3 from 3 to 4, S4
/// from 4 to 1.
pub static QUAD4: Cell = Cell {
    name: "quad4",
    dimension: 2,
    nodes: 4,
    faces: &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
    pieces: &[Piece { vtk: 9, frd: 9, nodes: &[0, 1, 2, 3] }],
};

const fn line(nodes: &'static [usize]) -> Piece {
    Piece { vtk: 3, frd: 11, nodes }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a row of the table agrees with itself: nodes of faces and pieces exist, the
    /// faces of an area run once around it.
    #[test]
    fn cells_agree_with_themselves() {
        for cell in [&POINT, &LINE2, &LINE3, &QUAD4] {
            let named = cell.faces.iter().copied().chain(cell.pieces.iter().map(|p| p.nodes));
            assert!(named.flatten().all(|&node| node < cell.nodes), "{}", cell.name);
        }
        let ends = QUAD4.faces.iter().map(|face| (face[0], face[face.len() - 1]));
        let ends: Vec<(usize, usize)> = ends.collect();
        for (place, (_, last)) in ends.iter().enumerate() {
            assert_eq!(*last, ends[(place + 1) % ends.len()].0);
        }
    }
}
