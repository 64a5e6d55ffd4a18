//! The forces of one element at its nodes.

use super::contributions::Contributions;
use super::elements::Structure;
use slideline_model::{ElementIndex, NodeIndex};

impl Structure<'_> {
    /// Calls back with the forces of an element along the axes of the model, node by node [F]; not at
    /// all for one that is rigid as a whole.
    pub fn forces_of(
        &self,
        element: ElementIndex,
        from: &Contributions,
        mut call: impl FnMut(NodeIndex, [f64; 3]),
    ) {
        let Some(index) = self.numbering.index_of(element) else { return };
        let (block, _) = self.element(index);
        let forces = from.force[block.own(index)].chunks_exact(block.dofs.len().max(1));
        for (&node, own) in self.numbering.nodes[block.nodes(index)].iter().zip(forces) {
            let mut force = [0.0; 3];
            for (dof, value) in block.dofs.iter().zip(own).take(block.translations) {
                force[*dof as usize] = *value;
            }
            call(node, force);
        }
    }
}
