//! Who follows whom: rigid links of `*MPC`, `*RIGID BODY` and `*KINEMATIC`, nodes with equal
//! dofs, and what equations and couplings make of dofs.

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dof, NodeIndex, NumberedSet, RigidLink};

use super::coupling::couple;
use super::equations;
use super::rigid_link::tie;
use crate::constraints::{CouplingKind, Link, LinkKind};
use crate::draft::Draft;
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::RigidBody;

pub(super) fn links(draft: &mut Draft) {
    let (beams, equal): (Vec<_>, Vec<_>) =
        std::mem::take(&mut draft.links).into_iter().partition(|link| link.kind == LinkKind::Beam);
    for link in beams {
        one(&link, &NumberedSet::default(), draft);
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
    rigid_meshes(draft);
    chains(draft);
    let turning = if equal.is_empty() { NumberedSet::default() } else { turning(draft) };
    for link in equal {
        one(&link, &turning, draft);
    }
    equations::equations(draft);
    for coupling in others {
        couple(&coupling, draft);
    }
    super::springs::cross(draft);
    super::embedded::embed(draft);
    super::shape_mpc::shapes(draft);
    super::ties::ties(draft);
    super::turned_means::turn_far(draft);
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
    let markers = body.markers.into_iter().flatten();
    nodes.extend(markers.map(|node| (node, RigidLink::PINNED)));
    let Some(master) = reference else { return };
    let mut seen = HashSet::from([master]);
    seen.extend(turn);
    for (dependent, follows) in nodes.into_iter().filter(|&(node, _)| seen.insert(node)) {
        tie(RigidLink { dependent, master, follows, turn, origin: body.origin }, draft);
    }
}

fn one(link: &Link, turning: &NumberedSet<(NodeIndex, Dof)>, draft: &mut Draft) {
    let masters = draft.nodes_of(&link.master, link.master_span);
    let nodes = draft.nodes_of(&link.dependent, link.dependent_span);
    if masters.len() > 1 {
        let message = format!("the master must be one node, but this set has {}", masters.len());
        let error = Diagnostic::error(Code("SL0317"), message).at(link.master_span);
        draft.consequence(Subject::Links, error);
    }
    let [master] = *masters else { return };
    draft.dependents.reserve(Dof::ALL.len() * nodes.len());
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
            LinkKind::Tie | LinkKind::Pin => equal(link, (dependent, master), turning, draft),
        }
    }
}

/// Equal displacements, and equal rotations where both nodes turn.
fn equal(
    link: &Link,
    (dependent, master): (NodeIndex, NodeIndex),
    turning: &NumberedSet<(NodeIndex, Dof)>,
    draft: &mut Draft,
) {
    let turns = |dof| [dependent, master].iter().all(|&node| turning.contains(&(node, dof)));
    let wanted = draft
        .model
        .directions()
        .iter()
        .filter(|dof| !dof.is_rotation() || (link.kind != LinkKind::Pin && turns(**dof)));
    for dof in wanted.copied().collect::<Vec<_>>() {
        let terms = draft.followed((dependent, dof), |dof| vec![(master, dof, 1.0)]);
        equations::add(draft, (dependent, dof), terms, link.origin);
    }
}

/// Nodes and their rotations that elements or bodies turn.
pub(super) fn turning(draft: &Draft) -> NumberedSet<(NodeIndex, Dof)> {
    let masters = draft.model.rigid_links.iter().map(|link| link.master);
    let rotations = || Dof::ALL.into_iter().filter(|dof| dof.is_rotation());
    let mut turning: NumberedSet<(NodeIndex, Dof)> =
        masters.flat_map(|node| rotations().map(move |dof| (node, dof))).collect();
    for block in &draft.model.blocks {
        for &dof in block.dofs().iter().filter(|dof| dof.is_rotation()) {
            let nodes = block.elements.iter().flat_map(|element| element.nodes);
            turning.extend(nodes.map(|&node| (node, dof)));
        }
    }
    turning
}

/// Complains about rigid meshes that belong to no rigid body.
fn rigid_meshes(draft: &mut Draft) {
    let mut owned = HashSet::new();
    for body in draft.bodies.clone() {
        let Some(set) = &body.elements else { continue };
        owned.extend(draft.elements_of(&set.name, set.span).unwrap_or_default());
    }
    let lonely = draft.elements.iter().enumerate().find_map(|(index, element)| {
        let bare = element.kind.bare().filter(|_| !owned.contains(&index))?;
        Some((bare.name, element.label, element.origin))
    });
    if let Some((name, label, origin)) = lonely {
        let message = format!("element {label} of type {name} belongs to no *RIGID BODY");
        let error = Diagnostic::error(Code("SL0307"), message).at(origin);
        let help = "*RIGID BODY, REF NODE=..., ELSET=... makes one of its set";
        draft.consequence(Subject::Links, error.help(help));
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
