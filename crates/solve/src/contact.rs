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
mod faces;
mod idle;
mod kinematics;
mod laws;
mod master;
mod operator;
mod positions;
mod segment;
mod shear;
mod values;

pub use candidates::{Candidates, coupled_parts};
pub use cliques::Cliques;
pub use crossing::{Missed, Sweep, SweepScratch};
pub use idle::Look;
pub use kinematics::{ContactKinematics, GeometryScratch, PointKinematics, PointRows};
pub use laws::{mean_length, state_size};
pub use master::placed;
pub use operator::{ContactOperator, OperatorRows};
pub use positions::MasterPositions;
pub use segment::{SEGMENT_POINTS, SlaveSegment};

use crate::dofs::{DofMap, Translations};
use crate::state::PointState;
use crate::users::UserFrictions;
use kinematics::{PointRowsMut, Stencil};
use master::{Facing, MasterSurface};
use slideline_mech::contact::pair::{self, AnyGap, History, Laws};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::rigid::{Attachment, PointMap, push_forward};
use slideline_model::{ContactPair, Dof, Formulation, Master, Model, NodeIndex};
use std::collections::{HashMap, HashSet};

/// A slave point.
#[derive(Clone, Debug)]
pub struct SlavePoint {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its node; of an integration point the nearer one.
    pub node: NodeIndex,
    /// Tributary area [L2]; of an integration point, with its whole cell closed.
    pub area: f64,
    /// Where its state values of a user friction law begin.
    pub state_variables: usize,
    /// How many they are.
    pub state_size: usize,
    /// How it is carried.
    carrier: Carrier,
}

impl SlavePoint {
    /// Whether it is an integration point of integrated contact.
    pub fn is_integration_point(&self) -> bool {
        matches!(self.carrier, Carrier::IntegrationPoint { .. })
    }
}

#[derive(Clone, Debug)]
enum Carrier {
    /// A node, free or on a rigid body.
    Node { position: [f64; 3], dofs: Translations },
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
    /// Tangential directions of a point: one in the plane.
    pub directions: usize,
    masters: Vec<MasterSurface>,
    /// Distance of neighbouring slave points, a pair each [L].
    spacing: Vec<f64>,
    /// Slave points that contact elements join, a list a pair.
    edges: Vec<Vec<[usize; 2]>>,
    /// Pairs with rigid masters that share slave nodes.
    opposed: Vec<[usize; 2]>,
    chain_nodes: usize,
    /// Tangents of a slave surface at its nodes, as scratch [1].
    tangents: Vec<[f64; 3]>,
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
            directions: if model.is_in_space() { 2 } else { 1 },
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
                Formulation::NodeToSurface => contact.add_nodes(dofs, place, pair),
                Formulation::SurfaceToSurface => contact.add_segments(model, dofs, place, pair),
            }
            let length = mean_length(model, pair);
            contact.laws.push(laws::laws(model, pair, length, users));
            let master = match &pair.master {
                Master::RigidSurface(surface) => MasterSurface::body(model, dofs, surface),
                Master::SlideLine(line) => {
                    MasterSurface::chain(model, dofs, line, contact.chain_nodes)
                }
                Master::Faces(faces) => {
                    MasterSurface::faces(model, dofs, faces, contact.chain_nodes)
                }
            };
            contact.chain_nodes += master.nodes().len();
            contact.spacing.push(laws::spacing(model, length, &master));
            contact.masters.push(master);
        }
        contact.opposed = contact.opposed_pairs();
        contact.take_points(model);
        contact.take_segments(model);
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

    fn add_nodes(&mut self, dofs: &DofMap, place: usize, pair: &ContactPair) {
        let nodes = self.slave_nodes[place].clone();
        let first = self.points.len();
        let points = nodes.iter().enumerate().map(|(k, &node)| (node, first + k));
        let points: HashMap<_, _> = points.collect();
        let elements = pair.elements.iter();
        self.edges[place] = elements.map(|own| own.nodes.map(|node| points[&node])).collect();
        self.points.reserve(nodes.len());
        for node in nodes {
            let (position, dofs) = ([0.0; 3], dofs.translations(node));
            self.add_point(place, pair, node, Carrier::Node { position, dofs });
        }
    }

    /// Adds a point without its numbers.
    fn add_point(
        &mut self,
        pair_place: usize,
        pair: &ContactPair,
        node: NodeIndex,
        carrier: Carrier,
    ) {
        let (state_variables, state_size) = (self.state_size, state_size(pair));
        self.state_size += state_size;
        let (pair, area) = (pair_place, 0.0);
        let point = SlavePoint { pair, node, area, state_variables, state_size, carrier };
        self.points.push(point);
    }

    /// All points, facing nothing yet, each with room for the dofs it may follow.
    pub fn nowhere(&self) -> ContactKinematics {
        let mut kinematics = ContactKinematics::default();
        self.forget(&mut kinematics);
        kinematics
    }

    /// Lets points face nothing, in the room they have.
    pub fn forget(&self, kinematics: &mut ContactKinematics) {
        let room = |point: &SlavePoint| {
            let own = match &point.carrier {
                Carrier::Node { dofs, .. } => dofs.as_slice().len(),
                Carrier::IntegrationPoint { segment } => self.segments[*segment].all_dofs().count(),
            };
            own + self.masters[point.pair].most_dofs()
        };
        let room = self.points.iter().map(room).max().unwrap_or(0);
        kinematics.forget(self.points.len(), room, self.directions);
    }

    /// Where every point stands at displacements `u`, with slips since the states `before`, of
    /// which there may be none. `positions` is scratch. Points that `idle` names are left as they
    /// are.
    pub fn meet(
        &self,
        (u, before): (&[f64], &[PointState]),
        idle: &[bool],
        positions: &mut MasterPositions,
        into: &mut ContactKinematics,
    ) {
        self.place_masters(u, positions);
        for (place, point) in self.points.iter().enumerate() {
            let is_idle = idle.get(place).is_some_and(|&idle| idle);
            if !is_idle && !point.is_integration_point() {
                into.at_mut(place).point.area = point.area;
                self.meet_one(place, (u, before), positions, into);
            }
        }
        for segment in &self.segments {
            self.meet_segment(segment, u, into);
        }
    }

    /// As [`Contact::meet`], with integration points left where they stand on their
    /// elements.
    pub fn meet_in_place(
        &self,
        at: (&[f64], &[PointState]),
        positions: &mut MasterPositions,
        into: &mut ContactKinematics,
    ) {
        self.place_masters(at.0, positions);
        for (place, point) in self.points.iter().enumerate() {
            if into.points()[place].faces || !point.is_integration_point() {
                self.meet_one(place, at, positions, into);
            }
        }
    }

    /// Where the points that `idle` names stand at displacements `u`, for which
    /// the masters are placed already.
    pub fn meet_idle(
        &self,
        at: (&[f64], &[PointState]),
        idle: &[bool],
        positions: &MasterPositions,
        into: &mut ContactKinematics,
    ) {
        for place in (0..self.points.len()).filter(|&place| idle[place]) {
            self.meet_one(place, at, positions, into);
        }
    }

    /// Where all points stand at displacements `u`, however far from their masters;
    /// integration points where their cells, wholly closed, have them.
    pub fn stand(&self, u: &[f64], positions: &mut MasterPositions, into: &mut ContactKinematics) {
        self.place_masters(u, positions);
        for (place, point) in self.points.iter().enumerate() {
            let own = into.at_mut(place);
            own.point.area = point.area;
            own.point.xi = self.resting_place(place);
            self.meet_one(place, (u, &[]), positions, into);
        }
    }

    /// Where one of them stands, without its rows; the masters are placed already.
    fn stands(&self, place: usize, u: &[f64], positions: &MasterPositions) -> PointKinematics {
        let point = &self.points[place];
        let xi = self.resting_place(place);
        let mut kinematics = PointKinematics { area: point.area, xi, ..PointKinematics::NOWHERE };
        let mut stencil = self.slave(point, xi, u);
        kinematics.position = stencil.position;
        if let Some((gap, facing)) = self.face(point, xi, u, positions, &mut stencil) {
            kinematics.take(&gap, facing);
        }
        kinematics
    }

    /// Whether a point faces nothing because its master ends, and would touch
    /// it, up to a gap of `slack`, were that end prolonged; an integration point at `xi`
    /// of its element.
    pub fn has_slid_off(&self, place: usize, (xi, slack): (f64, f64), u: &[f64]) -> bool {
        let mut positions = MasterPositions::default();
        self.place_masters(u, &mut positions);
        let point = &self.points[place];
        let mut stencil = self.slave(point, xi, u);
        let begins = self.laws[point.pair].normal.contact_begins();
        if let MasterSurface::Faces { .. } = &self.masters[point.pair] {
            let beyond = self.beyond_faces(point.pair, stencil.position, &positions);
            return beyond.is_some_and(|overclosure| overclosure > begins - slack);
        }
        if self.face(point, xi, u, &positions, &mut stencil).is_some() {
            return false;
        }
        let beyond = self.masters[point.pair].beyond_end(stencil.position, u, &positions.nodes);
        beyond.is_some_and(|overclosure| overclosure > begins - slack)
    }

    fn meet_one(
        &self,
        place: usize,
        (u, before): (&[f64], &[PointState]),
        positions: &MasterPositions,
        into: &mut ContactKinematics,
    ) {
        let point = &self.points[place];
        if let MasterSurface::Faces { .. } = &self.masters[point.pair] {
            self.meet_face(place, (u, before.get(place)), positions, into);
            return;
        }
        let mut into = into.at_mut(place);
        let stencil = self.slave(point, into.point.xi, u);
        self.meet_stencil(point, stencil, (u, positions), &mut into);
    }

    fn meet_stencil(
        &self,
        point: &SlavePoint,
        mut stencil: Stencil<'_>,
        (u, positions): (&[f64], &MasterPositions),
        into: &mut PointRowsMut<'_>,
    ) {
        into.point.position = stencil.position;
        match self.face(point, into.point.xi, u, positions, &mut stencil) {
            Some((gap, facing)) => {
                into.point.take(&gap, facing);
                into.take(&gap, &stencil, u);
            }
            None => into.turn_away_in_place(),
        }
    }

    /// The slave's part of a stencil.
    fn slave(&self, point: &SlavePoint, xi: f64, u: &[f64]) -> Stencil<'_> {
        match &point.carrier {
            Carrier::Node { position, dofs } => {
                let mut stencil = Stencil::new(dofs.displace(*position, u));
                stencil.add_from(dofs.as_slice(), u);
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
    ) -> Option<(AnyGap, Facing)> {
        let slave = self.attachment(point, xi);
        let tree = positions.tree(point.pair);
        let master = &self.masters[point.pair];
        let facing = master.search(u, (&positions.nodes, tree), stencil.position)?;
        let gap = master.gap(&facing, slave, (u, &positions.nodes), stencil)?;
        Some((gap, facing))
    }

    /// Tangent of the geometry of a point, normal * D dh + tangential *
    /// D direction, with `normal` and `tangential` forces [F]; row-major, as wide
    /// as its rows. The point faces what it faced when it was met, with masters at `positions`.
    pub fn geometric_tangent(
        &self,
        place: usize,
        (u, positions, before): (&[f64], &MasterPositions, &PointState),
        kinematics: &PointRows<'_>,
        (normal, tangential): (f64, Tangential),
        scratch: &mut GeometryScratch,
    ) {
        let point = &self.points[place];
        if let Some(Facing::Face(facing)) = kinematics.facing {
            let (facing, forces) = ((point.pair, facing), (normal, tangential));
            self.tangent_of_face(facing, (kinematics, before, positions), forces, scratch);
            return;
        }
        let mut stencil = self.slave(point, kinematics.xi, u);
        let m = kinematics.rows.width();
        let GeometryScratch { tangent, direct, force, .. } = scratch;
        tangent.clear();
        tangent.resize(m * m, 0.0);
        let Some(facing) = &kinematics.facing else { return };
        let slave = self.attachment(point, kinematics.xi);
        let master = &self.masters[point.pair];
        let Some(gap) = master.gap(facing, slave, (u, &positions.nodes), &mut stencil) else {
            return;
        };
        let (from, n) = (gap.derivatives(), gap.width());
        let mut gradient = [0.0; MOST_VARIABLES];
        let mut hessian = [0.0; MOST_VARIABLES * MOST_VARIABLES];
        combine(&mut gradient[..n], normal, (from.gradient, from.direction), tangential);
        let derivatives = (from.hessian, from.direction_derivative);
        combine(&mut hessian[..n * n], normal, derivatives, tangential);
        let width = stencil.width();
        force.clear();
        force.resize(width, 0.0);
        direct.clear();
        direct.resize(if stencil.shear.is_some() { width * width } else { 0 }, 0.0);
        let room = match stencil.shear {
            Some(_) => &mut *direct,
            None => &mut *tangent,
        };
        let (attachments, values) = (stencil.attachments(), stencil.values());
        push_forward(attachments, values, &gradient[..n], &hessian[..n * n], force, room);
        if let Some(shear) = stencil.shear {
            let dofs = kinematics.rows.unknowns;
            shear.push_tangent((dofs, u), force, (direct, width), tangent);
        }
    }

    /// Change of the slip coordinates of a point since its commit [L]; zero
    /// where it faced nothing then or faces nothing now. An integration point compares
    /// the same material place in both configurations.
    pub fn slip(
        &self,
        place: usize,
        history: &History,
        kinematics: &PointKinematics,
        committed: &[f64],
    ) -> Tangential {
        let point = &self.points[place];
        if !kinematics.faces {
            return Tangential::ZERO;
        }
        let period = self.period(point);
        if !point.is_integration_point() {
            return pair::slip(history, kinematics.along, period);
        }
        let mut stencil = self.slave(point, kinematics.xi, committed);
        let before =
            self.face(point, kinematics.xi, committed, &MasterPositions::default(), &mut stencil);
        let along = before.map(|(gap, _)| gap.along());
        pair::slip(&History { along, ..*history }, kinematics.along, period)
    }

    /// Change of the slip coordinates of a point that opened, between its
    /// committed state `old` and `new`, at displacements `from` and `to` [L];
    /// an integration point where it stood on its element before. Zero where it faces
    /// nothing in one of them.
    pub fn opening_slip(
        &self,
        place: usize,
        (old, new): (&PointState, &PointState),
        (from, to): (&[f64], &[f64]),
    ) -> Tangential {
        let point = &self.points[place];
        let (history, along) = if point.is_integration_point() {
            let none = MasterPositions::default();
            let along = |u: &[f64]| {
                let mut stencil = self.slave(point, old.xi, u);
                let gap = self.face(point, old.xi, u, &none, &mut stencil);
                gap.map(|(gap, _)| gap.along())
            };
            (History { along: along(from), ..History::default() }, along(to))
        } else {
            (old.history(), new.along)
        };
        let slip = |along| pair::slip(&history, along, self.period(point));
        along.map_or(Tangential::ZERO, slip)
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

/// The dofs of a node that turns in the plane: displacements and rotation.
fn rigid_dofs(dofs: &DofMap, node: NodeIndex) -> [usize; 3] {
    [Dof::U1, Dof::U2, Dof::UR3].map(|dof| dofs.find(node, dof).unwrap_or(0))
}

/// The most kernel variables of a point in the plane: itself and three control points.
const MOST_VARIABLES: usize = 8;

/// normal * of.0 + tangential . of.1, the latter direction after direction.
fn combine(
    into: &mut [f64],
    normal: f64,
    (along_normal, along_tangents): (&[f64], &[f64]),
    tangential: Tangential,
) {
    for (into, h) in into.iter_mut().zip(along_normal) {
        *into = normal * h;
    }
    for (of, force) in along_tangents.chunks_exact(along_normal.len()).zip(tangential.0) {
        into.iter_mut().zip(of).for_each(|(into, s)| *into += force * s);
    }
}
