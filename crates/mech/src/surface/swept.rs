//! Analytical surfaces in space: a profile drawn along a straight line, or turned about an axis.
//!
//! ```text
//!      M_3                   X = M_0 + sum_k y_k/L (M_k - M_0), k = 1 to 3
//!       |   _____            M: four markers of the body, at right angles, L from the first
//!       |  /     /  profile  y: drawn along    (x(s), y(s), t)
//!   M_0 o--/-----/ M_2          turned about   (r(s) cos a, r(s) sin a, z(s))
//!      /
//!     M_1
//! ```
//!
//! A place is linear in the markers, as that of a face is in its nodes: gap, slip and all their
//! derivatives are those of faces. The coordinates of its charts run so that the normal is on the
//! left of the profile's travel. [docs/theory.md, section 5.9]

use super::jet::Jet;
use crate::contact::search::rigid::RigidSegment;
use crate::vector::{Vector, dot, scale, sub};

/// How a profile sweeps a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sweep {
    /// Along the third axis; the profile lies across it.
    Along,
    /// About the third axis; the profile has its distance from the axis and its place along it.
    Around,
}

/// Part of a pole's radius up to which its cap has coordinates across the axis [1].
const CAP: f64 = 0.7;
/// What counts as on the axis, over the size of a segment [1].
pub(super) const ON_AXIS: f64 = 1e-9;

/// A swept profile.
#[derive(Debug, Clone, PartialEq)]
pub struct Swept {
    /// The profile, in the frame of the markers [L].
    pub segments: Vec<RigidSegment>,
    /// How it sweeps the surface.
    pub sweep: Sweep,
    /// Distance of the markers [L].
    pub length: f64,
}

/// Coordinates on a part of a swept surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chart {
    segment: RigidSegment,
    sweep: Sweep,
    /// About a pole: the coordinates are those across the axis.
    cap: Option<Cap>,
    /// Distance of the markers [L].
    length: f64,
}

/// A segment that meets the axis at right angles.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cap {
    /// Whether the profile travels away from the axis: the normal is then along the axis.
    outward: bool,
    /// z = centre + side sqrt(R^2 - rho^2) of an arc; of a line R = 0 and z = centre [L].
    centre: f64,
    side: f64,
    radius: f64,
}

impl Swept {
    /// Number of charts: two a segment, the second one about its pole.
    pub fn charts(&self) -> usize {
        2 * self.segments.len()
    }

    /// A chart.
    pub fn chart(&self, number: usize) -> Chart {
        let segment = self.segments[number / 2];
        let cap = if number % 2 == 1 { self.cap(number / 2) } else { None };
        Chart { segment, sweep: self.sweep, cap, length: self.length }
    }

    /// Coordinates of a point in the frame of the markers [L].
    pub fn local(&self, markers: &[Vector], point: Vector) -> Vector {
        let way = sub(point, markers[0]);
        std::array::from_fn(|k| dot(way, sub(markers[k + 1], markers[0])) / self.length)
    }

    /// A direction of the frame of the markers in space.
    pub fn direction(&self, markers: &[Vector], local: Vector) -> Vector {
        let axis = |k: usize| scale(sub(markers[k + 1], markers[0]), local[k] / self.length);
        let [a, b, c] = [0, 1, 2].map(axis);
        std::array::from_fn(|k| a[k] + b[k] + c[k])
    }

    /// The profile's plane at a point of the frame: its coordinates there [L].
    pub fn in_profile(&self, local: Vector) -> [f64; 2] {
        match self.sweep {
            Sweep::Along => [local[0], local[1]],
            Sweep::Around => [local[0].hypot(local[1]), local[2]],
        }
    }

    /// A direction of the profile's plane at a point of the frame.
    pub fn out_of_profile(&self, [a, b]: [f64; 2], local: Vector) -> Vector {
        match self.sweep {
            Sweep::Along => [a, b, 0.0],
            Sweep::Around => {
                let radius = local[0].hypot(local[1]);
                match radius > 0.0 {
                    true => [a * local[0] / radius, a * local[1] / radius, b],
                    false => [a, 0.0, b],
                }
            }
        }
    }

    /// The chart and the coordinates on it of the place at a parameter of a segment that faces a
    /// point of the frame.
    pub fn place(&self, segment: usize, parameter: f64, local: Vector) -> (usize, [f64; 2]) {
        if self.sweep == Sweep::Along {
            return (2 * segment, [parameter, local[2] / self.length]);
        }
        let [radius, z] = self.segments[segment].place(parameter);
        let covers = |cap: &Cap| {
            cap.radius == 0.0 || (radius <= CAP * cap.radius && cap.side * (z - cap.centre) > 0.0)
        };
        let Some(cap) = self.cap(segment).filter(covers) else {
            return (2 * segment, [parameter, local[1].atan2(local[0])]);
        };
        let beside = local[0].hypot(local[1]);
        let share = if beside > 0.0 { radius / (beside * self.length) } else { 0.0 };
        let [x, y] = [share * local[0], share * local[1]];
        (2 * segment + 1, if cap.outward { [x, y] } else { [y, x] })
    }

    /// The larger side of a box about the ends of a segment [L].
    pub(super) fn size(&self, segment: usize) -> f64 {
        let (start, end) = (self.segments[segment].start(), self.segments[segment].end());
        (end[0] - start[0]).abs().max((end[1] - start[1]).abs())
    }

    /// The cap of a segment that meets the axis at right angles.
    fn cap(&self, segment: usize) -> Option<Cap> {
        let own = self.segments[segment];
        let (start, end) = (own.start(), own.end());
        let size = self.size(segment);
        let touches = start[0].abs().min(end[0].abs()) <= ON_AXIS * size;
        if self.sweep == Sweep::Along || !touches {
            return None;
        }
        let outward = start[0].abs() < end[0].abs();
        match own {
            RigidSegment::Line { a, b } if (b[1] - a[1]).abs() <= ON_AXIS * size => {
                Some(Cap { outward, centre: a[1], side: 1.0, radius: 0.0 })
            }
            RigidSegment::Arc { centre, radius, .. } if centre[0].abs() <= ON_AXIS * size => {
                let pole = if outward { start } else { end };
                let side = if pole[1] > centre[1] { 1.0 } else { -1.0 };
                Some(Cap { outward, centre: centre[1], side, radius })
            }
            _ => None,
        }
    }
}

impl Chart {
    /// Coordinates in the frame of the markers over their distance, as functions of the chart's [1].
    pub fn coordinates(&self, at: [f64; 2]) -> [Jet; 3] {
        let [first, second] = [0, 1].map(|axis| Jet::coordinate(at[axis], axis));
        if let Some(cap) = &self.cap {
            return self.about_pole(cap, [first, second]);
        }
        let [x, y] =
            along(&self.segment, at[0]).map(|own| first.through(own.map(|v| v / self.length)));
        match self.sweep {
            Sweep::Along => [x, y, second],
            Sweep::Around => {
                let (sine, cosine) = at[1].sin_cos();
                let cosines = second.through([cosine, -sine, -cosine]);
                [x.by(cosines), x.by(second.through([sine, cosine, -sine])), y]
            }
        }
    }

    fn about_pole(&self, cap: &Cap, [first, second]: [Jet; 2]) -> [Jet; 3] {
        let [x, y] = if cap.outward { [first, second] } else { [second, first] };
        let centre = Jet::constant(cap.centre / self.length);
        if cap.radius == 0.0 {
            return [x, y, centre];
        }
        let square = x.by(x).plus(y.by(y));
        let radius = cap.radius / self.length;
        let height = (radius * radius - square.value).max(f64::MIN_POSITIVE).sqrt();
        let root = [height, -0.5 / height, -0.25 / (height * height * height)];
        [x, y, centre.plus(square.through(root).times(cap.side))]
    }
}

/// Both coordinates of a segment with their first and second derivatives by its parameter [L].
pub fn along(segment: &RigidSegment, parameter: f64) -> [[f64; 3]; 2] {
    let (s, rest) = (parameter, 1.0 - parameter);
    let at = segment.place(s);
    match *segment {
        RigidSegment::Line { a, b } => [0, 1].map(|c| [at[c], b[c] - a[c], 0.0]),
        RigidSegment::Arc { centre, convex, sweep, .. } => {
            let turn = if convex { -sweep } else { sweep };
            let r = [at[0] - centre[0], at[1] - centre[1]];
            let first = [-turn * r[1], turn * r[0]];
            [0, 1].map(|c| [at[c], first[c], -turn * turn * r[c]])
        }
        RigidSegment::Parabola { start, mid, end } => {
            let p = RigidSegment::parabola_control(start, mid, end);
            let first = |c: usize| 2.0 * (rest * (p[1][c] - p[0][c]) + s * (p[2][c] - p[1][c]));
            [0, 1].map(|c| [at[c], first(c), 2.0 * (p[0][c] - 2.0 * p[1][c] + p[2][c])])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(start: [f64; 2], end: [f64; 2], centre: [f64; 2]) -> RigidSegment {
        RigidSegment::arc(start, end, centre).expect("an arc")
    }

    /// Requirement: derivatives of the coordinates are those of differences, in all charts.
    #[test]
    fn charts_have_the_derivatives_of_differences() {
        let ball = arc([2.0, 1.0], [0.0, -1.0], [0.0, 1.0]);
        let mid = RigidSegment::Parabola { start: [1.0, 0.0], mid: [1.7, 0.6], end: [2.0, 1.5] };
        let disc = RigidSegment::Line { a: [0.0, 0.4], b: [1.5, 0.4] };
        for sweep in [Sweep::Along, Sweep::Around] {
            let swept = Swept { segments: vec![ball, mid, disc], sweep, length: 0.7 };
            for number in 0..swept.charts() {
                let chart = swept.chart(number);
                let at = [0.31, 0.47];
                let own = chart.coordinates(at);
                let step = 1e-5;
                for axis in 0..2 {
                    let moved = |sign: f64| {
                        let mut at = at;
                        at[axis] += sign * step;
                        chart.coordinates(at)
                    };
                    let (plus, minus) = (moved(1.0), moved(-1.0));
                    for k in 0..3 {
                        let slope = (plus[k].value - minus[k].value) / (2.0 * step);
                        assert!((slope - own[k].first[axis]).abs() < 1e-8, "{number} {axis} {k}");
                        for (second, other) in [(axis, axis), (2, 1 - axis)] {
                            let slope =
                                (plus[k].first[other] - minus[k].first[other]) / (2.0 * step);
                            let found = own[k].second[second];
                            assert!((slope - found).abs() < 1e-7, "{number} {axis} {k} {second}");
                        }
                    }
                }
            }
        }
    }

    /// Requirement: a pole has a chart whose place is the one of the profile.
    #[test]
    fn a_pole_is_a_place_like_others() {
        let ball = arc([2.0, 1.0], [0.0, -1.0], [0.0, 1.0]);
        let swept = Swept { segments: vec![ball], sweep: Sweep::Around, length: 0.7 };
        for local in [[0.0, 0.0, -3.0], [0.3, -0.2, -1.5], [1.6, 0.9, -0.1]] {
            let parameter = {
                let p = swept.in_profile(local);
                let turn = p[0].atan2(1.0 - p[1]);
                1.0 - turn / std::f64::consts::FRAC_PI_2
            };
            let (number, at) = swept.place(0, parameter, local);
            let found = swept.chart(number).coordinates(at).map(|jet| 0.7 * jet.value);
            let way = [local[0], local[1], local[2] - 1.0];
            let size = dot(way, way).sqrt();
            let expected = [2.0 * way[0] / size, 2.0 * way[1] / size, 1.0 + 2.0 * way[2] / size];
            for k in 0..3 {
                assert!((found[k] - expected[k]).abs() < 1e-12, "{found:?} {expected:?}");
            }
        }
    }
}
