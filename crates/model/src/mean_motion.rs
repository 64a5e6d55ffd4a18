//! Clouds of nodes whose mean motion another node follows.

use crate::node::NodeIndex;
use slideline_diag::Span;

/// A cloud of nodes whose mean displacement and turn a reference node follows linearly.
#[derive(Clone, Debug, PartialEq)]
pub struct MeanMotion {
    /// The reference node.
    pub reference: NodeIndex,
    /// The mean turn by the displacement of a node, a row a direction of the turn [1/L].
    pub turns: Vec<(NodeIndex, [[f64; 3]; 3])>,
    /// Where it was said.
    pub origin: Span,
}
