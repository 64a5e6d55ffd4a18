//! Who follows whom: rigid links of `*MPC`, `*RIGID BODY` and `*KINEMATIC`, nodes with equal
//! dofs, and what equations and couplings make of dofs.

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dof, NodeIndex, RigidLink};

use super::equations;
use super::faces::nodes_of_surface;
use crate::constraints::{Coupling, CouplingKind, Link, LinkKind, Points};
use crate::draft::Draft;
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::RigidBody;

pub(super) fn links(draft: &mut Draft) {
    for link in std::mem::take(&mut draft.links) {
        one(&link, draft);
    }
    for body in draft.bodies.clone() {
        tie_body(&body, draft);
    }
    let (kinematic, others): (Vec<_>, Vec<_>) = std::mem::take(&mut draft.couplings)
        .into_iter()
        .partition(|coupling| matches!(coupling.kind, CouplingKind::Kinematic(_)));
    for coupling in kinematic {
        couple(&coupling, draft);
    }
    chains(draft);
    equations::equations(draft);
    for coupling in others {
        couple(&coupling, draft);
    }
    super::ties::ties(draft);
    equations::circles(draft);
}

/// Ties the nodes of a rigid body to its reference node, each once; the
/// reference node itself may be among them.
fn tie_body(body: &RigidBody, draft: &mut Draft) {
    let reference = draft.reference_of(&body.reference, body.reference_span);
    let turn = body.turn.as_ref().and_then(|(node, span)| draft.reference_of(node, *span));
    let mut nodes = Vec::new();
    if let Some(set) = &body.tied {
        let tied = draft.nodes_of(&Target::Set(set.name.clone()), set.span);
        nodes.extend(tied.into_iter().map(|node| (node, RigidLink::WELDED)));
    }
    if let Some(set) = &body.elements {
        for index in draft.elements_of(&set.name, set.span).unwrap_or_default() {
            let element = draft.elements[index];
            let labels = element.nodes().iter();
            let own = labels.filter_map(|&label| draft.model.nodes.find(label));
            nodes.extend(own.map(|node| (node, RigidLink::WELDED)));
        }
    }
    if let Some(set) = &body.pinned {
        let pinned = draft.nodes_of(&Target::Set(set.name.clone()), set.span);
        nodes.extend(pinned.into_iter().map(|node| (node, RigidLink::PINNED)));
    }
    let Some(master) = reference else { return };
    let mut seen = HashSet::from([master]);
    seen.extend(turn);
    for (dependent, follows) in nodes.into_iter().filter(|&(node, _)| seen.insert(node)) {
        tie(RigidLink { dependent, master, follows, turn, origin: body.origin }, draft);
    }
}

fn tie(link: RigidLink, draft: &mut Draft) {
    let RigidLink { dependent, origin, .. } = link;
    let own = |dof: &Dof| link.follows[*dof as usize];
    let dofs: Vec<Dof> = Dof::ALL.into_iter().filter(own).collect();
    let taken = dofs.iter().find_map(|&dof| draft.dependents.get(&(dependent, dof)).copied());
    if let Some(first) = taken {
        let label = draft.model.nodes.label(dependent);
        let message = format!("node {label} is a dependent node twice");
        let error = Diagnostic::error(Code("SL0316"), message).at(origin);
        draft.consequence(Subject::Links, error.label(first, "linked here first"));
        return;
    }
    draft.dependents.extend(dofs.into_iter().map(|dof| ((dependent, dof), origin)));
    draft.model.rigid_links.push(link);
}

fn one(link: &Link, draft: &mut Draft) {
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
        match link.kind {
            LinkKind::Beam => tie(RigidLink::welded(dependent, master, link.origin), draft),
            LinkKind::Tie | LinkKind::Pin => equal(link, dependent, master, draft),
        }
    }
}

/// Equal displacements, and equal rotations where both nodes turn.
fn equal(link: &Link, dependent: NodeIndex, master: NodeIndex, draft: &mut Draft) {
    for &dof in draft.model.directions() {
        let turn = dof.is_rotation();
        if turn && (link.kind == LinkKind::Pin || !turns([dependent, master], dof, draft)) {
            continue;
        }
        let terms = draft.followed((dependent, dof), |dof| vec![(master, dof, 1.0)]);
        equations::add(draft, (dependent, dof), terms, link.origin);
    }
}

/// Whether elements or bodies turn all of these nodes.
fn turns(nodes: [NodeIndex; 2], dof: Dof, draft: &Draft) -> bool {
    let bodies = &draft.model.rigid_links;
    let with = draft.model.blocks.iter().filter(|block| block.stiffened_dofs().contains(&dof));
    let elements = || with.clone().flat_map(|block| &block.elements);
    nodes.into_iter().all(|node| {
        elements().any(|element| element.nodes.contains(&node))
            || bodies.iter().any(|link| link.master == node)
    })
}

/// The nodes of a coupling and its reference node.
fn couple(coupling: &Coupling, draft: &mut Draft) {
    let reference = draft.reference_of(&coupling.reference, coupling.reference_span);
    let mut nodes: Vec<(NodeIndex, f64)> = Vec::new();
    for points in &coupling.points {
        match points {
            Points::Nodes { target, span, weight } => {
                let found = draft.nodes_of(target, *span);
                nodes.extend(found.into_iter().map(|node| (node, *weight)));
            }
            Points::Surface(named) => {
                let Some(surface) = draft.surface(named) else { continue };
                let found = nodes_of_surface(&surface, draft);
                nodes.extend(found.into_iter().map(|node| (node, 1.0)));
            }
        }
    }
    let Some(master) = reference else { return };
    let mut seen = HashSet::from([master]);
    nodes.retain(|&(node, _)| seen.insert(node));
    let origin = coupling.origin;
    match coupling.kind {
        CouplingKind::Kinematic(follows) => {
            for (dependent, _) in nodes {
                tie(RigidLink { dependent, master, follows, turn: None, origin }, draft);
            }
        }
        CouplingKind::Distributing(dofs) => {
            super::distributing::distribute(master, dofs, &nodes, origin, draft);
        }
        CouplingKind::Open => {
            let message = "*COUPLING does not say how: *KINEMATIC or *DISTRIBUTING must follow";
            let error = Diagnostic::error(Code("SL0205"), message).at(origin);
            draft.consequence(Subject::Links, error);
        }
    }
}

/// A master that depends on another node itself.
fn chains(draft: &mut Draft) {
    for link in draft.model.rigid_links.clone() {
        let own = |dof: &Dof| draft.dependents.get(&(link.master, *dof)).copied();
        let Some(first) = Dof::ALL.iter().find_map(own) else { continue };
        let label = draft.model.nodes.label(link.master);
        let message = format!("the master node {label} depends on another node itself");
        let error = Diagnostic::error(Code("SL0317"), message).at(link.origin);
        let error = error.label(first, "it is a dependent node here");
        draft.consequence(Subject::Links, error.help("link all nodes to the same master"));
    }
}
