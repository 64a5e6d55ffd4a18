//! What faces a slave face: its segments.
//!
//! ```text
//!     ====o===o=======        curves, the nearest one on the line along n counts; one that
//!      |  |   |    |          turns its back or its edge there hides what lies behind it
//!   o--+--+---+----o--o
//! ```

use super::super::ends_within::{counts, fading};
use super::curve::{Curve, Place, cross, dot, sub};
use super::face::{MortarFace, field};
use super::integrals::{Bound, MERGING, Segment, across};
use super::normals::MeanNormal;

/// Part of a face below which bounds are one [1].
const SAME: f64 = 1e-11;
/// Part of a face that must be covered for any contact on it [1].
const LEAST: f64 = 1e-4;
/// Cosine of the angle of the normals of both sides from which on they face one another: 75 degrees.
/// Where two blocks touch, the sides beside the contact are across it and never meet its faces.
const FACING: f64 = 0.26;
/// The same from which on all counts: 59 degrees. (choice)
const WHOLE: f64 = 2.0 * FACING;
/// Lengths of the face behind its nearest part at which the middle of a part counts less, and no more [1]: what leans
/// as far as all counts, and covers the whole face, is not behind itself. (choice)
const FAR: [f64; 2] = [0.85, 1.25];
/// Most iterations towards a projection.
const MOST: usize = 60;

/// The segments of a face, in a list that is used again.
#[derive(Debug, Clone, Default)]
pub struct Cover {
    segments: Vec<Segment>,
    gaps: Vec<SegmentGap>,
    bounds: Vec<Bound>,
    spans: Vec<Span>,
}

/// How far a segment is away in its middle, at its bounds, and where it is nearest [L].
#[derive(Debug, Clone, Copy)]
struct SegmentGap {
    middle: f64,
    bounds: [f64; 2],
    nearest: f64,
}

/// What a curve covers of the face, seen along the normals.
#[derive(Debug, Clone, Copy)]
struct Span {
    curve: usize,
    from: f64,
    to: f64,
    faces: bool,
}

impl Cover {
    /// The segments of a face, in its order.
    pub fn find(&mut self, face: &MortarFace<'_, f64>) -> &[Segment] {
        self.segments.clear();
        self.gaps.clear();
        self.bounds.clear();
        self.spans.clear();
        let Some(ends) = face.end_normals() else { return &self.segments };
        let slave = face.curve();
        for (place, curve) in face.curves.iter().enumerate() {
            self.add_span((place, curve), &slave, &ends);
        }
        self.bounds.extend([Bound::End(0), Bound::End(1)]);
        self.bounds.sort_by(|a, b| a.at().total_cmp(&b.at()));
        for k in 1..self.bounds.len() {
            let bounds = [self.bounds[k - 1], self.bounds[k]];
            if bounds[1].at() - bounds[0].at() > SAME {
                self.add_segment(bounds, face, &ends);
            }
        }
        self.weigh(face, &ends);
        self.drop_across(face, &slave);
        self.drop_far(&slave);
        self.merge_ends(face);
        &self.segments
    }

    /// Notes what a curve covers, and its ends that lie on the face.
    fn add_span(
        &mut self,
        (place, curve): (usize, &Curve<f64>),
        slave: &Curve<f64>,
        ends: &[MeanNormal<f64>; 2],
    ) {
        let [Some(first), Some(last)] = [0, 1].map(|end| projected(curve.end(end), slave, ends))
        else {
            return;
        };
        let (from, to) = (first.min(last), first.max(last));
        if to <= 0.0 || from >= 1.0 {
            return;
        }
        for (end, at) in [first, last].into_iter().enumerate() {
            // an end that stands upon one of the face moves no bound: both sides of it are one
            if SAME < at && at < 1.0 - SAME {
                self.bounds.push(Bound::Projected { curve: place, end, at, merges: None });
            }
        }
        self.spans.push(Span { curve: place, from, to, faces: first < last });
    }

    /// Adds the segment between neighbouring bounds, where the nearest curve faces the slave.
    fn add_segment(
        &mut self,
        bounds: [Bound; 2],
        face: &MortarFace<'_, f64>,
        ends: &[MeanNormal<f64>; 2],
    ) {
        let middle = 0.5 * (bounds[0].at() + bounds[1].at());
        let (slave, normal) = (face.curve(), field(ends, middle));
        let at = slave.blend(&slave.shapes(middle).value);
        let mut nearest: Option<(f64, usize, bool)> = None;
        for span in self.spans.iter().filter(|span| span.from < middle && middle < span.to) {
            let curve = &face.curves[span.curve];
            let Some(eta) = curve.crossed(at, normal) else { continue };
            let there = curve.shapes(eta);
            let place = curve.blend(&there.value);
            // behind the focus of the normals the face does not look along them
            if across(&slave, ends, place, middle).1 >= 0.0 {
                continue;
            }
            let gap = dot(sub(place, at), normal);
            if nearest.is_none_or(|(known, ..)| gap.abs() < known.abs()) {
                let faces = span.faces && opposite(curve.blend(&there.slope), normal) > FACING;
                nearest = Some((gap, span.curve, faces));
            }
        }
        let Some((_, curve, true)) = nearest else { return };
        let bounds = bounds.map(|bound| self.of_curve(curve, bound));
        match self.segments.last_mut() {
            Some(last) if last.curve == curve && last.bounds[1] == bounds[0] => {
                last.bounds[1] = bounds[1];
            }
            _ => self.segments.push(Segment::new(curve, bounds)),
        }
    }

    /// How far every segment is away, and how much of it counts by how it faces the slave.
    fn weigh(&mut self, face: &MortarFace<'_, f64>, ends: &[MeanNormal<f64>; 2]) {
        let slave = face.curve();
        for segment in &mut self.segments {
            let curve = &face.curves[segment.curve];
            let at = |t: f64| {
                let (normal, at) = (field(ends, t), slave.blend(&slave.shapes(t).value));
                let there = curve.shapes(curve.crossed(at, normal)?);
                let gap =
                    dot(sub(curve.blend(&there.value), at), normal) / dot(normal, normal).sqrt();
                Some((gap, opposite(curve.blend(&there.slope), normal)))
            };
            let bounds = segment.bounds.map(|bound| bound.at());
            let gap = |t: f64| at(t).map_or(f64::INFINITY, |(gap, _)| gap);
            let found = at(0.5 * (bounds[0] + bounds[1]));
            let (middle, opposite) = found.unwrap_or((0.0, FACING));
            segment.counts *= fading((WHOLE - opposite) / (WHOLE - FACING));
            let bounds = bounds.map(gap);
            let nearest = bounds.into_iter().fold(middle, f64::min);
            self.gaps.push(SegmentGap { middle, bounds, nearest });
        }
    }

    /// A bound of a segment on a curve: an end of that curve itself where it stands there. An end of what
    /// is hidden may project upon the same place, as in a mesh with a mirror plane, and moves otherwise.
    fn of_curve(&self, own: usize, bound: Bound) -> Bound {
        let is_own = |other: &&Bound| {
            matches!(other, Bound::Projected { curve, at, .. }
                if *curve == own && (at - bound.at()).abs() <= SAME)
        };
        self.bounds.iter().find(is_own).copied().unwrap_or(bound)
    }

    /// Leaves out what begins at a corner of the slave and is deeper than it is wide: the corner went
    /// in through another side of the master than the one that it faces from inside. From as deep as wide on it
    /// counts less and less.
    ///
    /// ```text
    ///         |  slave  |
    ///     ----o---------o----      the sides of the slave, sunk by rounding or by what is allowed,
    ///     |     master      |      would face those of the master from within: not contact
    /// ```
    fn drop_across(&mut self, face: &MortarFace<'_, f64>, slave: &Curve<f64>) {
        let chord = sub(slave.end(1), slave.end(0));
        let length = dot(chord, chord).sqrt();
        let is_corner = [face.places.before.is_none(), face.places.after.is_none()];
        for end in (0..2).filter(|&end| is_corner[end]) {
            let (count, covered) = self.run_from(end, length);
            let all = self.segments.len();
            let run = if end == 0 { 0..count } else { all - count..all };
            let depth =
                self.gaps[run.clone()].iter().fold(0.0, |depth: f64, gap| depth.max(-gap.middle));
            let by = if covered < 1.0 - SAME { counts(depth, covered * length) } else { 1.0 };
            if by == 0.0 {
                self.segments.drain(run.clone());
                self.gaps.drain(run);
            } else {
                for segment in &mut self.segments[run] {
                    segment.counts *= by;
                    segment.went_in_elsewhere |= by < 1.0;
                }
            }
        }
    }

    /// How many segments lie side by side from an end of the face of this length [L] on, and how much they cover [1]; up to a
    /// step in the master that is higher than that is wide: beyond it something else is faced.
    fn run_from(&self, end: usize, length: f64) -> (usize, f64) {
        let (mut count, mut edge) = (0, end as f64);
        let all = self.segments.len();
        let at = |count: usize| if end == 0 { count } else { all - 1 - count };
        let covered = |edge: f64| (edge - end as f64).abs();
        while count < all && (self.segments[at(count)].bounds[end].at() - edge).abs() <= SAME {
            if let Some(before) = count.checked_sub(1).map(|before| &self.gaps[at(before)]) {
                let step = self.gaps[at(count)].bounds[end] - before.bounds[1 - end];
                if step.abs() > covered(edge) * length {
                    break;
                }
            }
            edge = self.segments[at(count)].bounds[1 - end].at();
            count += 1;
        }
        (count, covered(edge))
    }

    /// Marks the bounds that are next to an end of the slave surface, with nothing between.
    fn merge_ends(&mut self, face: &MortarFace<'_, f64>) {
        if let Some(first) = self.segments.first_mut().filter(|_| face.places.before.is_none()) {
            merge(&mut first.bounds[0], 0);
        }
        if let Some(last) = self.segments.last_mut().filter(|_| face.places.after.is_none()) {
            merge(&mut last.bounds[1], 1);
        }
    }

    /// Leaves out what lies further than the length of the face behind the nearest part, as the
    /// foot of a step, and a cover that is next to nothing. On the way there it counts less and less.
    fn drop_far(&mut self, slave: &Curve<f64>) {
        let chord = sub(slave.end(1), slave.end(0));
        let length = dot(chord, chord).sqrt();
        // nearest also at ends: a sliver that goes has the gap of what is beside it, and takes nothing with it
        let near = self.gaps.iter().map(|gap| gap.nearest).fold(f64::INFINITY, f64::min);
        let far = self.gaps.iter().map(|gap| gap.middle).fold(f64::NEG_INFINITY, f64::max);
        let far = far.min(near + FAR[1] * length);
        // what hardly counts does not say where the nearest part is
        let of = |(own, gap): (&Segment, &SegmentGap)| far + own.counts * (gap.nearest - far);
        let nearest = self.segments.iter().zip(&self.gaps).map(of).fold(f64::INFINITY, f64::min);
        for (segment, gap) in self.segments.iter_mut().zip(&self.gaps) {
            let behind = (gap.middle - nearest) / length;
            segment.counts *= fading((behind - FAR[0]) / (FAR[1] - FAR[0]));
        }
        self.segments.retain(|segment| segment.counts > 0.0);
        let part = |own: &Segment| own.counts * (own.bounds[1].at() - own.bounds[0].at());
        if self.segments.iter().map(part).sum::<f64>() < LEAST {
            self.segments.clear();
        }
    }
}

/// Cosine of the angle between the normals of both sides, turned to one another.
fn opposite(along: Place<f64>, normal: Place<f64>) -> f64 {
    cross(normal, along) / (dot(along, along) * dot(normal, normal)).sqrt()
}

/// Lets a bound go over into an end of its face where it is near.
fn merge(bound: &mut Bound, into: usize) {
    if let Bound::Projected { at, merges, .. } = bound
        && (*at - into as f64).abs() < MERGING
    {
        *merges = Some(into);
    }
}

/// Where a point projects on a face along its normals: infinite beyond an end, `None` behind the
/// focus of the normals.
fn projected(point: Place<f64>, slave: &Curve<f64>, ends: &[MeanNormal<f64>; 2]) -> Option<f64> {
    let off = |t: f64| across(slave, ends, point, t);
    let (first, last) = (off(0.0).0, off(1.0).0);
    match (first > 0.0, last < 0.0) {
        (false, false) => return None,
        (false, true) => return Some(f64::NEG_INFINITY),
        (true, false) => return Some(f64::INFINITY),
        (true, true) => {}
    }
    let (mut low, mut high) = (0.0, 1.0);
    let mut t = first / (first - last);
    for _ in 0..MOST {
        let (value, slope) = off(t);
        let newton = t - value / slope;
        if (newton - t).abs() <= f64::EPSILON {
            return Some(newton);
        }
        *(if value > 0.0 { &mut low } else { &mut high }) = t;
        t = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
    }
    Some(t)
}

#[cfg(test)]
mod tests;
