//! What a part holds while it is read.

use slideline_model::Nodes;

use super::cards::{Boundary, Gap, Interface, Normal, PointMass, Spring, Surface};
use super::elements::Element;
use super::sections::Section;
use crate::axes::{Distribution, Orientation, Transform};
use crate::constraints::{Coupling, Embedment, Equation, Link, PreTension, ShapeMpc, Tie};
use crate::sets::Sets;
use crate::surfaces::{Named, NamedSurface, Pairing, RigidBody};

/// What belongs to a part: everything with numbers and names of its own.
#[derive(Clone, Default)]
pub(crate) struct Contents {
    pub nodes: Nodes,
    pub node_sets: Sets,
    pub element_sets: Sets,
    pub node_sets_of_elements: Vec<(String, Named)>,
    pub elements: Vec<Element>,
    pub sections: Vec<Section>,
    pub springs: Vec<Spring>,
    pub gaps: Vec<Gap>,
    pub normals: Vec<Normal>,
    pub masses: Vec<PointMass>,
    pub surfaces: Vec<Surface>,
    pub interfaces: Vec<Interface>,
    pub named_surfaces: Vec<NamedSurface>,
    pub pairings: Vec<Pairing>,
    pub bodies: Vec<RigidBody>,
    pub links: Vec<Link>,
    pub equations: Vec<Equation>,
    pub couplings: Vec<Coupling>,
    pub ties: Vec<Tie>,
    pub transforms: Vec<Transform>,
    pub orientations: Vec<Orientation>,
    pub distributions: Vec<Distribution>,
    pub pre_tensions: Vec<PreTension>,
    pub shape_mpcs: Vec<ShapeMpc>,
    pub embedments: Vec<Embedment>,
    /// Boundary conditions before the first step.
    pub initial: Vec<Boundary>,
}
