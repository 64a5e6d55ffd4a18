//! Nodes that absent elements leave without anything that moves them.
//!
//! ```text
//!   A====B....C----D   ==== there   .... joined by a constraint   ---- absent
//!                      A to C are moved, D is not; without A====B none is
//! ```

use slideline_model::{Model, NodeIndex, Presence};
use std::collections::HashSet;

/// Nodes of absent elements, and those that constraints join to them, which nothing that is there
/// moves: no element, no pair, no body, and none of those to which they are joined.
pub(super) fn unmoved_nodes(presence: &Presence, model: &Model) -> HashSet<NodeIndex> {
    let absent = presence.absent.iter().filter_map(|&(block, member)| {
        model.blocks.get(block).map(|own| own.elements.get(member).nodes)
    });
    let mut left: HashSet<NodeIndex> = absent.flatten().copied().collect();
    let there = presence.elements(&model.blocks).flat_map(|(_, element)| element.nodes);
    let mut moved: HashSet<NodeIndex> = there.copied().collect();
    let pairs = model.contact_pairs.iter().enumerate();
    for (_, pair) in pairs.filter(|(place, _)| presence.has_pair(*place)) {
        moved.extend(pair.slave_places().chain(pair.master.deforming_nodes()));
        moved.extend(pair.rigid_surfaces().map(|surface| surface.reference));
    }
    let links = model.rigid_links.iter().map(|own| vec![own.dependent, own.master]);
    let joined = model.linear_constraints.iter().map(|own| {
        let terms = own.terms.iter().map(|&(node, ..)| node);
        terms.chain([own.dependent.0]).collect::<Vec<NodeIndex>>()
    });
    let joined: Vec<Vec<NodeIndex>> = links.chain(joined).collect();
    loop {
        let before = (left.len(), moved.len());
        for nodes in &joined {
            for list in [&mut left, &mut moved] {
                if nodes.iter().any(|node| list.contains(node)) {
                    list.extend(nodes);
                }
            }
        }
        if before == (left.len(), moved.len()) {
            left.retain(|node| !moved.contains(node));
            return left;
        }
    }
}
