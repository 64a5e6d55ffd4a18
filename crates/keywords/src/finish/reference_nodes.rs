//! Reference nodes of rigid bodies that name none.
//!
//! ```text
//!     o---o
//!     | + |    the middle of the nodes that move with the body
//!     o---o
//! ```

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Node, NodeIndex};

use crate::draft::Draft;
use crate::log::Target;
use crate::surfaces::RigidBody;

/// Gives every body of CalculiX that names no reference node one of its own. Where it stands does not matter: nothing
/// is said of it.
pub(super) fn reference_nodes(draft: &mut Draft) {
    for place in 0..draft.bodies.len() {
        let body = draft.bodies[place].clone();
        if body.has_reference {
            continue;
        }
        let own = nodes_of_body(&body, draft);
        let last = (0..draft.model.nodes.len()).map(|node| draft.model.nodes.label(node)).max();
        let (Some(position), Some(last)) = (middle(&own, draft), last) else { continue };
        let (label, origin) = (last + 1, body.origin);
        draft.model.nodes.insert(Node { label, position, origin });
        draft.bodies[place].reference = Target::Label(label);
        let message =
            format!("this rigid body names no REF NODE: node {label} in its middle is its own");
        draft.log.push(Diagnostic::note(Code("SL0253"), message).at(origin));
    }
}

fn nodes_of_body(body: &RigidBody, draft: &mut Draft) -> Vec<NodeIndex> {
    let mut nodes = Vec::new();
    for set in body.tied.iter().chain(&body.pinned) {
        nodes.extend(draft.nodes_of(&Target::Set(set.name.clone()), set.span));
    }
    if let Some(set) = &body.elements {
        for index in draft.elements_of(&set.name, set.span).unwrap_or_default() {
            let labels = draft.elements[index];
            let found = labels.nodes().iter().filter_map(|&label| draft.model.nodes.find(label));
            nodes.extend(found);
        }
    }
    nodes
}

fn middle(nodes: &[NodeIndex], draft: &Draft) -> Option<[f64; 3]> {
    let count = nodes.len() as f64;
    let sum =
        |axis: usize| nodes.iter().map(|&node| draft.model.nodes.position(node)[axis]).sum::<f64>();
    (!nodes.is_empty()).then(|| [0, 1, 2].map(|axis| sum(axis) / count))
}
