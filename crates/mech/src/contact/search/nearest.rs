//! The piece of a chain that is nearest to a point.
//!
//! ```text
//!           x             the pieces about the nearest node first; then those whose circle
//!    o---o--+--o---o      reaches nearer than what was found, in the order of the chain
//! ```

use super::chain::{Candidate, Chain, Piece, flat};
use super::tree::{Bounds, BoxTree};
use super::{Point, TIE, dot, sub};

/// A tree over the segments of a chain.
pub type ChainTree = BoxTree<2>;

/// What tells which segments of a chain come near a point.
#[derive(Debug, Clone, Copy)]
pub enum Nearby<'a> {
    /// Nothing but the positions of the nodes.
    Positions,
    /// [`Chain::reach`] of every segment at the positions [L].
    Reaches(&'a [f64]),
    /// A tree of the segments, fitted to the positions.
    Tree(&'a ChainTree),
}

impl<'a> Nearby<'a> {
    fn tree(self) -> Option<&'a ChainTree> {
        match self {
            Self::Tree(tree) => Some(tree),
            _ => None,
        }
    }
}

/// A box that holds two boxes.
pub(super) fn joined(a: Bounds<2>, b: Bounds<2>) -> Bounds<2> {
    ([0, 1].map(|axis| a.0[axis].min(b.0[axis])), [0, 1].map(|axis| a.1[axis].max(b.1[axis])))
}

impl Chain {
    /// The piece nearest by |g| that faces `point`, for the current `positions` of the nodes. `None`
    /// if the point faces no piece: see [`Chain::beyond_end`]. A number of positions other than that
    /// of the nodes gives `None`. With a tree of the parts, fitted to the positions, only those near
    /// are looked at; the answer is the same whatever is known. [semantics: search]
    pub fn closest(
        &self,
        positions: &[[f64; 3]],
        nearby: Nearby<'_>,
        point: [f64; 3],
    ) -> Option<Piece> {
        let point = flat(point);
        if positions.len() != self.node_count() {
            return None;
        }
        let mut best: Option<Candidate> = None;
        let nearest = match nearby.tree() {
            Some(tree) => self.nearest_by_tree(positions, tree, point)?,
            None => nearest_node(positions, point)?,
        };
        let nearest = self.met(nearest);
        let around = nearest.saturating_sub(1)..(nearest + 2).min(self.segments());
        for index in around.clone() {
            // in the order of travel, through the seam of a ring too: ties are decided by it
            self.consider(positions, point, self.met(index), &mut best);
        }
        let first_limit = best_limit(best.as_ref());
        let mut limit = first_limit;
        let mut rest = |index: usize, reach: f64| {
            let apart = sub(point, flat(positions[index]));
            let near = reach + limit;
            let is_new = self.is_met(index) && !around.contains(&index);
            if is_new && dot(apart, apart) <= near * near {
                self.consider(positions, point, index, &mut best);
                limit = best_limit(best.as_ref());
            }
        };
        match nearby {
            Nearby::Tree(tree) if first_limit.is_finite() => {
                // in the order of the parts, as without the tree: ties are decided by it
                let (mut from, mut found) = (0, [usize::MAX; AT_ONCE]);
                loop {
                    found.fill(usize::MAX);
                    tree.within(point, first_limit, |part| insert(&mut found, part, from));
                    let full = found[AT_ONCE - 1] != usize::MAX;
                    let parts = found.iter().take_while(|&&part| part != usize::MAX);
                    parts.for_each(|&part| rest(part, self.reach(positions, part)));
                    if !full {
                        break;
                    }
                    from = found[AT_ONCE - 1] + 1;
                }
            }
            Nearby::Reaches(reaches) => {
                let own = reaches.iter().take(self.segments()).enumerate();
                own.for_each(|(index, &reach)| rest(index, reach));
            }
            Nearby::Tree(_) | Nearby::Positions => {
                (0..self.segments()).for_each(|index| rest(index, self.reach(positions, index)))
            }
        }
        best.map(|candidate| candidate.piece)
    }

    /// Boxes of the parts for a tree: the circle about the first node of a segment that holds the
    /// segments before and after it, prolonged.
    pub fn bounds(&self, positions: &[[f64; 3]], index: usize) -> Bounds<2> {
        let (node, reach) = (flat(positions[index]), self.reach(positions, index));
        (node.map(|x| x - reach), node.map(|x| x + reach))
    }

    /// A tree of the parts.
    pub fn tree(&self, positions: &[[f64; 3]]) -> ChainTree {
        BoxTree::new(self.segments(), |part| self.bounds(positions, part))
    }

    /// Fits a tree to the positions.
    pub fn fit(&self, tree: &mut ChainTree, positions: &[[f64; 3]]) {
        tree.fit(|part| self.bounds(positions, part));
    }

    /// Fits a tree to the ways from positions to others.
    pub fn fit_ways(&self, tree: &mut ChainTree, from: &[[f64; 3]], to: &[[f64; 3]]) {
        tree.fit(|part| joined(self.bounds(from, part), self.bounds(to, part)));
    }

    /// Segments that a point may meet on the way `from` -> `to`, ascending, by a tree fitted to
    /// their ways; all of them without one.
    pub fn near_way(
        &self,
        tree: Option<&ChainTree>,
        (from, to): ([f64; 3], [f64; 3]),
        near: &mut Vec<usize>,
    ) {
        near.clear();
        match tree {
            Some(tree) => {
                tree.overlapping(joined((flat(from), flat(from)), (flat(to), flat(to))), |part| {
                    near.push(part);
                });
                near.sort_unstable();
            }
            None => near.extend(0..self.segments()),
        }
    }

    fn nearest_by_tree(
        &self,
        positions: &[[f64; 3]],
        tree: &ChainTree,
        point: Point,
    ) -> Option<usize> {
        let square = |node: usize| {
            let apart = sub(point, flat(positions[node]));
            dot(apart, apart)
        };
        let (part, _) = tree.nearest(point, |part| square(part).min(square(part + 1)))?;
        Some(if square(part) <= square(part + 1) { part } else { part + 1 })
    }

    /// Compares the straight part `index` and the corner at its first node with the best so far.
    fn consider(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        index: usize,
        best: &mut Option<Candidate>,
    ) {
        for candidate in self.candidates(positions, point, index).into_iter().flatten() {
            if better(&candidate, best.as_ref()) {
                *best = Some(candidate);
            }
        }
    }
}

/// The node nearest to a point, where the search begins.
fn nearest_node(positions: &[[f64; 3]], point: Point) -> Option<usize> {
    let mut nearest = None;
    let mut least = f64::INFINITY;
    for (index, &node) in positions.iter().enumerate() {
        let apart = sub(point, flat(node));
        let square = dot(apart, apart);
        if square < least {
            (nearest, least) = (Some(index), square);
        }
    }
    nearest
}

/// Nearer by more than rounding.
pub(super) fn better(candidate: &Candidate, best: Option<&Candidate>) -> bool {
    let Some(best) = best else { return candidate.distance.is_finite() };
    let (new, old) = (candidate.distance + candidate.outside, best.distance + best.outside);
    (new - old).abs() > TIE * (new + old) && new < old
}

/// Distance beyond which nothing is nearer than the best so far [L].
fn best_limit(best: Option<&Candidate>) -> f64 {
    best.map_or(f64::INFINITY, |best| (best.distance + best.outside) * (1.0 + 2.0 * TIE))
}

/// Parts that a tree's answer is sorted into at a time.
const AT_ONCE: usize = 16;

/// Keeps the lowest parts from `from` on, ascending, each once.
fn insert(found: &mut [usize; AT_ONCE], part: usize, from: usize) {
    if part < from || part >= found[AT_ONCE - 1] || found.contains(&part) {
        return;
    }
    let at = found.iter().position(|&other| part < other).unwrap_or(AT_ONCE - 1);
    found.copy_within(at..AT_ONCE - 1, at + 1);
    found[at] = part;
}
