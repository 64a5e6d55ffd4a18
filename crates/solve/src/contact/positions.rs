//! Where the nodes of deforming masters stand, and trees over their parts.
//!
//! ```text
//!   u --> positions of all chains, one after the other
//!         trees of the long ones, fitted: a search looks at what is near
//! ```

use super::Contact;
use super::master::MasterSurface;
use slideline_mech::contact::search::chain::ChainTree;
use slideline_mech::contact::search::faces::{self, FaceTree};

/// Segments from which on a tree pays.
const LONG: usize = 48;

/// Positions of the nodes of all deforming masters in one configuration.
#[derive(Clone, Debug, Default)]
pub struct MasterPositions {
    /// Positions, chain after chain [L].
    pub nodes: Vec<[f64; 3]>,
    /// A tree a pair, where its master is long.
    trees: Vec<Option<ChainTree>>,
    /// A tree a pair, where its master is made of faces.
    face_trees: Vec<Option<FaceTree>>,
}

impl MasterPositions {
    /// The tree over the master of a pair, where there is one.
    pub fn tree(&self, pair: usize) -> Option<&ChainTree> {
        self.trees.get(pair).and_then(Option::as_ref)
    }

    /// The tree over the faces of the master of a pair.
    pub fn face_tree(&self, pair: usize) -> Option<&FaceTree> {
        self.face_trees.get(pair).and_then(Option::as_ref)
    }
}

impl Contact {
    /// Fits the trees of `into` to the ways from its own positions to others.
    pub(super) fn fit_ways(&self, into: &mut MasterPositions, to: &MasterPositions) {
        for (master, tree) in self.masters.iter().zip(&mut into.face_trees) {
            let (MasterSurface::Faces { mesh, offset, .. }, Some(tree)) = (master, tree) else {
                continue;
            };
            let (from, to) = (&into.nodes[*offset..], &to.nodes[*offset..]);
            tree.fit(|face| faces::way_bounds(mesh, (from, to), face));
        }
        for (master, tree) in self.masters.iter().zip(&mut into.trees) {
            let (MasterSurface::Line { chain, offset, .. }, Some(tree)) = (master, tree) else {
                continue;
            };
            chain.fit_ways(tree, &into.nodes[*offset..], &to.nodes[*offset..]);
        }
    }

    /// Positions of all deforming masters at displacements `u`, written.
    pub fn place_masters(&self, u: &[f64], into: &mut MasterPositions) {
        into.nodes.clear();
        into.trees.resize(self.masters.len(), None);
        into.face_trees.resize(self.masters.len(), None);
        let trees = into.trees.iter_mut().zip(&mut into.face_trees);
        for (master, (tree, face_tree)) in self.masters.iter().zip(trees) {
            if let MasterSurface::Faces { mesh, nodes, offset, .. } = master {
                into.nodes.extend(nodes.iter().map(|(at, dofs)| dofs.displace(*at, u)));
                let own = &into.nodes[*offset..];
                match face_tree {
                    Some(tree) => tree.fit(|face| faces::bounds(mesh, own, face)),
                    None => *face_tree = Some(faces::tree(mesh, own)),
                }
            }
            let MasterSurface::Line { chain, nodes, offset } = master else { continue };
            into.nodes.extend(nodes.iter().map(|(at, dofs)| dofs.displace(*at, u)));
            if chain.segments() < LONG {
                continue;
            }
            let own = &into.nodes[*offset..];
            match tree {
                Some(tree) => chain.fit(tree, own),
                None => *tree = Some(chain.tree(own)),
            }
        }
    }
}
