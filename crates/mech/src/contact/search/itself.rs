//! A surface that meets itself: which of its own parts may a node of it touch?
//!
//! ```text
//!       .--<--.          runs: stretches of neighbouring faces, open or closed; the outside is
//!      /       \         on the left of travel
//!     |    a    |
//!     |    |    |        a node meets a face that looks at it (n_a . n_s < -.01), is none of its
//!      \   v   /         neighbours, and stands in front of it, or no deeper behind it than half
//!       '--s--'          the part is thick; no deeper than either is where the way leads through the part
//! ```
//!
//! Of two nodes that meet each other's faces one alone is a slave: the one that ranks first.
//! docs/theory.md section 5.12. (derived)

mod ranks;
mod undeformed;

use super::chain::{Candidate, Chain, Piece, PieceKind, flat};
use super::nearest::{ChainTree, better, joined};
use super::tree::{Bounds, BoxTree};
use super::{Point, cross, dot, sub};
use ranks::ranks;
use undeformed::{Part, Span, Undeformed, size};

pub(super) use undeformed::{INSIDE_OF, LOOKS, STAYS, SUNK};

/// Part of the distance of two nodes by which one may be further from the faces of the other and
/// still meet it at the same place [1].
pub(super) const HERE: f64 = 0.5;

/// A stretch of neighbouring nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// How many nodes it has, each once.
    pub nodes: usize,
    /// Whether its last node is joined to its first.
    pub is_closed: bool,
}

/// A surface that meets itself. Its nodes stand in one list, run after run, a closed run with its
/// last node before it and its first two behind it once more.
#[derive(Clone, Debug, PartialEq)]
pub struct Itself {
    /// The list as it stood before anything moved.
    undeformed: Undeformed,
    /// Number of the node at every place of the list, counted over all runs.
    numbers: Vec<usize>,
    /// Place of every node in the list.
    seats: Vec<usize>,
    /// Of every node: of two that meet, the lower one is the slave.
    ranks: Vec<usize>,
}

/// A surface where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// Its chain.
    pub chain: &'a Chain,
    /// Positions of its list [L].
    pub positions: &'a [[f64; 3]],
    /// A tree fitted to them.
    pub tree: &'a ChainTree,
}

/// The nodes of runs in the order of the list, numbered over all runs.
pub fn listed(runs: &[Run]) -> Vec<usize> {
    let mut list = Vec::new();
    let mut first = 0;
    for run in runs {
        let last = first + run.nodes;
        if run.is_closed {
            list.push(last - 1);
            list.extend(first..last);
            list.extend([first, first + 1]);
        } else {
            list.extend(first..last);
        }
        first = last;
    }
    list
}

/// What every segment of the list is, the faces of every run, and where every node stands in it.
fn laid_out(runs: &[Run]) -> (Vec<Part>, Vec<Span>, Vec<usize>) {
    let (mut parts, mut seats, mut spans) = (Vec::new(), Vec::new(), Vec::new());
    for run in runs {
        if !parts.is_empty() {
            parts.push(Part::Gap);
        }
        let begin = parts.len();
        let repeated = usize::from(run.is_closed);
        parts.extend(std::iter::repeat_n(Part::Repeated, repeated));
        let first = parts.len();
        parts.extend(std::iter::repeat_n(Part::Own, run.nodes - 1 + repeated));
        spans.push(Span { first, last: parts.len() - 1, is_closed: run.is_closed });
        parts.extend(std::iter::repeat_n(Part::Repeated, repeated));
        seats.extend((0..run.nodes).map(|k| begin + repeated + k));
    }
    (parts, spans, seats)
}

impl Itself {
    /// The surface of runs whose nodes stand at `reference` undeformed, in the order of
    /// [`listed`], and its chain. `None` for a run of too few nodes, a face without length, or
    /// fractions outside their range.
    pub fn new(
        runs: &[Run],
        reference: &[[f64; 3]],
        (smoothing, extension): (f64, f64),
    ) -> Option<(Self, Chain)> {
        let enough = |run: &Run| run.nodes > if run.is_closed { 2 } else { 1 };
        if runs.is_empty() || !runs.iter().all(enough) {
            return None;
        }
        let (parts, spans, seats) = laid_out(runs);
        let numbers = listed(runs);
        if reference.len() != numbers.len() {
            return None;
        }
        let reference = reference.iter().copied().map(flat).collect();
        let undeformed = Undeformed::new(parts, spans, reference);
        let ranks = ranks(&undeformed, &seats);
        let own = Self { undeformed, numbers, seats, ranks };
        let chain = own.chain(smoothing, extension)?;
        Some((own, chain))
    }

    /// The chain of the list; a gap has the mean length of the faces.
    fn chain(&self, smoothing: f64, extension: f64) -> Option<Chain> {
        let Undeformed { parts, reference, .. } = &self.undeformed;
        let lengths: Vec<f64> = reference.windows(2).map(|w| size(sub(w[1], w[0]))).collect();
        let faces = || lengths.iter().zip(parts).filter(|(_, part)| **part != Part::Gap);
        let mean = faces().map(|(length, _)| length).sum::<f64>() / faces().count() as f64;
        let lengths = lengths.iter().zip(parts);
        let lengths = lengths.map(|(&length, &part)| if part == Part::Gap { mean } else { length });
        Chain::of_lengths(lengths, smoothing, extension)
    }

    /// Place in the list of the node of that number.
    pub fn seat(&self, number: usize) -> usize {
        self.seats[number]
    }

    /// Whether a segment has the node at a seat, or a neighbour of it.
    fn is_neighbour(&self, seat: usize, part: usize) -> bool {
        let ends = [self.numbers[part], self.numbers[part + 1]];
        let near = |place: usize| ends.contains(&self.numbers[place]);
        near(seat) || self.undeformed.beside(seat).any(|side| near(side) || near(side + 1))
    }

    /// Whether the node at a seat can pass through a segment.
    pub fn stops(&self, seat: usize, part: usize) -> bool {
        self.undeformed.parts[part] == Part::Own && !self.is_neighbour(seat, part)
    }

    /// The piece that the node at `seat` slides on at the `positions` of the list, by a tree fitted
    /// to them: the nearest one that it may meet, unless that one's nearest node meets it here and
    /// ranks before it.
    pub fn closest(&self, placed: Placed<'_>, seat: usize) -> Option<Piece> {
        let found = self.nearest(placed, seat)?;
        let Placed { positions, .. } = placed;
        let apart = |&place: &usize| size(sub(flat(positions[place]), flat(positions[seat])));
        let other = found.piece.nodes().min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        let reach = found.distance + HERE * apart(&other);
        let yields = self.rank_of(other) < self.rank_of(seat)
            && self.nearest(placed, self.seats[self.numbers[other]]).is_some_and(|back| {
                let mut nodes = back.piece.nodes();
                back.distance <= reach && nodes.any(|k| self.numbers[k] == self.numbers[seat])
            });
        (!yields).then_some(found.piece)
    }

    fn rank_of(&self, place: usize) -> usize {
        self.ranks[self.numbers[place]]
    }

    /// The nearest piece that the node at `seat` may meet, whichever of both is the slave.
    pub fn met(&self, placed: Placed<'_>, seat: usize) -> Option<Piece> {
        self.nearest(placed, seat).map(|found| found.piece)
    }

    fn nearest(&self, placed: Placed<'_>, seat: usize) -> Option<Candidate> {
        let Placed { chain, positions, tree } = placed;
        let point = flat(positions[seat]);
        let best = |part: usize| self.best_of((chain, positions), (seat, point), part);
        let measure = |part: usize| {
            best(part).map_or(f64::INFINITY, |best| (best.distance + best.outside).powi(2))
        };
        let (part, _) = tree.nearest(point, measure)?;
        best(part)
    }

    /// The nearer of the straight part and the corner at its first node that the node may meet.
    fn best_of(
        &self,
        (chain, positions): (&Chain, &[[f64; 3]]),
        (seat, point): (usize, Point),
        part: usize,
    ) -> Option<Candidate> {
        if self.undeformed.parts[part] != Part::Own || self.is_neighbour(seat, part) {
            return None;
        }
        let mut best: Option<Candidate> = None;
        let straight =
            chain.straight_within(positions, point, (part, self.range((chain, positions), part)));
        let straight = straight.filter(|found| self.is_joined(found));
        let corner = match self.is_corner(part) && !self.is_neighbour(seat, part - 1) {
            true => chain.corner(positions, point, part),
            false => None,
        };
        for found in [straight, corner].into_iter().flatten() {
            if self.looks_at(positions, (seat, point), (chain, &found))
                && better(&found, best.as_ref())
            {
                best = Some(found);
            }
        }
        best
    }

    /// Whether faces join at the first node of a segment.
    fn is_corner(&self, part: usize) -> bool {
        part.checked_sub(1).is_some_and(|before| self.undeformed.parts[before] != Part::Gap)
    }

    /// Range of the parameter of a straight part: up to its corners, and beyond an open end.
    fn range(&self, (chain, positions): (&Chain, &[[f64; 3]]), part: usize) -> (f64, f64) {
        let end = |is_joined: bool, node: usize| {
            if is_joined { chain.cut(positions, node) } else { -chain.extension }
        };
        let behind = self.undeformed.parts.get(part + 1).is_some_and(|&next| next != Part::Gap);
        (end(self.is_corner(part), part), 1.0 - end(behind, part + 1))
    }

    /// Whether a straight part that is met beyond its end has a neighbour there.
    fn is_joined(&self, found: &Candidate) -> bool {
        found.outside == 0.0 || self.joined_there(found).is_some()
    }

    /// Whether a piece looks at the node, which is in front of it or has sunk in: not where the
    /// node stands behind it inside their own part.
    fn looks_at(
        &self,
        positions: &[[f64; 3]],
        (seat, point): (usize, Point),
        (chain, found): (&Chain, &Candidate),
    ) -> bool {
        let part = found.piece.index;
        let Some((foot, tangent)) = at_piece(chain, positions, &found.piece) else { return false };
        let faces = |side: usize| {
            let own = along(positions, side);
            dot(own, tangent) < -LOOKS * size(own) * size(tangent)
        };
        if !self.undeformed.beside(seat).any(faces) {
            return false;
        }
        let height = cross(tangent, sub(point, foot));
        let stands_free = |segment: usize, height: f64, depth: f64| {
            height >= 0.0 || self.undeformed.has_sunk_in(seat, (segment, depth))
        };
        if !stands_free(part, height, found.distance) {
            return false;
        }
        // behind a valley a node in line with one face is inside by the other alone
        self.joined_there(found).is_none_or(|other| match found.piece.kind {
            PieceKind::Straight => {
                let edge = along(positions, other);
                let height = cross(edge, sub(point, flat(positions[other]))) / size(edge);
                stands_free(other, height, -height)
            }
            _ => stands_free(other, height, found.distance),
        })
    }

    /// The other segment that a piece belongs to: of a corner the first one, of a straight part that is
    /// met beyond its end the one that joins it there, if one does; one that is repeated at a seam by
    /// its own place.
    fn joined_there(&self, found: &Candidate) -> Option<usize> {
        let part = found.piece.index;
        let other = match found.piece.kind {
            PieceKind::Straight if found.outside == 0.0 => None,
            PieceKind::Straight if found.piece.parameter >= 0.5 => Some(part + 1),
            _ => part.checked_sub(1),
        };
        let other =
            other.filter(|&k| self.undeformed.parts.get(k).is_some_and(|&own| own != Part::Gap))?;
        Some(self.seats[self.numbers[other]])
    }

    /// Change of the coordinate along the surface [L]: the short way round a closed run, zero from
    /// one run to another.
    pub fn slip(&self, chain: &Chain, from: f64, to: f64) -> f64 {
        let ends = |&Span { first, last, is_closed }: &Span| {
            let [low, high] = [first, last + 1].map(|place| chain.arc_coordinate(place));
            // pieces reach beyond the ends: about the seam, or prolonged
            let room = match is_closed {
                true => chain.reference_length(first - 1),
                false => chain.extension * chain.reference_length(first),
            };
            (low - room, high + room, is_closed.then_some(high - low))
        };
        let runs = self.undeformed.spans.iter().map(ends);
        let within = |x: f64, (low, high): (f64, f64)| (low..=high).contains(&x);
        runs.filter(|&(low, high, _)| within(from, (low, high)) && within(to, (low, high)))
            .map(|(_, _, period)| match period {
                Some(period) => (to - from) - period * ((to - from) / period).round(),
                None => to - from,
            })
            .next()
            .unwrap_or(0.0)
    }

    /// A tree of the segments.
    pub fn tree(&self, chain: &Chain, positions: &[[f64; 3]]) -> ChainTree {
        BoxTree::new(self.undeformed.parts.len(), |part| self.bounds(chain, positions, part))
    }

    /// Fits a tree to the positions.
    pub fn fit(&self, chain: &Chain, tree: &mut ChainTree, positions: &[[f64; 3]]) {
        tree.fit(|part| self.bounds(chain, positions, part));
    }

    /// Fits a tree to the ways from positions to others.
    pub fn fit_ways(
        &self,
        chain: &Chain,
        tree: &mut ChainTree,
        (from, to): (&[[f64; 3]], &[[f64; 3]]),
    ) {
        let bounds = |at: &[[f64; 3]], part: usize| self.bounds(chain, at, part);
        tree.fit(|part| joined(bounds(from, part), bounds(to, part)));
    }

    /// The circle about the first node of a segment that holds it, its prolongation and the corner
    /// there, boxed.
    fn bounds(&self, chain: &Chain, positions: &[[f64; 3]], part: usize) -> Bounds<2> {
        let node = flat(positions[part]);
        let before = part.checked_sub(1).filter(|_| self.is_corner(part));
        let ends = [Some(part + 1).filter(|_| self.undeformed.parts[part] != Part::Gap), before];
        let reach = ends.into_iter().flatten().map(|end| size(sub(flat(positions[end]), node)));
        let reach = (1.0 + chain.extension) * reach.fold(0.0, f64::max);
        (node.map(|x| x - reach), node.map(|x| x + reach))
    }
}

fn along(positions: &[[f64; 3]], part: usize) -> Point {
    sub(flat(positions[part + 1]), flat(positions[part]))
}

/// A point of a piece at its parameter, and its direction of travel [L].
fn at_piece(chain: &Chain, positions: &[[f64; 3]], piece: &Piece) -> Option<(Point, Point)> {
    let (part, s) = (piece.index, piece.parameter);
    if piece.kind == PieceKind::Straight {
        return Some((flat(positions[part]), along(positions, part)));
    }
    let control = chain.corner_control(positions, part)?;
    let weights = [(1.0 - s) * (1.0 - s), 2.0 * s * (1.0 - s), s * s];
    let mut foot = [0.0; 2];
    for (weight, at) in weights.into_iter().zip(control) {
        foot = [foot[0] + weight * at[0], foot[1] + weight * at[1]];
    }
    let (first, second) = (sub(control[1], control[0]), sub(control[2], control[1]));
    Some((foot, [0, 1].map(|axis| (1.0 - s) * first[axis] + s * second[axis])))
}

#[cfg(test)]
mod tests;
