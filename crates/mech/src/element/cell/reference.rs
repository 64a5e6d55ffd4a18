//! What a reference cell is.

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

/// A piece whose nodes stand in the same order in both kinds of file.
pub(super) const fn piece(vtk: u8, frd: u8, nodes: &'static [usize]) -> Piece {
    Piece { vtk, frd, nodes, frd_nodes: nodes }
}
