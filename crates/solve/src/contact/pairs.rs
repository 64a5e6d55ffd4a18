//! All contact pairs of a model: slave points, masters and laws.

use super::edge_crossings::sides::EdgeCrossings;
use super::edge_points::EdgePoints;
use super::laws::state_size;
use super::master::MasterSurface;
use super::mortar::slave::Mortar;
use super::mortar_faces::slave::FaceMortar;
use super::segment::{SEGMENT_POINTS, STRETCHES, SlaveSegment};
use super::slave_face::SlaveFace;
use super::stencil::SectionTurn;
use super::thicknesses::Thicknesses;
use crate::dofs::Translations;
use crate::state::PointState;
use slideline_mech::contact::friction::FrictionLaw;
use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::pair::{Footing, Laws};
use slideline_model::{Allowed, Amplitude, ContactPair, Formulation, Model, NodeIndex};
use std::collections::HashSet;
use std::ops::Range;

/// What is allowed of overclosure at the points of a pair.
#[derive(Clone, Debug)]
pub(super) struct Allowance {
    /// Place of the pair in the model.
    pub pair: usize,
    /// What is allowed at the start of the step.
    pub allowed: Allowed,
    /// Points and their overclosures at the start of the step [L]; not those that are integrated.
    pub points: Vec<(usize, f64)>,
    /// The part of it that is allowed before an increment [1].
    pub before: f64,
    /// And at its end [1].
    pub now: f64,
    /// How they change over the step.
    pub course: Course,
}

/// How an overclosure that is allowed changes over a step.
#[derive(Clone, Debug)]
pub(super) enum Course {
    /// Straight to zero.
    Straight,
    /// With an amplitude.
    Curve(Amplitude),
    /// The step before has left this part of it [1]; it is taken away at once.
    Left(f64),
}

/// What of a pair does not meet.
#[derive(Clone, Debug, Default)]
pub(super) struct Apart {
    /// Nodes of the slave.
    pub nodes: HashSet<NodeIndex>,
    /// Parts of the master, or its faces, that these do not meet; those behind the last one are met.
    pub parts: Vec<bool>,
}

/// A slave point.
#[derive(Clone, Debug)]
pub struct SlavePoint {
    /// Place of its pair in the model.
    pub pair: usize,
    /// Its node; of an integration point the nearer one.
    pub node: NodeIndex,
    /// Tributary area [L2]; of an integration point, with its whole cell closed; of a node, with the faces that do
    /// not look at its master.
    pub area: f64,
    /// What of its area it has of which faces of the slave surface; none where all of it counts wherever
    /// its master is [L2].
    pub(super) shares: Vec<(usize, f64)>,
    /// Where its state values of a user friction law begin.
    pub state_variables: usize,
    /// How many they are.
    pub state_size: usize,
    /// The mortar that it belongs to, of the plane or of space, where it is spread over its faces.
    pub(super) mortar: Option<usize>,
    /// Its place on a master that it belongs to; zero elsewhere.
    pub(super) seat: usize,
    /// Whether it is a crossing of two sharp edges.
    pub(super) is_crossing: bool,
    /// The faces of the slave surface that meet at it, where they are known.
    pub(super) faces: Vec<usize>,
    /// How it is carried.
    pub(super) carrier: Carrier,
}

impl SlavePoint {
    /// Whether it is a slave node that meets its master by itself.
    pub(crate) fn is_node(&self) -> bool {
        !self.is_integration_point() && self.mortar.is_none() && !self.is_crossing
    }

    /// Whether its area is that of the faces about it that look at the master.
    pub(crate) fn has_shares(&self) -> bool {
        !self.shares.is_empty()
    }

    /// Whether it is spread over faces of the slave.
    pub fn is_spread(&self) -> bool {
        self.mortar.is_some()
    }

    /// Whether it is an integration point of integrated contact.
    pub fn is_integration_point(&self) -> bool {
        matches!(self.carrier, Carrier::IntegrationPoint { .. })
    }
}

/// How a slave point is carried.
#[derive(Clone, Debug)]
pub(super) enum Carrier {
    /// A node, free or on a rigid body.
    Node { position: [f64; 3], dofs: Translations, section: SectionTurn },
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
    /// Laws, a pair each; then those of closed points that do not separate, a pair each.
    pub laws: Vec<Laws>,
    /// Pairs whose closed points do not separate.
    pub(super) keeps: Vec<bool>,
    /// Overclosures that the step allows and takes away.
    pub(super) allowances: Vec<Allowance>,
    /// Overclosure that is allowed at every point; empty: none [L].
    pub(super) allowed: Vec<f64>,
    /// That of the increment before.
    pub(super) allowed_before: Vec<f64>,
    /// Friction that changes over the step: pair, law at its start and at its end.
    pub(super) changing: Vec<(usize, [FrictionLaw; 2])>,
    /// Elements along which contact is integrated.
    pub segments: Vec<SlaveSegment>,
    /// Number of state values of user friction laws.
    pub state_size: usize,
    /// Tangential directions of a point: one in the plane.
    pub directions: usize,
    pub(super) masters: Vec<MasterSurface>,
    /// What of the sides of pairs does not meet, a list a pair, those of edges behind.
    pub(super) apart: Vec<Vec<Apart>>,
    /// How far the surfaces stand off the lines of beams, a pair each.
    pub(super) offsets: Vec<Offset>,
    /// How thick the parts of pairs are, in the plane.
    pub(super) thicknesses: Thicknesses,
    /// Faces of the slave surfaces of contact at nodes.
    pub(super) slave_faces: Vec<SlaveFace>,
    /// The first of them, a pair of the model each.
    pub(super) first_faces: Vec<usize>,
    /// Masters that have a sharp edge, a pair each.
    pub(super) sharp: Vec<bool>,
    /// Slave surfaces whose contact is spread over their faces.
    pub(super) mortars: Vec<Mortar>,
    /// The same in space.
    pub(super) face_mortars: Vec<FaceMortar>,
    /// Slave nodes whose contact is spread over their faces, ascending, a list a pair.
    pub(super) spread_nodes: Vec<Vec<NodeIndex>>,
    /// Distance of neighbouring slave points, a pair each [L].
    pub spacing: Vec<f64>,
    /// Points of sharp edges: their pairs come behind those of the model.
    pub(super) edge_points: Vec<EdgePoints>,
    /// Crossings of sharp edges: their pairs come behind those of the edges.
    pub(super) crossings: Vec<EdgeCrossings>,
    /// Slave points that contact elements join, a list a pair.
    pub(super) edges: Vec<Vec<[usize; 2]>>,
    /// Pairs with rigid masters that share slave nodes.
    pub(super) opposed: Vec<[usize; 2]>,
    pub(super) chain_nodes: usize,
    /// Tangents of a slave surface at its nodes, as scratch [1].
    pub(super) tangents: Vec<[f64; 3]>,
}

/// Number of contact points of a pair.
pub fn point_count(pair: &ContactPair) -> usize {
    match pair.formulation {
        Formulation::NodeToSurface => pair.slave_nodes().len(),
        Formulation::Mortar => pair.slave_nodes().len() + pair.corners.len(),
        Formulation::SurfaceToSurface => {
            let of_profile = pair.profile.as_ref().map_or(0, |own| STRETCHES * own.segments.len());
            (pair.elements.len() + of_profile) * SEGMENT_POINTS
        }
    }
}

/// Number of contact points of a model, those of sharp edges among them, and of their state values of user
/// friction laws.
pub fn contact_sizes(model: &Model) -> [usize; 2] {
    let pairs = model.contact_pairs.iter().map(|pair| (point_count(pair), pair));
    let edges = model.edge_pairs.iter();
    let edges = edges.map(|own| (own.nodes.len(), &model.contact_pairs[own.of]));
    let crossings = model.crossing_edges.iter();
    let crossings = crossings.map(|own| (own.points(), &model.contact_pairs[own.of]));
    pairs.chain(edges).chain(crossings).fold([0, 0], |[points, values], (count, pair)| {
        [points + count, values + count * state_size(pair)]
    })
}

impl Contact {
    /// Adds a point without its numbers.
    pub(super) fn add_point(
        &mut self,
        pair_place: usize,
        pair: &ContactPair,
        node: NodeIndex,
        carrier: Carrier,
    ) {
        let (state_variables, state_size) = (self.state_size, state_size(pair));
        self.state_size += state_size;
        let (pair, area) = (pair_place, 0.0);
        let (mortar, seat, is_crossing, faces) = (None, 0, false, Vec::new());
        self.points.push(SlavePoint {
            pair,
            node,
            area,
            shares: Vec::new(),
            state_variables,
            state_size,
            mortar,
            seat,
            is_crossing,
            faces,
            carrier,
        });
    }

    /// Pairs of the model: those of edges come behind them.
    pub fn own_pairs(&self) -> usize {
        self.masters.len() - self.edge_points.len() - self.crossings.len()
    }

    /// The pair of the model that a pair is, or whose edges it has.
    pub fn parent(&self, pair: usize) -> usize {
        let Some(own) = pair.checked_sub(self.own_pairs()) else { return pair };
        let edges = self.edge_points.iter().map(|own| own.of);
        edges.chain(self.crossings.iter().map(|own| own.of)).nth(own).unwrap_or(pair)
    }

    /// The pairs of the edges of a pair of the model.
    pub(super) fn edges_of(&self, pair: usize) -> Vec<usize> {
        let behind = self.own_pairs()..self.masters.len();
        behind.filter(|&own| self.parent(own) == pair).collect()
    }

    /// Whether a pair of edges meets the slave: its nodes are those of the master.
    pub fn is_reversed(&self, pair: usize) -> bool {
        let edges = pair.checked_sub(self.own_pairs());
        edges.and_then(|own| self.edge_points.get(own)).is_some_and(|own| own.of_master)
    }

    /// Whether a point is of a sharp edge.
    pub fn is_edge(&self, place: usize) -> bool {
        self.points[place].pair >= self.own_pairs()
    }

    /// The crossings of a pair that stands for them.
    pub(super) fn crossings_of(&self, pair: usize) -> Option<&EdgeCrossings> {
        let first = self.masters.len() - self.crossings.len();
        pair.checked_sub(first).map(|own| &self.crossings[own])
    }

    /// The node of a point in a state: of a crossing the nearer end of the slave edge.
    pub fn node_of(&self, place: usize, now: &PointState) -> NodeIndex {
        let point = &self.points[place];
        let stood = now.footing.filter(|_| point.is_crossing);
        match (stood, self.crossings_of(point.pair)) {
            (Some(stood), Some(own)) => own.node_of(stood.place),
            _ => point.node,
        }
    }

    /// How far nodes of both sides of a pair are apart where their surfaces touch [L].
    pub fn offset_of(&self, pair: usize) -> f64 {
        self.offsets[pair].both()
    }

    /// Whether a point is a crossing of two sharp edges.
    pub fn is_crossing(&self, place: usize) -> bool {
        self.points[place].is_crossing
    }

    /// Whether no edge is held in a state of the points.
    pub fn edges_are_open(&self, points: &[PointState]) -> bool {
        self.places_of_edges().all(|place| !points[place].closed)
    }

    /// The points of sharp edges.
    pub fn places_of_edges(&self) -> Range<usize> {
        let of_edges = self.edge_points.first().map(|own| own.first);
        let of_crossings = || Some(self.crossings.first()?.slots.first()?.start);
        of_edges.or_else(of_crossings).unwrap_or(self.points.len())..self.points.len()
    }

    /// Number of pairs, those of sharp edges among them.
    pub fn pair_count(&self) -> usize {
        self.keeps.len()
    }

    /// How far the surface on which friction acts stands off a slave point [L].
    pub fn standoff_of(&self, point: &SlavePoint) -> f64 {
        match &point.carrier {
            Carrier::Node { section, .. } if section[0].1 == 0.0 => 0.0,
            _ => self.offsets[point.pair].slave,
        }
    }

    /// Whether a node belongs to the slave surface of a pair whose contact is spread over its faces;
    /// `None` where it is not.
    pub fn is_spread_slave(&self, pair: usize, node: NodeIndex) -> Option<bool> {
        let nodes = &self.spread_nodes[pair];
        (!nodes.is_empty()).then(|| nodes.binary_search(&node).is_ok())
    }

    /// The place among the laws of the law that a point of a pair obeys, of what it was at the last
    /// commit.
    pub fn law_of(&self, pair: usize, before: &PointState) -> usize {
        let is_own = pair < self.own_pairs() || before.stands_alone;
        let bonded = usize::from(self.keeps[pair] && before.closed && is_own);
        let in_pole = usize::from(self.is_in_pole(pair, before));
        (bonded + 2 * in_pole) * self.pair_count() + pair
    }

    /// That law.
    pub fn laws_of(&self, pair: usize, before: &PointState) -> &Laws {
        &self.laws[self.law_of(pair, before)]
    }

    /// Whether the pressure of a pair is a function of its overclosure.
    pub(crate) fn is_soft(&self, pair: usize) -> bool {
        self.laws[pair].normal.pressure(0.0).is_some()
    }

    /// Whether a point stood in the pole of a surface of revolution with two coefficients of friction.
    fn is_in_pole(&self, pair: usize, before: &PointState) -> bool {
        match (&self.masters[pair], before.footing) {
            (MasterSurface::Faces { mesh, .. }, Some(Footing { place, .. })) => {
                mesh.is_pole((place.face, place.at))
            }
            _ => false,
        }
    }

    /// Fills in the laws of closed points that do not separate from those of their pairs, and of points in
    /// poles: all ways out of a pole are along the profile.
    pub(super) fn take_bonds(&mut self) {
        let pairs = self.pair_count();
        self.laws.truncate(pairs);
        for pair in 0..pairs {
            let own = &self.laws[pair];
            let bonded = own.normal.bonded().filter(|_| self.keeps[pair]);
            let normal = bonded.unwrap_or_else(|| own.normal.clone());
            self.laws.push(Laws { normal, ..own.clone() });
        }
        for place in 0..2 * pairs {
            let own = self.laws[place].clone();
            self.laws.push(Laws { friction: own.friction.in_pole(), ..own });
        }
    }

    /// Points of pairs that do not separate count as closed where they touch before anything moves.
    pub fn bond(&self, points: &mut [PointState]) {
        for (point, state) in self.points.iter().zip(points) {
            let touches = -state.opening >= -TOUCH * self.spacing[point.pair];
            let keeps = self.keeps[point.pair] && point.pair < self.own_pairs();
            state.closed |= keeps && state.along.is_some() && touches;
        }
    }
}

/// Gap that counts as none, in distances of neighbouring slave points [1].
const TOUCH: f64 = 1e-6;
