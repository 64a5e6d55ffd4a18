//! Models of which every body is clamped somewhere: nothing is loose.

use crate::dofs::DofMap;
use slideline_model::{Model, NodeIndex, Step};

/// Whether every body that beams and links join has a node of which all is held, turns as well: nothing is loose. A quick answer
/// without the lists of a [`Restraint`](super::Restraint), which may be no where supports hold all.
pub fn all_are_clamped(
    (model, step): (&Model, &Step),
    (dofs, is_held): (&DofMap, impl Fn(usize) -> bool),
) -> bool {
    let mut parent: Vec<NodeIndex> = (0..model.nodes.len()).collect();
    // halves the way to the root on each walk
    let root = |parent: &mut [NodeIndex], mut node: NodeIndex| {
        while parent[node] != node {
            parent[node] = parent[parent[node]];
            node = parent[node];
        }
        node
    };
    let mut join = |a: NodeIndex, b: NodeIndex| {
        let [a, b] = [a, b].map(|node| root(&mut parent, node));
        parent[a.max(b)] = a.min(b);
    };
    for (_, element) in
        step.presence.elements(&model.blocks).filter(|(block, _)| block.kind.joins())
    {
        element.nodes.windows(2).for_each(|ends| join(ends[0], ends[1]));
    }
    for link in &model.rigid_links {
        // with all that it has, turns as well
        if dofs.of_node(link.dependent).all(|dof| link.follows[dofs.name(dof).1 as usize]) {
            join(link.master, link.dependent);
        }
    }
    let own = |node: NodeIndex| dofs.of_node(node);
    let mut clamped = vec![false; parent.len()];
    for node in 0..parent.len() {
        let turns = own(node).any(|dof| dofs.is_rotation(dof));
        clamped[root(&mut parent, node)] |= turns && own(node).all(&is_held);
    }
    (0..clamped.len()).all(|node| own(node).all(&is_held) || clamped[root(&mut parent, node)])
}
