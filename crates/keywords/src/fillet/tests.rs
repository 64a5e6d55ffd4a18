//! Requirement: every corner becomes an arc of the given radius that is tangent to both segments;
//! smooth joints stay; neither orientation nor place, size or units matter; what does not fit is
//! refused, with the largest radius that does. Source: docs/theory.md, fillets. Tolerance: rounding.

#![allow(clippy::unwrap_used)] // a test may fail where it stands

use proptest::prelude::*;

use super::*;

fn line(x: f64, y: f64) -> SurfaceSegment {
    SurfaceSegment::Line { end: [x, y] }
}

/// Largest kink between neighbouring segments [rad].
fn kink(profile: &Profile) -> f64 {
    let curves = curves(profile.0, &profile.1);
    let joint = |a: &Curve, b: &Curve| {
        let (s, t) = (a.at(1.0).tangent, b.at(0.0).tangent);
        cross(s, t).atan2(dot(s, t)).abs()
    };
    let inner = curves.windows(2).map(|pair| joint(&pair[0], &pair[1])).fold(0.0, f64::max);
    if is_closed(profile.0, &profile.1) {
        return inner.max(joint(&curves[curves.len() - 1], &curves[0]));
    }
    inner
}

fn reversed((start, segments): &Profile) -> Profile {
    let mut points = vec![*start];
    points.extend(segments.iter().map(SurfaceSegment::end));
    let back = segments.iter().zip(&points).rev().map(|(segment, &end)| match *segment {
        SurfaceSegment::Line { .. } => SurfaceSegment::Line { end },
        SurfaceSegment::Circle { centre, .. } => SurfaceSegment::Circle { end, centre },
        SurfaceSegment::Parabola { middle, .. } => SurfaceSegment::Parabola { middle, end },
    });
    (points[points.len() - 1], back.collect())
}

/// The profile turned, scaled and moved.
fn moved((start, segments): &Profile, turn: f64, scale: f64, by: Point) -> Profile {
    let (sin, cos) = turn.sin_cos();
    let map =
        |[x, y]: Point| [by[0] + scale * (cos * x - sin * y), by[1] + scale * (sin * x + cos * y)];
    let segment = |segment: &SurfaceSegment| match *segment {
        SurfaceSegment::Line { end } => SurfaceSegment::Line { end: map(end) },
        SurfaceSegment::Circle { end, centre } => {
            SurfaceSegment::Circle { end: map(end), centre: map(centre) }
        }
        SurfaceSegment::Parabola { middle, end } => {
            SurfaceSegment::Parabola { middle: map(middle), end: map(end) }
        }
    };
    (map(*start), segments.iter().map(segment).collect())
}

fn near(a: &Profile, b: &Profile, tolerance: f64) -> bool {
    let points = |p: &Profile| -> Vec<Point> {
        std::iter::once(p.0).chain(p.1.iter().map(SurfaceSegment::end)).collect()
    };
    let (a, b) = (points(a), points(b));
    a.len() == b.len()
        && a.iter().zip(&b).all(|(&p, &q)| {
            let d = minus(p, q);
            d[0].hypot(d[1]) <= tolerance
        })
}

/// Requirement: between two lines the tangent points are r tan(turn/2) from the corner.
#[test]
fn a_right_angle() {
    let corner = ([-3.0, 0.0], vec![line(0.0, 0.0), line(0.0, 2.0)]);
    let (start, segments) = fillet(&corner, 0.5).unwrap();
    assert_eq!((start, segments.len()), ([-3.0, 0.0], 3));
    let expected = ([-3.0, 0.0], vec![line(-0.5, 0.0), line(0.0, 0.5), line(0.0, 2.0)]);
    assert!(near(&(start, segments.clone()), &expected, 1e-15));
    let SurfaceSegment::Circle { centre, .. } = segments[1] else { panic!("{segments:?}") };
    assert!((centre[0] + 0.5).abs() < 1e-15 && (centre[1] - 0.5).abs() < 1e-15);
}

#[test]
fn what_is_smooth_stays() {
    let stadium = (
        [0.0, 0.0],
        vec![
            line(4.0, 0.0),
            SurfaceSegment::Circle { end: [5.0, 1.0], centre: [4.0, 1.0] },
            line(5.0, 3.0),
        ],
    );
    assert_eq!(fillet(&stadium, 0.3).unwrap(), stadium);
}

#[test]
fn a_closed_square_has_four_arcs() {
    let square = ([0.0, 0.0], vec![line(1.0, 0.0), line(1.0, 1.0), line(0.0, 1.0), line(0.0, 0.0)]);
    let round = fillet(&square, 0.2).unwrap();
    assert_eq!(round.1.len(), 8);
    assert!(kink(&round) < 1e-12 && round.0 == round.1[7].end());
    // Nothing is left of the sides: four arcs make a circle.
    let circle = fillet(&square, 0.5).unwrap();
    assert!(circle.1.len() == 4 && kink(&circle) < 1e-9);
    let misfit = fillet(&square, 0.7).unwrap_err();
    assert!((misfit.largest.unwrap() - 0.5).abs() < 1e-8, "{misfit:?}");
}

#[test]
fn what_does_not_fit_says_what_would() {
    let short = ([-3.0, 0.0], vec![line(0.0, 0.0), line(0.0, 0.4), line(-3.0, 0.4)]);
    let misfit = fillet(&short, 0.5).unwrap_err();
    assert_eq!(misfit.segment, 1);
    assert!((misfit.largest.unwrap() - 0.2).abs() < 1e-8, "both corners share the short side");
    let back = ([0.0, 0.0], vec![line(1.0, 0.0), line(0.0, 0.0), line(0.0, 1.0)]);
    assert_eq!(fillet(&back, 1e-6).unwrap_err().largest, None, "a blade has no fillet");
    // Inside an arc of radius 0.3 none of radius 0.4 has room.
    let bowl = (
        [-0.3, 0.0],
        vec![SurfaceSegment::Circle { end: [0.0, -0.3], centre: [0.0, 0.0] }, line(0.0, 5.0)],
    );
    assert!(fillet(&bowl, 0.4).is_err() && fillet(&bowl, 0.05).is_ok());
}

/// A zigzag of lines, arcs and parabolas whose corners turn by 20 to 120 degrees.
fn zigzag() -> impl Strategy<Value = Profile> {
    let piece = (0..3_usize, 1.0..2.0_f64, 0.35..2.0_f64, any::<bool>(), -0.2..0.2_f64);
    proptest::collection::vec(piece, 2..6).prop_map(|pieces| {
        let (mut at, mut heading, mut segments) = ([0.0, 0.0], 0.0_f64, Vec::new());
        for (kind, length, turn, left, bulge) in pieces {
            let end = [at[0] + length * heading.cos(), at[1] + length * heading.sin()];
            let middle = [0, 1].map(|k| 0.5 * (at[k] + end[k]));
            let normal = [-heading.sin(), heading.cos()];
            let off = |by: f64| [0, 1].map(|k| middle[k] + by * normal[k]);
            segments.push(match kind {
                0 => SurfaceSegment::Line { end },
                1 => {
                    let far = 1.5 * length * if bulge < 0.0 { -1.0 } else { 1.0 };
                    SurfaceSegment::Circle { end, centre: off(far) }
                }
                _ => SurfaceSegment::Parabola { middle: off(0.3 * bulge * length), end },
            });
            at = end;
            heading += if left { turn } else { -turn };
        }
        ([0.0, 0.0], segments)
    })
}

proptest! {
    #[test]
    fn arcs_are_tangent_to_both_sides(profile in zigzag(), radius in 0.001..0.08_f64) {
        let Ok(round) = fillet(&profile, radius) else { return Ok(()) };
        prop_assert!(kink(&round) <= SMOOTH);
        prop_assert!(round.1.len() > profile.1.len());
        let pieces = curves(round.0, &round.1);
        for curve in &pieces {
            if let Curve::Arc { ends: [p, q], centre, radius: own, sweep, .. } = *curve {
                let radii = [p, q].map(|z| minus(z, centre)).map(|d| d[0].hypot(d[1]));
                prop_assert!((radii[0] - radii[1]).abs() < 1e-9 * own, "{:?}", radii);
                prop_assert!(sweep.abs() < std::f64::consts::PI);
            }
        }
        // The other way round, and anywhere else in any unit.
        let back = reversed(&fillet(&reversed(&profile), radius).unwrap());
        prop_assert!(near(&back, &round, 1e-9));
        let place = [3.0e-4, -2.0e-4];
        let small = fillet(&moved(&profile, 0.7, 1e-6, place), 1e-6 * radius).unwrap();
        prop_assert!(near(&small, &moved(&round, 0.7, 1e-6, place), 1e-13));
    }

    /// Small enough a fillet always fits, and the largest one named does.
    #[test]
    fn the_largest_radius_fits(profile in zigzag()) {
        prop_assert!(fillet(&profile, 1e-3).is_ok());
        // A corner of next to nothing takes next to any arc.
        let Err(misfit) = fillet(&profile, 10.0) else { return Ok(()) };
        let largest = misfit.largest.unwrap();
        prop_assert!(fillet(&profile, 0.999 * largest).is_ok());
        prop_assert!(fillet(&profile, 1.001 * largest).is_err());
    }
}
