//! Contact pairs at work: where every slave point stands against its master.
//!
//! ```text
//!   slave point --search--> facing piece --gap--> h, sigma, derivatives
//!        |                        |                     |
//!     of a node               of nodes           pushed to dofs
//! ```
//!
//! Geometry only; pressures and tractions come from the laws, in
//! [`crate::linearised`] and [`crate::evaluate`].

mod candidates;
mod cliques;
mod crossing;
mod idle;
mod kinematics;
mod laws;
mod master;
mod positions;
mod segment;
mod shear;
mod values;

pub use candidates::{Candidates, coupled_parts};
pub use cliques::Cliques;
pub use crossing::{Missed, Sweep, SweepScratch};
pub use idle::Look;
pub use kinematics::{ContactKinematics, GeometryScratch};
pub use laws::{average as average_element, state_size};
pub use master::placed;
pub use positions::MasterPositions;
pub use segment::{SEGMENT_POINTS, SlaveSegment};

use crate::dofs::DofMap;
use crate::linearised::MOST_DOFS;
use crate::state::PointState;
use crate::users::UserFrictions;
use kinematics::{MOST_DIRECT, Stencil};
use master::MasterSurface;
use slideline_mech::contact::pair::{self, AnyGap, History, Laws};
use slideline_mech::contact::points::tributary_areas;
use slideline_mech::rigid::{Attachment, PointMap, push_forward};
use slideline_model::{ContactPair, Dof, Formulation, Master, Model, NodeIndex};
use std::collections::{HashMap, HashSet};

/// The most kernel variables of a point: itself and three control points.
const MOST_VARIABLES: usize = 8;

/// A slave point.
#[derive(Clone, Debug)]
pub struct SlavePoint {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its node; of a integration_point the nearer one.
    pub node: NodeIndex,
    /// Tributary area [L2]; of a integration_point, with its whole cell closed.
    pub area: f64,
    /// Where its state values of a user friction law begin.
    pub state_variables: usize,
    /// How many they are.
    pub state_size: usize,
    /// How it is carried.
    carrier: Carrier,
}

impl SlavePoint {
    /// Whether it is a integration_point of integrated contact.
    pub fn is_integration_point(&self) -> bool {
        matches!(self.carrier, Carrier::IntegrationPoint { .. })
    }
}

#[derive(Clone, Debug)]
enum Carrier {
    /// A node, free or on a rigid body.
    Node { position: [f64; 2], dofs: [usize; 2] },
    /// A Gauss point of a cell of a segment.
    IntegrationPoint { segment: usize },
}

/// All contact pairs of a model.
#[derive(Clone, Debug, Default)]
pub struct Contact {
    /// Slave points of all pairs, pair by pair.
    pub points: Vec<SlavePoint>,
    /// Slave nodes, a list a pair.
    pub slave_nodes: Vec<Vec<NodeIndex>>,
    /// Laws, a pair each.
    pub laws: Vec<Laws>,
    /// Elements along which contact is integrated.
    pub segments: Vec<SlaveSegment>,
    /// Number of state values of user friction laws.
    pub state_size: usize,
    masters: Vec<MasterSurface>,
    /// Distance of neighbouring slave points, a pair each [L].
    spacing: Vec<f64>,
    /// Slave points that contact elements join, a list a pair.
    edges: Vec<Vec<[usize; 2]>>,
    /// Pairs with rigid masters that share slave nodes.
    opposed: Vec<[usize; 2]>,
    chain_nodes: usize,
    /// Tangents of a slave surface at its nodes, as scratch [1].
    tangents: Vec<[f64; 2]>,
}

impl Contact {
    /// Prepares the pairs of a model.
    pub fn new(model: &Model, dofs: &DofMap, users: &UserFrictions) -> Self {
        let mut contact = Self {
            points: Vec::new(),
            slave_nodes: model.contact_pairs.iter().map(ContactPair::slave_nodes).collect(),
            laws: Vec::new(),
            segments: Vec::new(),
            state_size: 0,
            masters: Vec::new(),
            spacing: Vec::new(),
            edges: Vec::new(),
            opposed: Vec::new(),
            chain_nodes: 0,
            tangents: Vec::new(),
        };
        for (place, pair) in model.contact_pairs.iter().enumerate() {
            contact.edges.push(Vec::new());
            match pair.formulation {
                Formulation::NodeToSurface => contact.add_nodes(model, dofs, place, pair),
                Formulation::SurfaceToSurface => contact.add_segments(model, dofs, place, pair),
            }
            let length = laws::average(model, pair);
            contact.laws.push(laws::laws(model, pair, length, users));
            let master = match &pair.master {
                Master::RigidSurface(surface) => MasterSurface::body(model, dofs, surface),
                Master::SlideLine(line) => {
                    MasterSurface::chain(model, dofs, line, contact.chain_nodes)
                }
            };
            if let MasterSurface::Line { nodes, .. } = &master {
                contact.chain_nodes += nodes.len();
            }
            contact.spacing.push(laws::spacing(model, length, &master));
            contact.masters.push(master);
        }
        contact.opposed = contact.opposed_pairs();
        contact
    }

    /// Pairs with rigid masters that share slave nodes.
    fn opposed_pairs(&self) -> Vec<[usize; 2]> {
        let rigid = |pair: &usize| matches!(self.masters[*pair], MasterSurface::Body { .. });
        let pairs: Vec<usize> = (0..self.masters.len()).filter(rigid).collect();
        let mut opposed = Vec::new();
        for (k, &first) in pairs.iter().enumerate() {
            let own: HashSet<_> = self.slave_nodes[first].iter().collect();
            let shares =
                |second: &&usize| self.slave_nodes[**second].iter().any(|node| own.contains(node));
            opposed.extend(pairs[k + 1..].iter().filter(shares).map(|&second| [first, second]));
        }
        opposed
    }

    fn add_nodes(&mut self, model: &Model, dofs: &DofMap, place: usize, pair: &ContactPair) {
        let nodes = self.slave_nodes[place].clone();
        let (elements, coordinates) = local_elements(model, pair, &nodes);
        let first = self.points.len();
        self.edges[place] = elements.iter().map(|own| own.map(|node| first + node)).collect();
        let width = pair.interaction.width;
        let shares: Vec<_> = pair.elements.iter().map(|e| e.lumping.shares()).collect();
        let areas = tributary_areas(&elements, &shares, &coordinates, width);
        self.points.reserve(nodes.len());
        for (&node, area) in nodes.iter().zip(areas) {
            let (position, dofs) = (model.nodes.plane(node), translations(dofs, node));
            self.add_point(place, pair, (node, area), Carrier::Node { position, dofs });
        }
    }

    fn add_point(
        &mut self,
        pair_place: usize,
        pair: &ContactPair,
        (node, area): (NodeIndex, f64),
        carrier: Carrier,
    ) {
        let (state_variables, state_size) = (self.state_size, state_size(pair));
        self.state_size += state_size;
        let point =
            SlavePoint { pair: pair_place, node, area, state_variables, state_size, carrier };
        self.points.push(point);
    }

    /// Where every point stands at displacements `u`. `positions` is scratch.
    /// Points that `idle` names are left as they are.
    pub fn meet(
        &self,
        u: &[f64],
        idle: &[bool],
        positions: &mut MasterPositions,
        into: &mut [ContactKinematics],
    ) {
        self.place_chains(u, positions);
        for (place, point) in self.points.iter().enumerate() {
            let is_idle = idle.get(place).is_some_and(|&idle| idle);
            if !is_idle && !point.is_integration_point() {
                into[place].area = point.area;
                self.meet_one(point, u, positions, &mut into[place]);
            }
        }
        for segment in &self.segments {
            self.meet_segment(segment, u, &mut into[segment.first..][..SEGMENT_POINTS]);
        }
    }

    /// As [`Contact::meet`], with integration_points left where they stand on their
    /// elements.
    pub fn meet_in_place(
        &self,
        u: &[f64],
        positions: &mut MasterPositions,
        into: &mut [ContactKinematics],
    ) {
        self.place_chains(u, positions);
        for (point, kinematics) in self.points.iter().zip(into) {
            if kinematics.faces || !point.is_integration_point() {
                self.meet_one(point, u, positions, kinematics);
            }
        }
    }

    /// Where the points that `idle` names stand at displacements `u`, for which
    /// the chains are placed already.
    pub fn meet_idle(
        &self,
        u: &[f64],
        idle: &[bool],
        positions: &MasterPositions,
        into: &mut [ContactKinematics],
    ) {
        for (place, point) in self.points.iter().enumerate() {
            if idle[place] {
                self.meet_one(point, u, positions, &mut into[place]);
            }
        }
    }

    /// Where a point stands at displacements `u`, however far from its
    /// master; a integration_point where its cell, wholly closed, has it.
    pub fn stand(&self, place: usize, u: &[f64], positions: &MasterPositions) -> ContactKinematics {
        let point = &self.points[place];
        let mut kinematics = ContactKinematics { area: point.area, ..ContactKinematics::NOWHERE };
        if let Carrier::IntegrationPoint { segment } = point.carrier {
            kinematics.xi = SlaveSegment::resting_place(place - self.segments[segment].first);
        }
        self.meet_one(point, u, positions, &mut kinematics);
        kinematics
    }

    /// Whether a point faces nothing because its master ends, and would touch
    /// it, up to a gap of `slack`, were that end prolonged; a integration_point at `xi`
    /// of its element.
    pub fn has_slid_off(&self, place: usize, (xi, slack): (f64, f64), u: &[f64]) -> bool {
        let mut positions = MasterPositions::default();
        self.place_chains(u, &mut positions);
        let point = &self.points[place];
        let mut stencil = self.slave(point, xi, u);
        if self.face(point, xi, u, &positions, &mut stencil).is_some() {
            return false;
        }
        let begins = self.laws[point.pair].normal.contact_begins();
        let beyond = self.masters[point.pair].beyond_end(stencil.position, u, &positions.nodes);
        beyond.is_some_and(|overclosure| overclosure > begins - slack)
    }

    fn meet_one(
        &self,
        point: &SlavePoint,
        u: &[f64],
        positions: &MasterPositions,
        into: &mut ContactKinematics,
    ) {
        self.meet_stencil(point, self.slave(point, into.xi, u), (u, positions), into);
    }

    fn meet_stencil(
        &self,
        point: &SlavePoint,
        mut stencil: Stencil<'_>,
        (u, positions): (&[f64], &MasterPositions),
        into: &mut ContactKinematics,
    ) {
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

    /// The slave's part of a stencil.
    fn slave(&self, point: &SlavePoint, xi: f64, u: &[f64]) -> Stencil<'_> {
        match &point.carrier {
            Carrier::Node { position, dofs } => {
                let mut stencil = Stencil::new(moved(position, dofs, u));
                stencil.add_from(dofs, u);
                stencil
            }
            Carrier::IntegrationPoint { segment } => {
                let segment = &self.segments[*segment];
                segment.stencil(&segment.ends(u), xi)
            }
        }
    }

    fn attachment(&self, point: &SlavePoint, xi: f64) -> Attachment {
        match &point.carrier {
            Carrier::Node { .. } => Attachment::Point { map: PointMap::Free, first: 0 },
            Carrier::IntegrationPoint { segment } => {
                Attachment::Blend { blend: self.segments[*segment].line.blend(xi), firsts: [0, 3] }
            }
        }
    }

    /// What the point of a stencil faces; the master's part is added to it.
    fn face(
        &self,
        point: &SlavePoint,
        xi: f64,
        u: &[f64],
        positions: &MasterPositions,
        stencil: &mut Stencil<'_>,
    ) -> Option<AnyGap> {
        let slave = self.attachment(point, xi);
        let tree = positions.tree(point.pair);
        self.masters[point.pair].face(slave, u, (&positions.nodes, tree), stencil)
    }

    /// Tangent of the geometry of a point, normal * D dh + tangential *
    /// D direction, with `normal` and `tangential` forces [F]; row-major, as wide
    /// as the kinematics.
    pub fn geometric_tangent(
        &self,
        place: usize,
        u: &[f64],
        kinematics: &ContactKinematics,
        (normal, tangential): (f64, f64),
        scratch: &mut GeometryScratch,
    ) {
        let point = &self.points[place];
        let mut stencil = self.slave(point, kinematics.xi, u);
        let m = kinematics.width;
        scratch.tangent[..m * m].fill(0.0);
        let Some(gap) = self.face(point, kinematics.xi, u, &scratch.positions, &mut stencil) else {
            return;
        };
        let (from, n) = (gap.derivatives(), gap.width());
        let mut gradient = [0.0; MOST_VARIABLES];
        let mut hessian = [0.0; MOST_VARIABLES * MOST_VARIABLES];
        let sum = |h: &f64, s: &f64| normal * h + tangential * s;
        for (into, (h, s)) in gradient.iter_mut().zip(from.gradient.iter().zip(from.direction)) {
            *into = sum(h, s);
        }
        for (into, (h, s)) in
            hessian.iter_mut().zip(from.hessian.iter().zip(from.direction_derivative))
        {
            *into = sum(h, s);
        }
        let direct = stencil.width;
        let (mut force, mut tangent) = ([0.0; MOST_DOFS], [0.0; MOST_DIRECT * MOST_DIRECT]);
        let room = match stencil.shear {
            Some(_) => &mut tangent[..direct * direct],
            None => &mut scratch.tangent[..m * m],
        };
        push_forward(
            stencil.attachments(),
            &stencil.values[..direct],
            &gradient[..n],
            &hessian[..n * n],
            &mut force[..direct],
            room,
        );
        if let Some(shear) = stencil.shear {
            let dofs = &kinematics.dofs[..m];
            shear.push_tangent((dofs, u), &force, (&tangent, direct), &mut scratch.tangent);
        }
    }

    /// Positions of all chains at displacements `u`.
    pub fn fill_scratch(&self, u: &[f64], scratch: &mut GeometryScratch) {
        self.place_chains(u, &mut scratch.positions);
    }

    /// Change of the slip coordinate of a point since its commit [L]; zero
    /// where it faced nothing then or faces nothing now. A integration_point compares
    /// the same material place in both configurations.
    pub fn slip(
        &self,
        place: usize,
        history: &History,
        kinematics: &ContactKinematics,
        committed: &[f64],
    ) -> f64 {
        let point = &self.points[place];
        if !kinematics.faces {
            return 0.0;
        }
        let period = self.period(point);
        if !point.is_integration_point() {
            return pair::slip(history, kinematics.along, period);
        }
        let mut stencil = self.slave(point, kinematics.xi, committed);
        let before =
            self.face(point, kinematics.xi, committed, &MasterPositions::default(), &mut stencil);
        let along = before.map(|gap| gap.along());
        pair::slip(&History { along, ..*history }, kinematics.along, period)
    }

    /// Change of the slip coordinate of a point that opened, between its
    /// committed state `old` and `new`, at displacements `from` and `to` [L];
    /// a integration_point where it stood on its element before. Zero where it faces
    /// nothing in one of them.
    pub fn opening_slip(
        &self,
        place: usize,
        (old, new): (&PointState, &PointState),
        (from, to): (&[f64], &[f64]),
    ) -> f64 {
        let point = &self.points[place];
        let (history, along) = if point.is_integration_point() {
            let none = MasterPositions::default();
            let along = |u: &[f64]| {
                let mut stencil = self.slave(point, old.xi, u);
                let gap = self.face(point, old.xi, u, &none, &mut stencil);
                gap.map(|gap| gap.along())
            };
            (History { along: along(from), ..History::default() }, along(to))
        } else {
            (old.history(), new.along)
        };
        along.map_or(0.0, |along| pair::slip(&history, along, self.period(point)))
    }

    /// Length after which the slip coordinate of a point's master begins anew.
    fn period(&self, point: &SlavePoint) -> Option<f64> {
        match &self.masters[point.pair] {
            MasterSurface::Body { surface, .. } => surface.period(),
            _ => None,
        }
    }
}

/// Number of contact points of a pair.
pub fn point_count(pair: &ContactPair) -> usize {
    match pair.formulation {
        Formulation::NodeToSurface => pair.slave_nodes().len(),
        Formulation::SurfaceToSurface => pair.elements.len() * SEGMENT_POINTS,
    }
}

/// Contact elements by places among the slave nodes, with their coordinates.
fn local_elements(
    model: &Model,
    pair: &ContactPair,
    nodes: &[NodeIndex],
) -> (Vec<[usize; 2]>, Vec<[f64; 2]>) {
    let place: HashMap<_, _> =
        nodes.iter().enumerate().map(|(place, &node)| (node, place)).collect();
    let elements = pair.elements.iter().map(|element| element.nodes.map(|node| place[&node]));
    (elements.collect(), nodes.iter().map(|&node| model.nodes.plane(node)).collect())
}

/// The dofs of a node that turns: displacements and rotation.
fn rigid_dofs(dofs: &DofMap, node: NodeIndex) -> [usize; 3] {
    [Dof::U1, Dof::U2, Dof::UR3].map(|dof| dofs.find(node, dof).unwrap_or(0))
}

/// The displacements of a node.
fn translations(dofs: &DofMap, node: NodeIndex) -> [usize; 2] {
    [Dof::U1, Dof::U2].map(|dof| dofs.find(node, dof).unwrap_or(0))
}

/// Current position of a node.
fn moved(position: &[f64; 2], dofs: &[usize; 2], u: &[f64]) -> [f64; 2] {
    [position[0] + u[dofs[0]], position[1] + u[dofs[1]]]
}
