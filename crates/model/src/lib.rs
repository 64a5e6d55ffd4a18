//! The problem as plain data: what is to be solved, and where in the deck it
//! was said.
//!
//! ```text
//!    (o)  rigid body: reference node + rigid links or an analytic surface
//!   /////\\\\  contact pair: points, master, interaction
//!   o---o---o---o   elements on nodes, a section, a material
//!   #          ^    steps: what moves, what pulls, how it is to be solved
//! ```
//!
//! A model is cloned, compared and edited freely; nothing in it is computed.
//! Nodes are named by their place in [`Nodes`]; their deck numbers are labels.
//! Every object remembers the deck line it came from.

mod amplitude;
mod contact;
mod controls;
mod crossing_edges;
mod dialect;
mod driven;
mod edge_lines;
mod edge_pair;
mod edges;
mod element;
mod friction;
mod initial_stress;
mod kept_shape;
mod left_out;
mod load;
mod mean_motion;
mod model;
mod node;
mod numbered;
mod numbering;
mod output;
mod presence;
mod refine;
mod request;
mod section_print;
mod stabilisation;
mod step;
mod surface;
mod symmetry;
mod tested;
mod transform;
mod vocabulary;

pub use amplitude::{Amplitude, Curve};
pub use contact::{Adjust, ContactElement, ContactPair, Formulation, Interaction, Lumping, Offset};
pub use controls::{Controls, FieldControls, TimeIncrementation};
pub use crossing_edges::{CrossingEdges, EdgeLine, SharpEdge};
pub use dialect::Dialect;
pub use driven::Driven;
pub use edge_pair::EdgePair;
pub use edges::{corners_of_line, nodes_at_creases};
pub use element::block::{Allowable, Beams, Element, ElementBlock, Elements, Limit, Springs};
pub use element::element_type::{
    ElementType, Field, Kinematics, Location, Undeformed, mean_at_nodes,
};
pub use element::other_names::read_as;
pub use element::section::{
    BeamSection, Section, ShearRule, SolidSection, SpringSection, SpringWay,
};
pub use element::table::{MOST_NODES, TYPES, element_type, types};
pub use friction::{Decay, Friction, StickRule};
pub use initial_stress::{InitialHardening, InitialStress};
pub use kept_shape::KeptShape;
pub use left_out::{FacesByNodes, LeftOut};
pub use load::{Distributed, Load, Pressed, Pressure};
pub use mean_motion::{Hung, LinearMeanTurn, MeanMotion};
pub use model::Model;
pub use node::{Dof, LinearConstraint, Node, NodeIndex, NodeSet, Nodes, RigidLink};
pub use numbered::{Mixed, Numbered, NumberedSet};
pub use numbering::{Name, Numbering};
pub use output::{
    ContactPrint, ContactVariable, ElementPrint, ElementVariable, NodePrint, NodeVariable,
    OutputRequests, SECTION_POINTS, SavedStates,
};
pub use presence::{ElementIndex, Presence};
pub use refine::refine;
pub use request::{PrintTarget, Request, Totals};
pub use section_print::{SectionFace, SectionPrint, SectionShare, SectionVariable};
pub use slideline_mech::axes::{Axes, System};
pub use slideline_mech::contact::normal::NormalLaw;
pub use slideline_mech::contact::onset::Onset;
pub use slideline_mech::element::{SpringLaw, Temperature};
pub use slideline_mech::material::Material;
pub use slideline_mech::section::{Fault, Profile, Shape, Wall};
pub use stabilisation::Stabilisation;
pub use step::{
    Allowed, ChangedFriction, ChangedPressure, ChangedSection, Extrapolation, Interference,
    NodalTemperature, Passage, Prescribed, Static, Step,
};
pub use surface::{
    ContactFace, Master, MasterFaces, OwnSurface, ProfilePoint, RigidSurface, SlideLine,
    SurfaceRun, SurfaceSegment, Sweep, SweptSurface,
};
pub use symmetry::SymmetryPlane;
pub use tested::Tested;
pub use transform::Transform;
pub use vocabulary::Vocabulary;
