//! Contact pairs at work: where every slave point stands against its master.
//!
//! ```text
//!   slave point --search--> facing piece --gap--> h, sigma, derivatives
//!        |                        |                     |
//!      carried                 carried            pushed to dofs
//!     by a node               by nodes            (PointMap alone)
//! ```
//!
//! Geometry only; pressures and tractions come from the laws in
//! [`crate::linearised`] and [`crate::evaluate`].

use crate::layout::{Carried, Layout};
use crate::linearised::{Laws, MOST_DOFS};
use slideline_mech::contact::friction::{Decay, FrictionLaw, Stick};
use slideline_mech::contact::gap::Gap;
use slideline_mech::contact::gap::circle::{Circle, Side};
use slideline_mech::contact::gap::curve::{Along, Weights, point_to_curve};
use slideline_mech::contact::points::{average_length, tributary_areas};
use slideline_mech::contact::search::chain::{Chain, PieceKind};
use slideline_mech::contact::search::rigid::{Facing, Part, RigidSegment, closest};
use slideline_mech::rigid::{Attachment, PointMap, push_forward, push_gradient};
use slideline_model::{
    ContactPair, Dof, Friction, Master, Model, NodeIndex, RigidSurface, StickRule, SurfaceSegment,
};

/// The most kernel variables of a point: itself and three control points.
const MOST_VARIABLES: usize = 8;
/// The most attachments: the point, its control points, a rotation.
const MOST_ATTACHMENTS: usize = 4;

/// A slave point.
#[derive(Clone, Debug)]
pub struct SlavePoint {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its node.
    pub node: NodeIndex,
    /// Tributary area [L2].
    pub area: f64,
    carried: Carried,
    slots: [usize; 3],
}

/// A master, ready to be searched.
#[derive(Clone, Debug)]
enum Facade {
    /// Segments in the frame of the body, positions relative to its node.
    Body { slots: [usize; 3], origin: [f64; 2], segments: Vec<RigidSegment>, starts: Vec<f64> },
    /// A chain of nodes and the range its positions take in the scratch.
    Line { chain: Chain, nodes: Vec<(Carried, [usize; 3])> },
}

/// All contact pairs of a step.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Slave points of all pairs, pair by pair.
    pub points: Vec<SlavePoint>,
    /// Laws, a pair each.
    pub laws: Vec<Laws>,
    facades: Vec<Facade>,
}

/// A slave point against its master in one configuration.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// Whether it faces its master at all.
    pub faces: bool,
    /// Overclosure [L]; minus infinity where it faces nothing.
    pub overclosure: f64,
    /// Coordinate along the master [L].
    pub along: f64,
    /// Outward normal of the master [1].
    pub normal: [f64; 2],
    /// Position of the point [L].
    pub position: [f64; 2],
    /// Number of slots it couples.
    pub width: usize,
    /// Those slots.
    pub slots: [usize; MOST_DOFS],
    /// dh/du of each slot [1].
    pub gradient: [f64; MOST_DOFS],
    /// d sigma/du of each slot [1].
    pub slip_gradient: [f64; MOST_DOFS],
    kernel: Kernel,
}

/// Derivatives by kernel variables, kept for the geometric tangent.
#[derive(Clone, Copy, Debug)]
struct Kernel {
    variables: usize,
    gradient: [f64; MOST_VARIABLES],
    slip_gradient: [f64; MOST_VARIABLES],
    hessian: [f64; MOST_VARIABLES * MOST_VARIABLES],
    slip_hessian: [f64; MOST_VARIABLES * MOST_VARIABLES],
    attachments: [Attachment; MOST_ATTACHMENTS],
    attached: usize,
}

impl Meeting {
    /// A point that faces nothing.
    pub const NOWHERE: Self = Self {
        faces: false,
        overclosure: f64::NEG_INFINITY,
        along: 0.0,
        normal: [0.0; 2],
        position: [0.0; 2],
        width: 0,
        slots: [0; MOST_DOFS],
        gradient: [0.0; MOST_DOFS],
        slip_gradient: [0.0; MOST_DOFS],
        kernel: Kernel {
            variables: 0,
            gradient: [0.0; MOST_VARIABLES],
            slip_gradient: [0.0; MOST_VARIABLES],
            hessian: [0.0; MOST_VARIABLES * MOST_VARIABLES],
            slip_hessian: [0.0; MOST_VARIABLES * MOST_VARIABLES],
            attachments: [Attachment::Rotation { dof: 0 }; MOST_ATTACHMENTS],
            attached: 0,
        },
    };

    /// Tangent of the geometry, normal * D dh + tangential * D d sigma, with
    /// `normal` and `tangential` forces [F]; row-major, `width` wide.
    pub fn geometric_tangent(
        &self,
        u: &[f64],
        normal: f64,
        tangential: f64,
        tangent: &mut [f64; MOST_DOFS * MOST_DOFS],
    ) {
        let n = self.kernel.variables;
        let m = self.width;
        let mut dofs = [0.0; MOST_DOFS];
        for (dof, &slot) in dofs.iter_mut().zip(&self.slots[..m]) {
            *dof = u[slot];
        }
        let mut gradient = [0.0; MOST_VARIABLES];
        let mut hessian = [0.0; MOST_VARIABLES * MOST_VARIABLES];
        for i in 0..n {
            gradient[i] =
                normal * self.kernel.gradient[i] + tangential * self.kernel.slip_gradient[i];
        }
        for i in 0..n * n {
            hessian[i] = normal * self.kernel.hessian[i] + tangential * self.kernel.slip_hessian[i];
        }
        let mut force = [0.0; MOST_DOFS];
        tangent[..m * m].fill(0.0);
        push_forward(
            &self.kernel.attachments[..self.kernel.attached],
            &dofs[..m],
            &gradient[..n],
            &hessian[..n * n],
            &mut force[..m],
            &mut tangent[..m * m],
        );
    }
}

impl Contact {
    /// Prepares the pairs of a model.
    pub fn new(model: &Model, layout: &Layout) -> Self {
        let mut contact = Self { points: Vec::new(), laws: Vec::new(), facades: Vec::new() };
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            contact.add_points(model, layout, place, pair);
            contact.laws.push(laws(model, pair));
            contact.facades.push(match &pair.master {
                Master::RigidSurface(surface) => body(model, layout, surface),
                Master::SlideLine(line) => {
                    let reference: Vec<_> =
                        line.nodes.iter().map(|&node| model.nodes.plane(node)).collect();
                    let nodes = line.nodes.iter().map(|&node| {
                        let carried = layout.carried_node(model, node);
                        (carried, slots_of(layout, carried.node))
                    });
                    match Chain::new(&reference, line.smooth, line.extension) {
                        Some(chain) => Facade::Line { chain, nodes: nodes.collect() },
                        None => Facade::Body {
                            slots: [0; 3],
                            origin: [0.0; 2],
                            segments: Vec::new(),
                            starts: Vec::new(),
                        },
                    }
                }
            });
        }
        contact
    }

    fn add_points(&mut self, model: &Model, layout: &Layout, place: usize, pair: &ContactPair) {
        let nodes = pair.slave_nodes();
        let (elements, coordinates) = local_elements(model, pair, &nodes);
        let width = pair.interaction.width;
        let areas = tributary_areas(nodes.len(), &elements, &coordinates, width);
        for (&node, area) in nodes.iter().zip(areas) {
            let carried = layout.carried_node(model, node);
            let slots = slots_of(layout, carried.node);
            self.points.push(SlavePoint { pair: place, node, area, carried, slots });
        }
    }

    /// Sets of slots that may ever couple.
    pub fn cliques(&self) -> Vec<Vec<usize>> {
        let mut cliques = Vec::new();
        for point in &self.points {
            let own = &point.slots[..point.carried.map.width()];
            match &self.facades[point.pair] {
                Facade::Body { slots, .. } => cliques.push([own, slots].concat()),
                Facade::Line { nodes, .. } => {
                    for window in nodes.windows(nodes.len().min(3)) {
                        let mut clique = own.to_vec();
                        for (carried, slots) in window {
                            clique.extend(&slots[..carried.map.width()]);
                        }
                        cliques.push(clique);
                    }
                }
            }
        }
        cliques
    }

    /// The most positions a chain has, for the scratch.
    pub fn most_chain_nodes(&self) -> usize {
        self.facades
            .iter()
            .map(|facade| match facade {
                Facade::Line { nodes, .. } => nodes.len(),
                Facade::Body { .. } => 0,
            })
            .max()
            .unwrap_or(0)
    }

    /// Where every point stands at displacements `u`. `positions` is scratch.
    pub fn meet(&self, u: &[f64], positions: &mut Vec<[f64; 2]>, into: &mut [Meeting]) {
        let mut current = usize::MAX;
        for (point, meeting) in self.points.iter().zip(into) {
            if point.pair != current {
                current = point.pair;
                if let Facade::Line { nodes, .. } = &self.facades[current] {
                    positions.clear();
                    positions.extend(nodes.iter().map(|(node, slots)| place(node, slots, u)));
                }
            }
            self.meet_one(point, u, positions, meeting);
        }
    }

    fn meet_one(&self, point: &SlavePoint, u: &[f64], positions: &[[f64; 2]], into: &mut Meeting) {
        into.position = place(&point.carried, &point.slots, u);
        into.faces = false;
        into.overclosure = f64::NEG_INFINITY;
        into.width = 0;
        into.kernel.attached = 0;
        into.attach(&point.carried, &point.slots);
        let found = match &self.facades[point.pair] {
            Facade::Body { slots, origin, segments, starts } => {
                let body = Body { slots, origin: *origin, segments, starts };
                body.meet(u, into)
            }
            Facade::Line { chain, nodes } => meet_chain(chain, nodes, positions, into),
        };
        if found.is_some() {
            into.faces = true;
            into.push(u);
        } else {
            into.width = 0;
        }
    }
}

impl Meeting {
    /// Adds a carried point to the stencil.
    fn attach(&mut self, carried: &Carried, slots: &[usize; 3]) {
        let map = carried.map;
        let first = self.width;
        for &slot in &slots[..map.width()] {
            self.slots[self.width] = slot;
            self.width += 1;
        }
        self.kernel.attachments[self.kernel.attached] = Attachment::Point { map, first };
        self.kernel.attached += 1;
    }

    /// Adds points fixed to a body, which share its dofs.
    fn attach_body(&mut self, slots: &[usize; 3], arms: &[[f64; 2]], rotation: bool) {
        let first = self.width;
        for &slot in slots {
            self.slots[self.width] = slot;
            self.width += 1;
        }
        let points = arms
            .iter()
            .map(|&arm| Attachment::Point { map: PointMap::Arm { arm }, first })
            .chain(rotation.then_some(Attachment::Rotation { dof: first + 2 }));
        for attachment in points {
            self.kernel.attachments[self.kernel.attached] = attachment;
            self.kernel.attached += 1;
        }
    }

    /// Takes a gap in.
    fn take<const N: usize>(&mut self, gap: &Gap<N>) {
        self.overclosure = gap.overclosure;
        self.along = gap.along;
        self.normal = gap.normal;
        let kernel = &mut self.kernel;
        kernel.variables = N;
        kernel.gradient[..N].copy_from_slice(&gap.gradient);
        kernel.slip_gradient[..N].copy_from_slice(&gap.slip_gradient);
        kernel.hessian[..N * N].copy_from_slice(gap.hessian.as_flattened());
        kernel.slip_hessian[..N * N].copy_from_slice(gap.slip_hessian.as_flattened());
    }

    /// Pushes gradients from kernel variables to slots.
    fn push(&mut self, u: &[f64]) {
        let (m, n) = (self.width, self.kernel.variables);
        let mut dofs = [0.0; MOST_DOFS];
        for (dof, &slot) in dofs.iter_mut().zip(&self.slots[..m]) {
            *dof = u[slot];
        }
        let attachments = &self.kernel.attachments[..self.kernel.attached];
        self.gradient[..m].fill(0.0);
        self.slip_gradient[..m].fill(0.0);
        let (gradient, slip) = (&self.kernel.gradient[..n], &self.kernel.slip_gradient[..n]);
        push_gradient(attachments, &dofs[..m], gradient, &mut self.gradient[..m]);
        push_gradient(attachments, &dofs[..m], slip, &mut self.slip_gradient[..m]);
    }
}

/// A rigid surface in place.
struct Body<'a> {
    slots: &'a [usize; 3],
    origin: [f64; 2],
    segments: &'a [RigidSegment],
    starts: &'a [f64],
}

impl Body<'_> {
    fn meet(&self, u: &[f64], into: &mut Meeting) -> Option<()> {
        let pose = self.slots.map(|slot| u[slot]);
        let (s, c) = pose[2].sin_cos();
        let centre = [self.origin[0] + pose[0], self.origin[1] + pose[1]];
        let d = [into.position[0] - centre[0], into.position[1] - centre[1]];
        let local = [c * d[0] + s * d[1], c * d[1] - s * d[0]];
        let facing = closest(self.segments, local, None)?;
        let segment = self.segments.get(facing.segment)?;
        let start = self.starts.get(facing.segment).copied()?;
        let current = |arm: [f64; 2]| {
            [centre[0] + c * arm[0] - s * arm[1], centre[1] + s * arm[0] + c * arm[1]]
        };
        let turned = Turned { current: &current, rotation: pose[2], start };
        match facing.part {
            Part::Vertex { convex } => {
                let side = if convex { Side::Convex } else { Side::Concave };
                let circle = Circle { radius: 0.0, side };
                let mut gap =
                    circle.gap(into.position, current(segment.end()), pose[2], 0.0)?;
                gap.along = start + segment.length();
                into.attach_body(self.slots, &[segment.end()], true);
                into.take(&gap);
            }
            Part::Interior => turned.interior(segment, &facing, self.slots, into)?,
        }
        Some(())
    }
}

/// A body's frame in space, and where the segment starts along the surface.
struct Turned<'a> {
    current: &'a dyn Fn([f64; 2]) -> [f64; 2],
    rotation: f64,
    start: f64,
}

impl Turned<'_> {
    fn interior(
        &self,
        segment: &RigidSegment,
        facing: &Facing,
        slots: &[usize; 3],
        into: &mut Meeting,
    ) -> Option<()> {
        let xi = facing.parameter;
        match *segment {
            RigidSegment::Line { a, b } => {
                let along = Along::straight(self.start, segment.length(), xi);
                let control = [(self.current)(a), (self.current)(b)];
                let weights = Weights::straight(xi);
                let gap = point_to_curve::<2, 6>(into.position, &control, &weights, &along, xi)?;
                into.attach_body(slots, &[a, b], false);
                into.take(&gap);
            }
            RigidSegment::Arc { start, centre, radius, convex, .. } => {
                let (side, travel) =
                    if convex { (Side::Convex, -1.0) } else { (Side::Concave, 1.0) };
                let begin =
                    travel * radius * (start[1] - centre[1]).atan2(start[0] - centre[0]);
                let reference = begin + 0.5 * segment.length();
                let circle = Circle { radius, side };
                let middle = (self.current)(centre);
                let mut gap = circle.gap(into.position, middle, self.rotation, reference)?;
                gap.along += self.start - begin;
                into.attach_body(slots, &[centre], true);
                into.take(&gap);
            }
            RigidSegment::Parabola { start, mid, end } => {
                let arms = RigidSegment::parabola_control(start, mid, end);
                let weights = Weights::quadratic(xi);
                let speed = |parameter: f64| curve_speed(&arms, parameter);
                let along = Along {
                    value: self.start + segment.arc_length(xi),
                    first: speed(xi).0,
                    second: speed(xi).1,
                };
                let control = arms.map(self.current);
                let gap = point_to_curve::<3, 8>(into.position, &control, &weights, &along, xi)?;
                into.attach_body(slots, &arms, false);
                into.take(&gap);
            }
        }
        Some(())
    }
}

/// |B'| and its derivative of a quadratic Bezier curve.
fn curve_speed(control: &[[f64; 2]; 3], s: f64) -> (f64, f64) {
    let [p, q, r] = *control;
    let first = [0, 1].map(|c| 2.0 * ((1.0 - s) * (q[c] - p[c]) + s * (r[c] - q[c])));
    let second = [0, 1].map(|c| 2.0 * (r[c] - 2.0 * q[c] + p[c]));
    let speed = first[0].hypot(first[1]);
    let bend = first[0] * second[0] + first[1] * second[1];
    (speed, if speed > 0.0 { bend / speed } else { 0.0 })
}

fn meet_chain(
    chain: &Chain,
    nodes: &[(Carried, [usize; 3])],
    positions: &[[f64; 2]],
    into: &mut Meeting,
) -> Option<()> {
    let piece = chain.closest(positions, into.position, None)?;
    let xi = piece.parameter;
    for (carried, slots) in &nodes[piece.nodes()] {
        into.attach(carried, slots);
    }
    let at = |k: usize| positions[piece.nodes().start + k];
    match piece.kind {
        PieceKind::Straight => {
            let length = chain.reference_length(piece.index);
            let along = Along::straight(chain.arc_coordinate(piece.index), length, xi);
            let control = [at(0), at(1)];
            let weights = Weights::straight(xi);
            let gap = point_to_curve::<2, 6>(into.position, &control, &weights, &along, xi)?;
            into.take(&gap);
        }
        PieceKind::Corner => {
            let f = chain.smoothing;
            let cut = [piece.index - 1, piece.index].map(|k| f * chain.reference_length(k));
            let node = chain.arc_coordinate(piece.index);
            let along = Along::corner(node, cut[0], cut[1], xi);
            let control = [at(0), at(1), at(2)];
            let weights = Weights::corner(xi, f);
            let gap = point_to_curve::<3, 8>(into.position, &control, &weights, &along, xi)?;
            into.take(&gap);
        }
    }
    Some(())
}

fn body(model: &Model, layout: &Layout, surface: &RigidSurface) -> Facade {
    let carrier = layout.carrier(surface.reference);
    let origin = model.nodes.plane(carrier);
    let local = |p: [f64; 2]| [p[0] - origin[0], p[1] - origin[1]];
    let mut from = local(surface.start);
    let mut segments = Vec::new();
    let mut starts = Vec::new();
    let mut travelled = 0.0;
    for segment in &surface.segments {
        let placed = match *segment {
            SurfaceSegment::Line { end } => Some(RigidSegment::Line { a: from, b: local(end) }),
            SurfaceSegment::Circle { end, centre } => {
                RigidSegment::arc(from, local(end), local(centre))
            }
            SurfaceSegment::Parabola { middle, end } => Some(RigidSegment::Parabola {
                start: from,
                mid: local(middle),
                end: local(end),
            }),
        };
        if let Some(placed) = placed {
            from = placed.end();
            starts.push(travelled);
            travelled += placed.length();
            segments.push(placed);
        }
    }
    Facade::Body { slots: slots_of(layout, carrier), origin, segments, starts }
}

/// The laws of a pair with lengths filled in.
fn laws(model: &Model, pair: &ContactPair) -> Laws {
    let friction = match &pair.interaction.friction {
        Friction::Frictionless => FrictionLaw::None,
        Friction::Coulomb { coefficient, .. } if *coefficient == 0.0 => FrictionLaw::None,
        Friction::Coulomb { coefficient, limit, decay, stick } => FrictionLaw::Coulomb {
            coefficient: *coefficient,
            limit: *limit,
            decay: decay.map(|decay| Decay { kinetic: decay.kinetic, rate: decay.rate }),
            stick: match stick {
                StickRule::Lagrange => Stick::Lagrange,
                StickRule::ElasticSlip(slip) => Stick::Elastic { slip: *slip },
                StickRule::SlipTolerance(fraction) => {
                    Stick::Elastic { slip: fraction * average(model, pair) }
                }
            },
        },
        Friction::Rough => FrictionLaw::Rough { stick: Stick::Lagrange },
        Friction::User { name, properties, state_size } => FrictionLaw::User {
            name: name.clone(),
            properties: properties.clone(),
            state_size: *state_size,
        },
    };
    Laws { normal: pair.interaction.normal.clone(), friction }
}

fn average(model: &Model, pair: &ContactPair) -> f64 {
    let nodes = pair.slave_nodes();
    let (elements, coordinates) = local_elements(model, pair, &nodes);
    average_length(&elements, &coordinates)
}

/// Contact elements by places among the slave nodes, with their coordinates.
fn local_elements(
    model: &Model,
    pair: &ContactPair,
    nodes: &[NodeIndex],
) -> (Vec<[usize; 2]>, Vec<[f64; 2]>) {
    let place: std::collections::HashMap<_, _> =
        nodes.iter().enumerate().map(|(place, &node)| (node, place)).collect();
    let elements = pair.elements.iter().map(|element| element.nodes.map(|node| place[&node]));
    (elements.collect(), nodes.iter().map(|&node| model.nodes.plane(node)).collect())
}

fn slots_of(layout: &Layout, node: NodeIndex) -> [usize; 3] {
    Dof::PLANE.map(|dof| layout.slot(node, dof).unwrap_or(0))
}

/// Current position of a carried point.
fn place(carried: &Carried, slots: &[usize; 3], u: &[f64]) -> [f64; 2] {
    let dofs = slots.map(|slot| u[slot]);
    let [x, y] = carried.map.displacement(&dofs);
    [carried.reference[0] + x, carried.reference[1] + y]
}
