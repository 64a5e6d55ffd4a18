//! A line that meets itself as it stood before anything moved: what is behind its segments, and whether
//! a node has sunk in there since or stands on the other side of its own part.
//!
//! ```text
//!     _____________
//!    | x           |      x: behind the right end at the start, seen through its own part: not sunk in,
//!    |____________ |      however the part bends
//! ```
//!
//! docs/theory.md section 5.12. (derived)

use crate::contact::search::{Point, cross, dot, sub};

/// Cosine by which two faces must look at one another: faces at a right angle, as exactly as a deck
/// gives them, do not [1].
pub(in crate::contact::search) const LOOKS: f64 = 0.01;
/// Part of the thickness that a node may have sunk in [1].
pub(in crate::contact::search) const SUNK: f64 = 0.5;
/// What was back to back at the start within this many thicknesses is a part's own inside [1].
pub(in crate::contact::search) const INSIDE_OF: f64 = 2.5;
/// Part of its first distance from a face behind which it stood up to which a node has stayed there
/// [1]. (choice)
pub(in crate::contact::search) const STAYS: f64 = 0.5;

/// What a place of the list of segments is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// A face of the surface.
    Own,
    /// A repeated face at the seam of a closed run: a neighbour, never met.
    Repeated,
    /// Nothing: one run ends and the next begins.
    Gap,
}

/// First and last face of a run in the list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) first: usize,
    pub(super) last: usize,
    pub(super) is_closed: bool,
}

/// The list of segments before anything moved.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Undeformed {
    /// What every segment is.
    pub(super) parts: Vec<Part>,
    /// The faces of every run.
    pub(super) spans: Vec<Span>,
    /// The places of the list [L].
    pub(super) reference: Vec<Point>,
    /// Depth of the part behind every segment [L]; infinite where none ends it.
    thickness: Vec<f64>,
}

impl Undeformed {
    /// Segments and runs whose list of places is `reference` [L].
    pub(super) fn new(parts: Vec<Part>, spans: Vec<Span>, reference: Vec<Point>) -> Self {
        let mut own = Self { parts, spans, reference, thickness: Vec::new() };
        own.thickness = (0..own.parts.len()).map(|part| own.depth_behind(part)).collect();
        own
    }

    /// The segments that join the node at a seat to its neighbours.
    pub(super) fn beside(&self, seat: usize) -> impl Iterator<Item = usize> {
        let before = seat.checked_sub(1);
        let joins = |&part: &usize| self.parts.get(part).is_some_and(|&own| own != Part::Gap);
        before.into_iter().chain([seat]).filter(joins)
    }

    /// Angle by which the surface turns at a seat, to the left, where the outside is: an
    /// edge that stands out is negative, a valley positive; zero at an end [rad].
    pub(super) fn turn(&self, seat: usize) -> f64 {
        let mut sides = self.beside(seat).map(|side| along_of(&self.reference, side));
        let (Some(before), Some(behind)) = (sides.next(), sides.next()) else { return 0.0 };
        cross(before, behind).atan2(dot(before, behind))
    }

    /// Whether the node at a seat that is so deep behind a segment [L] has sunk in there: not where it
    /// stood behind it before anything moved and has come no nearer since, nor from inside their own
    /// part; where the way there led through that at the start, as from the side of a strip to its
    /// end, no deeper than either side is thick.
    pub(super) fn has_sunk_in(&self, seat: usize, (part, depth): (usize, f64)) -> bool {
        let most = SUNK * self.thickness[part];
        if depth > most {
            return false;
        }
        let (a, b) = (self.reference[part], self.reference[part + 1]);
        let (edge, way) = (sub(b, a), self.way_at_start(seat, part));
        let (behind, first) = (cross(edge, way), size(way));
        // in line with the segment and beyond its end, as exactly as a deck gives that, counts as behind
        let was_behind = self.is_one_line(seat, part) && behind > -LOOKS * size(edge) * first;
        if was_behind && most.is_finite() && first <= most && depth > STAYS * first {
            return false;
        }
        if behind <= 0.0 {
            return true;
        }
        let own = self.thickness_towards(seat, part);
        let near = INSIDE_OF * own.min(self.thickness[part]) + size(edge);
        let is_inside = first <= near && self.leads_in(seat, way);
        !is_inside && (depth <= SUNK * own || !self.leads_through(seat, part))
    }

    /// Whether a seat and a segment are of one line.
    fn is_one_line(&self, seat: usize, part: usize) -> bool {
        let line =
            |span: &Span| [seat, part].iter().all(|own| (span.first..=span.last + 1).contains(own));
        self.spans.iter().any(line)
    }

    /// The way from the undeformed node at a seat to what of a segment is nearest [L].
    fn way_at_start(&self, seat: usize, part: usize) -> Point {
        let (from, a, b) = (self.reference[seat], self.reference[part], self.reference[part + 1]);
        let edge = sub(b, a);
        let at = (dot(sub(from, a), edge) / dot(edge, edge)).clamp(0.0, 1.0);
        sub([a[0] + at * edge[0], a[1] + at * edge[1]], from)
    }

    /// Whether the way from the node at a seat to the middle of a segment of the same line led into the
    /// part at the start, and out of it there.
    fn leads_through(&self, seat: usize, part: usize) -> bool {
        let (from, a, b) = (self.reference[seat], self.reference[part], self.reference[part + 1]);
        let way = sub([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])], from);
        self.is_one_line(seat, part) && self.leads_in(seat, way) && cross(sub(b, a), way) > 0.0
    }

    /// Depth of the part behind the faces of a seat that look at a segment, of both where neither
    /// does [L]: a web may be thin one way and wide the other.
    fn thickness_towards(&self, seat: usize, part: usize) -> f64 {
        let along = |side: usize| {
            let edge = along_of(&self.reference, side);
            [edge[0] / size(edge), edge[1] / size(edge)]
        };
        let towards = along(part);
        let least = |sides: &mut dyn Iterator<Item = usize>| {
            sides.map(|side| self.thickness[side]).reduce(f64::min)
        };
        let looking = &mut self.beside(seat).filter(|&side| dot(along(side), towards) < -LOOKS);
        least(looking).or_else(|| least(&mut self.beside(seat))).unwrap_or(f64::INFINITY)
    }

    /// Whether a way from the undeformed node at a seat leads into the part: behind a valley is what is
    /// behind one of both faces, elsewhere what is behind both.
    fn leads_in(&self, seat: usize, way: Point) -> bool {
        let edges = self.beside(seat).map(|side| along_of(&self.reference, side));
        let mut enters = edges.map(|edge| cross(edge, way) <= 0.0);
        match self.turn(seat) > 0.0 {
            true => enters.any(|enters| enters),
            false => enters.all(|enters| enters),
        }
    }

    /// How far the straight way inward from the middle of a segment leads to the next one that
    /// ends its part [L].
    fn depth_behind(&self, part: usize) -> f64 {
        let (a, b) = (self.reference[part], self.reference[part + 1]);
        let edge = sub(b, a);
        let (middle, inward) = ([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])], [edge[1], -edge[0]]);
        let inward = inward.map(|x| x / size(edge));
        let others = (0..self.parts.len()).filter(|&k| k != part && self.parts[k] == Part::Own);
        let depths = others.filter_map(|other| {
            let (c, d) = (self.reference[other], self.reference[other + 1]);
            let (edge, way) = (sub(d, c), sub(c, middle));
            // the way leaves the material where it goes to the outside, on the left of the edge
            let area = cross(inward, edge);
            let (depth, at) = (cross(way, edge) / area, cross(way, inward) / area);
            (area < 0.0 && depth > 0.0 && (0.0..=1.0).contains(&at)).then_some(depth)
        });
        depths.fold(f64::INFINITY, f64::min)
    }
}

/// Length of a way [L].
pub(super) fn size(way: Point) -> f64 {
    way[0].hypot(way[1])
}

/// The segment of that number of a list of places.
pub(super) fn along_of(places: &[Point], part: usize) -> Point {
    sub(places[part + 1], places[part])
}
