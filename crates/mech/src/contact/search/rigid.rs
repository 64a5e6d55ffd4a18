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

use super::{INSIDE, Point, TIE, cross, dot, project_line, project_quadratic, sub};

/// One segment of a rigid surface, positions in the frame of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RigidSegment {
    /// Straight line.
    Line {
        /// Start [L].
        a: Point,
        /// End [L].
        b: Point,
    },
    /// Circular arc of less than 180 degrees, the shorter one from start to end.
    Arc {
        /// Start [L].
        start: Point,
        /// End [L].
        end: Point,
        /// Centre [L].
        centre: Point,
        /// Radius [L].
        radius: f64,
        /// Whether the normal points away from the centre: travel is clockwise.
        convex: bool,
        /// Angle from start to end, positive [rad].
        sweep: f64,
    },
    /// Parabola through the point `mid` halfway (quadratic Bezier with `mid` at parameter 1/2).
    Parabola {
        /// Start [L].
        start: Point,
        /// Point at parameter 1/2 [L].
        mid: Point,
        /// End [L].
        end: Point,
    },
}

impl RigidSegment {
    /// The shorter arc from start to end about the centre. `None` if the radii to both differ by more
    /// than 1e-4 relative, or the arc is zero or 180 degrees. [semantics: segments]
    pub fn arc(start: Point, end: Point, centre: Point) -> Option<Self> {
        let (p, q) = (sub(start, centre), sub(end, centre));
        let (rp, rq) = (p[0].hypot(p[1]), q[0].hypot(q[1]));
        let radius = 0.5 * (rp + rq);
        let turn = cross(p, q);
        let valid = (rp - rq).abs() <= 1e-4 * radius && turn.abs() > 1e-9 * radius * radius;
        let sweep = turn.abs().atan2(dot(p, q));
        valid.then_some(Self::Arc { start, end, centre, radius, convex: turn < 0.0, sweep })
    }

    /// Start of the segment [L].
    pub fn start(&self) -> Point {
        match *self {
            Self::Line { a, .. } => a,
            Self::Arc { start, .. } | Self::Parabola { start, .. } => start,
        }
    }

    /// End of the segment [L].
    pub fn end(&self) -> Point {
        match *self {
            Self::Line { b, .. } => b,
            Self::Arc { end, .. } | Self::Parabola { end, .. } => end,
        }
    }

    /// Control points of the quadratic Bezier form of a parabola: start, 2 mid - (start + end)/2, end.
    pub fn parabola_control(start: Point, mid: Point, end: Point) -> [Point; 3] {
        let middle = |c: usize| 2.0 * mid[c] - 0.5 * (start[c] + end[c]);
        [start, [middle(0), middle(1)], end]
    }

    /// Parameter of the place on an arc that faces `point`; `None` for other segments.
    fn arc_parameter(&self, point: Point) -> Option<f64> {
        let Self::Arc { start, centre, convex, sweep, .. } = *self else { return None };
        let (p, d) = (sub(start, centre), sub(point, centre));
        let sign = if convex { -1.0 } else { 1.0 };
        Some((sign * cross(p, d)).atan2(dot(p, d)) / sweep)
    }

    /// Whether a point at the radius of an arc lies on it.
    pub fn holds(&self, point: Point) -> bool {
        self.arc_parameter(point).is_some_and(|at| (-INSIDE..=1.0 + INSIDE).contains(&at))
    }

    /// Length of the segment [L].
    pub fn length(&self) -> f64 {
        self.arc_length(1.0)
    }

    /// Length from the start to a parameter in [0, 1] [L].
    pub fn arc_length(&self, parameter: f64) -> f64 {
        match *self {
            Self::Line { a, b } => parameter * dot(sub(b, a), sub(b, a)).sqrt(),
            Self::Arc { radius, .. } => parameter * radius * self.sweep(),
            Self::Parabola { start, mid, end } => {
                parabola_length(&Self::parabola_control(start, mid, end), parameter)
            }
        }
    }

    /// Angle of an arc, positive [rad]; 0 for others.
    pub fn sweep(&self) -> f64 {
        match *self {
            Self::Arc { sweep, .. } => sweep,
            _ => 0.0,
        }
    }

    /// Unit tangent at the start (`true`) or the end, in the direction of travel.
    pub fn tangent(&self, at_start: bool) -> Point {
        let unit = |v: Point| {
            let size = v[0].hypot(v[1]);
            if size > 0.0 { [v[0] / size, v[1] / size] } else { [0.0, 0.0] }
        };
        match *self {
            Self::Line { a, b } => unit(sub(b, a)),
            Self::Arc { start, end, centre, convex, .. } => {
                let e = unit(sub(if at_start { start } else { end }, centre));
                if convex { [e[1], -e[0]] } else { [-e[1], e[0]] }
            }
            Self::Parabola { start, mid, end } => {
                let control = Self::parabola_control(start, mid, end);
                let (from, to) = if at_start { (0, 1) } else { (1, 2) };
                unit(sub(control[to], control[from]))
            }
        }
    }

    /// Parameter and distance |g| of the projection, if the point faces the segment. The parameter
    /// of an arc costs an arc tangent and is left for [`RigidSegment::arc_parameter`].
    fn project(&self, point: Point) -> Option<(f64, f64)> {
        let inside = |parameter: f64| (-INSIDE..=1.0 + INSIDE).contains(&parameter);
        match *self {
            Self::Line { a, b } => {
                let parameter = project_line(a, b, point).filter(|&xi| inside(xi))?;
                let along = sub(b, a);
                Some((parameter, cross(along, sub(point, a)).abs() / along[0].hypot(along[1])))
            }
            Self::Arc { start, end, centre, radius, convex, sweep } => {
                // A sector of less than 180 degrees is what lies ahead of its start and short of
                // its end.
                let (p, q, d) = (sub(start, centre), sub(end, centre), sub(point, centre));
                let sign = if convex { -1.0 } else { 1.0 };
                let (ahead, short) = (sign * cross(p, d), sign * cross(d, q));
                let slack = -INSIDE * sweep * radius;
                if ahead.min(short) < slack * (d[0].abs() + d[1].abs()) {
                    return None;
                }
                let distance = d[0].hypot(d[1]);
                let faces = distance > 0.0 && ahead.min(short) >= slack * distance;
                faces.then_some((0.0, (distance - radius).abs()))
            }
            Self::Parabola { start, mid, end } => {
                let control = Self::parabola_control(start, mid, end);
                let s = project_quadratic(&control, point)?;
                let weights = [(1.0 - s) * (1.0 - s), 2.0 * s * (1.0 - s), s * s];
                let mut apart = point;
                for (weight, p) in weights.iter().zip(control) {
                    apart = [apart[0] - weight * p[0], apart[1] - weight * p[1]];
                }
                Some((s, apart[0].hypot(apart[1])))
            }
        }
    }
}

/// Length of a quadratic Bezier curve up to `parameter`: Gauss rule of five points on sixteen parts.
fn parabola_length(control: &[Point; 3], parameter: f64) -> f64 {
    const NODES: [(f64, f64); 5] = [
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_1),
        (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    ];
    let (p, q) = (sub(control[1], control[0]), sub(control[2], control[1]));
    let half = parameter / 32.0;
    let mut sum = 0.0;
    for part in 0..16 {
        let middle = half * f64::from(2 * part + 1);
        for (x, weight) in NODES {
            let s = middle + half * x;
            let d = [p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])];
            sum += weight * half * 2.0 * d[0].hypot(d[1]);
        }
    }
    sum
}

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

/// The part nearest by |g| that faces `point` (frame of the body); on a tie the `committed` one.
/// All segments are looked at. `None` if the point faces nothing. [semantics: search]
pub fn closest(
    segments: &[RigidSegment],
    point: Point,
    committed: Option<Facing>,
) -> Option<Facing> {
    closest_on(segments, is_closed(segments), point, committed)
}

/// The same where it is known whether the surface is `closed`.
pub fn closest_on(
    segments: &[RigidSegment],
    closed: bool,
    point: Point,
    committed: Option<Facing>,
) -> Option<Facing> {
    let (mut facing, _) = nearest_on(segments, closed, point, committed)?;
    if facing.part == Part::Interior
        && let Some(parameter) = segments[facing.segment].arc_parameter(point)
    {
        facing.parameter = parameter;
    }
    Some(facing)
}

/// The same with the distance |g| [L], and without the parameter of an arc.
pub fn nearest_on(
    segments: &[RigidSegment],
    closed: bool,
    point: Point,
    committed: Option<Facing>,
) -> Option<(Facing, f64)> {
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
        let mut consider = |(facing, distance): (Facing, f64)| {
            if better(&facing, distance, best.as_ref(), committed.as_ref()) {
                best = Some((facing, distance));
            }
        };
        if let Some(interior) = interior {
            consider(interior);
        }
        let apart = sub(point, segment.end());
        let nearer = |least: f64| dot(apart, apart) <= least * least * (1.0 + 4.0 * TIE);
        let reached = best.as_ref().is_none_or(|&(_, least)| nearer(least));
        if let Some(next) = next.filter(|_| reached)
            && let Some((facing, distance)) = vertex(segment, next, index, point)
            && better(&facing, distance, best.as_ref(), committed.as_ref())
        {
            best = Some((facing, distance));
        }
    }
    best
}

/// Whether a surface with these directions before and behind a corner turns outward there, by more
/// than rounding.
pub fn beyond_corner([before, after]: [Point; 2]) -> bool {
    cross(before, after) < -INSIDE
}

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

fn better(
    facing: &Facing,
    distance: f64,
    best: Option<&(Facing, f64)>,
    committed: Option<&Facing>,
) -> bool {
    let Some((_, least)) = best else { return distance.is_finite() };
    let is_committed =
        committed.is_some_and(|kept| kept.segment == facing.segment && kept.part == facing.part);
    if (distance - least).abs() <= TIE * (distance + least) {
        is_committed
    } else {
        distance < *least
    }
}

#[cfg(test)]
mod tests;
