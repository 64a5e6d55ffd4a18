//! Faces of both sides of a contact pair that do not meet one another.
//!
//! ```text
//!      |  slave |
//!   +--+~~~~~~~~+--+     ~~~ tied, a pair of their own, or excluded: nothing is carried here, but
//!   |    master    |         what lies behind, the far sides of the master, stays hidden
//!   +--------------+
//! ```

use crate::node::NodeIndex;
use std::collections::HashMap;

/// Faces of both sides that do not meet one another, each by its nodes.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct LeftOut {
    /// Of the slave.
    pub slave: Vec<Vec<NodeIndex>>,
    /// Of the master.
    pub master: Vec<Vec<NodeIndex>>,
}

impl LeftOut {
    /// The same with both sides exchanged.
    pub fn turned(&self) -> Self {
        Self { slave: self.master.clone(), master: self.slave.clone() }
    }
}

/// Faces that are found by some of their nodes.
#[derive(Clone, Debug, Default)]
pub struct FacesByNodes<'a> {
    faces: &'a [Vec<NodeIndex>],
    at: HashMap<NodeIndex, Vec<usize>>,
}

impl<'a> FacesByNodes<'a> {
    /// Of these faces.
    pub fn new(faces: &'a [Vec<NodeIndex>]) -> Self {
        let mut at: HashMap<NodeIndex, Vec<usize>> = HashMap::new();
        for (place, face) in faces.iter().enumerate() {
            face.iter().for_each(|&node| at.entry(node).or_default().push(place));
        }
        Self { faces, at }
    }

    /// Whether a node belongs to one of them.
    pub fn has_node(&self, node: NodeIndex) -> bool {
        self.at.contains_key(&node)
    }

    /// Whether all of some nodes belong to the same one of them.
    pub fn has(&self, nodes: &[NodeIndex]) -> bool {
        let about = nodes.first().and_then(|node| self.at.get(node));
        let has_all = |&face: &usize| nodes.iter().all(|node| self.faces[face].contains(node));
        about.is_some_and(|about| about.iter().any(has_all))
    }
}
