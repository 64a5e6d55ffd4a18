//! Contact points at the nodes of sharp edges, and the slave nodes that they stand between.
//!
//! docs/theory.md section 5.17

use slideline_mech::vector::{size, sub};
use slideline_model::{Model, NodeIndex};
use std::collections::HashMap;
use std::ops::Range;

/// The points of an edge pair.
#[derive(Clone, Debug)]
pub(super) struct EdgePoints {
    /// The pair whose edges they are.
    pub of: usize,
    /// Whether they are of its master.
    pub of_master: bool,
    /// The first of them.
    pub first: usize,
    /// How many they are.
    pub count: usize,
    /// Of the slave: the slave node of each. Of the master: the slave node at each node of what they meet.
    pub seats: Vec<usize>,
    /// Slave nodes of the pair.
    pub slaves: Vec<SlaveNode>,
}

/// A slave node of a pair with edges.
#[derive(Clone, Debug, Default)]
pub(super) struct SlaveNode {
    /// Its contact points: where the surface turns sharply, more than one.
    pub points: Vec<usize>,
    /// Mean size of the faces about it [L].
    pub size: f64,
}

impl EdgePoints {
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.count
    }

    /// Mean undeformed sizes of the faces about the slave nodes.
    pub fn take_sizes(&mut self, model: &Model, node: impl Fn(usize) -> NodeIndex) {
        let pair = &model.contact_pairs[self.of];
        let at = |node: NodeIndex| model.nodes.position(node);
        let mut sums: HashMap<NodeIndex, (f64, f64)> = HashMap::new();
        let mut whole = (0.0, 0.0);
        let mut add = |[a, b]: [NodeIndex; 2]| {
            let length = size(sub(at(a), at(b)));
            whole = (whole.0 + length, whole.1 + 1.0);
            for node in [a, b] {
                let sum = sums.entry(node).or_default();
                *sum = (sum.0 + length, sum.1 + 1.0);
            }
        };
        pair.elements.iter().for_each(|element| add(element.nodes));
        for face in &pair.faces {
            let corners = face.cell().map_or(0, |cell| cell.faces.len());
            (0..corners).for_each(|k| add([face.nodes[k], face.nodes[(k + 1) % corners]]));
        }
        for slave in &mut self.slaves {
            let own = slave.points.first().and_then(|&point| sums.get(&node(point)));
            let (sum, count) = own.copied().unwrap_or(whole);
            slave.size = if count > 0.0 { sum / count } else { 0.0 };
        }
    }
}
