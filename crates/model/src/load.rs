//! Loads of a step: on nodes, and spread over faces and volumes.

use crate::node::{Dof, NodeIndex};
use slideline_diag::Span;
use slideline_mech::pressure::Face;
use slideline_mech::traction::Traction;
use slideline_mech::turning::Turning;

/// A concentrated load, or a share of a distributed one.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Node.
    pub node: NodeIndex,
    /// Degree of freedom.
    pub dof: Dof,
    /// Value at the end of the step [F or F L]; with an amplitude, its factor.
    pub value: f64,
    /// Amplitude by place in the model's list; without one the value is approached linearly from
    /// that of the load it continues, or from zero.
    pub amplitude: Option<usize>,
    /// The load of the step before that it goes on from, by place in the list of its kind there.
    pub continues: Option<usize>,
    /// Where it was said.
    pub origin: Span,
}

/// What is spread over faces and volumes.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Distributed {
    /// Pressures and tractions, which follow their faces where the kinematics are nonlinear, and
    /// forces of turning, which follow the places of nodes.
    pub pressures: Vec<Pressure>,
    /// Forces of fixed direction, already on the nodes; several may act on a node.
    pub forces: Vec<Load>,
}

/// What a pressure acts on.
#[derive(Clone, Debug, PartialEq)]
pub enum Pressed {
    /// A face; the pressure stays across it.
    Face(Face),
    /// A face that a traction pulls at.
    Traction(Traction),
    /// A beam: the pressure is a force per length along an axis of its sections and turns with them.
    /// For every node the integral of its shape function times that axis, undeformed [L].
    Sections(Vec<[f64; 3]>),
    /// The mass of an element that turns about an axis; the size is omega squared [1/T2].
    Turning(Turning),
}

impl Pressed {
    /// Whether it is a centrifugal force, whose derivative alone is symmetric.
    pub fn is_turning(&self) -> bool {
        matches!(self, Self::Turning(_))
    }
}

/// A pressure or a traction on a face, or a force per length that turns with a beam.
#[derive(Clone, Debug, PartialEq)]
pub struct Pressure {
    /// What it acts on.
    pub on: Pressed,
    /// Its nodes.
    pub nodes: Vec<NodeIndex>,
    /// Value at the end of the step [F/L2], of a beam [F/L], of a pressure positive towards the face; with an
    /// amplitude, its factor.
    pub value: f64,
    /// Amplitude by place in the model's list; without one the value is approached linearly from
    /// that of the pressure it continues, or from zero.
    pub amplitude: Option<usize>,
    /// The pressure of the step before that it goes on from, by place in the list there.
    pub continues: Option<usize>,
    /// Where it was said.
    pub origin: Span,
}
