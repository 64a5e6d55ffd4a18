//! Contact pairs at work: where every slave point stands against its master.
//!
//! ```text
//!   slave point --search--> facing piece --gap--> h, sigma, derivatives
//!        |                        |                     |
//!      carried                 carried            pushed to dofs
//!     by a node               by nodes            (PointMap alone)
//! ```
//!
//! Geometry only; pressures and tractions come from the laws, in
//! [`crate::linearised`] and [`crate::evaluate`].

use crate::layout::{Carried, Layout};
use crate::linearised::MOST_DOFS;
use crate::users::UserFrictions;
use slideline_mech::contact::friction::{Decay, FrictionLaw, Stick};
use slideline_mech::contact::pair::{
    AnyGap, Body, Laws, RigidSurface, StencilAttachments, chain_attachments, chain_gap,
};
use slideline_mech::contact::points::{average_length, tributary_areas};
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::rigid::RigidSegment;
use slideline_mech::rigid::{Attachment, push_forward, push_gradient};
use slideline_model::{
    ContactPair, Dof, Friction, Master, Model, NodeIndex, SlideLine, StickRule, SurfaceSegment,
};

/// The most kernel variables of a point: itself and three control points.
const MOST_VARIABLES: usize = 8;

/// A slave point.
#[derive(Clone, Debug)]
pub struct SlavePoint {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its node.
    pub node: NodeIndex,
    /// Tributary area [L2].
    pub area: f64,
    /// Where its state values of a user friction law begin.
    pub memory: usize,
    /// How many they are.
    pub memory_size: usize,
    carried: Carried,
    slots: [usize; 3],
}

/// A master, ready to be searched.
#[derive(Clone, Debug)]
enum Facade {
    /// A rigid surface on the body of a node.
    Body { slots: [usize; 3], reference: [f64; 2], surface: RigidSurface },
    /// A chain of nodes.
    Line { chain: Chain, nodes: Vec<(Carried, [usize; 3])> },
    /// Nothing to slide on (a master that reading has refused).
    Nothing,
}

/// All contact pairs of a step.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Slave points of all pairs, pair by pair.
    pub points: Vec<SlavePoint>,
    /// Laws, a pair each.
    pub laws: Vec<Laws>,
    /// Number of state values of user friction laws.
    pub memory_size: usize,
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
    attachments: Option<StencilAttachments>,
}

impl Kernel {
    fn attachments(&self) -> &[Attachment] {
        self.attachments.as_ref().map_or(&[], StencilAttachments::as_slice)
    }
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
            attachments: None,
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
        let kernel = &self.kernel;
        for (sum, (h, s)) in
            gradient.iter_mut().zip(kernel.gradient.iter().zip(&kernel.slip_gradient)).take(n)
        {
            *sum = normal * h + tangential * s;
        }
        for (sum, (h, s)) in
            hessian.iter_mut().zip(kernel.hessian.iter().zip(&kernel.slip_hessian)).take(n * n)
        {
            *sum = normal * h + tangential * s;
        }
        let mut force = [0.0; MOST_DOFS];
        tangent[..m * m].fill(0.0);
        push_forward(
            self.kernel.attachments(),
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
    pub fn new(model: &Model, layout: &Layout, users: &UserFrictions) -> Self {
        let mut contact =
            Self { points: Vec::new(), laws: Vec::new(), memory_size: 0, facades: Vec::new() };
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            contact.add_points(model, layout, place, pair);
            contact.laws.push(laws(model, pair, users));
            contact.facades.push(match &pair.master {
                Master::RigidSurface(surface) => body(model, layout, surface),
                Master::SlideLine(line) => chain(model, layout, line),
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
            let (memory, size) = (self.memory_size, memory_size(pair));
            self.memory_size += size;
            self.points.push(SlavePoint {
                pair: place,
                node,
                area,
                memory,
                memory_size: size,
                carried,
                slots,
            });
        }
    }

    /// Sets of slots that may ever couple.
    pub fn cliques(&self) -> Vec<Vec<usize>> {
        let mut cliques = Vec::new();
        for point in &self.points {
            let own = &point.slots[..point.carried.map.width()];
            match &self.facades[point.pair] {
                Facade::Nothing => {}
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
                Facade::Body { .. } | Facade::Nothing => 0,
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
        let slave = into.attach(&point.carried, &point.slots);
        let gap = match &self.facades[point.pair] {
            Facade::Nothing => None,
            Facade::Body { slots, reference, surface } => {
                let body = Body { reference: *reference, dofs: slots.map(|slot| u[slot]) };
                into.meet_body(surface, &body, slots, slave)
            }
            Facade::Line { chain, nodes } => into.meet_chain(chain, nodes, positions, slave),
        };
        match gap {
            Some(gap) => into.take(&gap, u),
            None => into.width = 0,
        }
    }

    /// Length after which the slip coordinate of a pair's master repeats [L].
    pub fn period(&self, pair: usize) -> Option<f64> {
        match &self.facades[pair] {
            Facade::Body { surface, .. } => surface.period(),
            _ => None,
        }
    }
}

impl Meeting {
    /// Adds a carried point's slots to the stencil.
    fn attach(&mut self, carried: &Carried, slots: &[usize; 3]) -> Attachment {
        let first = self.width;
        for &slot in &slots[..carried.map.width()] {
            self.slots[self.width] = slot;
            self.width += 1;
        }
        Attachment::Point { map: carried.map, first }
    }

    fn meet_body(
        &mut self,
        surface: &RigidSurface,
        body: &Body,
        slots: &[usize; 3],
        slave: Attachment,
    ) -> Option<AnyGap> {
        let facing = surface.closest(body, self.position, None)?;
        let gap = surface.gap(body, &facing, self.position)?;
        let first = self.width;
        self.kernel.attachments = surface.attachments(body, &facing, slave, first);
        self.slots[first..first + 3].copy_from_slice(slots);
        self.width += 3;
        Some(gap)
    }

    fn meet_chain(
        &mut self,
        chain: &Chain,
        nodes: &[(Carried, [usize; 3])],
        positions: &[[f64; 2]],
        slave: Attachment,
    ) -> Option<AnyGap> {
        let piece = chain.closest(positions, self.position, None)?;
        let gap = chain_gap(chain, &piece, positions, self.position)?;
        let mut control = [slave; 3];
        let facing = &nodes[piece.nodes()];
        for (attachment, (carried, slots)) in control.iter_mut().zip(facing) {
            *attachment = self.attach(carried, slots);
        }
        self.kernel.attachments = Some(chain_attachments(slave, &control[..facing.len()]));
        Some(gap)
    }

    /// Takes a gap in and pushes its gradients from kernel variables to slots.
    fn take(&mut self, gap: &AnyGap, u: &[f64]) {
        self.faces = true;
        self.overclosure = gap.overclosure();
        self.along = gap.along();
        self.normal = gap.normal();
        let (m, n) = (self.width, gap.width());
        let from = gap.derivatives();
        let kernel = &mut self.kernel;
        kernel.variables = n;
        kernel.gradient[..n].copy_from_slice(from.gradient);
        kernel.slip_gradient[..n].copy_from_slice(from.slip_gradient);
        kernel.hessian[..n * n].copy_from_slice(from.hessian);
        kernel.slip_hessian[..n * n].copy_from_slice(from.slip_hessian);
        let mut dofs = [0.0; MOST_DOFS];
        for (dof, &slot) in dofs.iter_mut().zip(&self.slots[..m]) {
            *dof = u[slot];
        }
        self.gradient[..m].fill(0.0);
        self.slip_gradient[..m].fill(0.0);
        let attachments = self.kernel.attachments();
        push_gradient(attachments, &dofs[..m], from.gradient, &mut self.gradient[..m]);
        push_gradient(attachments, &dofs[..m], from.slip_gradient, &mut self.slip_gradient[..m]);
    }
}

fn chain(model: &Model, layout: &Layout, line: &SlideLine) -> Facade {
    let reference: Vec<_> = line.nodes.iter().map(|&node| model.nodes.plane(node)).collect();
    let nodes = line.nodes.iter().map(|&node| {
        let carried = layout.carried_node(model, node);
        (carried, slots_of(layout, carried.node))
    });
    match Chain::new(&reference, line.smooth, line.extension) {
        Some(chain) => Facade::Line { chain, nodes: nodes.collect() },
        None => Facade::Nothing,
    }
}

fn body(model: &Model, layout: &Layout, surface: &slideline_model::RigidSurface) -> Facade {
    let carrier = layout.carrier(surface.reference);
    let mut from = surface.start;
    let mut segments = Vec::with_capacity(surface.segments.len());
    for segment in &surface.segments {
        let placed = match *segment {
            SurfaceSegment::Line { end } => Some(RigidSegment::Line { a: from, b: end }),
            SurfaceSegment::Circle { end, centre } => RigidSegment::arc(from, end, centre),
            SurfaceSegment::Parabola { middle, end } => {
                Some(RigidSegment::Parabola { start: from, mid: middle, end })
            }
        };
        let Some(placed) = placed else { return Facade::Nothing };
        from = placed.end();
        segments.push(placed);
    }
    Facade::Body {
        slots: slots_of(layout, carrier),
        reference: model.nodes.plane(carrier),
        surface: RigidSurface::new(segments),
    }
}

/// State values a point of the pair keeps for a user friction law.
pub fn memory_size(pair: &ContactPair) -> usize {
    match &pair.interaction.friction {
        Friction::User { state_size, .. } => *state_size,
        _ => 0,
    }
}

/// The laws of a pair with lengths filled in.
fn laws(model: &Model, pair: &ContactPair, users: &UserFrictions) -> Laws {
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
    let onset = model.friction_onset;
    let user = match &pair.interaction.friction {
        Friction::User { name, .. } => users.find(name),
        _ => None,
    };
    Laws { normal: pair.interaction.normal.clone(), friction, onset, user }
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
