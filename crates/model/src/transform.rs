//! Nodes with axes of their own: `*TRANSFORM`.

use crate::{Model, NodeIndex};
use slideline_diag::Span;
use slideline_mech::axes::{Axes, System};

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

impl Model {
    /// Whether some node has axes of its own.
    pub fn has_own_axes(&self) -> bool {
        !self.transforms.is_empty()
    }

    /// The axes along which the degrees of freedom of a node are named, where these are not
    /// those of the model.
    pub fn axes_of(&self, node: NodeIndex) -> Option<Axes> {
        let own = self.transforms.iter().find(|own| own.nodes.contains(&node))?;
        Some(own.system.at(self.nodes.position(node)))
    }
}
