//! `*SECTION PRINT`: what passes through a surface of solids.

use crate::node::NodeIndex;
use crate::presence::ElementIndex;
use crate::request::Request;
use slideline_mech::pressure::Face;

/// What passes through a surface of solids.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionPrint {
    /// Name of the surface, frequency, file.
    pub request: Request,
    /// Its own name.
    pub name: String,
    /// Whether a request for contact of surfaces that are tied asked for it.
    pub is_tied: bool,
    /// The faces of the surface.
    pub faces: Vec<SectionFace>,
    /// The elements behind them, each once.
    pub shares: Vec<SectionShare>,
    /// Columns.
    pub variables: Vec<SectionVariable>,
}

/// A face of such a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionFace {
    /// What it is.
    pub face: Face,
    /// Its nodes.
    pub nodes: Vec<NodeIndex>,
}

/// An element behind such a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionShare {
    /// The element.
    pub element: ElementIndex,
    /// Its nodes on the surface.
    pub nodes: Vec<NodeIndex>,
}

/// A sum over a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SectionVariable {
    /// Force.
    SOF,
    /// Moment about the origin.
    SOM,
    /// Area.
    SOAREA,
}
