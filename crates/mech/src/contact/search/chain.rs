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
use super::{INSIDE, Point, TIE, cross, dot, project_line, project_quadratic, sub};

use std::ops::Range;

pub use super::{flat, raised};

/// Part of both segments over which a valley is rounded where nothing else is round [1]: its bottom moves by 0.0025 of a
/// segment times the sine of half its turn.
const VALLEY: f64 = 0.005;
/// The same of a chain without smoothing [1], where many may be chords of something round on which nodes stand: a
/// five thousandth of what its arc rises over a chord.
const BARE_VALLEY: f64 = 1e-4;
/// Turn up to which a ridge counts as a valley [rad]: what is flat turns to and fro by its strains.
const FLAT: f64 = 1e-3;

/// Part of the segments by which those at the seam of a ring are prolonged [1].
const SEAM: f64 = 0.01;
/// Part of a rounded valley that a curve beside it keeps clear of [1]: it leaves the chord, along which that begins, a
/// little.
const LAP: f64 = 0.9;
/// By how much farther than its nodes a curve may reach from one of them, in parts of the segment [1].
const BULGE: f64 = 0.25;

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
    pub fn nodes(&self) -> Range<usize> {
        match self.kind {
            PieceKind::Straight => self.index..self.index + 2,
            PieceKind::Curve { first } => first..first + CONTROLS,
            PieceKind::Corner | PieceKind::Nose { .. } => {
                self.index.saturating_sub(1)..self.index + 2
            }
        }
    }

    /// The segments that it is of: both that a corner joins.
    pub fn segments(&self) -> impl Iterator<Item = usize> {
        let before = match self.kind {
            PieceKind::Straight | PieceKind::Curve { .. } => None,
            PieceKind::Corner | PieceKind::Nose { .. } => self.index.checked_sub(1),
        };
        before.into_iter().chain([self.index])
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
    /// Its own segments; those before and behind continue it.
    pub(super) own: Range<usize>,
    pub(super) lengths: Vec<f64>,
    pub(super) arc: Vec<f64>,
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
            own: 0..segments,
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
        self.own = 0..self.lengths.len();
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

    /// Number of segments, the parts of a tree.
    pub fn segments(&self) -> usize {
        self.lengths.len()
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

    /// The length after which it comes back to its beginning [L], where it does.
    pub fn period(&self) -> Option<f64> {
        let [from, to] = [self.own.start, self.own.end].map(|node| self.arc_coordinate(node));
        self.is_ring.then_some(to - from)
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

    /// What a point faces of the straight part `index`, or of the curve in its place, and of the corner at its first
    /// node.
    pub(super) fn candidates(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        index: usize,
    ) -> [Option<Candidate>; 2] {
        let range = self.range(positions, index);
        let along = match self.curve(index) {
            Some(curve) => self.curved(curve, positions, point, (index, range)),
            None => self.straight_within(positions, point, (index, range)),
        };
        [along, self.corner(positions, point, index)]
    }

    /// Range of the straight part's parameter.
    fn range(&self, positions: &[[f64; 3]], index: usize) -> (f64, f64) {
        let last = self.segments();
        let lap = if self.curve(index).is_some() { LAP } else { 1.0 };
        let beyond = |node: usize| match node == 0 || node == last {
            true => self.beyond_ends(positions),
            false => -lap * self.cut(positions, node),
        };
        (-beyond(index), 1.0 + beyond(index + 1))
    }

    /// Part of the end segments by which they are prolonged [1]: those of a ring that is drawn as a curve or does
    /// not turn away at its seam a little, so that what stands there faces one of them.
    fn beyond_ends(&self, positions: &[[f64; 3]]) -> f64 {
        let nodes = [positions.len() - 2, 0, 1].map(|node| positions[node]);
        let joins = self.is_ring
            && self.own.len() == self.segments()
            && (self.curve(0).is_some() || is_valley(&nodes, 1));
        if joins { self.extension.max(SEAM) } else { self.extension }
    }

    /// Part of both segments that the corner at a node between them takes [1]: nothing of a ridge that is
    /// not smoothed, nor where a curve passes.
    pub(super) fn cut(&self, positions: &[[f64; 3]], node: usize) -> f64 {
        let is_drawn =
            self.smoothing <= 0.0 && (self.is_joined(node) || !is_valley(positions, node));
        if is_drawn { 0.0 } else { self.corner_fraction() }
    }

    /// The same of a corner that there is.
    pub fn corner_fraction(&self) -> f64 {
        match self.is_drawn_through() {
            true => VALLEY,
            false if self.smoothing > 0.0 => self.smoothing,
            false => BARE_VALLEY,
        }
    }

    /// The curve in place of the straight part `index` for a point, in this range of its parameter; beyond it
    /// the straight part, in the wedge at a ridge.
    fn curved(
        &self,
        curve: &Curve,
        positions: &[[f64; 3]],
        point: Point,
        (index, range): (usize, (f64, f64)),
    ) -> Option<Candidate> {
        let Some((parameter, place)) = curve.project(positions, point, range) else {
            let beyond = self.straight_within(positions, point, (index, range))?;
            return (beyond.outside > 0.0).then_some(beyond);
        };
        let apart = sub(point, place);
        let piece = Piece { index, kind: PieceKind::Curve { first: curve.first }, parameter };
        Some(Candidate { piece, distance: apart[0].hypot(apart[1]), outside: 0.0 })
    }

    /// The straight part `index` for a point, in this range of its parameter; beyond it only in the
    /// wedge at its node.
    pub(super) fn straight_within(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        (index, (low, high)): (usize, (f64, f64)),
    ) -> Option<Candidate> {
        let (a, b) = (flat(positions[index]), flat(positions[index + 1]));
        let parameter = project_line(a, b, point)?;
        let along = sub(b, a);
        let length = dot(along, along).sqrt();
        let over = (low - parameter).max(parameter - high);
        let outside = if over <= INSIDE { 0.0 } else { over * length };
        let before = parameter < low;
        if outside > 0.0 && !self.in_wedge(positions, point, index, (before, outside)) {
            return None;
        }
        let distance = cross(along, sub(point, a)).abs() / length;
        let piece = Piece { index, kind: PieceKind::Straight, parameter };
        Some(Candidate { piece, distance, outside })
    }

    /// Whether a point outside the range of a straight part lies in the wedge at its node, on this
    /// side of the bisector. Only where there is no corner.
    fn in_wedge(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        index: usize,
        (before, outside): (bool, f64),
    ) -> bool {
        let neighbour = if before { index.checked_sub(1) } else { Some(index + 1) };
        let Some(neighbour) = neighbour.filter(|&n| n < self.segments()) else { return false };
        let node = index.max(neighbour);
        if self.is_joined(node) || self.cut(positions, node) > 0.0 {
            return false;
        }
        let (a, b) = (flat(positions[neighbour]), flat(positions[neighbour + 1]));
        let Some(parameter) = project_line(a, b, point) else { return false };
        let length = dot(sub(b, a), sub(b, a)).sqrt();
        let over = (if before { parameter - 1.0 } else { -parameter }) * length;
        over > 0.0 && outside <= over * (1.0 + TIE)
    }

    /// Control points P0, X, P2 of the corner at node `index`.
    pub(super) fn corner_control(
        &self,
        positions: &[[f64; 3]],
        index: usize,
    ) -> Option<[Point; 3]> {
        let at = |node: usize| positions.get(node).copied().map(flat);
        let (a, x, b) = (at(index.checked_sub(1)?)?, at(index)?, at(index + 1)?);
        let f = self.corner_fraction();
        let toward = |p: Point| [x[0] + f * (p[0] - x[0]), x[1] + f * (p[1] - x[1])];
        Some([toward(a), x, toward(b)])
    }

    /// The smoothed corner at node `index` for a point.
    pub(super) fn corner(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        index: usize,
    ) -> Option<Candidate> {
        if index == 0 || self.cut(positions, index) == 0.0 {
            return None;
        }
        let control = self.corner_control(positions, index)?;
        let s = project_quadratic(&control, point)?;
        let weights = [(1.0 - s) * (1.0 - s), 2.0 * s * (1.0 - s), s * s];
        let mut apart = point;
        for (weight, p) in weights.iter().zip(control) {
            apart = [apart[0] - weight * p[0], apart[1] - weight * p[1]];
        }
        let piece = Piece { index, kind: PieceKind::Corner, parameter: s };
        Some(Candidate { piece, distance: apart[0].hypot(apart[1]), outside: 0.0 })
    }
}

/// Whether a chain turns to its outside, which is on its left, or hardly at all, at a node between its
/// ends.
fn is_valley(positions: &[[f64; 3]], node: usize) -> bool {
    let [before, here, behind] = [node - 1, node, node + 1].map(|node| flat(positions[node]));
    let ways = (sub(here, before), sub(behind, here));
    cross(ways.0, ways.1) > -FLAT * dot(ways.0, ways.1).abs()
}

#[cfg(test)]
mod tests;
