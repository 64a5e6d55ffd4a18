//! Line, arc and parabola as curves of one parameter in [0, 1].

use slideline_model::{ProfilePoint, SurfaceSegment};

/// Point or direction in the plane [L] or [1].
pub(super) type Point = ProfilePoint;

pub(super) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

pub(super) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A segment with its start.
#[derive(Clone, Copy, Debug)]
pub(super) enum Curve {
    Line([Point; 2]),
    /// From `first` by `sweep` [rad], positive to the left, about `centre`.
    Arc {
        ends: [Point; 2],
        centre: Point,
        radius: f64,
        first: f64,
        sweep: f64,
    },
    /// Control points of a quadratic Bezier curve.
    Parabola([Point; 3]),
}

/// A curve at one parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub point: Point,
    /// Unit tangent [1].
    pub tangent: Point,
    /// Length a unit of the parameter [L].
    pub speed: f64,
    /// Curvature, positive to the left [1/L].
    pub bend: f64,
}

impl Place {
    /// The point at a distance to the left.
    pub fn beside(&self, distance: f64) -> Point {
        let [x, y] = self.tangent;
        [self.point[0] - distance * y, self.point[1] + distance * x]
    }
}

impl Curve {
    pub fn new(start: Point, segment: &SurfaceSegment) -> Self {
        match *segment {
            SurfaceSegment::Line { end } => Self::Line([start, end]),
            SurfaceSegment::Circle { end, centre } => {
                let (p, q) = (minus(start, centre), minus(end, centre));
                let radius = 0.5 * (p[0].hypot(p[1]) + q[0].hypot(q[1]));
                let (first, sweep) = (p[1].atan2(p[0]), cross(p, q).atan2(dot(p, q)));
                Self::Arc { ends: [start, end], centre, radius, first, sweep }
            }
            SurfaceSegment::Parabola { middle, end } => {
                let control = [0, 1].map(|c| 2.0 * middle[c] - 0.5 * (start[c] + end[c]));
                Self::Parabola([start, control, end])
            }
        }
    }

    pub fn start(&self) -> Point {
        match *self {
            Self::Line([start, _])
            | Self::Arc { ends: [start, _], .. }
            | Self::Parabola([start, ..]) => start,
        }
    }

    pub fn end(&self) -> Point {
        match *self {
            Self::Line([_, end]) | Self::Arc { ends: [_, end], .. } | Self::Parabola([.., end]) => {
                end
            }
        }
    }

    /// The curve with another origin and unit of length.
    pub fn seen_from(&self, origin: Point, unit: f64) -> Self {
        let seen = |p: Point| minus(p, origin).map(|x| x / unit);
        match *self {
            Self::Line(points) => Self::Line(points.map(seen)),
            Self::Arc { ends, centre, radius, first, sweep } => {
                let (ends, centre) = (ends.map(seen), seen(centre));
                Self::Arc { ends, centre, radius: radius / unit, first, sweep }
            }
            Self::Parabola(points) => Self::Parabola(points.map(seen)),
        }
    }

    pub fn at(&self, parameter: f64) -> Place {
        match *self {
            Self::Line([a, b]) => {
                let along = minus(b, a);
                let speed = along[0].hypot(along[1]);
                let point = [a[0] + parameter * along[0], a[1] + parameter * along[1]];
                Place { point, tangent: along.map(|x| x / speed), speed, bend: 0.0 }
            }
            Self::Arc { centre, radius, first, sweep, .. } => {
                let (sin, cos) = (first + parameter * sweep).sin_cos();
                let side = sweep.signum();
                Place {
                    point: [centre[0] + radius * cos, centre[1] + radius * sin],
                    tangent: [-side * sin, side * cos],
                    speed: radius * sweep.abs(),
                    bend: side / radius,
                }
            }
            Self::Parabola([a, b, c]) => {
                let other = 1.0 - parameter;
                let mix = |k: usize| {
                    other * other * a[k]
                        + 2.0 * other * parameter * b[k]
                        + parameter * parameter * c[k]
                };
                let slope =
                    [0, 1].map(|k| 2.0 * (other * (b[k] - a[k]) + parameter * (c[k] - b[k])));
                let second = [0, 1].map(|k| 2.0 * (a[k] - 2.0 * b[k] + c[k]));
                let speed = slope[0].hypot(slope[1]);
                Place {
                    point: [mix(0), mix(1)],
                    tangent: slope.map(|x| x / speed),
                    speed,
                    bend: cross(slope, second) / speed.powi(3),
                }
            }
        }
    }

    /// The part between two parameters, which ends at `end`.
    pub fn piece(&self, from: f64, until: f64, end: Point) -> SurfaceSegment {
        match *self {
            Self::Line(_) => SurfaceSegment::Line { end },
            Self::Arc { centre, .. } => SurfaceSegment::Circle { end, centre },
            // A part of a parabola is one, with its own parameter 1/2 halfway.
            Self::Parabola(_) => {
                let middle = self.at(0.5 * (from + until)).point;
                SurfaceSegment::Parabola { middle, end }
            }
        }
    }
}
