//! An open chain of master nodes, drawn through its nodes or with its corners smoothed, its ends
//! prolonged.
//!
//! ```text
//!                      . X_k .
//!            a1 = f l1 .     . a2 = f l2
//!    - - o-----------.  corner .-----------o - -
//!    extension  straight          straight   extension
//! ```
//!
//! Where nothing else is said, segments that are chords of something round are drawn as curves through
//! their nodes ([`super::through`]). With smoothing the pieces join with a common tangent, so that no
//! point near the chain lacks a facing piece. Without it a point in the wedge at a ridge faces the nearer
//! of the two straight parts, each taken as prolonged to the bisector: the gap stays continuous, its
//! normal jumps there. A valley is rounded over next to nothing: each of its segments pushes a node to
//! the other one, and what holds it has a normal between theirs.

use super::through::{CONTROLS, Curve, Through};
use super::tree::{Bounds, BoxTree};
use super::{Point, TIE, cross, dot, project_line, sub};

pub use super::{flat, raised};

/// By how much farther than its nodes a curve may reach from one of them, in parts of the segment [1].
const BULGE: f64 = 0.25;

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

/// Kind of a piece of the chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PieceKind {
    /// Straight part between the nodes `index` and `index + 1`, extensions included; the parameter
    /// runs from 0 to 1 between the nodes.
    Straight,
    /// The same as a curve, which follows the node `first` and three more.
    Curve {
        /// The first of its nodes.
        first: usize,
    },
    /// Smoothed corner at node `index`, on the nodes `index - 1`, `index`, `index + 1`.
    Corner,
    /// Nose at the sharp edge at node `index`, on the same nodes: it prolongs the straight part before
    /// it, or not `ahead` the one behind it, and turns away ([`super::sharp`]).
    Nose {
        /// Which part it prolongs.
        ahead: bool,
    },
}

/// The piece that faces a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// First node of the straight part, or the corner's node.
    pub index: usize,
    /// Straight or corner.
    pub kind: PieceKind,
    /// Parameter of the projection [1].
    pub parameter: f64,
}

impl Piece {
    /// The control nodes in order.
    pub fn nodes(&self) -> std::ops::Range<usize> {
        match self.kind {
            PieceKind::Straight => self.index..self.index + 2,
            PieceKind::Curve { first } => first..first + CONTROLS,
            PieceKind::Corner | PieceKind::Nose { .. } => {
                self.index.saturating_sub(1)..self.index + 2
            }
        }
    }
}

/// The undeformed chain.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// Fraction f of each segment cut off by the corners, 0 <= f < 0.5 (`SMOOTH`); zero where curves
    /// pass through the nodes.
    pub smoothing: f64,
    /// Fraction of the end segments by which the ends are prolonged (`EXTENSION ZONE`).
    pub extension: f64,
    /// Mean length of the slave faces that may stand about its sharp edges [L].
    pub slave: f64,
    /// Whether its last node is its first one.
    pub is_ring: bool,
    lengths: Vec<f64>,
    arc: Vec<f64>,
    through: Through,
}

/// A candidate: the piece, its distance, and how far its parameter lies outside [L].
pub(super) struct Candidate {
    pub piece: Piece,
    pub distance: f64,
    pub outside: f64,
}

impl Chain {
    /// The chain through the undeformed positions of its nodes, in order; without `smoothing` with curves
    /// where it is round. `None` for fewer than two nodes, a segment of zero length, or a fraction outside
    /// its range.
    pub fn new(reference: &[[f64; 3]], smoothing: Option<f64>, extension: f64) -> Option<Self> {
        let lengths = reference.windows(2).map(|pair| {
            let d = sub(flat(pair[1]), flat(pair[0]));
            d[0].hypot(d[1])
        });
        if lengths.len() == 0 {
            return None;
        }
        let mut chain = Self::of_lengths(lengths, smoothing.unwrap_or(0.0), extension)?;
        if smoothing.is_none() {
            chain.round(reference.iter().copied());
        }
        Some(chain)
    }

    /// Draws curves through these undeformed positions of the nodes, where they are round.
    pub fn round(&mut self, reference: impl Iterator<Item = [f64; 3]> + Clone) {
        self.through.draw(reference, &self.lengths);
    }

    /// The chain of segments of these undeformed lengths [L]. `None` as for [`Chain::new`].
    pub fn of_lengths(
        lengths: impl ExactSizeIterator<Item = f64>,
        smoothing: f64,
        extension: f64,
    ) -> Option<Self> {
        let segments = lengths.len();
        let mut chain = Self {
            smoothing,
            extension,
            slave: f64::INFINITY,
            is_ring: false,
            lengths: Vec::with_capacity(segments),
            arc: Vec::with_capacity(segments + 1),
            through: Through::default(),
        };
        chain.take(lengths, smoothing, extension).then_some(chain)
    }

    /// Becomes the chain of segments of these undeformed lengths [L], without curves, in the room it has. False for
    /// a segment of zero length or a fraction outside its range: then it is the chain of nothing.
    pub fn take(
        &mut self,
        lengths: impl Iterator<Item = f64>,
        smoothing: f64,
        extension: f64,
    ) -> bool {
        (self.smoothing, self.extension) = (smoothing, extension.max(0.0));
        self.through.clear();
        self.lengths.clear();
        self.lengths.extend(lengths);
        self.arc.clear();
        let mut total = 0.0;
        self.arc.push(total);
        for length in &self.lengths {
            total += length;
            self.arc.push(total);
        }
        let sound = self.lengths.iter().all(|&length| length > 0.0 && length.is_finite());
        sound && (0.0..0.5).contains(&smoothing) && !extension.is_nan()
    }

    /// The line of these nodes with its end segments prolonged by their extension.
    pub fn prolonged(&self, mut nodes: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
        let beyond = |end: [f64; 3], before: [f64; 3]| {
            [0, 1, 2].map(|c| end[c] + self.extension * (end[c] - before[c]))
        };
        let last = nodes.len() - 1;
        if last > 0 {
            let ends = [beyond(nodes[0], nodes[1]), beyond(nodes[last], nodes[last - 1])];
            (nodes[0], nodes[last]) = (ends[0], ends[1]);
        }
        nodes
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.arc.len()
    }

    /// Undeformed length of segment `index` [L].
    pub fn reference_length(&self, index: usize) -> f64 {
        self.lengths.get(index).copied().unwrap_or(0.0)
    }

    /// Undeformed arc coordinate of node `index` [L].
    pub fn arc_coordinate(&self, index: usize) -> f64 {
        self.arc.get(index).copied().unwrap_or(0.0)
    }

    /// The segment at an arc coordinate, and where on it that lies, 0 to 1; beyond the ends, these.
    pub fn part_at(&self, along: f64) -> (usize, f64) {
        let behind = self.arc.partition_point(|&arc| arc <= along);
        let part = behind.saturating_sub(1).min(self.lengths.len().saturating_sub(1));
        let length = self.reference_length(part);
        let way = along - self.arc_coordinate(part);
        (part, if length > 0.0 { (way / length).clamp(0.0, 1.0) } else { 0.0 })
    }

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
        let around = nearest.saturating_sub(1)..(nearest + 2).min(self.lengths.len());
        for index in around.clone() {
            self.consider(positions, point, index, &mut best);
        }
        let first_limit = best_limit(best.as_ref());
        let mut limit = first_limit;
        let mut rest = |index: usize, reach: f64| {
            let apart = sub(point, flat(positions[index]));
            let near = reach + limit;
            if dot(apart, apart) <= near * near && !around.contains(&index) {
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
                let own = reaches.iter().take(self.lengths.len()).enumerate();
                own.for_each(|(index, &reach)| rest(index, reach));
            }
            Nearby::Tree(_) | Nearby::Positions => {
                (0..self.lengths.len()).for_each(|index| rest(index, self.reach(positions, index)))
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

    /// Number of segments, the parts of a tree.
    pub fn segments(&self) -> usize {
        self.lengths.len()
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

    /// Radius of the circle about the first node of segment `index` that holds it, its extension and
    /// the segment before with the corner between them [L]: none of them comes nearer to a point
    /// than that circle.
    pub fn reach(&self, positions: &[[f64; 3]], index: usize) -> f64 {
        let node = flat(positions[index]);
        let square = |p: [f64; 3]| dot(sub(flat(p), node), sub(flat(p), node));
        let mut reach = square(positions[index + 1]);
        if let Some(before) = index.checked_sub(1) {
            reach = reach.max(square(positions[before]));
        }
        let bulge = if self.curve(index).is_some() { BULGE } else { 0.0 };
        (1.0 + self.extension + bulge) * reach.sqrt()
    }

    /// Overclosure [L] that a point beyond an end would have against the straight line that prolongs
    /// the nearer end; `None` where no end lies behind it.
    pub fn beyond_end(&self, positions: &[[f64; 3]], point: [f64; 3]) -> Option<f64> {
        let point = flat(point);
        let last = self.lengths.len().checked_sub(1)?;
        let ends = [(0, 0.0), (last, 1.0)].into_iter().filter_map(|(index, end)| {
            let (a, b) = (flat(*positions.get(index)?), flat(*positions.get(index + 1)?));
            let xi = project_line(a, b, point)?;
            let beyond = if end == 0.0 { xi < 0.0 } else { xi > 1.0 };
            let apart = sub(point, if end == 0.0 { a } else { b });
            let overclosure = -cross(sub(b, a), sub(point, a)) / sub(b, a)[0].hypot(sub(b, a)[1]);
            beyond.then_some((dot(apart, apart), overclosure))
        });
        ends.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, overclosure)| overclosure)
    }

    /// The length after which it comes back to its beginning [L], where it does.
    pub fn period(&self) -> Option<f64> {
        self.is_ring.then(|| self.arc_coordinate(self.lengths.len()))
    }

    /// Whether curves through its nodes take the place of segments where it is round.
    pub fn is_drawn_through(&self) -> bool {
        self.through.is_drawn()
    }

    /// The most nodes that a piece follows.
    pub fn most_nodes(&self) -> usize {
        if self.is_drawn_through() { CONTROLS } else { 3 }
    }

    /// Whether it passes a node with one tangent, without smoothing.
    pub fn is_joined(&self, node: usize) -> bool {
        self.through.is_joined(node)
    }

    /// The curve in place of the segment `index`.
    pub fn curve(&self, index: usize) -> Option<&Curve> {
        self.through.curve(index)
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

#[cfg(test)]
mod tests;
