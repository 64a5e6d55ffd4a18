//! Where the nodes of deforming masters stand, and trees over their parts.
//!
//! ```text
//!   u --> positions of all chains, one after the other
//!         trees of the long ones, fitted: a search looks at what is near
//! ```

use slideline_mech::contact::search::faces::FaceTree;
use slideline_mech::contact::search::nearest::{ChainTree, Nearby};
use slideline_mech::contact::search::own_faces::Standing;
use std::ops::Range;

/// Positions of the nodes of all deforming masters in one configuration.
#[derive(Clone, Debug, Default)]
pub struct MasterPositions {
    /// Positions, chain after chain [L].
    pub nodes: Vec<[f64; 3]>,
    /// How far the segments behind the nodes of short chains reach [L]; zero at other nodes.
    pub(super) reaches: Vec<f64>,
    /// A tree a pair, where its master is long.
    pub(super) trees: Vec<Option<ChainTree>>,
    /// A tree a pair, where its master is made of faces.
    pub(super) face_trees: Vec<Option<FaceTree>>,
    /// How the faces of a master that meets itself stand, a pair each; empty elsewhere.
    pub(super) standing: Vec<Standing>,
}

impl MasterPositions {
    /// The tree over the master of a pair, where there is one.
    pub fn tree(&self, pair: usize) -> Option<&ChainTree> {
        self.trees.get(pair).and_then(Option::as_ref)
    }

    /// The nodes of the chain of a pair, which stand at `own` among all, and what is known of its
    /// segments; `None`: they are not placed.
    pub fn chain(&self, pair: usize, own: Range<usize>) -> Option<(&[[f64; 3]], Nearby<'_>)> {
        let nearby = match self.tree(pair) {
            Some(tree) => Nearby::Tree(tree),
            None => Nearby::Reaches(self.reaches.get(own.clone())?),
        };
        Some((self.nodes.get(own)?, nearby))
    }

    /// The tree over the faces of the master of a pair.
    pub fn face_tree(&self, pair: usize) -> Option<&FaceTree> {
        self.face_trees.get(pair).and_then(Option::as_ref)
    }
}

/// Distance of two places [L].
pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    square(a, b).sqrt()
}

/// Its square [L2].
pub(super) fn square(a: [f64; 3], b: [f64; 3]) -> f64 {
    let way = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    way[0] * way[0] + way[1] * way[1] + way[2] * way[2]
}
