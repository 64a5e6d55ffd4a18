//! Named surfaces, interactions, pairs and rigid bodies while they are read:
//! the modern spelling of a contact, joined by names instead of element sets.
//!
//! ```text
//!   *SURFACE, NAME=CIRCLE  <---  *RIGID BODY, ANALYTICAL SURFACE=CIRCLE
//!        ^         *SURFACE, NAME=BEAM
//!        |              ^
//!        +--------------+----  *CONTACT PAIR  --->  *SURFACE INTERACTION
//! ```

use slideline_diag::Span;
use slideline_model::{
    Formulation, Friction, Interaction, LeftOut, NodeIndex, NormalLaw, ProfilePoint,
    SurfaceSegment, Sweep,
};

use crate::log::Target;

/// A name, and where it was said.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub name: String,
    pub span: Span,
}

/// `*SURFACE`.
#[derive(Clone, Debug)]
pub(crate) struct NamedSurface {
    pub named: Named,
    pub extent: Extent,
    /// Where areas are given for its nodes.
    pub areas: Option<Span>,
    pub origin: Span,
}

/// What a surface is made of.
#[derive(Clone, Debug)]
pub(crate) enum Extent {
    Elements(Vec<Stretch>),
    Nodes(Vec<(Target, Span)>),
    Rigid {
        start: ProfilePoint,
        segments: Vec<SurfaceSegment>,
    },
    /// A profile that sweeps a surface in space.
    Swept {
        start: ProfilePoint,
        segments: Vec<SurfaceSegment>,
        axes: SweptAxes,
    },
}

impl Extent {
    /// Whether it is an analytical surface, which belongs to a rigid body.
    pub fn is_analytical(&self) -> bool {
        matches!(self, Self::Rigid { .. } | Self::Swept { .. })
    }
}

/// The frame of an analytical surface in space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SweptAxes {
    pub sweep: Sweep,
    /// Its origin [L].
    pub origin: [f64; 3],
    /// Three directions at right angles: those of the profile and of the way, or two across the
    /// axis and the axis.
    pub directions: [[f64; 3]; 3],
}

/// Elements, and which of their faces.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    pub elements: Target,
    pub span: Span,
    pub side: Option<Side>,
    /// Face of a solid, from 0 for S1.
    pub face: Option<usize>,
}

/// The face of a beam: the outward normal stands 90 degrees counter-clockwise
/// of the direction from the first to the last node of the element (`SPOS`),
/// or opposite (`SNEG`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Side {
    Positive,
    Negative,
}

impl Side {
    pub fn name(self) -> &'static str {
        match self {
            Self::Positive => "SPOS",
            Self::Negative => "SNEG",
        }
    }
}

/// `*SURFACE INTERACTION`.
#[derive(Clone, Debug)]
pub(crate) struct NamedInteraction {
    pub named: Named,
    pub interaction: Interaction,
    /// Thickness out of the plane [L], where the card gives it.
    pub thickness: Option<f64>,
    /// `PRESSURE-OVERCLOSURE=TIED`: its pairs are ties.
    pub is_tied: bool,
}

impl NamedInteraction {
    /// Hard contact without friction.
    pub fn plain(named: Named) -> Self {
        let interaction = unsaid(named.span);
        Self { named, interaction, thickness: None, is_tied: false }
    }
}

/// Hard contact without friction, of a card that says nothing yet.
pub(crate) fn unsaid(origin: Span) -> Interaction {
    Interaction {
        width: 1.0,
        normal: NormalLaw::Hard,
        friction: Friction::Frictionless,
        origin,
        no_separation: false,
        normal_origin: None,
        friction_origin: None,
    }
}

/// A data line of `*CONTACT PAIR`.
#[derive(Clone, Debug)]
pub(crate) struct Pairing {
    pub slave: Named,
    pub master: Named,
    pub interaction: Named,
    pub formulation: Formulation,
    /// `SMOOTH`, where it is given or the dialect has a value for it.
    pub smooth: Option<f64>,
    pub extension: f64,
    /// Whether the first surface stands alone: it meets itself.
    pub alone: bool,
    /// `SMOOTH` or `EXTENSION ZONE`, where the card gives one.
    pub chain_parameter: Option<(&'static str, Span)>,
    /// `ADJUST`, and where it was said.
    pub adjust: Option<(Adjusted, Span)>,
    /// `NO THICKNESS` was said.
    pub no_thickness: bool,
    /// `TIED`: the slaves do not leave the master.
    pub is_tied: bool,
    /// Axes of the slave and of the master, by name.
    pub axes: [Option<(String, Span)>; 2],
    /// Faces of both sides that do not meet one another.
    pub left_out: Vec<LeftOut>,
    /// The data line.
    pub origin: Span,
}

/// `*SURFACE PROPERTY ASSIGNMENT`: a thickness that counts in contact.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceThickness {
    pub named: Named,
    /// [L]; `None`: that of its elements.
    pub value: Option<f64>,
    pub factor: f64,
}

/// `*CLEARANCE`: the gap at which the slaves of a pair begin.
#[derive(Clone, Debug)]
pub(crate) struct Clearance {
    pub slave: Named,
    pub master: Named,
    /// [L], negative for an overclosure.
    pub value: f64,
    pub origin: Span,
}

/// `*CONTACT` with the cards that belong to it.
#[derive(Clone, Debug)]
pub(crate) struct GeneralContact {
    pub inclusions: Vec<Two>,
    pub exclusions: Vec<Two>,
    /// Where which surface interaction acts; the last that fits counts.
    pub properties: Vec<(Two, Named)>,
    /// Where slaves begin otherwise, by the name of the data; the last that fits counts.
    pub initializations: Vec<(Two, Named)>,
    pub origin: Span,
}

/// `*CONTACT INITIALIZATION DATA`: how slaves of general contact begin.
#[derive(Clone, Debug)]
pub(crate) struct Initialization {
    pub named: Named,
    pub adjusted: Adjusted,
}

/// Two surfaces of a line; without a name all outer faces.
#[derive(Clone, Debug)]
pub(crate) struct Two {
    pub first: Option<Named>,
    pub second: Option<Named>,
}

impl Two {
    /// Whether the line means contact within its first surface.
    pub fn is_alone(&self) -> bool {
        self.second.is_none()
    }
}

/// How slaves begin: `ADJUST`, a distance or a set of nodes; or a gap.
#[derive(Clone, Debug)]
pub(crate) enum Adjusted {
    Within(f64),
    Set(Target),
    Clearance(f64),
}

/// `*RIGID BODY`.
#[derive(Clone, Debug)]
pub(crate) struct RigidBody {
    pub reference: Target,
    pub reference_span: Span,
    /// Whether the card names it; CalculiX' need not.
    pub has_reference: bool,
    /// `ROT NODE`: the node whose displacements are the rotation.
    pub turn: Option<(Target, Span)>,
    pub tied: Option<Named>,
    /// Nodes that follow with their displacements alone.
    pub pinned: Option<Named>,
    pub elements: Option<Named>,
    pub surface: Option<Named>,
    /// Nodes that carry its analytical surface in space.
    pub markers: Option<[NodeIndex; 4]>,
    pub origin: Span,
}
