//! Search and gap put together for rigid surfaces: the gap of a point against what it faces.

use super::super::gap::circle::{Circle, Side};
use super::super::gap::curve::{Along, Weights};
use super::super::gap::offset::{Offset, Turn};
use super::super::gap::{Linear, Order};
use super::super::search::chain::{flat, raised};
use super::super::search::outlook::Outlook;
use super::super::search::rigid::{self, Facing, Part, RigidSegment};
use super::super::search::sharp_rigid;
use super::super::search::sweep::{Crossing, cross_rigid};
use super::body::Body;
use super::nose::{Nose, bounds};
use super::stencil::{AnyGap, StencilAttachments, curve_gap};
use crate::rigid::Attachment;

/// A rigid surface with its arc coordinates; segments in undeformed positions.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidSurface {
    segments: Vec<RigidSegment>,
    starts: Vec<f64>,
    period: Option<f64>,
    bounds: ([f64; 2], f64),
    noses: Vec<Nose>,
    /// Mean length of the faces of its slave [L].
    slave: f64,
}

impl RigidSurface {
    /// The surface of the segments in order of travel.
    pub fn new(segments: Vec<RigidSegment>) -> Self {
        let (starts, noses) = (Vec::with_capacity(segments.len()), Vec::new());
        let (bounds, slave) = (([0.0; 2], 0.0), f64::INFINITY);
        let mut new = Self { segments, starts, period: None, bounds, noses, slave };
        new.measure();
        new
    }

    /// Becomes the surface of other segments, in the room it has. False where one of them is none:
    /// then only those before it are there.
    pub fn take(&mut self, segments: impl Iterator<Item = Option<RigidSegment>>) -> bool {
        self.segments.clear();
        let mut whole = true;
        self.segments.extend(segments.map_while(|segment| {
            whole &= segment.is_some();
            segment
        }));
        self.measure();
        whole
    }

    /// It is met by a slave whose faces are so long [L]: open ends are prolonged by `extension` of the segments there,
    /// or of such a face where that is shorter, straight and then by rounded noses, which are none that may pass
    /// between points.
    pub fn prolong(&mut self, extension: f64, slave: f64) {
        self.slave = slave;
        if extension > 0.0 && self.period.is_none() {
            rigid::prolong(&mut self.segments, |end| extension * end.length().min(slave));
            let noses = std::mem::take(&mut self.noses);
            self.measure();
            self.noses = noses;
        }
    }

    /// Arc coordinates, bounds and noses of the segments.
    fn measure(&mut self) {
        let mut total = 0.0;
        self.starts.clear();
        for segment in &self.segments {
            self.starts.push(total);
            total += segment.length();
        }
        self.period = rigid::is_closed(&self.segments).then_some(total);
        self.bounds = bounds(&self.segments);
        Nose::find(&self.segments, self.period.is_some(), &mut self.noses);
    }

    /// Length along the surface [L].
    pub fn length(&self) -> f64 {
        let last = self.segments.last().map_or(0.0, RigidSegment::length);
        self.starts.last().map_or(0.0, |start| start + last)
    }

    /// A circle that holds the surface, in the frame of the body: centre and radius [L].
    pub fn bounds(&self) -> ([f64; 3], f64) {
        (raised(self.bounds.0), self.bounds.1)
    }

    /// Corners and arcs that the surface turns outward, and that may pass between points.
    pub fn noses(&self) -> impl Iterator<Item = &Nose> {
        self.noses.iter()
    }

    /// The segments.
    pub fn segments(&self) -> &[RigidSegment] {
        &self.segments
    }

    /// Undeformed places along it, so many parts a segment [L].
    pub fn outline(&self, parts: usize) -> impl Iterator<Item = [f64; 3]> {
        let place =
            move |segment: &RigidSegment, k: usize| raised(segment.place(k as f64 / parts as f64));
        self.segments.iter().flat_map(move |segment| (0..=parts).map(move |k| place(segment, k)))
    }

    /// Perimeter of a closed surface [L], after which sigma repeats.
    pub fn period(&self) -> Option<f64> {
        self.period
    }

    /// Whether it has a sharp corner that stands out.
    pub fn is_sharp(&self) -> bool {
        sharp_rigid::is_sharp(&self.segments, self.period.is_some())
    }

    /// What faces `point` (in space) on the body; see [`rigid::closest`].
    pub fn closest(&self, body: &Body, point: [f64; 3]) -> Option<Facing> {
        rigid::closest_on(&self.segments, self.period.is_some(), body.in_frame(point))
    }

    /// What faces a slave node of that outlook (in space) on the body; see [`sharp_rigid::closest`].
    pub fn closest_to_node(
        &self,
        body: &Body,
        (point, before, outlook): ([f64; 3], Option<usize>, &Outlook),
    ) -> Option<Facing> {
        let outlook = outlook.turned(|normal| body.turn_back(normal));
        let at = (body.in_frame(point), before, &outlook);
        sharp_rigid::closest((&self.segments, self.slave), self.period.is_some(), at)
    }

    /// Where the straight path between two places in the frame of the body crosses the surface, with
    /// the coordinate sigma of each crossing [L].
    pub fn crossings(&self, path: ([f64; 3], [f64; 3]), mut each: impl FnMut(Crossing, f64)) {
        cross_rigid(&self.segments, (flat(path.0), flat(path.1)), |crossing| {
            let segment = &self.segments[crossing.segment];
            let own = segment.arc_length(crossing.parameter.clamp(0.0, 1.0));
            each(crossing, self.starts[crossing.segment] + own);
        });
    }

    /// Overclosure of a place in the frame of the body [L]; `None` where it faces nothing.
    pub fn depth(&self, place: [f64; 3]) -> Option<f64> {
        self.overclosure(&Body::STILL, place)
    }

    /// Largest overclosure of the places of another profile, both undeformed [L]; `None` where none of them
    /// faces this one. Found among samples, then beside the best one.
    pub fn overclosure_of(&self, profile: &Self) -> Option<f64> {
        const SAMPLES: usize = 32;
        let of_segment = |segment: &RigidSegment| {
            let at = |parameter: f64| {
                let overclosure = self.overclosure(&Body::STILL, raised(segment.place(parameter)));
                overclosure.unwrap_or(f64::NEG_INFINITY)
            };
            let samples = (0..=SAMPLES).map(|k| k as f64 / SAMPLES as f64);
            let best = samples.max_by(|&a, &b| at(a).total_cmp(&at(b))).unwrap_or(0.0);
            let mut step = 0.5 / SAMPLES as f64;
            let mut place = best;
            while step > 1e-9 {
                let beside = [place - step, place + step].map(|place| place.clamp(0.0, 1.0));
                match beside.into_iter().find(|&other| at(other) > at(place)) {
                    Some(better) => place = better,
                    None => step *= 0.5,
                }
            }
            at(place)
        };
        let most = profile.segments.iter().map(of_segment).fold(f64::NEG_INFINITY, f64::max);
        most.is_finite().then_some(most)
    }

    /// Overclosure of `point` (in space) alone [L], without derivatives; `None` where it faces
    /// nothing.
    pub fn overclosure(&self, body: &Body, point: [f64; 3]) -> Option<f64> {
        let local = body.in_frame(point);
        let (facing, distance) = rigid::nearest_on(&self.segments, self.period.is_some(), local)?;
        let segment = self.segments.get(facing.segment)?;
        match (facing.part, *segment) {
            (Part::Interior, RigidSegment::Line { a, b }) => {
                let (d, r) = ([b[0] - a[0], b[1] - a[1]], [local[0] - a[0], local[1] - a[1]]);
                Some(-(d[0] * r[1] - d[1] * r[0]) / d[0].hypot(d[1]))
            }
            (Part::Interior, RigidSegment::Arc { centre, radius, convex, .. }) => {
                let r = [local[0] - centre[0], local[1] - centre[1]];
                let outside = r[0] * r[0] + r[1] * r[1] > radius * radius;
                Some(if outside == convex { -distance } else { distance })
            }
            (Part::Vertex { convex }, _) => Some(if convex { -distance } else { distance }),
            _ => {
                let gap = self.gap::<Linear>(body, &facing, (point, Offset::NONE));
                gap.map(|gap| gap.overclosure())
            }
        }
    }

    /// Overclosure [L] that `point` (in space) would have were the end prolonged beyond which it
    /// lies; `None` where it lies beyond none.
    pub fn beyond_end(&self, body: &Body, point: [f64; 3]) -> Option<f64> {
        match self.period {
            None => {
                let end = rigid::beyond_end(&self.segments, body.in_frame(point));
                end.map(|end| end.depth)
            }
            Some(_) => None,
        }
    }

    /// Gap of `point` (in space), or of the surface that stands off it, against what it faces.
    pub fn gap<O: Order>(
        &self,
        body: &Body,
        facing: &Facing,
        (point, offset): ([f64; 3], Offset),
    ) -> Option<AnyGap<O>> {
        let point = (flat(point), offset);
        let segment = self.segments.get(facing.segment)?;
        let start = *self.starts.get(facing.segment)?;
        if let Part::Vertex { convex } = facing.part {
            let at = start + segment.length();
            return circle_gap(body, segment.end(), (0.0, convex), point, (at, 0.0));
        }
        let xi = facing.parameter;
        match *segment {
            RigidSegment::Line { a, b } => {
                let control = [body.carry(a), body.carry(b)];
                let along = Along::straight(start, segment.length(), xi);
                curve_gap(point, &control, &Weights::straight(xi), &along, xi).map(AnyGap::Straight)
            }
            RigidSegment::Arc { start: from, centre, radius, convex, .. } => {
                let travel = if convex { -1.0 } else { 1.0 };
                let first = travel * radius * (from[1] - centre[1]).atan2(from[0] - centre[0]);
                let middle = first + 0.5 * segment.length();
                circle_gap(body, centre, (radius, convex), point, (start - first, middle))
            }
            RigidSegment::Parabola { start: from, mid, end } => {
                let rest = RigidSegment::parabola_control(from, mid, end);
                let control = rest.map(|p| body.carry(p));
                let weights = Weights::quadratic(xi);
                let along = parabola_along(&rest, &weights, start + segment.arc_length(xi));
                curve_gap(point, &control, &weights, &along, xi).map(AnyGap::Curved)
            }
        }
    }

    /// Attachments of the gap's variables: the slave, then the control points on the body whose dofs
    /// begin at the local number `first`.
    pub fn attachments(
        &self,
        body: &Body,
        facing: &Facing,
        slave: Attachment,
        first: usize,
    ) -> Option<StencilAttachments> {
        let mut attachments = StencilAttachments::new(slave);
        let segment = self.segments.get(facing.segment)?;
        let mut ride =
            |p: [f64; 2]| attachments.push(Attachment::Point { map: body.ride(p), first });
        let turns = match (facing.part, *segment) {
            (Part::Vertex { .. }, _) => {
                ride(segment.end());
                true
            }
            (Part::Interior, RigidSegment::Arc { centre, .. }) => {
                ride(centre);
                true
            }
            (Part::Interior, RigidSegment::Line { a, b }) => {
                ride(a);
                ride(b);
                false
            }
            (Part::Interior, RigidSegment::Parabola { start, mid, end }) => {
                RigidSegment::parabola_control(start, mid, end).into_iter().for_each(ride);
                false
            }
        };
        if turns {
            attachments.push(Attachment::Rotation { dof: first + 2 });
        }
        Some(attachments)
    }
}

/// Gap against a circle of the body, sigma shifted by `shift` and wrapped near `reference`.
fn circle_gap<O: Order>(
    body: &Body,
    centre: [f64; 2],
    (radius, convex): (f64, bool),
    (point, offset): ([f64; 2], Offset),
    (shift, reference): (f64, f64),
) -> Option<AnyGap<O>> {
    let circle = Circle { radius, side: if convex { Side::Convex } else { Side::Concave } };
    let mut gap = circle.gap(point, body.carry(centre), body.dofs[2], reference)?;
    gap.along += shift;
    gap.stand_off(offset, |_| Turn::OF_BODY);
    Some(AnyGap::Circle(gap))
}

/// Arc length of a parabola and its derivatives |B'|, B'.B''/|B'|.
fn parabola_along(control: &[[f64; 2]; 3], weights: &Weights<3>, value: f64) -> Along {
    let (mut first, mut second) = ([0.0; 2], [0.0; 2]);
    for (k, point) in control.iter().enumerate() {
        for c in 0..2 {
            first[c] += weights.first[k] * point[c];
            second[c] += weights.second[k] * point[c];
        }
    }
    let size = first[0].hypot(first[1]);
    let bend = first[0] * second[0] + first[1] * second[1];
    Along { value, first: size, second: if size > 0.0 { bend / size } else { 0.0 } }
}
