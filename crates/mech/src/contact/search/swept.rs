//! Which place of an analytical surface in space faces a point, and what a way crosses.
//!
//! ```text
//!      z |    x   the point and the profile in one plane with the axis: the search of
//!        |  /     rigid surfaces of the plane
//!        +-'---- r
//! ```
//!
//! [docs/theory.md, section 5.9]

use super::rigid::{Part, RigidSegment, closest_on, is_closed};
use super::sweep::{Crossing, cross_rigid};
use super::{Point, dot};
use crate::surface::swept::{Swept, along};
use crate::vector::Vector;

/// Parts of a way that are taken as straight in the plane of the profile.
const PIECES: usize = 16;
/// Newton iterations of a projection.
const ITERATIONS: usize = 40;

/// The chart of a swept surface on the markers that faces a point, and where on it.
///
/// In the wedge of a corner that turns away a point faces nothing, as it touches nothing; in that
/// of one that turns towards it, the segment before is prolonged.
pub fn closest(swept: &Swept, markers: &[Vector], point: Vector) -> Option<(usize, [f64; 2])> {
    let local = swept.local(markers, point);
    let at = swept.in_profile(local);
    let facing = closest_on(&swept.segments, is_closed(&swept.segments), at)?;
    if facing.part == (Part::Vertex { convex: true }) {
        return None;
    }
    let segment = &swept.segments[facing.segment];
    let parameter = project(segment, facing.parameter, at);
    Some(swept.place(facing.segment, parameter, local))
}

/// The parameter at which the way to a point stands across the segment, from a place near it.
fn project(segment: &RigidSegment, mut parameter: f64, point: Point) -> f64 {
    for _ in 0..ITERATIONS {
        let [x, y] = along(segment, parameter);
        let (way, first) = ([point[0] - x[0], point[1] - y[0]], [x[1], y[1]]);
        let whole = dot(first, first);
        let bent = whole - dot(way, [x[2], y[2]]);
        // past the centre of curvature the tangent alone tells the step
        let step = dot(way, first) / if bent > 0.0 { bent } else { whole };
        parameter += step;
        if step.abs() <= 4.0 * f64::EPSILON {
            break;
        }
    }
    parameter
}

/// Crossings of a point on its way with a swept surface whose markers go from `before` to `after`.
pub fn cross(
    swept: &Swept,
    (before, after): (&[Vector], &[Vector]),
    (from, to): (Vector, Vector),
    mut each: impl FnMut(Crossing),
) {
    let between = |a: Vector, b: Vector, t: f64| std::array::from_fn(|k| a[k] + t * (b[k] - a[k]));
    let local = |t: f64| {
        let markers: [Vector; 4] = std::array::from_fn(|k| between(before[k], after[k], t));
        swept.local(&markers, between(from, to, t))
    };
    let mut last = local(0.0);
    for piece in 0..PIECES {
        let share = |t: f64| (piece as f64 + t) / PIECES as f64;
        let next = local(share(1.0));
        let way = (swept.in_profile(last), swept.in_profile(next));
        cross_rigid(&swept.segments, way, |crossing| {
            let normal = [crossing.normal[0], crossing.normal[1]];
            let out = swept.out_of_profile(normal, between(last, next, crossing.fraction));
            let normal = swept.direction(before, out);
            each(Crossing { fraction: share(crossing.fraction), normal, ..crossing });
        });
        last = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::swept::Sweep;

    const MARKERS: [Vector; 4] =
        [[1.0, 2.0, 3.0], [2.0, 2.0, 3.0], [1.0, 3.0, 3.0], [1.0, 2.0, 4.0]];

    fn ball() -> Swept {
        let arc = RigidSegment::arc([2.0, 0.0], [0.0, -2.0], [0.0, 0.0]).expect("an arc");
        Swept { segments: vec![arc], sweep: Sweep::Around, length: 1.0 }
    }

    /// Requirement: a way through a ball is seen where it goes in, with the normal there.
    #[test]
    fn a_way_into_a_ball_is_seen() {
        let (from, to) = ([1.3, 2.4, -1.0], [1.3, 2.4, 3.0]);
        let mut found = Vec::new();
        cross(&ball(), (&MARKERS, &MARKERS), (from, to), |crossing| found.push(crossing));
        assert_eq!(found.len(), 1);
        let depth = (4.0f64 - 0.25).sqrt();
        assert!((found[0].fraction - (4.0 - depth) / 4.0).abs() < 1e-6 && found[0].inward);
        let expected = [0.15, 0.2, -0.5 * depth];
        for (own, expected) in found[0].normal.iter().zip(expected) {
            assert!((own - expected).abs() < 1e-3, "{:?}", found[0].normal);
        }
    }

    /// Requirement: the place that faces a point is on the way to the centre, at the pole too.
    #[test]
    fn a_ball_faces_points_along_its_radii() {
        let swept = ball();
        for way in [[0.0, 0.0, -1.0], [0.1, 0.0, -0.9], [0.6, -0.7, -0.2]] {
            let point = std::array::from_fn(|k| MARKERS[0][k] + 2.5 * way[k]);
            let (chart, at) = closest(&swept, &MARKERS, point).expect("it faces the ball");
            let found = swept.chart(chart).coordinates(at).map(|jet| jet.value);
            let size = way.iter().map(|x: &f64| x * x).sum::<f64>().sqrt();
            for k in 0..3 {
                assert!((found[k] - 2.0 * way[k] / size).abs() < 1e-12, "{found:?}");
            }
        }
    }
}
