//! Clouds of nodes whose mean motion another node follows, and faces that nodes hang at.

use crate::node::{Dof, NodeIndex};
use slideline_diag::Span;
use std::ops::Range;

/// A cloud of nodes whose mean displacement and turn a reference node follows, linearly where its constraints
/// say so, and as the rigid motion that fits best where the kinematics are nonlinear.
#[derive(Clone, Debug, PartialEq)]
pub struct MeanMotion {
    /// The reference node.
    pub reference: NodeIndex,
    /// Which dofs of it are coupled: displacements, and all of its rotations or none.
    pub coupled: [bool; 6],
    /// The nodes with their weights.
    pub cloud: Vec<(NodeIndex, f64)>,
    /// What each of them has in the motion of a node that hangs at faces; of other clouds none, where the weights
    /// say that.
    pub hung: Vec<Hung>,
    /// The linear constraints that it is in small motion.
    pub constraints: Range<usize>,
    /// What follows the others in large motion.
    pub dependents: Vec<(NodeIndex, Dof)>,
    /// Those of them that follow a dof of their own, which turns with the cloud.
    pub turning: Vec<(NodeIndex, Dof)>,
    /// Where it was said.
    pub origin: Span,
}

/// What a node of faces has in the motion of a node that hangs at them.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Hung {
    /// Shares in the displacement along each axis of the model [1].
    pub shares: [f64; 3],
    /// Its displacement in a small turn, a row a direction of the turn [1/L].
    pub turn: [[f64; 3]; 3],
}

/// A cloud of nodes whose mean turn a reference node follows linearly, however far it turns: of which it follows
/// parts only, or where steps of small motion or other constraints leave no choice.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearMeanTurn {
    /// The reference node.
    pub reference: NodeIndex,
    /// The mean turn by the displacement of a node, a row a direction of the turn [1/L].
    pub turns: Vec<(NodeIndex, [[f64; 3]; 3])>,
    /// Where it was said.
    pub origin: Span,
}
