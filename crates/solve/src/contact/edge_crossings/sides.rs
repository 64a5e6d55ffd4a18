//! The sharp edges of both sides of a pair where they stand, and the points of their crossings.

use crate::dofs::{DofMap, Translations};
use slideline_mech::contact::search::edges::PlacedEdge;
use slideline_mech::contact::search::faces::FacePlace;
use slideline_mech::contact::search::tree::BoxTree;
use slideline_mech::surface::mesh::area_between;
use slideline_mech::vector::Vector;
use slideline_model::{EdgeLine, Model, NodeIndex};
use std::collections::HashMap;
use std::ops::Range;

/// Sharp edges of both sides of a pair, and the points of their crossings.
#[derive(Clone, Debug)]
pub(crate) struct EdgeCrossings {
    /// The pair whose edges they are.
    pub of: usize,
    /// Edges of the slave.
    pub slave: EdgeSide,
    /// Edges of the master.
    pub master: EdgeSide,
    /// Contact points of every line of the slave.
    pub slots: Vec<Range<usize>>,
    /// Whether the pair is absent in the step.
    pub is_absent: bool,
}

/// Sharp edges of one side.
#[derive(Clone, Debug, Default)]
pub(crate) struct EdgeSide {
    /// Nodes of the edges and of the faces about them.
    pub nodes: Vec<SideNode>,
    /// The edges, line by line.
    pub edges: Vec<SideEdge>,
    /// The edges of every line, and whether it is closed.
    pub lines: Vec<(Range<usize>, bool)>,
}

/// A node of a side.
#[derive(Clone, Debug)]
pub(crate) struct SideNode {
    /// The node.
    pub node: NodeIndex,
    /// Its undeformed position [L].
    pub position: Vector,
    /// Its dofs.
    pub dofs: Translations,
    /// Points of the pair, and of the nodes of its edges, that are at it.
    pub points: Vec<usize>,
}

/// An edge, by the places of nodes on its side.
#[derive(Clone, Debug)]
pub(crate) struct SideEdge {
    pub ends: [usize; 2],
    /// Corners of faces between which it lies, and where its ends stand between them [1].
    pub corners: [usize; 2],
    pub part: Range<f64>,
    /// Corners of both faces.
    pub faces: [Vec<usize>; 2],
    /// Its line.
    pub line: usize,
}

/// Where the edges of both sides stand, in room that is used again.
#[derive(Clone, Debug, Default)]
pub(crate) struct PlacedSides {
    /// Nodes of the slave and of the master [L].
    at: [Vec<Vector>; 2],
    /// Edges of both.
    pub edges: [Vec<PlacedEdge>; 2],
    /// The tree over edges of the master.
    pub tree: Option<BoxTree<3>>,
}

impl SideNode {
    /// Where it stands at displacements `u` [L].
    fn place(&self, u: &[f64]) -> Vector {
        self.dofs.displace(self.position, u)
    }
}

impl EdgeSide {
    /// Lines of edges with their dofs.
    pub fn new(lines: &[EdgeLine], dofs: &DofMap) -> Self {
        let (mut own, mut places) = (Self::default(), HashMap::new());
        for (line, said) in lines.iter().enumerate() {
            let first = own.edges.len();
            for edge in &said.edges {
                let mut place = |&node: &NodeIndex| {
                    *places.entry(node).or_insert_with(|| {
                        let (position, dofs) = ([0.0; 3], dofs.translations(node));
                        own.nodes.push(SideNode { node, position, dofs, points: Vec::new() });
                        own.nodes.len() - 1
                    })
                };
                let both = |of: &[NodeIndex; 2], place: &mut dyn FnMut(&NodeIndex) -> usize| {
                    [place(&of[0]), place(&of[1])]
                };
                let ends = both(&edge.nodes, &mut place);
                let corners = both(&edge.corners, &mut place);
                let faces = [0, 1].map(|k: usize| edge.faces[k].iter().map(&mut place).collect());
                own.edges.push(SideEdge { ends, corners, part: edge.part.clone(), faces, line });
            }
            own.lines.push((first..own.edges.len(), said.is_closed));
        }
        own
    }

    /// Takes the positions of a model.
    pub fn take(&mut self, model: &Model) {
        for own in &mut self.nodes {
            own.position = model.nodes.position(own.node);
        }
    }

    /// Where the ends of an edge stand at displacements `u` [L].
    pub fn ends(&self, edge: usize, u: &[f64]) -> [Vector; 2] {
        self.edges[edge].ends.map(|node| self.nodes[node].place(u))
    }

    /// Where its nodes and edges stand.
    fn place(&self, u: &[f64], at: &mut Vec<Vector>, edges: &mut Vec<PlacedEdge>) {
        at.clear();
        at.extend(self.nodes.iter().map(|own| own.place(u)));
        edges.clear();
        edges.extend(self.edges.iter().map(|own| {
            let [first, second] = &own.faces;
            let normals =
                [first, second].map(|face| area_between(face.len(), |corner| at[face[corner]]));
            let corners = [first, second].map(|face| face.iter().map(|&corner| at[corner]));
            PlacedEdge::new(own.ends.map(|node| at[node]), normals, corners)
        }));
    }

    /// The edges before and behind an edge in its line.
    pub fn beside(&self, edge: usize) -> [Option<usize>; 2] {
        let (range, is_closed) = &self.lines[self.edges[edge].line];
        let last = range.end - 1;
        let round = |to: usize| is_closed.then_some(to);
        [
            if edge > range.start { Some(edge - 1) } else { round(last) },
            if edge < last { Some(edge + 1) } else { round(range.start) },
        ]
    }

    /// Whether two edges are one, or neighbours in a line.
    pub fn are_near(&self, one: usize, other: usize) -> bool {
        one == other || self.beside(one).contains(&Some(other))
    }
}

impl EdgeCrossings {
    /// The number of the crossing of two edges.
    pub fn number(&self, [slave, master]: [usize; 2]) -> usize {
        slave * self.master.edges.len() + master
    }

    /// The edges of a crossing by its number.
    pub fn edges(&self, number: usize) -> [usize; 2] {
        let count = self.master.edges.len();
        [number / count, number % count]
    }

    /// The node of the slave that is nearest to a crossing.
    pub fn node_of(&self, stood: FacePlace) -> NodeIndex {
        let [slave, _] = self.edges(stood.face);
        let end = usize::from(stood.at[0] > 0.5);
        self.slave.nodes[self.slave.edges[slave].ends[end]].node
    }

    /// Both sides.
    pub fn sides(&self) -> [&EdgeSide; 2] {
        [&self.slave, &self.master]
    }

    /// Where the ends of the two edges of a crossing stand at displacements `u` [L].
    pub fn ends(&self, edges: [usize; 2], u: &[f64]) -> [[Vector; 2]; 2] {
        [self.slave.ends(edges[0], u), self.master.ends(edges[1], u)]
    }

    /// Where both sides stand at displacements `u`.
    pub fn place(&self, u: &[f64], into: &mut PlacedSides) {
        for ((side, at), edges) in self.sides().into_iter().zip(&mut into.at).zip(&mut into.edges) {
            side.place(u, at, edges);
        }
        let masters = &into.edges[1];
        let bounds = |edge: usize| masters[edge].bounds();
        match &mut into.tree {
            Some(tree) => tree.fit(bounds),
            None => into.tree = Some(BoxTree::new(masters.len(), bounds)),
        }
    }

    /// The lines of the two edges of a crossing.
    pub fn lines(&self, edges: [usize; 2]) -> [usize; 2] {
        [self.slave.edges[edges[0]].line, self.master.edges[edges[1]].line]
    }
}
