//! A point at a ridge between two segments keeps the one on which it stood.
//!
//! ```text
//!         .o.           a point in the material below the ridge is as far from one side as from the other:
//!      .'  x  '.        rounding would tell which one it faces, and their normals differ
//! ```
//!
//! docs/theory.md section 5.6. (derived)

use super::chain::{Candidate, Chain, Piece, PieceKind, flat};
use super::faces::{RIDGE, SEAM};
use super::rigid::{Facing, Part, RigidSegment};
use super::{Point, cross, dot, project_line, sub};

impl Chain {
    /// The segment `before`, on which a point stood, in place of the one that was `found` nearest to it: where both
    /// meet at a ridge that is drawn as one, and the point is hardly nearer to the latter.
    pub(super) fn kept(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        (found, before): (&Piece, usize),
    ) -> Option<Piece> {
        if matches!(found.kind, PieceKind::Corner | PieceKind::Nose { .. })
            || self.met(found.index) == before
        {
            return None;
        }
        let neighbours = [found.index.checked_sub(1), Some(found.index + 1)].into_iter().flatten();
        let mut own = neighbours.filter(|&part| part < self.segments() && self.met(part) == before);
        let part = own.find(|&part| self.is_ridge(positions, part.max(found.index)))?;
        let [own, nearest] = [part, found.index].map(|part| self.along(positions, point, part));
        let (own, nearest) = (own?, nearest?);
        let parameter = nearest.piece.parameter;
        // in the wedge before the ridge both sides are prolonged; beside it the other one is not there
        let in_wedge = if part < found.index { parameter < 0.0 } else { parameter > 1.0 };
        if !in_wedge && !self.is_behind(positions, point, &nearest.piece) {
            return None;
        }
        let side = self.slave.min(self.reference_length(part));
        (own.distance - nearest.distance <= RIDGE * side).then_some(own.piece)
    }

    /// Whether a point stands in the material behind a segment, or the curve in its place.
    fn is_behind(&self, positions: &[[f64; 3]], point: Point, piece: &Piece) -> bool {
        let [from, to] = [0, 1].map(|next| flat(positions[piece.index + next]));
        let (at, along) = match self.curve(piece.index) {
            Some(curve) => curve.place(positions, piece.parameter),
            None => (from, sub(to, from)),
        };
        cross(along, sub(point, at)) <= 0.0
    }

    /// Whether the line turns away at a node between its ends, and neither a curve nor a corner goes round there.
    fn is_ridge(&self, positions: &[[f64; 3]], node: usize) -> bool {
        !self.is_joined(node) && self.cut(positions, node) == 0.0
    }

    /// A segment or the curve in its place for a point, a little beyond its ends too.
    fn along(&self, positions: &[[f64; 3]], point: Point, index: usize) -> Option<Candidate> {
        let range = (-SEAM, 1.0 + SEAM);
        let Some(curve) = self.curve(index) else {
            let own = self.straight_within(positions, point, (index, range))?;
            return (own.outside == 0.0).then_some(own);
        };
        let (parameter, place) = curve.project(positions, point, range)?;
        let [x, y] = sub(point, place);
        let piece = Piece { index, kind: PieceKind::Curve { first: curve.first }, parameter };
        Some(Candidate { piece, distance: x.hypot(y), outside: 0.0 })
    }
}

/// A rigid surface about a point that has sunk in beside a corner, in the frame of the body.
pub(super) struct Profile<'a> {
    /// Its segments, in order of travel.
    pub segments: &'a [RigidSegment],
    /// Whether it ends where it starts.
    pub closed: bool,
    /// Mean length of the slave's faces [L].
    pub slave: f64,
}

impl Profile<'_> {
    /// The segment `before`, on which a point stood, in place of the one that was `found` nearest to it: where both
    /// meet at a corner that the surface turns away from, and the point has sunk in hardly deeper from the former.
    pub fn kept(&self, point: Point, (found, before): (&Facing, usize)) -> Option<Facing> {
        let of = found.segment;
        if found.part != Part::Interior || of == before || before >= self.segments.len() {
            return None;
        }
        let ends = [(before, of), (of, before)];
        ends.into_iter().find(|&(first, second)| self.turns_away(first, second))?;
        let (own, depth) = self.along(before, point)?;
        let (_, least) = self.along(of, point)?;
        let side = self.slave.min(self.segments[before].length());
        (least >= 0.0 && depth - least <= RIDGE * side).then_some(own)
    }

    /// Whether the second segment follows the first one, at a corner that stands out.
    fn turns_away(&self, first: usize, second: usize) -> bool {
        let count = self.segments.len();
        let follows = first + 1 == second || (self.closed && first + 1 == count && second == 0);
        let [before, behind] =
            [self.segments[first].tangent(false), self.segments[second].tangent(true)];
        follows && cross(before, behind) < 0.0
    }

    /// The place of a segment that faces a point, straight ones a little beyond their ends too, and how deep the
    /// point stands behind it [L].
    fn along(&self, segment: usize, point: Point) -> Option<(Facing, f64)> {
        let own = &self.segments[segment];
        let parameter = match *own {
            RigidSegment::Line { a, b } => project_line(a, b, point)
                .filter(|parameter| (-SEAM..=1.0 + SEAM).contains(parameter))?,
            RigidSegment::Arc { .. } => {
                own.project(point)?;
                own.arc_parameter(point)?
            }
            RigidSegment::Parabola { .. } => own.project(point)?.0,
        };
        let depth = dot(sub(own.place(parameter), point), own.normal(parameter));
        Some((Facing { segment, part: Part::Interior, parameter }, depth))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::search::nearest::Nearby;
    use crate::contact::search::rigid::closest_on;

    /// Segments on which points about a ridge of two sides stand, that stood on the one or the other.
    fn segments(chain: &Chain, line: &[[f64; 3]], at: [f64; 3]) -> [usize; 3] {
        let found = chain.closest(line, Nearby::Positions, at).unwrap();
        let kept = |before| chain.kept(line, flat(at), (&found, before)).unwrap_or(found).index;
        [found.index, kept(0), kept(1)]
    }

    /// Requirement: a point in the material below a ridge keeps its side until it is nearer to the other one by 0.005
    /// of a slave face; in a valley, and without a side, the nearest is met.
    #[test]
    fn a_point_at_a_ridge_keeps_its_side() {
        let ridge = [[-3.0, -4.0, 0.0], [0.0; 3], [3.0, -4.0, 0.0]];
        let mut chain = Chain::of_lengths([5.0; 2].into_iter(), 0.0, 0.1).unwrap();
        chain.slave = 1.0;
        // one side is nearer than the other by 1.6 of the way beside the ridge
        for (x, expected) in [
            (1e-12, [1, 0, 1]),
            (-1e-12, [0, 0, 1]),
            (3e-3, [1, 0, 1]),
            (3.3e-3, [1, 1, 1]),
            (-3e-3, [0, 0, 1]),
            (-3.3e-3, [0, 0, 0]),
        ] {
            assert_eq!(segments(&chain, &ridge, [x, -0.01, 0.0]), expected, "{x}");
        }
        chain.slave = 0.1;
        assert_eq!(segments(&chain, &ridge, [4e-4, -0.01, 0.0]), [1, 1, 1]);
        let valley = ridge.map(|[x, y, z]| [x, -y, z]);
        let at = chain.closest(&valley, Nearby::Positions, [1e-12, 1.0, 0.0]).unwrap();
        assert!(chain.kept(&valley, [1e-12, 1.0], (&at, 0)).is_none());
    }

    /// Requirement: the same of a corner of a rigid surface, between two lines, a line and an arc; a point in front of
    /// it, or in the corner of a valley, keeps nothing.
    #[test]
    fn a_point_in_a_rigid_corner_keeps_its_side() {
        let line = |a, b| RigidSegment::Line { a, b };
        // the tangent of the arc at the corner is the second side
        let (sin, cos) = (0.5, 0.75f64.sqrt());
        let end = [4.0 * cos + 3.0 * sin - 4.0, 3.0 * cos - 4.0 * sin - 3.0];
        let arc = RigidSegment::arc([0.0; 2], end, [-4.0, -3.0]).unwrap();
        let sides = [line([0.0; 2], [3.0, -4.0]), arc];
        for second in sides {
            let segments = [line([-3.0, -4.0], [0.0; 2]), second];
            let profile = Profile { segments: &segments, closed: false, slave: 1.0 };
            let kept = |x: f64, y: f64, before| {
                let found = closest_on(&segments, false, [x, y]).unwrap();
                profile.kept([x, y], (&found, before)).unwrap_or(found).segment
            };
            for x in [1e-12, -1e-12, 1e-3, -1e-3] {
                assert_eq!([kept(x, -0.01, 0), kept(x, -0.01, 1)], [0, 1], "{x}");
            }
            assert_eq!([kept(4e-3, -0.01, 0), kept(-4e-3, -0.01, 1)], [1, 0]);
            assert_eq!(kept(1.0, -1.0, 0), 1, "in front");
        }
        let valley = [line([-3.0, 4.0], [0.0; 2]), line([0.0; 2], [3.0, 4.0])];
        let profile = Profile { segments: &valley, closed: false, slave: 1.0 };
        let found = closest_on(&valley, false, [1e-12, 1.0]).unwrap();
        assert!(profile.kept([1e-12, 1.0], (&found, 0)).is_none());
    }

    /// Requirement: the corner at which a closed surface begins is one as any other.
    #[test]
    fn a_closed_surface_has_no_first_corner() {
        let corners = [[0.0; 2], [3.0, -4.0], [-3.0, -4.0]];
        let segments =
            [0, 1, 2].map(|k| RigidSegment::Line { a: corners[k], b: corners[(k + 1) % 3] });
        let kept = |closed: bool, x: f64, before| {
            let found = closest_on(&segments, closed, [x, -0.01]).unwrap();
            Profile { segments: &segments, closed, slave: 1.0 }
                .kept([x, -0.01], (&found, before))
                .unwrap_or(found)
                .segment
        };
        assert_eq!([kept(true, 1e-12, 2), kept(true, -1e-12, 0)], [2, 0]);
        assert_eq!([kept(false, 1e-12, 2), kept(false, -1e-12, 0)], [0, 2]);
    }

    /// Requirement: what was kept beside a ridge is the straight line of its segment, prolonged; a point that stands free
    /// in front of the other side is not kept below that line.
    #[test]
    fn what_is_kept_goes_on() {
        let flat_ridge = [[-4.0, -1.0, 0.0], [0.0; 3], [4.0, -1.0, 0.0]];
        let chain = Chain::new(&flat_ridge, Some(0.0), 0.1).unwrap();
        let at = [0.04, -0.0105, 0.0];
        let found = chain.closest(&flat_ridge, Nearby::Positions, at).unwrap();
        let kept = chain.kept(&flat_ridge, flat(at), (&found, 0)).unwrap();
        assert_eq!((found.index, kept.index, kept.kind), (1, 0, PieceKind::Straight));
        assert!((kept.parameter - (1.0 + (4.0 * 0.04 - 0.0105) / 17.0)).abs() < 1e-12);
        let free = [0.04, -0.0095, 0.0];
        let found = chain.closest(&flat_ridge, Nearby::Positions, free).unwrap();
        assert!(chain.kept(&flat_ridge, flat(free), (&found, 0)).is_none());
        let wedge = [1e-12, 0.01, 0.0];
        let found = chain.closest(&flat_ridge, Nearby::Positions, wedge).unwrap();
        assert!(chain.kept(&flat_ridge, flat(wedge), (&found, 1 - found.index)).is_some());
    }
}
