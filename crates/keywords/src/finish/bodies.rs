//! Which nodes rigid bodies move as a whole. What one body moves on both sides of a tie needs none.
//!
//! ```text
//!      \\ s m /         s, m: nodes at the seam of two halves
//!       \\ | /          on a hub: both follow r, and the tie
//!         r            of s to m says nothing new
//! ```

use std::collections::HashMap;

use slideline_model::NodeIndex;

use crate::draft::Draft;

/// Share of a node in a place below which it is none [1].
const NOTHING: f64 = 1e-12;

/// Nodes that follow a rigid body with all displacements, and its reference node.
#[derive(Debug, Default)]
pub(super) struct Bodies(HashMap<NodeIndex, NodeIndex>);

impl Bodies {
    pub fn of(draft: &Draft) -> Self {
        let directions = draft.model.directions();
        let moves = || directions.iter().filter(|dof| !dof.is_rotation());
        let links = draft.model.rigid_links.iter();
        let whole = links.filter(|link| moves().all(|&dof| link.follows[dof as usize]));
        let both = |link: &slideline_model::RigidLink| {
            [(link.dependent, link.master), (link.master, link.master)]
        };
        Self(whole.flat_map(both).collect())
    }

    /// Whether a rigid body moves the node.
    pub fn have(&self, node: NodeIndex) -> bool {
        self.0.contains_key(&node)
    }

    /// Whether one body moves all of these nodes.
    pub fn hold_all(&self, nodes: impl IntoIterator<Item = NodeIndex>) -> bool {
        let mut bodies = nodes.into_iter().map(|node| self.0.get(&node));
        let first = bodies.next().flatten();
        first.is_some() && bodies.all(|other| other == first)
    }

    /// Whether one body moves a slave node and all that it is tied to, so that it stays where it is there.
    /// Two nodes at one place are one in contact, as those that are held alike.
    pub fn hold(&self, node: NodeIndex, shares: &[(NodeIndex, f64)], draft: &mut Draft) -> bool {
        let Some(body) = self.0.get(&node) else { return false };
        let some = || shares.iter().filter(|(_, share)| share.abs() > NOTHING);
        if !some().all(|(own, _)| self.0.get(own) == Some(body)) {
            return false;
        }
        let mut all = some();
        if let (Some(&(one, _)), None) = (all.next(), all.next()) {
            let dofs = draft.model.directions().iter().filter(|dof| !dof.is_rotation());
            let alike: Vec<_> = dofs.map(|&dof| ((node, dof), one)).collect();
            alike.into_iter().for_each(|(own, one)| _ = draft.held_alike.insert(own, one));
        }
        true
    }
}
