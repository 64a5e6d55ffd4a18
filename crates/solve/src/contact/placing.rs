//! Where the nodes of deforming masters stand, written; trees of the long ones, fitted.

use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use slideline_mech::contact::search::faces;
use slideline_mech::contact::search::own_faces::Standing;

/// Segments from which on a tree pays.
const LONG: usize = 48;

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
            let (MasterSurface::Line { chain, offset, itself, .. }, Some(tree)) = (master, tree)
            else {
                continue;
            };
            let (from, to) = (&into.nodes[*offset..], &to.nodes[*offset..]);
            match itself {
                Some(own) => own.fit_ways(chain, tree, (from, to)),
                None => chain.fit_ways(tree, from, to),
            }
        }
    }

    /// Positions of all deforming masters at displacements `u`, written.
    pub fn place_masters(&self, u: &[f64], into: &mut MasterPositions) {
        into.nodes.clear();
        into.reaches.clear();
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
            let MasterSurface::Line { chain, nodes, offset, itself, beyond, .. } = master else {
                continue;
            };
            beyond.place(nodes, u, &mut into.nodes);
            let own = &into.nodes[*offset..];
            if let Some(itself) = itself {
                match tree {
                    Some(tree) => itself.fit(chain, tree, own),
                    None => *tree = Some(itself.tree(chain, own)),
                }
                continue;
            }
            if chain.segments() < LONG {
                into.reaches.reserve(*offset + chain.segments() + 1 - into.reaches.len());
                into.reaches.resize(*offset, 0.0);
                into.reaches.extend((0..chain.segments()).map(|index| chain.reach(own, index)));
                into.reaches.push(0.0);
                continue;
            }
            match tree {
                Some(tree) => chain.fit(tree, own),
                None => *tree = Some(chain.tree(own)),
            }
        }
        self.stand_own_faces(into);
    }

    /// How the faces of masters that meet themselves stand, which are placed already.
    fn stand_own_faces(&self, into: &mut MasterPositions) {
        for (pair, master) in self.masters.iter().enumerate() {
            let MasterSurface::Faces { mesh, nodes, offset, itself: Some(_), .. } = master else {
                continue;
            };
            let pairs = into.standing.len().max(pair + 1);
            into.standing.resize_with(pairs, Standing::default);
            into.standing[pair].take(mesh, &into.nodes[*offset..offset + nodes.len()]);
        }
    }
}
