//! `FILLET RADIUS`: corners of an analytical surface rounded by tangent arcs.
//!
//! ```text
//!        A            The centre C is at the distance r from both segments, on the side to which
//!    ----T.           the surface turns; the tangent points T are its feet. [semantics: fillets]
//!        |  '.
//!        C---T  B
//!            |
//! ```
//!
//! Lengths are measured from the corner in units of the radius, so that neither the place of the
//! surface nor its units decide anything.

use slideline_model::{ProfilePoint, SurfaceSegment};

mod curve;

use curve::{Curve, Point, cross, dot, minus};

/// A start and the segments behind it.
pub(crate) type Profile = (Point, Vec<SurfaceSegment>);

/// Tangents that differ by less are one [rad]: arcs are given to this accuracy.
const SMOOTH: f64 = 1e-4;
/// Arcs longer than this are written as two [rad]: a segment is below 180 degrees.
const LONGEST: f64 = 3.0;
/// Parts of a segment that are shorter than this fraction of it are left out [1].
const NOTHING: f64 = 1e-9;

/// A corner that cannot be rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Misfit {
    /// The segment behind the corner.
    pub segment: usize,
    /// The largest radius that fits every corner [L]; `None` where none does.
    pub largest: Option<f64>,
}

/// The profile with every corner rounded by an arc of `radius` [L].
///
/// # Errors
/// The first corner that the arc does not fit.
pub(crate) fn fillet(profile: &Profile, radius: f64) -> Result<Profile, Misfit> {
    rounded(profile, radius)
        .map_err(|segment| Misfit { segment, largest: largest(profile, radius) })
}

/// The largest radius below `radius` that fits, by bisection.
fn largest(profile: &Profile, radius: f64) -> Option<f64> {
    let (mut fits, mut too_large) = (0.0, radius);
    for _ in 0..60 {
        let middle = 0.5 * (fits + too_large);
        if rounded(profile, middle).is_ok() {
            fits = middle;
        } else {
            too_large = middle;
        }
    }
    (fits > NOTHING * radius).then_some(fits)
}

/// A corner after rounding: what stays of the segments about it, and the arc.
#[derive(Clone, Copy, Debug)]
struct Rounding {
    /// Parameter at which the segment before the corner ends [1].
    until: f64,
    /// Parameter at which the segment behind it begins [1].
    from: f64,
    /// Beginning and end of the arc [L].
    ends: [Point; 2],
    /// Its centre [L].
    centre: Point,
    /// Angle from beginning to end, positive to the left [rad].
    sweep: f64,
}

/// The rounded profile, or the segment behind the first corner that does not fit.
fn rounded(profile: &Profile, radius: f64) -> Result<Profile, usize> {
    let (start, segments) = profile;
    let curves = curves(*start, segments);
    let count = curves.len();
    let mut corners: Vec<Option<Rounding>> = vec![None; count]; // the corner before each segment
    for (at, corner) in corners.iter_mut().enumerate() {
        let before = match at {
            0 if is_closed(*start, segments) => count - 1,
            0 => continue,
            _ => at - 1,
        };
        if before != at {
            *corner = round(&curves[before], &curves[at], radius).map_err(|()| at)?;
        }
    }
    let mut new = Vec::new();
    let mut first = None;
    for (at, curve) in curves.iter().enumerate() {
        let behind = if at + 1 < count { at + 1 } else { 0 };
        let from = corners[at].map_or(0.0, |corner| corner.from);
        let until = corners[behind].map_or(1.0, |corner| corner.until);
        if from > until {
            return Err(if corners[behind].is_some() && behind > 0 { behind } else { at });
        }
        let begin = corners[at].map_or_else(|| curve.start(), |corner| corner.ends[1]);
        first.get_or_insert(begin);
        if until - from > NOTHING {
            let end = corners[behind].map_or_else(|| curve.end(), |corner| corner.ends[0]);
            new.push(curve.piece(from, until, end));
        }
        if let Some(corner) = corners[behind] {
            corner.push(&mut new);
        }
    }
    Ok((first.unwrap_or(*start), new))
}

impl Rounding {
    /// The arc as one segment, or as two where it is long.
    fn push(&self, segments: &mut Vec<SurfaceSegment>) {
        let Self { ends: [begin, end], centre, sweep, .. } = *self;
        if sweep.abs() > LONGEST {
            let (sin, cos) = (0.5 * sweep).sin_cos();
            let [x, y] = minus(begin, centre);
            let middle = [centre[0] + cos * x - sin * y, centre[1] + sin * x + cos * y];
            segments.push(SurfaceSegment::Circle { end: middle, centre });
        }
        segments.push(SurfaceSegment::Circle { end, centre });
    }
}

fn curves(start: Point, segments: &[SurfaceSegment]) -> Vec<Curve> {
    let mut from = start;
    let mut curves = Vec::with_capacity(segments.len());
    for segment in segments {
        curves.push(Curve::new(from, segment));
        from = segment.end();
    }
    curves
}

/// The points of every segment, between which it is straight to less than a thousandth of its size.
pub(crate) fn drawn((start, segments): &Profile) -> Vec<Vec<Point>> {
    const PIECES: u32 = 48;
    let points = |curve: &Curve| match curve {
        Curve::Line(ends) => ends.to_vec(),
        curved => {
            let inner = (1..PIECES).map(|k| curved.at(f64::from(k) / f64::from(PIECES)).point);
            [curved.start()].into_iter().chain(inner).chain([curved.end()]).collect()
        }
    };
    curves(*start, segments).iter().map(points).collect()
}

/// Whether the last segment ends where the first one begins.
fn is_closed(start: Point, segments: &[SurfaceSegment]) -> bool {
    let points = segments.iter().map(SurfaceSegment::end);
    let size = points.map(|p| minus(p, start)).fold(0.0, |s: f64, d| s.max(d[0].hypot(d[1])));
    segments.last().is_some_and(|last| {
        let gap = minus(last.end(), start);
        segments.len() > 1 && gap[0].hypot(gap[1]) <= NOTHING * size
    })
}

/// Rounds the corner between two segments; `None` where there is none.
fn round(before: &Curve, behind: &Curve, radius: f64) -> Result<Option<Rounding>, ()> {
    let corner = before.end();
    // Seen from the corner, in units of the radius.
    let (a, b) = (before.seen_from(corner, radius), behind.seen_from(corner, radius));
    let (ta, tb) = (a.at(1.0).tangent, b.at(0.0).tangent);
    let turn = cross(ta, tb).atan2(dot(ta, tb));
    if turn.abs() <= SMOOTH {
        return Ok(None);
    }
    let side = turn.signum();
    let [until, from] = feet(&a, &b, side).ok_or(())?;
    let (p, q) = (a.at(until), b.at(from));
    let centre = p.beside(side);
    let (u, v) = (minus(p.point, centre), minus(q.point, centre));
    let mut sweep = cross(u, v).atan2(dot(u, v));
    if sweep * side < 0.0 {
        sweep += side * std::f64::consts::TAU;
    }
    let back = |z: Point| [corner[0] + radius * z[0], corner[1] + radius * z[1]];
    let ends = [back(p.point), back(q.point)];
    Ok(Some(Rounding { until, from, ends, centre: back(centre), sweep }))
}

/// Parameters of the tangent points of a circle of radius 1 on both curves.
///
/// Follows the circle as it grows from the corner, so that of several circles that touch both
/// curves it is the one in the corner.
fn feet(a: &Curve, b: &Curve, side: f64) -> Option<ProfilePoint> {
    let (mut feet, mut radius, mut step) = ([1.0, 0.0], 0.0, 1.0_f64);
    while radius < 1.0 {
        let next = (radius + step).min(1.0);
        match newton(a, b, side * next, feet) {
            Some(found) => {
                (feet, radius) = (found, next);
                step *= 2.0;
                if feet[0] < -NOTHING || feet[1] > 1.0 + NOTHING {
                    return None; // it only grows from here
                }
            }
            None => {
                step = 0.5 * (next - radius);
                if step < 1e-6 {
                    return None;
                }
            }
        }
    }
    Some([feet[0].max(0.0), feet[1].min(1.0)])
}

/// Solves A(u) + r n_A(u) = B(v) + r n_B(v) near `feet`; `None` where it leads astray: the step
/// was too large, or no such circle exists.
fn newton(a: &Curve, b: &Curve, radius: f64, feet: ProfilePoint) -> Option<ProfilePoint> {
    let [mut u, mut v] = feet;
    let mut best = f64::INFINITY;
    for _ in 0..20 {
        let (p, q) = (a.at(u), b.at(v));
        let (left, right) = (p.beside(radius), q.beside(radius));
        let gap = minus(left, right);
        let size = gap[0].abs().max(gap[1].abs());
        // d/du (A + r n) = A' (1 - r k) along the tangent.
        let (along_a, along_b) =
            (p.speed * (1.0 - radius * p.bend), q.speed * (1.0 - radius * q.bend));
        let turn = cross(p.tangent, q.tangent);
        if along_a <= 0.0 || along_b <= 0.0 || turn * radius <= 0.0 {
            return None; // tighter than the curve itself, or past the corner
        }
        if size >= best && best < 1e-9 {
            break; // rounding has been reached
        }
        best = size;
        u -= cross(gap, q.tangent) / (turn * along_a);
        v -= cross(gap, p.tangent) / (turn * along_b);
        if !(-1.0..=1.5).contains(&u) || !(-0.5..=2.0).contains(&v) {
            return None;
        }
        if size == 0.0 {
            break;
        }
    }
    (best < 1e-9).then_some([u, v])
}

#[cfg(test)]
mod tests;
