//! Blocks of solids of every element type, as decks.
//!
//! ```text
//!   a grid of cells, numbers of cells a direction     map: unit cube --> body
//!   +--+--+      hexahedra as they are, wedges two a cell, tetrahedra six
//!   +--+--+      corners are mapped; middle nodes stand between them, or are mapped too
//! ```

use std::collections::HashMap;
use std::fmt::Write as _;

/// A block of one element type.
#[derive(Clone, Debug)]
pub struct Solid<'a> {
    /// Element type.
    pub element: &'a str,
    /// Cells along each axis; the third one counts in space only.
    pub cells: [usize; 3],
    /// From the unit cube to the body [L].
    pub map: fn([f64; 3]) -> [f64; 3],
    /// Data of `*SOLID SECTION` and what follows `*MATERIAL`.
    pub material: &'a str,
}

/// Its deck's first part, and its nodes.
#[derive(Clone, Debug, Default)]
pub struct Meshed {
    /// Nodes, elements, section and material.
    pub text: String,
    /// Label, place in the unit cube and position of every node.
    pub nodes: Vec<(u64, [f64; 3], [f64; 3])>,
    /// Labels of the nodes of every element, corners first; elements are numbered from 1.
    pub elements: Vec<Vec<u64>>,
    /// Corners of every face of an element, as decks number them.
    pub faces: Faces,
}

/// Corners of every face.
type Faces = &'static [&'static [usize]];
const OF_A_TRIANGLE: Faces = &[&[0, 1], &[1, 2], &[2, 0]];
const OF_A_SQUARE: Faces = &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]];
const OF_A_TETRAHEDRON: Faces = &[&[0, 1, 2], &[0, 1, 3], &[1, 2, 3], &[0, 2, 3]];
const OF_A_WEDGE: Faces = &[&[0, 1, 2], &[3, 4, 5], &[0, 1, 3, 4], &[1, 2, 4, 5], &[0, 2, 3, 5]];
const OF_A_CUBE: Faces =
    &[&[0, 1, 2, 3], &[4, 5, 6, 7], &[0, 1, 4, 5], &[1, 2, 5, 6], &[2, 3, 6, 7], &[0, 3, 4, 7]];

const CUBE: [[usize; 3]; 8] =
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
const TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]];
const WEDGES: [[usize; 6]; 2] = [[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]];
const TRIANGLES: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

/// Edges of a cell that carry middle nodes, in the order of these.
pub type Edges = &'static [[usize; 2]];
/// Those of a triangle.
pub const OF_TRIANGLE: Edges = &[[0, 1], [1, 2], [2, 0]];
/// Those of a quadrilateral.
pub const OF_SQUARE: Edges = &[[0, 1], [1, 2], [2, 3], [3, 0]];
/// Those of a tetrahedron.
pub const OF_TETRAHEDRON: Edges = &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];
/// Those of a wedge.
pub const OF_WEDGE: Edges =
    &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]];
/// Those of a brick.
pub const OF_CUBE: Edges = &[
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

impl Solid<'_> {
    /// Whether it is a body in space.
    pub fn is_spatial(&self) -> bool {
        self.element.starts_with("C3D")
    }

    /// Corners of each element within a cell, and the edges with middle nodes.
    fn pieces(&self) -> (Vec<Vec<usize>>, Edges) {
        let number = self.element[3..].trim_end_matches(|c: char| c.is_ascii_uppercase());
        let lists = |lists: &[&[usize]]| lists.iter().map(|list| list.to_vec()).collect();
        let quadratic = |edges: Edges, yes: bool| if yes { edges } else { &[] };
        match (self.is_spatial(), number) {
            (false, "3" | "6") => (
                lists(&TRIANGLES.each_ref().map(|t| &t[..])),
                quadratic(OF_TRIANGLE, number == "6"),
            ),
            (false, _) => (lists(&[&[0, 1, 2, 3]]), quadratic(OF_SQUARE, number == "8")),
            (true, "4" | "10") => (
                lists(&TETRAHEDRA.each_ref().map(|t| &t[..])),
                quadratic(OF_TETRAHEDRON, number == "10"),
            ),
            (true, "6" | "15") => {
                (lists(&WEDGES.each_ref().map(|w| &w[..])), quadratic(OF_WEDGE, number == "15"))
            }
            (true, _) => (lists(&[&[0, 1, 2, 3, 4, 5, 6, 7]]), quadratic(OF_CUBE, number == "20")),
        }
    }

    /// Faces of its elements.
    fn faces(&self) -> Faces {
        match (self.is_spatial(), self.pieces().0[0].len()) {
            (false, 3) => OF_A_TRIANGLE,
            (false, _) => OF_A_SQUARE,
            (true, 4) => OF_A_TETRAHEDRON,
            (true, 6) => OF_A_WEDGE,
            (true, _) => OF_A_CUBE,
        }
    }

    /// Where the nodes of an element stand within a cell, corners first: one list a piece.
    pub fn places(&self) -> Vec<Vec<[f64; 3]>> {
        let (pieces, edges) = self.pieces();
        let of = |piece: &Vec<usize>| {
            let corners: Vec<[f64; 3]> =
                piece.iter().map(|&corner| CUBE[corner].map(|x| x as f64)).collect();
            let middle = |&[a, b]: &[usize; 2]| {
                std::array::from_fn(|axis| 0.5 * (corners[a][axis] + corners[b][axis]))
            };
            let middles: Vec<[f64; 3]> = edges.iter().map(middle).collect();
            [corners, middles].concat()
        };
        pieces.iter().map(of).collect()
    }

    /// Nodes and elements, of straight edges.
    pub fn mesh(&self) -> Meshed {
        self.meshed(false)
    }

    /// Nodes and elements, whose middle nodes are mapped as their corners are.
    pub fn curved(&self) -> Meshed {
        self.meshed(true)
    }

    fn meshed(&self, curved: bool) -> Meshed {
        let (pieces, edges) = self.pieces();
        let [nx, ny, nz] =
            [self.cells[0], self.cells[1], if self.is_spatial() { self.cells[2] } else { 1 }];
        let mut meshed = Meshed { faces: self.faces(), ..Meshed::default() };
        // by twice the index in the grid, so that middles are whole too
        let mut labels: HashMap<[usize; 3], u64> = HashMap::new();
        let (mut elements, mut count) = (String::new(), 0);
        for cell in 0..nx * ny * nz {
            let from = [cell % nx, cell / nx % ny, cell / (nx * ny)];
            for piece in &pieces {
                let corners: Vec<[usize; 3]> = piece
                    .iter()
                    .map(|&c| std::array::from_fn(|axis| 2 * (from[axis] + CUBE[c][axis])))
                    .collect();
                let middles = edges.iter().map(|&[a, b]| {
                    std::array::from_fn(|axis| (corners[a][axis] + corners[b][axis]) / 2)
                });
                let all: Vec<[usize; 3]> = corners.iter().copied().chain(middles).collect();
                for (k, grid) in all.iter().enumerate() {
                    let next = labels.len() as u64 + 1;
                    if labels.contains_key(grid) {
                        continue;
                    }
                    labels.insert(*grid, next);
                    let ends = match k.checked_sub(corners.len()) {
                        Some(edge) if !curved => edges[edge].map(|end| corners[end]),
                        _ => [*grid; 2],
                    };
                    meshed.nodes.push(self.node(next, *grid, ends));
                }
                count += 1;
                meshed.elements.push(all.iter().map(|grid| labels[grid]).collect());
                let own: Vec<String> = all.iter().map(|grid| labels[grid].to_string()).collect();
                let (head, tail) = own.split_at(own.len().min(15));
                let _ = writeln!(elements, "{count}, {}", head.join(", "));
                if !tail.is_empty() {
                    elements.truncate(elements.len() - 1);
                    let _ = writeln!(elements, ",\n{}", tail.join(", "));
                }
            }
        }
        let text = &mut meshed.text;
        text.push_str("*NODE\n");
        for (label, _, [x, y, z]) in &meshed.nodes {
            let _ = writeln!(text, "{label}, {x:?}, {y:?}, {z:?}");
        }
        let _ = write!(text, "*ELEMENT, TYPE={}, ELSET=ALL\n{elements}", self.element);
        text.push_str("*SOLID SECTION, ELSET=ALL, MATERIAL=M\n");
        if !self.is_spatial() {
            text.push_str("1.0\n");
        }
        let _ = write!(text, "*MATERIAL, NAME=M\n{}", self.material);
        meshed
    }

    fn node(
        &self,
        label: u64,
        grid: [usize; 3],
        ends: [[usize; 3]; 2],
    ) -> (u64, [f64; 3], [f64; 3]) {
        let unit = |grid: [usize; 3]| -> [f64; 3] {
            std::array::from_fn(|axis| grid[axis] as f64 / (2.0 * self.cells[axis].max(1) as f64))
        };
        let [a, b] = ends.map(|end| {
            let mut at = unit(end);
            if !self.is_spatial() {
                at[2] = 0.0;
            }
            (self.map)(at)
        });
        (label, unit(grid), std::array::from_fn(|axis| 0.5 * (a[axis] + b[axis])))
    }
}

impl Meshed {
    /// Labels of the nodes whose place in the unit cube answers yes.
    pub fn labels(&self, of: impl Fn([f64; 3]) -> bool) -> Vec<u64> {
        self.nodes.iter().filter(|(_, at, _)| of(*at)).map(|(label, ..)| *label).collect()
    }

    /// `*BOUNDARY` lines that give nodes displacements along an axis (1, 2, 3) [L].
    pub fn hold(&self, of: impl Fn([f64; 3]) -> bool, axis: usize, value: f64) -> String {
        let labels = self.labels(of);
        labels.iter().map(|label| format!("{label}, {axis}, {axis}, {value:?}\n")).collect()
    }

    /// Elements with a face all of whose corners answer yes, as lines of `*DLOAD` with a pressure
    /// on it [F/L2].
    pub fn press(&self, of: impl Fn([f64; 3]) -> bool, pressure: f64) -> String {
        let inside = self.labels(of);
        let mut lines = String::new();
        for (element, nodes) in self.elements.iter().enumerate() {
            for (face, corners) in self.faces.iter().enumerate() {
                if corners.iter().all(|&corner| inside.binary_search(&nodes[corner]).is_ok()) {
                    let _ = writeln!(lines, "{}, P{}, {pressure:?}", element + 1, face + 1);
                }
            }
        }
        lines
    }

    /// The label of the node nearest to a place of the unit cube.
    pub fn nearest(&self, place: [f64; 3]) -> u64 {
        let far = |at: &[f64; 3]| (0..3).map(|k| (at[k] - place[k]).powi(2)).sum::<f64>();
        let near = self.nodes.iter().min_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
        near.map_or(0, |(label, ..)| *label)
    }
}
