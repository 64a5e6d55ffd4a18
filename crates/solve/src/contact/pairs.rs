//! All contact pairs of a model: slave points, masters and laws.

use super::master::MasterSurface;
use super::mortar::slave::Mortar;
use super::mortar_faces::slave::FaceMortar;
use super::segment::{SEGMENT_POINTS, SlaveSegment};
use crate::dofs::Translations;
use slideline_mech::contact::friction::FrictionLaw;
use slideline_mech::contact::pair::Laws;
use slideline_model::{ContactPair, Formulation, NodeIndex};

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
    /// The mortar that it belongs to, of the plane or of space, where it is spread over its faces.
    pub(super) mortar: Option<usize>,
    /// Its place on a master that it belongs to; zero elsewhere.
    pub(super) seat: usize,
    /// How it is carried.
    pub(super) carrier: Carrier,
}

impl SlavePoint {
    /// Whether it is a slave node that meets its master by itself.
    pub(super) fn is_node(&self) -> bool {
        !self.is_integration_point() && self.mortar.is_none()
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
    /// Friction that changes over the step: pair, law at its start and at its end.
    pub(super) changing: Vec<(usize, [FrictionLaw; 2])>,
    /// Elements along which contact is integrated.
    pub segments: Vec<SlaveSegment>,
    /// Number of state values of user friction laws.
    pub state_size: usize,
    /// Tangential directions of a point: one in the plane.
    pub directions: usize,
    pub(super) masters: Vec<MasterSurface>,
    /// Slave surfaces whose contact is spread over their faces.
    pub(super) mortars: Vec<Mortar>,
    /// The same in space.
    pub(super) face_mortars: Vec<FaceMortar>,
    /// Distance of neighbouring slave points, a pair each [L].
    pub(super) spacing: Vec<f64>,
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
        Formulation::SurfaceToSurface => pair.elements.len() * SEGMENT_POINTS,
    }
}
