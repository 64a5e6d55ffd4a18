//! Shapes that nodes keep in large motion.

use crate::node::NodeIndex;
use slideline_mech::kept_shape;

/// What a linear constraint keeps where the kinematics are nonlinear: its coefficients are those of
/// the undeformed places.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptShape {
    /// Index of the linear constraint.
    pub constraint: usize,
    /// What is kept.
    pub shape: kept_shape::KeptShape,
    /// Its nodes, each once, in the order that the shape has.
    pub nodes: Vec<NodeIndex>,
    /// The node whose first displacement is the angle of a mean turn.
    pub angle: Option<NodeIndex>,
}
