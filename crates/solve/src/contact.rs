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
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::contact::pair::{
    self, AnyGap, Body, History, Laws, RigidSurface, StencilAttachments, chain_attachments,
    chain_gap,
};
use slideline_mech::contact::points::stations::{GAUSS, HermiteLine, POINTS, closed_part_between};
use slideline_mech::contact::points::{average_length, tributary_areas};
use slideline_mech::contact::search::chain::Chain;
use slideline_mech::contact::search::rigid::RigidSegment;
use slideline_mech::rigid::{Attachment, push_forward, push_gradients};
use slideline_model::{
    ContactPair, Dof, ElementBlock, Formulation, Friction, Master, Model, NodeIndex, SlideLine,
    StickRule, SurfaceSegment,
};
use std::collections::HashMap;

/// The most kernel variables of a point: itself and three control points.
const MOST_VARIABLES: usize = 8;
/// Cells of a slave element along which contact is integrated.
pub const CELLS: usize = 8;

/// A slave point.
#[derive(Clone, Debug)]
pub struct SlavePoint {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its node; of a station the nearer one.
    pub node: NodeIndex,
    /// Tributary area [L2]; of a station, with its whole cell closed.
    pub area: f64,
    /// Where its state values of a user friction law begin.
    pub memory: usize,
    /// How many they are.
    pub memory_size: usize,
    /// How it is carried.
    carrier: Carrier,
}

impl SlavePoint {
    /// Whether it is a station of integrated contact.
    pub fn is_station(&self) -> bool {
        matches!(self.carrier, Carrier::Station { .. })
    }
}

#[derive(Clone, Debug)]
enum Carrier {
    /// A node, free or on a rigid body.
    Node { carried: Carried, slots: [usize; 3] },
    /// A Gauss point of a cell of a strip.
    Station { strip: usize },
}

/// A slave element along which contact is integrated.
#[derive(Clone, Debug)]
pub struct Strip {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its nodes.
    pub nodes: [NodeIndex; 2],
    /// Its smooth line.
    line: HermiteLine,
    slots: [usize; 6],
    /// Out-of-plane width [L].
    width: f64,
    /// Its first point; cell by cell, Gauss point by Gauss point.
    pub first: usize,
}

/// Points of a strip.
pub const STRIP_POINTS: usize = CELLS * POINTS;

/// A master, ready to be searched.
#[derive(Clone, Debug)]
enum Facade {
    /// A rigid surface on the body of a node.
    Body { slots: [usize; 3], reference: [f64; 2], surface: RigidSurface },
    /// A chain of nodes, and where its positions begin in the scratch.
    Line { chain: Chain, nodes: Vec<(Carried, [usize; 3])>, offset: usize },
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
    /// Elements along which contact is integrated.
    pub strips: Vec<Strip>,
    /// Number of state values of user friction laws.
    pub memory_size: usize,
    facades: Vec<Facade>,
    chain_nodes: usize,
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
    /// Area it stands for [L2].
    pub area: f64,
    /// Where a station stands on its element, 0 to 1.
    pub xi: f64,
    /// Number of slots it couples.
    pub width: usize,
    /// Those slots.
    pub slots: [usize; MOST_DOFS],
    /// dh/du of each slot [1].
    pub gradient: [f64; MOST_DOFS],
    /// d sigma/du of each slot [1].
    pub slip_gradient: [f64; MOST_DOFS],
    /// Direction of the tangential force on each slot [1].
    pub drag: [f64; MOST_DOFS],
}

/// The dofs that a point and what it faces depend on.
struct Stencil {
    position: [f64; 2],
    width: usize,
    slots: [usize; MOST_DOFS],
    attachments: Option<StencilAttachments>,
}

impl Meeting {
    /// A point that faces nothing.
    pub const NOWHERE: Self = Self {
        faces: false,
        overclosure: f64::NEG_INFINITY,
        along: 0.0,
        normal: [0.0; 2],
        position: [0.0; 2],
        area: 0.0,
        xi: 0.0,
        width: 0,
        slots: [0; MOST_DOFS],
        gradient: [0.0; MOST_DOFS],
        slip_gradient: [0.0; MOST_DOFS],
        drag: [0.0; MOST_DOFS],
    };
}

impl Contact {
    /// Prepares the pairs of a model.
    pub fn new(model: &Model, layout: &Layout, users: &UserFrictions) -> Self {
        let mut contact = Self {
            points: Vec::new(),
            laws: Vec::new(),
            strips: Vec::new(),
            memory_size: 0,
            facades: Vec::new(),
            chain_nodes: 0,
        };
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            match pair.formulation {
                Formulation::NodeToSurface => contact.add_nodes(model, layout, place, pair),
                Formulation::SurfaceToSurface => contact.add_strips(model, layout, place, pair),
            }
            contact.laws.push(laws(model, pair, users));
            let facade = match &pair.master {
                Master::RigidSurface(surface) => body(model, layout, surface),
                Master::SlideLine(line) => chain(model, layout, line, contact.chain_nodes),
            };
            if let Facade::Line { nodes, .. } = &facade {
                contact.chain_nodes += nodes.len();
            }
            contact.facades.push(facade);
        }
        contact
    }

    fn add_nodes(&mut self, model: &Model, layout: &Layout, place: usize, pair: &ContactPair) {
        let nodes = pair.slave_nodes();
        let (elements, coordinates) = local_elements(model, pair, &nodes);
        let width = pair.interaction.width;
        let areas = tributary_areas(nodes.len(), &elements, &coordinates, width);
        for (&node, area) in nodes.iter().zip(areas) {
            let carried = layout.carried_node(model, node);
            let slots = slots_of(layout, carried.node);
            self.add_point(place, pair, (node, area), Carrier::Node { carried, slots });
        }
    }

    fn add_point(
        &mut self,
        pair_place: usize,
        pair: &ContactPair,
        (node, area): (NodeIndex, f64),
        carrier: Carrier,
    ) {
        let (memory, memory_size) = (self.memory_size, memory_size(pair));
        self.memory_size += memory_size;
        let point = SlavePoint { pair: pair_place, node, area, memory, memory_size, carrier };
        self.points.push(point);
    }

    fn add_strips(&mut self, model: &Model, layout: &Layout, place: usize, pair: &ContactPair) {
        let tangents = node_tangents(model, pair);
        for element in &pair.elements {
            let nodes = element.nodes.map(|node| model.nodes.plane(node));
            let length = (nodes[1][0] - nodes[0][0]).hypot(nodes[1][1] - nodes[0][1]);
            let tangents = element.nodes.map(|node| tangents[&node].map(|t| t * length));
            let [a, b] = element.nodes.map(|node| slots_of(layout, node));
            let strip = self.strips.len();
            let first = self.points.len();
            let width = pair.interaction.width;
            for cell in 0..CELLS {
                for (_, weight) in GAUSS {
                    let area = width * length * weight / CELLS as f64;
                    let node = element.nodes[usize::from(2 * cell >= CELLS)];
                    self.add_point(place, pair, (node, area), Carrier::Station { strip });
                }
            }
            self.strips.push(Strip {
                pair: place,
                nodes: element.nodes,
                line: HermiteLine { nodes, tangents },
                slots: [a[0], a[1], a[2], b[0], b[1], b[2]],
                width,
                first,
            });
        }
    }

    /// Sets of slots that may ever couple.
    pub fn cliques(&self) -> Vec<Vec<usize>> {
        let mut cliques = Vec::new();
        for strip in &self.strips {
            if let Facade::Body { slots, .. } = &self.facades[strip.pair] {
                cliques.push([&strip.slots[..], slots].concat());
            }
        }
        for point in &self.points {
            let Carrier::Node { carried, slots } = &point.carrier else { continue };
            let own = &slots[..carried.map.width()];
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

    /// Number of chain positions of all pairs, for the scratch.
    pub fn chain_nodes(&self) -> usize {
        self.chain_nodes
    }

    /// Where every point stands at displacements `u`. `positions` is scratch.
    pub fn meet(&self, u: &[f64], positions: &mut Vec<[f64; 2]>, into: &mut [Meeting]) {
        self.place_chains(u, positions);
        for (place, point) in self.points.iter().enumerate() {
            if !point.is_station() {
                into[place].area = point.area;
                self.meet_one(point, u, positions, &mut into[place]);
            }
        }
        for strip in &self.strips {
            self.meet_strip(strip, u, &mut into[strip.first..][..STRIP_POINTS]);
        }
    }

    /// As [`Contact::meet`], with stations left where they stand on their
    /// elements.
    pub fn meet_in_place(&self, u: &[f64], positions: &mut Vec<[f64; 2]>, into: &mut [Meeting]) {
        self.place_chains(u, positions);
        for (point, meeting) in self.points.iter().zip(into) {
            if meeting.faces || !point.is_station() {
                self.meet_one(point, u, positions, meeting);
            }
        }
    }

    fn place_chains(&self, u: &[f64], positions: &mut Vec<[f64; 2]>) {
        positions.clear();
        for facade in &self.facades {
            if let Facade::Line { nodes, .. } = facade {
                positions.extend(nodes.iter().map(|(node, slots)| place(node, slots, u)));
            }
        }
    }

    fn meet_one(&self, point: &SlavePoint, u: &[f64], positions: &[[f64; 2]], into: &mut Meeting) {
        let mut stencil = self.slave(point, into.xi, u);
        into.position = stencil.position;
        match self.face(point, into.xi, u, positions, &mut stencil) {
            Some(gap) => into.take(&gap, &stencil, u),
            None => {
                into.faces = false;
                into.overclosure = f64::NEG_INFINITY;
                into.width = 0;
            }
        }
    }

    /// Stations follow the closed part of their cells; those of cells that
    /// contact cannot reach in an iteration face nothing.
    fn meet_strip(&self, strip: &Strip, u: &[f64], into: &mut [Meeting]) {
        into.iter_mut().for_each(Meeting::turn_away);
        let begins = self.laws[strip.pair].normal.contact_begins();
        let Facade::Body { slots, reference, surface } = &self.facades[strip.pair] else { return };
        let body = Body { reference: *reference, dofs: slots.map(|slot| u[slot]) };
        let bent = strip.line.bent(&strip.slots.map(|slot| u[slot]));
        let beyond = |xi: f64| {
            let overclosure = surface.overclosure(&body, bent.position(xi));
            overclosure.unwrap_or(f64::NEG_INFINITY) - begins
        };
        let length = strip.line.length();
        if top_of_parabola([beyond(0.0), beyond(0.5), beyond(1.0)]) < -NEAR * length {
            return;
        }
        for cell in 0..CELLS {
            let at = |t: f64| (cell as f64 + t) / CELLS as f64;
            let ends = [beyond(at(0.0)), beyond(at(0.5)), beyond(at(1.0))];
            if top_of_parabola(ends) < -NEAR * length {
                continue;
            }
            let part = closed_part_between(|t| beyond(at(t)), ends);
            let (begin, end) = part.unwrap_or((0.0, 1.0));
            for (k, (t, weight)) in GAUSS.into_iter().enumerate() {
                let meeting = &mut into[cell * POINTS + k];
                meeting.xi = at(begin + t * (end - begin));
                meeting.area = strip.width * length * weight * (end - begin) / CELLS as f64;
                let point = &self.points[strip.first + cell * POINTS + k];
                self.meet_one(point, u, &[], meeting);
            }
        }
    }

    /// The slave's part of a stencil.
    fn slave(&self, point: &SlavePoint, xi: f64, u: &[f64]) -> Stencil {
        let mut stencil =
            Stencil { position: [0.0; 2], width: 0, slots: [0; MOST_DOFS], attachments: None };
        match &point.carrier {
            Carrier::Node { carried, slots } => {
                stencil.position = place(carried, slots, u);
                stencil.add(&slots[..carried.map.width()]);
            }
            Carrier::Station { strip } => {
                let strip = &self.strips[*strip];
                stencil.position = strip.position(xi, u);
                stencil.add(&strip.slots);
            }
        }
        stencil
    }

    fn attachment(&self, point: &SlavePoint, xi: f64) -> Attachment {
        match &point.carrier {
            Carrier::Node { carried, .. } => Attachment::Point { map: carried.map, first: 0 },
            Carrier::Station { strip } => {
                Attachment::Blend { blend: self.strips[*strip].line.blend(xi), firsts: [0, 3] }
            }
        }
    }

    /// What the point of a stencil faces; the master's part is added to it.
    fn face(
        &self,
        point: &SlavePoint,
        xi: f64,
        u: &[f64],
        positions: &[[f64; 2]],
        stencil: &mut Stencil,
    ) -> Option<AnyGap> {
        match &self.facades[point.pair] {
            Facade::Nothing => None,
            Facade::Body { slots, reference, surface } => {
                let body = Body { reference: *reference, dofs: slots.map(|slot| u[slot]) };
                let facing = surface.closest(&body, stencil.position, None)?;
                let gap = surface.gap(&body, &facing, stencil.position)?;
                let slave = self.attachment(point, xi);
                let first = stencil.width;
                stencil.attachments = surface.attachments(&body, &facing, slave, first);
                stencil.add(slots);
                Some(gap)
            }
            Facade::Line { chain, nodes, offset } => {
                let positions = positions.get(*offset..offset + nodes.len())?;
                let piece = chain.closest(positions, stencil.position, None)?;
                let gap = chain_gap(chain, &piece, positions, stencil.position)?;
                let slave = self.attachment(point, 0.0);
                let mut control = [slave; 3];
                let facing = &nodes[piece.nodes()];
                for (attachment, (carried, slots)) in control.iter_mut().zip(facing) {
                    let first = stencil.width;
                    *attachment = Attachment::Point { map: carried.map, first };
                    stencil.add(&slots[..carried.map.width()]);
                }
                stencil.attachments = Some(chain_attachments(slave, &control[..facing.len()]));
                Some(gap)
            }
        }
    }

    /// Tangent of the geometry of a point, normal * D dh + tangential *
    /// D drag, with `normal` and `tangential` forces [F]; row-major, as wide
    /// as the meeting.
    pub fn geometric_tangent(
        &self,
        place: usize,
        u: &[f64],
        meeting: &Meeting,
        (normal, tangential): (f64, f64),
        scratch: &mut GeometryScratch,
    ) {
        let point = &self.points[place];
        let mut stencil = self.slave(point, meeting.xi, u);
        let m = meeting.width;
        scratch.tangent[..m * m].fill(0.0);
        let Some(gap) = self.face(point, meeting.xi, u, &scratch.positions, &mut stencil) else {
            return;
        };
        let (from, n) = (gap.derivatives(), gap.width());
        let mut gradient = [0.0; MOST_VARIABLES];
        let mut hessian = [0.0; MOST_VARIABLES * MOST_VARIABLES];
        let sum = |h: &f64, s: &f64| normal * h + tangential * s;
        for (into, (h, s)) in gradient.iter_mut().zip(from.gradient.iter().zip(from.drag)) {
            *into = sum(h, s);
        }
        for (into, (h, s)) in hessian.iter_mut().zip(from.hessian.iter().zip(from.drag_derivative))
        {
            *into = sum(h, s);
        }
        let mut force = [0.0; MOST_DOFS];
        let attachments = stencil.attachments();
        let dofs = stencil.dofs(u);
        push_forward(
            attachments,
            &dofs[..m],
            &gradient[..n],
            &hessian[..n * n],
            &mut force[..m],
            &mut scratch.tangent[..m * m],
        );
    }

    /// Positions of all chains at displacements `u`.
    pub fn fill_scratch(&self, u: &[f64], scratch: &mut GeometryScratch) {
        self.place_chains(u, &mut scratch.positions);
    }

    /// Change of the slip coordinate of a point since its commit [L]; zero
    /// where it faced nothing then or faces nothing now. A station compares
    /// the same material place in both configurations.
    pub fn slip(
        &self,
        place: usize,
        history: &History,
        meeting: &Meeting,
        committed: &[f64],
    ) -> f64 {
        let point = &self.points[place];
        if !meeting.faces {
            return 0.0;
        }
        let period = match &self.facades[point.pair] {
            Facade::Body { surface, .. } => surface.period(),
            _ => None,
        };
        if !point.is_station() {
            return pair::slip(history, meeting.along, period);
        }
        let mut stencil = self.slave(point, meeting.xi, committed);
        let before = self.face(point, meeting.xi, committed, &[], &mut stencil);
        let along = before.map(|gap| gap.along());
        pair::slip(&History { along, ..*history }, meeting.along, period)
    }
}

/// How far beyond the reach of contact a cell is looked at, in lengths of its
/// element: what an iteration may move it.
const NEAR: f64 = 0.1;

/// Largest value on [0, 1] of the parabola through values at 0, 1/2 and 1.
fn top_of_parabola([left, middle, right]: [f64; 3]) -> f64 {
    let largest = left.max(middle).max(right);
    let bend = left - 2.0 * middle + right;
    let slope = right - left;
    if bend.is_nan() || bend >= 0.0 || slope.abs() >= -2.0 * bend {
        return largest;
    }
    middle - slope * slope / (8.0 * bend)
}

/// Scratch of [`Contact::geometric_tangent`].
#[derive(Clone, Debug)]
pub struct GeometryScratch {
    /// The tangent, row-major.
    pub tangent: [f64; MOST_DOFS * MOST_DOFS],
    positions: Vec<[f64; 2]>,
}

impl GeometryScratch {
    /// Room for the chains of a plan.
    pub fn new(contact: &Contact) -> Self {
        let positions = Vec::with_capacity(contact.chain_nodes());
        Self { tangent: [0.0; MOST_DOFS * MOST_DOFS], positions }
    }
}

impl Strip {
    /// Current position of the station at `xi` [L].
    fn position(&self, xi: f64, u: &[f64]) -> [f64; 2] {
        self.line.bent(&self.slots.map(|slot| u[slot])).position(xi)
    }
}

impl Stencil {
    fn add(&mut self, slots: &[usize]) {
        self.slots[self.width..][..slots.len()].copy_from_slice(slots);
        self.width += slots.len();
    }

    fn attachments(&self) -> &[Attachment] {
        self.attachments.as_ref().map_or(&[], StencilAttachments::as_slice)
    }

    fn dofs(&self, u: &[f64]) -> [f64; MOST_DOFS] {
        let mut dofs = [0.0; MOST_DOFS];
        for (dof, &slot) in dofs.iter_mut().zip(&self.slots[..self.width]) {
            *dof = u[slot];
        }
        dofs
    }
}

impl Meeting {
    /// The point faces nothing and stands for nothing.
    fn turn_away(&mut self) {
        self.faces = false;
        self.overclosure = f64::NEG_INFINITY;
        self.width = 0;
        self.area = 0.0;
    }

    /// Takes a gap in and pushes its gradients from kernel variables to slots.
    fn take(&mut self, gap: &AnyGap, stencil: &Stencil, u: &[f64]) {
        self.faces = true;
        self.overclosure = gap.overclosure();
        self.along = gap.along();
        self.normal = gap.normal();
        let m = stencil.width;
        self.width = m;
        self.slots[..m].copy_from_slice(&stencil.slots[..m]);
        self.gradient[..m].fill(0.0);
        self.slip_gradient[..m].fill(0.0);
        self.drag[..m].fill(0.0);
        let (from, dofs) = (gap.derivatives(), stencil.dofs(u));
        let attachments = stencil.attachments();
        push_gradients(
            attachments,
            &dofs[..m],
            [from.gradient, from.slip_gradient, from.drag],
            [&mut self.gradient[..m], &mut self.slip_gradient[..m], &mut self.drag[..m]],
        );
    }
}

/// Unit tangents of a slave surface at its nodes: the mean direction of the
/// elements that meet there, so that the surface has no corners.
fn node_tangents(model: &Model, pair: &ContactPair) -> HashMap<NodeIndex, [f64; 2]> {
    let mut tangents: HashMap<NodeIndex, [f64; 2]> = HashMap::new();
    for element in &pair.elements {
        let [a, b] = element.nodes.map(|node| model.nodes.plane(node));
        let d = [b[0] - a[0], b[1] - a[1]];
        let length = d[0].hypot(d[1]);
        for node in element.nodes {
            let sum = tangents.entry(node).or_default();
            *sum = [sum[0] + d[0] / length, sum[1] + d[1] / length];
        }
    }
    for tangent in tangents.values_mut() {
        let size = tangent[0].hypot(tangent[1]);
        if size > 0.0 {
            *tangent = tangent.map(|t| t / size);
        }
    }
    tangents
}

fn chain(model: &Model, layout: &Layout, line: &SlideLine, offset: usize) -> Facade {
    let reference: Vec<_> = line.nodes.iter().map(|&node| model.nodes.plane(node)).collect();
    let nodes = line.nodes.iter().map(|&node| {
        let carried = layout.carried_node(model, node);
        (carried, slots_of(layout, carried.node))
    });
    match Chain::new(&reference, line.smooth, line.extension) {
        Some(chain) => Facade::Line { chain, nodes: nodes.collect(), offset },
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

/// Number of contact points of a pair.
pub fn point_count(pair: &ContactPair) -> usize {
    match pair.formulation {
        Formulation::NodeToSurface => pair.slave_nodes().len(),
        Formulation::SurfaceToSurface => pair.elements.len() * STRIP_POINTS,
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
    let integrated = pair.formulation == Formulation::SurfaceToSurface;
    let elastic = |fraction: f64| Stick::Elastic { slip: fraction * average(model, pair) };
    let friction = match &pair.interaction.friction {
        Friction::Frictionless => FrictionLaw::None,
        Friction::Coulomb { coefficient, .. } if *coefficient == 0.0 => FrictionLaw::None,
        Friction::Coulomb { coefficient, limit, decay, stick } => FrictionLaw::Coulomb {
            coefficient: *coefficient,
            limit: *limit,
            decay: decay.map(|decay| Decay { kinetic: decay.kinetic, rate: decay.rate }),
            stick: match stick {
                // Exact stick at every station would fix more than the nodes can follow.
                StickRule::Lagrange if integrated => elastic(0.005),
                StickRule::Lagrange => Stick::Lagrange,
                StickRule::ElasticSlip(slip) => Stick::Elastic { slip: *slip },
                StickRule::SlipTolerance(fraction) => elastic(*fraction),
            },
        },
        Friction::Rough if integrated => FrictionLaw::Rough { stick: elastic(0.005) },
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
    let normal = match &pair.interaction.normal {
        NormalLaw::Hard if integrated => {
            NormalLaw::Linear { stiffness: PENALTY * stiffest_face(model, pair) }
        }
        other => other.clone(),
    };
    Laws { normal, friction, onset, user }
}

/// Stiffness of an integrated hard contact, in multiples of the stiffest
/// slave element's own, per area.
const PENALTY: f64 = 10.0;

/// Largest EA/l of the beams, per area of a contact element [F/L3].
fn stiffest_face(model: &Model, pair: &ContactPair) -> f64 {
    let length = average(model, pair);
    let axial = |block: &ElementBlock| match block {
        ElementBlock::B21(block) | ElementBlock::B22(block) | ElementBlock::B23(block) => {
            block.section.material.modulus * block.section.width * block.section.height
        }
        ElementBlock::Spring(_) => 0.0,
    };
    let largest = model.blocks.iter().map(axial).fold(0.0, f64::max);
    largest / (length * length * pair.interaction.width)
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
