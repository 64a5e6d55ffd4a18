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
use slideline_model::{Formulation, Interaction, ProfilePoint, SurfaceSegment};

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
    pub origin: Span,
}

/// What a surface is made of.
#[derive(Clone, Debug)]
pub(crate) enum Extent {
    Elements(Vec<Stretch>),
    Nodes(Vec<(Target, Span)>),
    Rigid { start: ProfilePoint, segments: Vec<SurfaceSegment> },
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
}

/// A data line of `*CONTACT PAIR`.
#[derive(Clone, Debug)]
pub(crate) struct Pairing {
    pub slave: Named,
    pub master: Named,
    pub interaction: Named,
    pub formulation: Formulation,
    pub smooth: f64,
    pub extension: f64,
    /// `SMOOTH` or `EXTENSION ZONE`, where the card gives one.
    pub chain_parameter: Option<(&'static str, Span)>,
    /// `ADJUST`, and where it was said.
    pub adjust: Option<(Adjusted, Span)>,
    /// `NO THICKNESS` was said.
    pub no_thickness: bool,
    /// The data line.
    pub origin: Span,
}

/// `ADJUST`: a distance or a set of nodes.
#[derive(Clone, Debug)]
pub(crate) enum Adjusted {
    Within(f64),
    Set(Target),
}

/// `*RIGID BODY`.
#[derive(Clone, Debug)]
pub(crate) struct RigidBody {
    pub reference: Target,
    pub reference_span: Span,
    /// `ROT NODE`: the node whose displacements are the rotation.
    pub turn: Option<(Target, Span)>,
    pub tied: Option<Named>,
    /// Nodes that follow with their displacements alone.
    pub pinned: Option<Named>,
    pub elements: Option<Named>,
    pub surface: Option<Named>,
    pub origin: Span,
}
