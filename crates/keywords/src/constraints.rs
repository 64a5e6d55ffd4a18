//! Constraints as cards give them: who follows whom, by number and name.

use slideline_diag::Span;
use slideline_model::{Dof, LinearMeanTurn, NodeIndex};
use std::ops::Range;

use crate::instances::Target;
use crate::surfaces::Named;

/// A line of `*MPC`.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub kind: LinkKind,
    pub dependent: Target,
    pub dependent_span: Span,
    pub master: Target,
    pub master_span: Span,
    pub origin: Span,
}

/// A line of `*MPC` that keeps a shape.
#[derive(Clone, Debug)]
pub(crate) struct ShapeMpc {
    pub shape: Shape,
    pub nodes: Vec<(Target, Span)>,
    pub origin: Span,
}

/// What an `*MPC` keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Nodes stay on the line of the first two.
    Straight,
    /// Nodes stay in the plane of the first three.
    Plane,
    /// The mean rotation is a dof of the last one.
    MeanRotation,
    /// The first stays where it is between the two others.
    Linear,
    /// Nodes stay as far from the last one as they are.
    Link,
}

impl Shape {
    /// Its word on the card.
    pub fn word(self) -> &'static str {
        match self {
            Self::Straight => "STRAIGHT",
            Self::Plane => "PLANE",
            Self::MeanRotation => "MEANROT",
            Self::Linear => "LINEAR",
            Self::Link => "LINK",
        }
    }

    /// What its nodes must be.
    pub fn needs(self) -> &'static str {
        match self {
            Self::Straight => "two nodes apart from one another, then others on their line",
            Self::Plane => "three nodes of a plane in space, then others in that plane",
            Self::MeanRotation => {
                "nodes off the axis through their centre, then a node whose coordinates are the axis"
            }
            Self::Linear => "a node, then two apart from one another",
            Self::Link => "nodes, then one apart from them",
        }
    }
}

/// The type of an `*MPC`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LinkKind {
    /// A rigid bar, welded at both ends.
    Beam,
    /// All dofs equal.
    Tie,
    /// Displacements equal.
    Pin,
}

/// One equation of `*EQUATION`.
#[derive(Clone, Debug)]
pub(crate) struct Equation {
    pub terms: Vec<Term>,
    /// Its first line.
    pub origin: Span,
}

/// A term of an equation.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    pub node: Target,
    pub span: Span,
    pub dof: Dof,
    pub factor: f64,
}

/// `*COUPLING` with what follows it, `*KINEMATIC COUPLING`, `*DISTRIBUTING COUPLING`.
#[derive(Clone, Debug)]
pub(crate) struct Coupling {
    pub reference: Target,
    /// The target is not a node but a set with one element on it.
    pub of_element: bool,
    pub reference_span: Span,
    pub points: Vec<Points>,
    pub kind: CouplingKind,
    /// Largest distance of a coupled node from the reference node [L], where the card gives one.
    pub within: Option<f64>,
    /// The `*ORIENTATION` along whose axes the dofs are named.
    pub axes: Option<(String, Span)>,
    pub origin: Span,
}

/// `*EMBEDDED ELEMENT`: elements whose nodes follow the solids they lie in.
#[derive(Clone, Debug)]
pub(crate) struct Embedment {
    /// The set of solids; none: all that are not embedded.
    pub hosts: Option<Named>,
    pub embedded: Vec<(Target, Span)>,
    pub outside: Outside,
    pub origin: Span,
}

/// How far from its host a node may lie: the smaller of what is given.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outside {
    /// A distance [L].
    pub distance: f64,
    /// A part of the mean size of the hosts [1].
    pub part: f64,
}

/// `*TIE`, a line of it.
#[derive(Clone, Debug)]
pub(crate) struct Tie {
    pub slave: Named,
    pub master: Named,
    /// Largest distance that is tied [L], where the card gives one.
    pub tolerance: Option<f64>,
    /// Whether slave nodes are moved onto the master.
    pub adjust: bool,
    /// Whether faces are tied to faces; else each slave node to the place nearest to it.
    pub by_faces: bool,
    /// Whether it is a contact pair that is tied.
    pub is_pair: bool,
    pub origin: Span,
}

/// `*PRE-TENSION SECTION`.
#[derive(Clone, Debug)]
pub(crate) struct PreTension {
    pub cut: Cut,
    pub reference: Target,
    pub reference_span: Span,
    /// Unit normal, where the card gives one.
    pub normal: Option<[f64; 3]>,
    pub origin: Span,
}

/// Where a bolt is cut.
#[derive(Clone, Debug)]
pub(crate) enum Cut {
    /// Along faces of elements.
    Surface(Named),
    /// At the last node of an element.
    Element(u64, Span),
}

/// Points that are coupled.
#[derive(Clone, Debug)]
pub(crate) enum Points {
    /// A node or a set, and what each of its nodes counts.
    Nodes { target: Target, span: Span, weight: f64 },
    /// The nodes of a surface.
    Surface(Named),
}

/// How nodes are coupled to the reference node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CouplingKind {
    /// Not said yet.
    Open,
    /// They follow it rigidly, with these dofs.
    Kinematic([bool; 6]),
    /// It follows their mean, with these dofs.
    Distributing([bool; 6], Fading),
}

/// How the weight of a node falls with its distance from the reference node, of the largest one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(crate) enum Fading {
    #[default]
    Uniform,
    Linear,
    Quadratic,
    Cubic,
}

impl Fading {
    /// The factor of a weight at a part 0 to 1 of the largest distance [1].
    pub fn at(self, part: f64) -> f64 {
        match self {
            Self::Uniform => 1.0,
            Self::Linear => 1.0 - part,
            Self::Quadratic => 1.0 - part * part,
            Self::Cubic => 1.0 - part * part * (3.0 - 2.0 * part),
        }
    }
}

/// A cloud that may turn far, of which it is still open what follows what.
#[derive(Debug)]
pub(crate) struct OpenMean {
    /// Its nodes with their weights.
    pub cloud: Vec<(NodeIndex, f64)>,
    /// Its equations of small motion, an entry a dof.
    pub rows: Vec<Vec<f64>>,
    /// The dofs, those of the reference node first, and how many these are.
    pub names: Vec<(NodeIndex, Dof)>,
    pub own: usize,
    /// Those that follow in small motion.
    pub pivots: Vec<usize>,
    /// The constraints that it is in small motion.
    pub constraints: Range<usize>,
    /// What it is where it has to stay linear.
    pub linear: LinearMeanTurn,
}
