//! What loads and motions of a deck act on.

use crate::dofs::DofMap;
use slideline_diag::Span;
use slideline_model::{Dof, Model, NodeIndex};

/// What acts on nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Idle {
    /// A force or a moment.
    Load,
    /// A prescribed motion that is not zero.
    Motion,
}

/// The loads and motions of all steps that have no effect, each with its node and direction and the
/// line of the deck: no element, body, equation or contact gives that node such a motion. A node
/// without any of them may be moved, as a reference node that nothing uses.
pub fn without_effect(model: &Model) -> Vec<(Idle, (NodeIndex, Dof), Span)> {
    let dofs = DofMap::new(model);
    let mut found = Vec::new();
    for step in &model.steps {
        for load in step.loads.iter().filter(|load| load.value != 0.0) {
            let own = dofs.named(load.node, load.dof);
            if own.is_none_or(|own| !dofs.is_active(own)) {
                found.push((Idle::Load, (load.node, load.dof), load.origin));
            }
        }
        for motion in step.prescribed.iter().filter(|motion| motion.moves()) {
            if dofs.named(motion.node, motion.dof).is_none() {
                found.push((Idle::Motion, (motion.node, motion.dof), motion.origin));
            }
        }
    }
    found
}
