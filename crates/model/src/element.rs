//! Elements in blocks of one kind and one section.

use crate::{Dof, NodeIndex};
use slideline_diag::Span;
use slideline_mech::material::Elastic;

/// Elements that share kind and section: the solver dispatches once a block.
#[derive(Clone, Debug, PartialEq)]
pub enum ElementBlock {
    /// Two-node shear-flexible plane beams.
    B21(BeamBlock),
    /// Three-node shear-flexible plane beams.
    B22(BeamBlock),
    /// Two-node shear-rigid plane beams.
    B23(BeamBlock),
    /// Linear springs.
    Spring(SpringBlock),
}

impl ElementBlock {
    /// The type in a deck's words.
    pub fn word(&self) -> &'static str {
        match self {
            Self::B21(_) => "B21",
            Self::B22(_) => "B22",
            Self::B23(_) => "B23",
            Self::Spring(block) if block.kind == SpringKind::Axial => "SPRINGA",
            Self::Spring(_) => "SPRING1",
        }
    }

    /// The beams, of whatever type; `None`: springs.
    pub fn beams(&self) -> Option<&BeamBlock> {
        match self {
            Self::B21(block) | Self::B22(block) | Self::B23(block) => Some(block),
            Self::Spring(_) => None,
        }
    }
}

/// What the material of a beam section may be strained to. It changes no
/// result: margin and verdict are held against it.
#[derive(Clone, Debug, PartialEq)]
pub struct Allowable {
    /// Place of the block of beams.
    pub block: usize,
    /// Allowable fibre strain [1].
    pub strain: f64,
    /// Its stress, where the deck gave that one [F/L2].
    pub stress: Option<f64>,
    /// Where it was defined.
    pub origin: Span,
}

/// Beams of one section.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamBlock {
    /// Name of the element set that the section was given to.
    pub name: String,
    /// Section and material.
    pub section: BeamSection,
    /// Elements in order of definition.
    pub elements: Vec<BeamElement>,
    /// The section's card.
    pub origin: Span,
}

/// A beam between two nodes, with or without a third one in the middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamElement {
    /// Its number in the deck.
    pub label: u64,
    /// Its ends.
    pub nodes: [NodeIndex; 2],
    /// The node between them, of a three-node beam.
    pub middle: Option<NodeIndex>,
    /// Where it was defined.
    pub origin: Span,
}

impl BeamElement {
    /// Its nodes in order along the beam.
    pub fn all_nodes(&self) -> impl Iterator<Item = NodeIndex> + use<> {
        let [first, last] = self.nodes;
        [Some(first), self.middle, Some(last)].into_iter().flatten()
    }
}

/// A rectangular section of an elastic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamSection {
    /// Width out of the plane [L].
    pub width: f64,
    /// Height in the plane [L].
    pub height: f64,
    /// Section Poisson ratio [1]; read, stated, and kept out of the energy.
    pub poisson: f64,
    /// Material.
    pub material: Elastic,
    /// Transverse shear.
    pub shear: ShearRule,
}

/// How the transverse shear stiffness is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearRule {
    /// `K23` of `*TRANSVERSE SHEAR STIFFNESS` [F]; default k G A.
    pub stiffness: Option<f64>,
    /// Slenderness compensation factor SCF [1]; default 0.25.
    pub slenderness_compensation: f64,
}

impl Default for ShearRule {
    fn default() -> Self {
        Self { stiffness: None, slenderness_compensation: 0.25 }
    }
}

/// Springs of one stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringBlock {
    /// Name of the element set.
    pub name: String,
    /// Stiffness [F/L] (about a rotation: [F L]).
    pub stiffness: f64,
    /// Kind.
    pub kind: SpringKind,
    /// Elements.
    pub elements: Vec<SpringElement>,
    /// The `*SPRING` card.
    pub origin: Span,
}

/// What a spring acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpringKind {
    /// `SPRING1`: between a dof and the ground.
    Ground(Dof),
    /// `SPRINGA`: between two nodes, along the line that joins them.
    Axial,
}

/// One spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringElement {
    /// Its number in the deck.
    pub label: u64,
    /// Its node, and for [`SpringKind::Axial`] its second node.
    pub nodes: [NodeIndex; 2],
    /// Where it was defined.
    pub origin: Span,
}
