//! A mesh as it was read.

use slideline_diag::Span;
use std::collections::BTreeMap;

/// Nodes, cells of every dimension, and what the author of the mesh gave names to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions of the nodes by their numbers [L].
    pub nodes: BTreeMap<u64, [f64; 3]>,
    /// All cells, points and lines among them.
    pub cells: Vec<Cell>,
    /// Physical groups, or sets.
    pub groups: Vec<Group>,
}

/// A cell: its dimension and the number of its nodes say which.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// Its number in the file.
    pub label: u64,
    /// 0 a point, 1 a line, 2 an area, 3 a volume [1].
    pub dimension: usize,
    /// Numbers of its nodes, in the order of Abaqus: a line of three nodes has its middle second.
    pub nodes: Vec<u64>,
    /// Where it stands.
    pub span: Span,
}

/// Cells, or only nodes, with a name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// As written.
    pub name: String,
    /// The largest dimension of its cells [1].
    pub dimension: usize,
    /// Places of its cells in the mesh.
    pub cells: Vec<usize>,
    /// Numbers of nodes that are named without cells.
    pub nodes: Vec<u64>,
}

impl Mesh {
    /// Numbers of all nodes of a group, each once, ascending.
    pub fn nodes_of(&self, group: &Group) -> Vec<u64> {
        let of_cells = group.cells.iter().flat_map(|&cell| &self.cells[cell].nodes);
        let mut all: Vec<u64> = of_cells.chain(&group.nodes).copied().collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}
