//! Where the nodes of deforming masters stand, and trees over their parts.
//!
//! ```text
//!   u --> positions of all chains, one after the other
//!         trees of the long ones, fitted: a search looks at what is near
//! ```

use super::Contact;
use super::master::MasterSurface;
use slideline_mech::contact::search::chain::ChainTree;

/// Segments from which on a tree pays.
const LONG: usize = 48;

/// Positions of the nodes of all deforming masters in one configuration.
#[derive(Clone, Debug, Default)]
pub struct MasterPositions {
    /// Positions, chain after chain [L].
    pub nodes: Vec<[f64; 3]>,
    /// A tree a pair, where its master is long.
    trees: Vec<Option<ChainTree>>,
}

impl MasterPositions {
    /// The tree over the master of a pair, where there is one.
    pub fn tree(&self, pair: usize) -> Option<&ChainTree> {
        self.trees.get(pair).and_then(Option::as_ref)
    }
}

impl Contact {
    /// Fits the trees of `into` to the ways from its own positions to others.
    pub(super) fn fit_ways(&self, into: &mut MasterPositions, to: &MasterPositions) {
        for (master, tree) in self.masters.iter().zip(&mut into.trees) {
            let (MasterSurface::Line { chain, offset, .. }, Some(tree)) = (master, tree) else {
                continue;
            };
            chain.fit_ways(tree, &into.nodes[*offset..], &to.nodes[*offset..]);
        }
    }

    /// Positions of all chains at displacements `u`, written.
    pub fn place_chains(&self, u: &[f64], into: &mut MasterPositions) {
        into.nodes.clear();
        into.trees.resize(self.masters.len(), None);
        for (master, tree) in self.masters.iter().zip(&mut into.trees) {
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
