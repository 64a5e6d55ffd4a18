//! Which parts of a master does a moving point cross on its way?
//!
//! ```text
//!        p0 o                    rigid: the straight path in the frame of the body
//!            \   front           against lines, arcs and parabolas
//!      -------x------ n          chain: point and segment both on straight paths;
//!              \   behind        where the three stand in one line
//!            p1 o
//! ```
//!
//! A search that looks at the end of an increment alone does not see what lies between its ends.

use super::chain::{flat, raised};
use super::segment::RigidSegment;
use super::{INSIDE, Point, cross, dot, sub};

/// A crossing of a path and a part of a master.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Segment of the master.
    pub segment: usize,
    /// Where on it, 0 at its start, 1 at its end.
    pub parameter: f64,
    /// Where on the path, 0 at its start, 1 at its end.
    pub fraction: f64,
    /// Outward normal of the master there [1].
    pub normal: [f64; 3],
    /// Whether the point goes from the front of the master to behind it.
    pub inward: bool,
}

/// Crossings of the straight path `from` -> `to` with rigid segments, all in the frame of the body.
pub fn cross_rigid(
    segments: &[RigidSegment],
    (from, to): (Point, Point),
    mut each: impl FnMut(Crossing),
) {
    for (index, segment) in segments.iter().enumerate() {
        match *segment {
            RigidSegment::Line { a, b } => cross_line(index, (a, b), (from, to), &mut each),
            RigidSegment::Arc { .. } => cross_arc(index, segment, (from, to), &mut each),
            RigidSegment::Parabola { start, mid, end } => {
                let control = RigidSegment::parabola_control(start, mid, end);
                cross_parabola(index, &control, (from, to), &mut each);
            }
        }
    }
}

/// Crossings of a point on its way `point.0` -> `point.1` with a chain whose nodes go from `before`
/// to `after`, all on straight paths; its corners are taken as they are, without smoothing.
pub fn cross_chain(
    (before, after): (&[[f64; 3]], &[[f64; 3]]),
    point: ([f64; 3], [f64; 3]),
    each: impl FnMut(Crossing),
) {
    cross_parts((before, after), 0..before.len().saturating_sub(1), point, each);
}

/// The same with the segments given, as a tree has found them.
pub fn cross_parts(
    (before, after): (&[[f64; 3]], &[[f64; 3]]),
    parts: impl Iterator<Item = usize>,
    point: ([f64; 3], [f64; 3]),
    mut each: impl FnMut(Crossing),
) {
    let point = (flat(point.0), flat(point.1));
    for index in parts {
        let [start, end] = [before, after].map(|line| [flat(line[index]), flat(line[index + 1])]);
        if apart_in(&[start[0], start[1], end[0], end[1]], &[point.0, point.1]) {
            continue;
        }
        // cross(b - a, p - a) along the way, a quadratic in the fraction
        let (e0, e1) = (sub(start[1], start[0]), sub(end[1], end[0]));
        let (r0, r1) = (sub(point.0, start[0]), sub(point.1, end[0]));
        let (de, dr) = (sub(e1, e0), sub(r1, r0));
        let (c0, c1, c2) = (cross(e0, r0), cross(e0, dr) + cross(de, r0), cross(de, dr));
        for fraction in roots(c0, c1, c2).into_iter().flatten() {
            let at = |a: Point, d: Point| [a[0] + fraction * d[0], a[1] + fraction * d[1]];
            let (along, apart) = (at(e0, de), at(r0, dr));
            let length = along[0].hypot(along[1]);
            let parameter = dot(along, apart) / (length * length);
            if inside(fraction) && inside(parameter) {
                let normal = [-along[1] / length, along[0] / length];
                let inward = c1 + 2.0 * fraction * c2 < 0.0;
                each(Crossing {
                    segment: index,
                    parameter,
                    fraction,
                    normal: raised(normal),
                    inward,
                });
            }
        }
    }
}

/// Whether the boxes about two sets of points have nothing in common.
pub fn apart(one: &[[f64; 3]], other: &[[f64; 3]]) -> bool {
    apart_in(one, other)
}

fn apart_in<const D: usize>(one: &[[f64; D]], other: &[[f64; D]]) -> bool {
    (0..D).any(|axis| {
        let range = |points: &[[f64; D]]| {
            points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| {
                (low.min(p[axis]), high.max(p[axis]))
            })
        };
        let ((low, high), (other_low, other_high)) = (range(one), range(other));
        high < other_low || other_high < low
    })
}

fn inside(parameter: f64) -> bool {
    (-INSIDE..=1.0 + INSIDE).contains(&parameter)
}

/// Real roots of c0 + c1 x + c2 x^2.
pub(super) fn roots(c0: f64, c1: f64, c2: f64) -> [Option<f64>; 2] {
    let square = c1 * c1 - 4.0 * c0 * c2;
    if square.is_nan() || square < 0.0 {
        return [None; 2];
    }
    // without cancellation, also where c2 vanishes
    let q = -0.5 * (c1 + if c1 < 0.0 { -square.sqrt() } else { square.sqrt() });
    let first = (q != 0.0).then(|| c0 / q);
    let second = (c2 != 0.0).then(|| q / c2).filter(|&root| Some(root) != first);
    [first, second].map(|root| root.filter(|root| root.is_finite()))
}

fn cross_line(
    index: usize,
    (a, b): (Point, Point),
    (from, to): (Point, Point),
    each: &mut impl FnMut(Crossing),
) {
    let (along, way, apart) = (sub(b, a), sub(to, from), sub(a, from));
    let area = cross(way, along);
    if area == 0.0 {
        return;
    }
    let (fraction, parameter) = (cross(apart, along) / area, cross(apart, way) / area);
    if inside(fraction) && inside(parameter) {
        let length = along[0].hypot(along[1]);
        let normal = [-along[1] / length, along[0] / length];
        let inward = dot(way, normal) < 0.0;
        each(Crossing { segment: index, parameter, fraction, normal: raised(normal), inward });
    }
}

fn cross_arc(
    index: usize,
    segment: &RigidSegment,
    (from, to): (Point, Point),
    each: &mut impl FnMut(Crossing),
) {
    let RigidSegment::Arc { start, centre, radius, convex, sweep, .. } = *segment else { return };
    let (way, r) = (sub(to, from), sub(from, centre));
    let c0 = (r[0].hypot(r[1]) - radius) * (r[0].hypot(r[1]) + radius);
    for fraction in roots(c0, 2.0 * dot(way, r), dot(way, way)).into_iter().flatten() {
        let at = [r[0] + fraction * way[0], r[1] + fraction * way[1]];
        let p = sub(start, centre);
        let sign = if convex { -1.0 } else { 1.0 };
        let parameter = (sign * cross(p, at)).atan2(dot(p, at)) / sweep;
        if inside(fraction) && inside(parameter) {
            let outward = if convex { 1.0 } else { -1.0 };
            let normal = at.map(|x| outward * x / radius);
            let inward = dot(way, normal) < 0.0;
            each(Crossing { segment: index, parameter, fraction, normal: raised(normal), inward });
        }
    }
}

fn cross_parabola(
    index: usize,
    control: &[Point; 3],
    (from, to): (Point, Point),
    each: &mut impl FnMut(Crossing),
) {
    let way = sub(to, from);
    let square = dot(way, way);
    // B(s) - from across the way, a quadratic in s
    let [c0, c1, c2] = {
        let across = control.map(|p| cross(way, sub(p, from)));
        [across[0], 2.0 * (across[1] - across[0]), across[0] - 2.0 * across[1] + across[2]]
    };
    for s in roots(c0, c1, c2).into_iter().flatten() {
        let rest = 1.0 - s;
        let weights = [rest * rest, 2.0 * s * rest, s * s];
        let at = |c: usize| (0..3).map(|k| weights[k] * control[k][c]).sum::<f64>() - from[c];
        let fraction = dot([at(0), at(1)], way) / square;
        if inside(fraction) && inside(s) {
            let (d0, d1) = (sub(control[1], control[0]), sub(control[2], control[1]));
            let tangent = [rest * d0[0] + s * d1[0], rest * d0[1] + s * d1[1]];
            let length = tangent[0].hypot(tangent[1]);
            let normal = [-tangent[1] / length, tangent[0] / length];
            let inward = dot(way, normal) < 0.0;
            each(Crossing {
                segment: index,
                parameter: s,
                fraction,
                normal: raised(normal),
                inward,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crossings(segments: &[RigidSegment], from: Point, to: Point) -> Vec<Crossing> {
        let mut found = Vec::new();
        cross_rigid(segments, (from, to), |crossing| found.push(crossing));
        found.sort_by(|a, b| a.fraction.total_cmp(&b.fraction));
        found
    }

    /// Requirement: a path through a circle enters at the bottom and leaves at the top, with the
    /// normals of those places.
    #[test]
    fn through_a_circle() {
        let arc = |a, b| RigidSegment::arc(a, b, [0.0, 0.0]).unwrap();
        let circle = [arc([0.0, 1.0], [1.0, 0.0]), arc([1.0, 0.0], [0.0, -1.0])];
        let rest = [arc([0.0, -1.0], [-1.0, 0.0]), arc([-1.0, 0.0], [0.0, 1.0])];
        let found = crossings(&[circle, rest].concat(), [0.3, -3.0], [0.3, 3.0]);
        assert_eq!(found.len(), 2);
        let height = (1.0f64 - 0.09).sqrt();
        for (crossing, (y, inward)) in found.iter().zip([(-height, true), (height, false)]) {
            assert_eq!(crossing.inward, inward);
            assert!((crossing.fraction - (y + 3.0) / 6.0).abs() < 1e-15, "{crossing:?}");
            assert!((crossing.normal[0] - 0.3).abs() + (crossing.normal[1] - y).abs() < 1e-14);
        }
    }

    /// Requirement: a parabola is crossed where the straight line meets it.
    #[test]
    fn through_a_parabola() {
        // y = 1 - x^2, travelled to the right: the normal points up
        let segment =
            RigidSegment::Parabola { start: [-1.0, 0.0], mid: [0.0, 1.0], end: [1.0, 0.0] };
        let found = crossings(&[segment], [0.5, 2.0], [0.5, 0.0]);
        assert_eq!(found.len(), 1);
        assert!(found[0].inward && (found[0].fraction - 0.625).abs() < 1e-15, "{found:?}");
        assert!((found[0].normal[0] / found[0].normal[1] - 1.0).abs() < 1e-14);
    }

    /// Requirement: a chain that moves up past a point is crossed from front to back, wherever both
    /// are taken to; a point that stays in front is not.
    #[test]
    fn a_chain_that_moves() {
        let before = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(raised);
        let after = [[0.0, 1.0], [1.0, 1.0], [2.0, 3.0]].map(raised);
        let mut found = Vec::new();
        let way = ([0.5, 0.25, 0.0], [0.5, 0.75, 0.0]);
        cross_chain((&before, &after), way, |crossing| found.push(crossing));
        assert_eq!(found.len(), 1);
        assert!(found[0].inward && (found[0].fraction - 0.5).abs() < 1e-15);
        found.clear();
        let way = ([0.5, 0.25, 0.0], [0.5, 1.25, 0.0]);
        cross_chain((&before, &after), way, |crossing| found.push(crossing));
        assert!(found.is_empty());
    }
}
