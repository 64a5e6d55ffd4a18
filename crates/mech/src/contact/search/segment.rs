//! One segment of a rigid surface, in the frame of its body.
//!
//! ```text
//!   a ------- b      .--.  arc: the shorter one      start  mid  end: a parabola
//!               start    end                              '-.___.-'
//! ```

use super::{INSIDE, Point, cross, dot, project_line, project_quadratic, sub};

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
    pub(super) fn arc_parameter(&self, point: Point) -> Option<f64> {
        let Self::Arc { start, centre, convex, sweep, .. } = *self else { return None };
        let (p, d) = (sub(start, centre), sub(point, centre));
        let sign = if convex { -1.0 } else { 1.0 };
        Some((sign * cross(p, d)).atan2(dot(p, d)) / sweep)
    }

    /// Whether a point at the radius of an arc lies on it.
    pub fn holds(&self, point: Point) -> bool {
        self.arc_parameter(point).is_some_and(|at| (-INSIDE..=1.0 + INSIDE).contains(&at))
    }

    /// Position at a parameter of a line or parabola, of an arc on the way along it [L].
    pub fn place(&self, parameter: f64) -> Point {
        let (rest, s) = (1.0 - parameter, parameter);
        match *self {
            Self::Line { a, b } => [0, 1].map(|c| rest * a[c] + s * b[c]),
            Self::Arc { start, centre, convex, sweep, .. } => {
                let turn = if convex { -s * sweep } else { s * sweep };
                let (r, (sin, cos)) = (sub(start, centre), turn.sin_cos());
                [centre[0] + cos * r[0] - sin * r[1], centre[1] + sin * r[0] + cos * r[1]]
            }
            Self::Parabola { start, mid, end } => {
                let p = Self::parabola_control(start, mid, end);
                [0, 1].map(|c| rest * rest * p[0][c] + 2.0 * s * rest * p[1][c] + s * s * p[2][c])
            }
        }
    }

    /// Outward normal at a parameter [1].
    pub fn normal(&self, parameter: f64) -> Point {
        let unit = |t: Point| {
            let size = t[0].hypot(t[1]);
            [-t[1] / size, t[0] / size]
        };
        match *self {
            Self::Line { a, b } => unit(sub(b, a)),
            Self::Arc { centre, radius, convex, .. } => {
                let outward = if convex { 1.0 } else { -1.0 };
                sub(self.place(parameter), centre).map(|x| outward * x / radius)
            }
            Self::Parabola { start, mid, end } => {
                let p = Self::parabola_control(start, mid, end);
                let (d0, d1) = (sub(p[1], p[0]), sub(p[2], p[1]));
                unit([0, 1].map(|c| (1.0 - parameter) * d0[c] + parameter * d1[c]))
            }
        }
    }

    /// Angle from the start of an arc to the place that faces a point [rad]; 0 for others.
    pub fn angle_to(&self, point: Point) -> f64 {
        self.arc_parameter(point).unwrap_or(0.0) * self.sweep()
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
    pub(super) fn project(&self, point: Point) -> Option<(f64, f64)> {
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
