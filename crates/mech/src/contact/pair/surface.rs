//! Search and gap put together: the gap of a point against what it faces.

use super::super::gap::Gap;
use super::super::gap::circle::{Circle, Side};
use super::super::gap::curve::{Along, Weights, overclosure, point_to_curve};
use super::super::search::chain::{Chain, Piece, PieceKind, flat, raised};
use super::super::search::rigid::{self, Facing, Part, RigidSegment};
use super::super::search::sweep::{Crossing, cross_rigid};
use super::super::tangential::Tangential;
use super::nose::{Nose, bounds};
use crate::rigid::{Attachment, PointMap};

/// A gap of any of the kernels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(clippy::large_enum_variant)] // a box would allocate in the Newton loop
pub enum AnyGap {
    /// Circle or vertex: (slave x, y, centre x, y, body rotation).
    Circle(Gap<5>),
    /// Straight: (slave, two control points).
    Straight(Gap<6>),
    /// Corner or parabola: (slave, three control points).
    Quadratic(Gap<8>),
}

/// Evaluates an expression for the gap inside an [`AnyGap`].
macro_rules! each {
    ($any:expr, $gap:ident => $body:expr) => {
        match $any {
            AnyGap::Circle($gap) => $body,
            AnyGap::Straight($gap) => $body,
            AnyGap::Quadratic($gap) => $body,
        }
    };
}

impl AnyGap {
    /// Overclosure h [L].
    pub fn overclosure(&self) -> f64 {
        each!(self, gap => gap.overclosure)
    }

    /// Master coordinates sigma [L].
    pub fn along(&self) -> Tangential {
        Tangential::along(each!(self, gap => gap.along))
    }

    /// Outward normal of the master.
    pub fn normal(&self) -> [f64; 3] {
        raised(each!(self, gap => gap.normal))
    }

    /// First tangent of the master, in the direction of travel.
    pub fn tangent(&self) -> [f64; 3] {
        raised(each!(self, gap => gap.tangent))
    }

    /// Facing position on the master [L].
    pub fn position(&self) -> [f64; 3] {
        raised(each!(self, gap => gap.position))
    }

    /// Number of variables.
    pub fn width(&self) -> usize {
        each!(self, gap => gap.gradient.len())
    }

    /// Derivatives by the variables, as slices.
    pub fn derivatives(&self) -> Derivatives<'_> {
        each!(self, gap => Derivatives {
            gradient: &gap.gradient,
            slip_gradient: &gap.slip_gradient,
            hessian: gap.hessian.as_flattened(),
            direction: &gap.direction,
            direction_derivative: gap.direction_derivative.as_flattened(),
        })
    }
}

/// Derivatives of a gap of n variables; those of sigma direction after direction.
#[derive(Debug, Clone, Copy)]
pub struct Derivatives<'a> {
    /// dh/dq, n [1].
    pub gradient: &'a [f64],
    /// d sigma/dq, n each [1].
    pub slip_gradient: &'a [f64],
    /// d2h/dq2, n x n row-major [1/L].
    pub hessian: &'a [f64],
    /// Directions of the tangential force, n each [1].
    pub direction: &'a [f64],
    /// Their derivatives, n x n row-major each, not symmetric [1/L].
    pub direction_derivative: &'a [f64],
}

/// Where the attachments of a stencil go, slave first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StencilAttachments {
    all: [Attachment; 4],
    count: usize,
}

impl StencilAttachments {
    fn new(slave: Attachment) -> Self {
        Self { all: [slave; 4], count: 1 }
    }

    fn push(&mut self, attachment: Attachment) {
        if let Some(entry) = self.all.get_mut(self.count) {
            *entry = attachment;
            self.count += 1;
        }
    }

    /// The attachments in the order of the gap's variables.
    pub fn as_slice(&self) -> &[Attachment] {
        &self.all[..self.count]
    }
}

/// Gap of `point` against the piece of a chain that faces it; variables (slave, nodes of
/// [`Piece::nodes`]). `None` for degenerate positions.
pub fn chain_gap(
    chain: &Chain,
    piece: &Piece,
    positions: &[[f64; 3]],
    point: [f64; 3],
) -> Option<AnyGap> {
    let (k, xi, point) = (piece.index, piece.parameter, flat(point));
    let at = |node: usize| positions.get(node).copied().map(flat);
    match piece.kind {
        PieceKind::Straight => {
            let control = [at(k)?, at(k + 1)?];
            let along = Along::straight(chain.arc_coordinate(k), chain.reference_length(k), xi);
            point_to_curve(point, &control, &Weights::straight(xi), &along, xi)
                .map(AnyGap::Straight)
        }
        PieceKind::Corner => {
            let before = k.checked_sub(1)?;
            let control = [at(before)?, at(k)?, at(k + 1)?];
            let f = chain.smoothing;
            let (a1, a2) = (f * chain.reference_length(before), f * chain.reference_length(k));
            let along = Along::corner(chain.arc_coordinate(k), a1, a2, xi);
            point_to_curve(point, &control, &Weights::corner(xi, f), &along, xi)
                .map(AnyGap::Quadratic)
        }
    }
}

/// Overclosure and coordinate along the master of that gap [L], without its derivatives.
pub fn chain_overclosure(
    chain: &Chain,
    piece: &Piece,
    positions: &[[f64; 3]],
    point: [f64; 3],
) -> Option<[f64; 2]> {
    let (xi, point, control) = (piece.parameter, flat(point), positions.get(piece.nodes())?);
    let length = |index| chain.reference_length(index);
    let (over, along) = match *control {
        [a, b] => (
            overclosure(point, &[a, b].map(flat), &Weights::straight(xi)),
            Along::straight(chain.arc_coordinate(piece.index), length(piece.index), xi),
        ),
        [a, b, c] => {
            let f = chain.smoothing;
            let (before, behind) = (f * length(piece.index - 1), f * length(piece.index));
            let node = chain.arc_coordinate(piece.index);
            let weights = Weights::corner(xi, f);
            (
                overclosure(point, &[a, b, c].map(flat), &weights),
                Along::corner(node, before, behind, xi),
            )
        }
        _ => return None,
    };
    Some([over?, along.value])
}

/// Attachments of a chain stencil: the slave, then the piece's nodes, given in order.
pub fn chain_attachments(slave: Attachment, nodes: &[Attachment]) -> StencilAttachments {
    let mut attachments = StencilAttachments::new(slave);
    for node in nodes {
        attachments.push(*node);
    }
    attachments
}

/// A rigid body in the plane: x = x_ref + R(phi)(X - X_ref).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Undeformed position of the reference node X_ref [L].
    pub reference: [f64; 3],
    /// Its dofs (ux, uy, phi).
    pub dofs: [f64; 3],
}

impl Body {
    /// A body whose frame is space.
    pub const STILL: Self = Self { reference: [0.0; 3], dofs: [0.0; 3] };

    /// How an undeformed position rides on the body.
    pub fn map(&self, position: [f64; 3]) -> PointMap {
        self.ride(flat(position))
    }

    fn ride(&self, position: [f64; 2]) -> PointMap {
        let arm = [position[0] - self.reference[0], position[1] - self.reference[1]];
        PointMap::Arm { arm }
    }

    /// Current position of an undeformed one [L].
    pub fn to_space(&self, position: [f64; 3]) -> [f64; 3] {
        raised(self.carry(flat(position)))
    }

    pub(super) fn carry(&self, position: [f64; 2]) -> [f64; 2] {
        let u = self.ride(position).displacement(&self.dofs);
        [position[0] + u[0], position[1] + u[1]]
    }

    /// The undeformed position that is now at `point` [L].
    pub fn to_body(&self, point: [f64; 3]) -> [f64; 3] {
        raised(self.in_frame(point))
    }

    pub(super) fn in_frame(&self, point: [f64; 3]) -> [f64; 2] {
        let [x, y, _] = self.reference;
        let d = [point[0] - x - self.dofs[0], point[1] - y - self.dofs[1]];
        let (s, c) = self.dofs[2].sin_cos();
        [x + c * d[0] + s * d[1], y - s * d[0] + c * d[1]]
    }

    /// A direction in space as the body sees it.
    pub fn turn_back(&self, direction: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.dofs[2].sin_cos();
        let [x, y, z] = direction;
        [cos * x + sin * y, cos * y - sin * x, z]
    }
}

/// A rigid surface with its arc coordinates; segments in undeformed positions.
#[derive(Debug, Clone, PartialEq)]
pub struct RigidSurface {
    segments: Vec<RigidSegment>,
    starts: Vec<f64>,
    period: Option<f64>,
    bounds: ([f64; 2], f64),
    noses: Vec<Nose>,
}

impl RigidSurface {
    /// The surface of the segments in order of travel.
    pub fn new(segments: Vec<RigidSegment>) -> Self {
        let (starts, noses) = (Vec::with_capacity(segments.len()), Vec::new());
        let mut new = Self { segments, starts, period: None, bounds: ([0.0; 2], 0.0), noses };
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

    /// What faces `point` (in space) on the body; see [`rigid::closest`].
    pub fn closest(&self, body: &Body, point: [f64; 3]) -> Option<Facing> {
        rigid::closest_on(&self.segments, self.period.is_some(), body.in_frame(point))
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
            _ => self.gap(body, &facing, point).map(|gap| gap.overclosure()),
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

    /// Gap of `point` (in space) against what it faces.
    pub fn gap(&self, body: &Body, facing: &Facing, point: [f64; 3]) -> Option<AnyGap> {
        let point = flat(point);
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
                point_to_curve(point, &control, &Weights::straight(xi), &along, xi)
                    .map(AnyGap::Straight)
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
                point_to_curve(point, &control, &weights, &along, xi).map(AnyGap::Quadratic)
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
fn circle_gap(
    body: &Body,
    centre: [f64; 2],
    (radius, convex): (f64, bool),
    point: [f64; 2],
    (shift, reference): (f64, f64),
) -> Option<AnyGap> {
    let circle = Circle { radius, side: if convex { Side::Convex } else { Side::Concave } };
    let mut gap = circle.gap(point, body.carry(centre), body.dofs[2], reference)?;
    gap.along += shift;
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
