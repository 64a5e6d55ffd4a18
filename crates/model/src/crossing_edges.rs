//! Sharp edges of both sides of a pair that may cross in space, line by line.
//!
//! ```text
//!      o----o----o----o      a line of sharp edges goes on where two of them meet and hardly turn;
//!                     |      at a corner another one begins
//!                     o
//! ```
//!
//! docs/theory.md section 5.18

use crate::node::NodeIndex;
use std::ops::Range;

/// Lines of sharp edges of both sides of a pair that is spread over faces in space.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossingEdges {
    /// Place of the pair.
    pub of: usize,
    /// Of the slave.
    pub slave: Vec<EdgeLine>,
    /// Of the master.
    pub master: Vec<EdgeLine>,
}

/// Sharp edges one behind the other.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeLine {
    /// The edges: each begins where the one before ends.
    pub edges: Vec<SharpEdge>,
    /// Whether the first one begins where the last one ends.
    pub is_closed: bool,
}

/// A straight edge at which two faces turn away from one another, or a half of one with a middle node.
#[derive(Clone, Debug, PartialEq)]
pub struct SharpEdge {
    /// Its ends.
    pub nodes: [NodeIndex; 2],
    /// The corners of faces between which it lies.
    pub corners: [NodeIndex; 2],
    /// Where its ends stand between them [1].
    pub part: Range<f64>,
    /// Corners of both faces; the first one has the edge in its order, counter-clockwise as seen from outside.
    pub faces: [Vec<NodeIndex>; 2],
}

impl EdgeLine {
    /// The most crossings that are followed at a time along a line, where the other side has so many lines.
    pub fn most_crossings(&self, others: usize) -> usize {
        (2 * others).min(2 * self.edges.len() + 2)
    }
}

impl CrossingEdges {
    /// Number of contact points.
    pub fn points(&self) -> usize {
        self.slave.iter().map(|line| line.most_crossings(self.master.len())).sum()
    }
}

impl SharpEdge {
    /// The same from its other end.
    pub(crate) fn reversed(mut self) -> Self {
        self.nodes.reverse();
        self.corners.reverse();
        self.part = 1.0 - self.part.end..1.0 - self.part.start;
        self.faces.reverse();
        self
    }
}
