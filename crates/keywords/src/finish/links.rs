//! Rigid links: each dependent node follows one master. `*MPC` gives them one
//! by one, `*RIGID BODY` for its whole body.

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{NodeIndex, RigidLink};

use crate::draft::{Draft, Link};
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::RigidBody;

pub(super) fn links(draft: &mut Draft) {
    let mut dependents: HashMap<NodeIndex, Span> = HashMap::new();
    for link in std::mem::take(&mut draft.links) {
        one(&link, &mut dependents, draft);
    }
    for body in draft.bodies.clone() {
        tie_body(&body, &mut dependents, draft);
    }
    chains(&dependents, draft);
}

/// Ties the nodes of a rigid body to its reference node, each once; the
/// reference node itself may be among them.
fn tie_body(body: &RigidBody, dependents: &mut HashMap<NodeIndex, Span>, draft: &mut Draft) {
    let reference = draft.reference_of(&body.reference, body.reference_span);
    let mut nodes = Vec::new();
    if let Some(set) = &body.tied {
        nodes.extend(draft.nodes_of(&Target::Set(set.name.clone()), set.span));
    }
    if let Some(set) = &body.elements {
        for index in draft.elements_of(&set.name, set.span).unwrap_or_default() {
            let element = draft.elements[index];
            let labels = element.nodes().iter();
            nodes.extend(labels.filter_map(|&label| draft.model.nodes.find(label)));
        }
    }
    let Some(master) = reference else { return };
    let mut seen = HashSet::from([master]);
    for dependent in nodes.into_iter().filter(|&node| seen.insert(node)) {
        tie(dependent, master, body.origin, dependents, draft);
    }
}

fn tie(
    dependent: NodeIndex,
    master: NodeIndex,
    origin: Span,
    dependents: &mut HashMap<NodeIndex, Span>,
    draft: &mut Draft,
) {
    if let Some(&first) = dependents.get(&dependent) {
        let label = draft.model.nodes.label(dependent);
        let message = format!("node {label} is a dependent node twice");
        let error = Diagnostic::error(Code("SL0316"), message).at(origin);
        draft.consequence(Subject::Links, error.label(first, "linked here first"));
        return;
    }
    dependents.insert(dependent, origin);
    draft.model.rigid_links.push(RigidLink::welded(dependent, master, origin));
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
        tie(dependent, master, link.origin, dependents, draft);
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
