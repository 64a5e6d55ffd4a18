//! Nodes with axes of their own: `*TRANSFORM`.

use crate::node::NodeIndex;
use slideline_diag::Span;
use slideline_mech::axes::System;

/// Nodes whose degrees of freedom are named along axes of their own: what is prescribed, loaded
/// or linked there acts along these. Positions and results stay in the axes of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Transform {
    /// The nodes, each in one transform only.
    pub nodes: Vec<NodeIndex>,
    /// Their axes.
    pub system: System,
    /// Where it was said.
    pub origin: Span,
}
