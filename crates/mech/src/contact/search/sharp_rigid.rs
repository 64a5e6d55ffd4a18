//! The part of a rigid surface that a slave node faces about a sharp corner.
//!
//! ```text
//!                x  node, its face looks down       the nearest part is the side, or the vertex;
//!     ----------.       . . . .                     the node faces the top, which is prolonged a
//!       body     |   BEYOND                         little for it where it is straight
//! ```
//!
//! docs/theory.md section 5.14. (derived)

use super::outlook::{BEYOND, Outlook, SUNK};
use super::ridge::Profile;
use super::rigid::{self, Facing, Part, RigidSegment};
use super::sharp::turns_away;
use super::{Point, cross, dot, project_line, sub};

/// The part that a slave node at `point` with that outlook (frame of the body) faces: the nearest
/// one ([`rigid::closest`]), or at a corner the segment `before`, on which it stood, or, about a sharp corner,
/// the one beside it that looks at the node. Faces of the `slave` are so long [L].
pub fn closest(
    (segments, slave): (&[RigidSegment], f64),
    closed: bool,
    (point, before, outlook): (Point, Option<usize>, &Outlook),
) -> Option<Facing> {
    let found = rigid::closest_on(segments, closed, point)?;
    let profile = Profile { segments, closed, slave };
    let kept = before.and_then(|segment| profile.kept(point, (&found, segment)));
    let found = kept.unwrap_or(found);
    if outlook.is_everywhere() {
        return Some(found);
    }
    let about = About { segments, closed, point, outlook };
    Some(about.other_side(&found).unwrap_or(found))
}

/// Whether a surface has a sharp corner that stands out.
pub fn is_sharp(segments: &[RigidSegment], closed: bool) -> bool {
    let outlook = &Outlook::EVERYWHERE;
    let about = About { segments, closed, point: [0.0; 2], outlook };
    (0..segments.len())
        .any(|segment| about.behind(segment).is_some_and(|next| about.is_edge(segment, next)))
}

/// A slave node about a rigid surface.
struct About<'a> {
    segments: &'a [RigidSegment],
    closed: bool,
    point: Point,
    outlook: &'a Outlook,
}

impl About<'_> {
    fn behind(&self, segment: usize) -> Option<usize> {
        let next = segment + 1;
        if next < self.segments.len() { Some(next) } else { self.closed.then_some(0) }
    }

    fn before(&self, segment: usize) -> Option<usize> {
        let last = self.closed.then(|| self.segments.len() - 1);
        segment.checked_sub(1).or(last)
    }

    /// Whether two segments meet at a sharp corner that stands out.
    fn is_edge(&self, segment: usize, next: usize) -> bool {
        turns_away(self.segments[segment].tangent(false), self.segments[next].tangent(true))
    }

    /// Whether the place of a segment at a parameter looks at the node.
    fn meets(&self, segment: usize, parameter: f64) -> bool {
        let [x, y] = self.segments[segment].normal(parameter);
        self.outlook.meets([x, y, 0.0])
    }

    /// The part beyond a sharp corner that looks at the node, where the one that was found does not.
    fn other_side(&self, found: &Facing) -> Option<Facing> {
        let own = found.segment;
        match found.part {
            Part::Vertex { .. } => {
                let next = self.behind(own).filter(|&next| self.is_edge(own, next))?;
                match (self.meets(own, 1.0), self.meets(next, 0.0)) {
                    (true, false) => self.straight(own, false),
                    (false, true) => self.straight(next, true),
                    _ => None,
                }
            }
            Part::Interior if self.meets(own, found.parameter) => None,
            Part::Interior => {
                let sides = [self.edge(own, false), self.edge(own, true)];
                let nearer = |a: &(f64, Facing), b: &(f64, Facing)| a.0.total_cmp(&b.0);
                sides.into_iter().flatten().min_by(nearer).map(|(_, facing)| facing)
            }
        }
    }

    /// The segment behind the next sharp corner on the way from a segment, and its distance: where
    /// the node has sunk in no deeper than half of that side.
    fn edge(&self, from: usize, ahead: bool) -> Option<(f64, Facing)> {
        let next = |segment| if ahead { self.behind(segment) } else { self.before(segment) };
        let is_edge = |segment: usize, other: usize| match ahead {
            true => self.is_edge(segment, other),
            false => self.is_edge(other, segment),
        };
        let mut segment = from;
        // a closed surface is gone round once
        for _ in 0..self.segments.len() {
            let other = next(segment)?;
            if is_edge(segment, other) {
                if !self.meets(other, if ahead { 0.0 } else { 1.0 }) {
                    return None;
                }
                let facing = self.straight(other, ahead)?;
                let depth = self.depth(other)?;
                return (depth <= SUNK * self.side(segment, ahead))
                    .then_some((depth.abs(), facing));
            }
            segment = other;
        }
        None
    }

    /// Length of a side from the sharp corner that its segment ends at, `ahead` or before, to the
    /// other one [L].
    fn side(&self, segment: usize, ahead: bool) -> f64 {
        let (mut segment, mut sum) = (segment, self.segments[segment].length());
        for _ in 1..self.segments.len() {
            let other = if ahead { self.before(segment) } else { self.behind(segment) };
            let Some(other) = other else { break };
            let (first, second) = if ahead { (other, segment) } else { (segment, other) };
            if self.is_edge(first, second) {
                break;
            }
            segment = other;
            sum += self.segments[segment].length();
        }
        sum
    }

    /// How deep the node stands behind the line of a segment [L]; `None` of one that is curved.
    fn depth(&self, segment: usize) -> Option<f64> {
        let RigidSegment::Line { a, b } = self.segments[segment] else { return None };
        let along = sub(b, a);
        Some(-cross(along, sub(self.point, a)) / along[0].hypot(along[1]))
    }

    /// A straight segment, prolonged a little beyond the corner at its start or its end, where the
    /// node faces it.
    fn straight(&self, segment: usize, at_start: bool) -> Option<Facing> {
        let RigidSegment::Line { a, b } = self.segments[segment] else { return None };
        let parameter = project_line(a, b, self.point)?;
        let size = dot(sub(b, a), sub(b, a)).sqrt();
        let beyond = BEYOND * self.outlook.size().min(size) / size;
        let (low, high) = if at_start { (-beyond, 1.0) } else { (0.0, 1.0 + beyond) };
        let inside = (low..=high).contains(&parameter) && self.depth(segment)? <= SUNK * size;
        inside.then_some(Facing { segment, part: Part::Interior, parameter })
    }
}
