//! Rigid links: each dependent node follows one master.

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{NodeIndex, RigidLink};

use crate::draft::{Draft, Link};
use crate::keyword::Subject;

pub(super) fn links(draft: &mut Draft) {
    let mut dependents: HashMap<NodeIndex, Span> = HashMap::new();
    for link in std::mem::take(&mut draft.links) {
        one(&link, &mut dependents, draft);
    }
    chains(&dependents, draft);
}

fn one(link: &Link, dependents: &mut HashMap<NodeIndex, Span>, draft: &mut Draft) {
    let masters = draft.nodes_of(&link.master, link.master_span);
    let nodes = draft.nodes_of(&link.dependent, link.dependent_span);
    if masters.len() > 1 {
        let message = format!("the master must be one node, but this set has {}", masters.len());
        let error = Diagnostic::error(Code("SL0317"), message).at(link.master_span);
        draft.consequence(Subject::Links, error);
    }
    let [master] = *masters else { return };
    for dependent in nodes {
        let label = draft.model.nodes.label(dependent);
        if dependent == master {
            let message = format!("node {label} cannot be linked to itself");
            let error = Diagnostic::error(Code("SL0317"), message).at(link.origin);
            draft.consequence(Subject::Links, error);
            continue;
        }
        if let Some(&first) = dependents.get(&dependent) {
            let message = format!("node {label} is a dependent node twice");
            let error = Diagnostic::error(Code("SL0316"), message).at(link.origin);
            draft.consequence(Subject::Links, error.label(first, "linked here first"));
            continue;
        }
        dependents.insert(dependent, link.origin);
        let origin = link.origin;
        draft.model.rigid_links.push(RigidLink { dependent, master, origin });
    }
}

/// A master that depends on another node itself.
fn chains(dependents: &HashMap<NodeIndex, Span>, draft: &mut Draft) {
    for link in draft.model.rigid_links.clone() {
        let Some(&first) = dependents.get(&link.master) else { continue };
        let label = draft.model.nodes.label(link.master);
        let message = format!("the master node {label} depends on another node itself");
        let error = Diagnostic::error(Code("SL0317"), message).at(link.origin);
        let error = error.label(first, "it is a dependent node here");
        draft.consequence(Subject::Links, error.help("link all nodes to the same master"));
    }
}
