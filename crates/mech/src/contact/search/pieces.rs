//! The pieces of a chain that a point may face: straight parts, curves, corners.
//!
//! ```text
//!       straight    corner    straight        ridge: each part up to the bisector
//!    o------------.        .-----------o           _o_
//!                   ` o  '                       /  :  \
//! ```
//!
//! docs/theory.md section 5.3. (derived)

use super::chain::{Candidate, Chain, Piece, PieceKind, flat};
use super::through::Curve;
use super::{INSIDE, Point, TIE, cross, dot, project_line, project_quadratic, sub};

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

impl Chain {
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
        let joins = self.is_ring && (self.curve(0).is_some() || is_valley(&nodes, 1));
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
