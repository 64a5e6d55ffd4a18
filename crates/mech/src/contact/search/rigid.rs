//! Rigid surface of analytic segments, in the frame of its body.
//!
//! ```text
//!      start o----line----.          outward normal: 90 degrees counter-clockwise of travel
//!                          \  arc
//!                           '--o     vertices: a point in the wedge of a corner faces the vertex
//! ```
//!
//! A corner that the surface turns away from leaves a wedge of points that face neither segment; they
//! face the vertex (nearest end point), on either side of the surface, so that no hole exists. Open
//! ends have no such wedge: beyond them there is no contact.

pub use super::segment::RigidSegment;
use super::sweep::cross_rigid;
use super::{Point, TIE, cross, dot, sub};

/// Which part of a segment a point faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The segment itself.
    Interior,
    /// The vertex at the segment's end.
    Vertex {
        /// Whether the wedge with the point lies outside (a convex corner): h = -distance; else the
        /// point has penetrated a concave corner and h = + distance.
        convex: bool,
    },
}

/// The part of a rigid surface that faces a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Facing {
    /// Segment.
    pub segment: usize,
    /// Interior, or the vertex at the segment's end.
    pub part: Part,
    /// Parameter on the segment, 0 at its start, 1 at its end (and at its vertex).
    pub parameter: f64,
}

/// The part nearest by |g| that faces `point` (frame of the body).
/// All segments are looked at. `None` if the point faces nothing. [semantics: search]
pub fn closest(segments: &[RigidSegment], point: Point) -> Option<Facing> {
    closest_on(segments, is_closed(segments), point)
}

/// The same where it is known whether the surface is `closed`.
pub fn closest_on(segments: &[RigidSegment], closed: bool, point: Point) -> Option<Facing> {
    let (mut facing, _) = nearest_on(segments, closed, point)?;
    if facing.part == Part::Interior
        && let Some(parameter) = segments[facing.segment].arc_parameter(point)
    {
        facing.parameter = parameter;
    }
    Some(facing)
}

/// The same with the distance |g| [L], and without the parameter of an arc.
pub fn nearest_on(segments: &[RigidSegment], closed: bool, point: Point) -> Option<(Facing, f64)> {
    let mut best: Option<(Facing, f64)> = None;
    for (index, segment) in segments.iter().enumerate() {
        let interior = segment.project(point).map(|(parameter, distance)| {
            (Facing { segment: index, part: Part::Interior, parameter }, distance)
        });
        let next = if index + 1 < segments.len() {
            segments.get(index + 1)
        } else if closed {
            segments.first()
        } else {
            None
        };
        if let Some((facing, distance)) = interior
            && better(distance, best.as_ref())
            && is_seen(segments, &facing, point)
        {
            best = Some((facing, distance));
        }
        let apart = sub(point, segment.end());
        let nearer = |least: f64| dot(apart, apart) <= least * least * (1.0 + 4.0 * TIE);
        let reached = best.as_ref().is_none_or(|&(_, least)| nearer(least));
        if let Some(next) = next.filter(|_| reached)
            && let Some((facing, distance)) = vertex(segment, next, index, point)
            && better(distance, best.as_ref())
            && is_seen(segments, &facing, point)
        {
            best = Some((facing, distance));
        }
    }
    best
}

/// Whether a point that stands behind a part of the surface is overclosed there: it lies no deeper
/// than the surface is large, and no other part lies between. In front of a part every point is seen.
///
/// ```text
///      x . . . . .|.      behind the infinite line of the steep face, but the ramp is between:
///         ramp / /|       the point is in front of the ramp, and not overclosed by ten millimetres
/// ```
fn is_seen(segments: &[RigidSegment], facing: &Facing, point: Point) -> bool {
    let segment = &segments[facing.segment];
    let foot = match (facing.part, *segment) {
        (Part::Vertex { convex: true }, _) => return true,
        (Part::Vertex { convex: false }, _) => segment.end(),
        // no deeper than its radius, and nothing lies within
        (Part::Interior, RigidSegment::Arc { convex: true, .. }) => return true,
        (Part::Interior, RigidSegment::Arc { centre, radius, .. }) => {
            let apart = sub(point, centre);
            let distance = apart[0].hypot(apart[1]);
            [0, 1].map(|c| centre[c] + radius * apart[c] / distance)
        }
        (Part::Interior, _) => segment.place(facing.parameter),
    };
    let way = sub(foot, point);
    let normal = segment.normal(facing.parameter);
    if dot(way, normal) <= 0.0 {
        return true;
    }
    let ends = segments.iter().flat_map(|other| [other.start(), other.end()]);
    let size = ends.fold(0.0_f64, |size, end| {
        let apart = sub(end, foot);
        size.max(dot(apart, apart))
    });
    if dot(way, way) > size {
        return false;
    }
    let mut free = true;
    cross_rigid(segments, (point, foot), |crossing| {
        free &= crossing.segment == facing.segment || crossing.fraction > 1.0 - REACHED;
    });
    free
}

/// Last part of the way to a place that belongs to that place [1].
const REACHED: f64 = 1e-6;

/// A place beyond an open end of a rigid surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeyondEnd {
    /// Whether it is the end at which the surface starts.
    pub at_start: bool,
    /// How far beyond it, along its tangent [L].
    pub beyond: f64,
    /// Overclosure against what prolongs that end: the line, the circle, or the tangent of the
    /// parabola [L].
    pub depth: f64,
}

/// Where a point lies beyond the nearer end of an open surface. `None` where no end lies behind the
/// point.
pub fn beyond_end(segments: &[RigidSegment], point: Point) -> Option<BeyondEnd> {
    let (first, last) = (segments.first()?, segments.last()?);
    let ends = [(first, true), (last, false)].into_iter().filter_map(|(segment, at_start)| {
        let end = if at_start { segment.start() } else { segment.end() };
        let (apart, tangent) = (sub(point, end), segment.tangent(at_start));
        let along = dot(apart, tangent);
        let beyond = if at_start { -along } else { along };
        let depth = match *segment {
            RigidSegment::Arc { centre, radius, convex, .. } => {
                let r = sub(point, centre);
                let outside = r[0].hypot(r[1]) - radius;
                if convex { -outside } else { outside }
            }
            _ => -cross(tangent, apart),
        };
        (beyond > 0.0).then_some((dot(apart, apart), BeyondEnd { at_start, beyond, depth }))
    });
    ends.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place)| place)
}

/// Prolongs both ends of an open surface, each by so much for its segment [L]: straight, then by a
/// quarter of a circle of that radius that turns away.
pub fn prolong(segments: &mut Vec<RigidSegment>, by: impl Fn(&RigidSegment) -> f64) {
    let (Some(&first), Some(&last)) = (segments.first(), segments.last()) else { return };
    // the outside is on the left of travel, the centre on the right
    let beyond = |from: Point, [x, y]: Point, by: f64, ahead: bool| {
        let way = if ahead { by } else { -by };
        let on = [from[0] + way * x, from[1] + way * y];
        let centre = [on[0] + by * y, on[1] - by * x];
        let end = [centre[0] + way * x, centre[1] + way * y];
        let [a, b] = if ahead { [from, on] } else { [on, from] };
        let [start, stop] = if ahead { [on, end] } else { [end, on] };
        (RigidSegment::Line { a, b }, RigidSegment::arc(start, stop, centre))
    };
    let (line, arc) = beyond(last.end(), last.tangent(false), by(&last), true);
    segments.push(line);
    segments.extend(arc);
    let (line, arc) = beyond(first.start(), first.tangent(true), by(&first), false);
    segments.insert(0, line);
    if let Some(arc) = arc {
        segments.insert(0, arc);
    }
}

/// Whether the surface ends where it starts.
pub fn is_closed(segments: &[RigidSegment]) -> bool {
    match (segments.first(), segments.last()) {
        (Some(first), Some(last)) => {
            let gap = sub(first.start(), last.end());
            let size: f64 = segments.iter().map(RigidSegment::length).sum();
            gap[0].hypot(gap[1]) <= 1e-9 * size
        }
        _ => false,
    }
}

/// The vertex between two segments, if the point lies in its wedge.
fn vertex(
    segment: &RigidSegment,
    next: &RigidSegment,
    index: usize,
    point: Point,
) -> Option<(Facing, f64)> {
    let apart = sub(point, segment.end());
    let (before, after) = (segment.tangent(false), next.tangent(true));
    let in_wedge = dot(apart, before) > 0.0 && dot(apart, after) < 0.0;
    let distance = apart[0].hypot(apart[1]);
    // The side of the point itself, not the turn: it is also right where the turn is rounding.
    let convex = cross([before[0] + after[0], before[1] + after[1]], apart) > 0.0;
    (in_wedge && distance.is_finite()).then_some((
        Facing { segment: index, part: Part::Vertex { convex }, parameter: 1.0 },
        distance,
    ))
}

/// Nearer by more than rounding.
fn better(distance: f64, best: Option<&(Facing, f64)>) -> bool {
    let Some((_, least)) = best else { return distance.is_finite() };
    (distance - least).abs() > TIE * (distance + least) && distance < *least
}

#[cfg(test)]
mod tests;
