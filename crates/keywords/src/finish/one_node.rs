//! Nodes that equations make one are one node in contact.
//!
//! ```text
//!   o-----o s    m o-----o      u_s = u_m, at one place: without this two points of hard contact would
//!   |  A  |        |  B  |      share one force at will, and friction begin anew at whichever takes it;
//!   o-----o        o-----o      a master would have an edge where there is none
//! ```

use std::collections::{HashMap, HashSet};

use slideline_mech::vector::{size, sub};
use slideline_model::{
    Adjust, ContactPair, Dof, Formulation, LinearConstraint, Master, NodeIndex, Offset,
};

use crate::changes::{Changed, ModelChange};
use crate::draft::Draft;
use crate::rule::Subject;

/// What factors of ties may be off [1].
const LOOSE: f64 = 1e-12;

/// Distance of two nodes at one place in lengths of the face about them [1]: as near as *TIE takes for
/// touching.
const APART: f64 = 1e-6;

/// Whether a factor of a tie is one.
pub(super) fn is_one(factor: f64) -> bool {
    (factor - 1.0).abs() <= LOOSE
}

/// Puts the node that another one follows in its place in every pair.
pub(super) fn in_contact(draft: &mut Draft) {
    let leaders = leaders(draft);
    let led = |node| leaders.get(&node).copied().unwrap_or(node);
    for ([one, other], said) in std::mem::take(&mut draft.joined_ends) {
        if led(one) != led(other) {
            draft.consequence(Subject::Elements, said);
        }
    }
    // where elements come and go one of both nodes may be left without any
    let of_elements = |own: &ModelChange| matches!(own.of, Changed::Elements(_));
    draft.model.seams = seams_of_cuts(draft);
    if leaders.is_empty() || draft.steps.iter().any(|step| step.changes.iter().any(of_elements)) {
        return;
    }
    let mut seams = std::mem::take(&mut draft.model.seams);
    let mut pairs = std::mem::take(&mut draft.model.contact_pairs);
    for pair in pairs.iter_mut().filter(|pair| is_of_nodes(pair)) {
        let own = taken(pair, &leaders, draft);
        replace(pair, &own);
        seams.extend(own.into_iter().map(|(node, leader)| [node, leader]));
    }
    seams.sort_unstable();
    seams.dedup();
    draft.model.seams = seams;
    draft.model.contact_pairs = pairs;
}

/// The nodes that cuts have added, with those that they stand for.
fn seams_of_cuts(draft: &Draft) -> Vec<[NodeIndex; 2]> {
    let nodes = &draft.model.nodes;
    let added = draft.behind_cuts.iter().flat_map(|(original, own)| {
        own.iter().filter_map(|own| Some([nodes.find(*own)?, nodes.find(*original)?]))
    });
    let mut seams: Vec<_> = added.collect();
    seams.sort_unstable();
    seams
}

/// Whether the pair asks for places of nodes and nothing else, and its sides are two.
fn is_of_nodes(pair: &ContactPair) -> bool {
    let turns = pair.formulation == Formulation::SurfaceToSurface || pair.offset != Offset::NONE;
    !turns && !pair.meets_itself()
}

/// Nodes that follow another one in all displacements, and the last one of those.
fn leaders(draft: &Draft) -> HashMap<NodeIndex, NodeIndex> {
    let rows = draft.model.linear_constraints.iter();
    let rows: HashMap<_, _> = rows.map(|row| (row.dependent, row)).collect();
    let one = |row: &LinearConstraint| match told(row, draft)[..] {
        [(node, dof, factor)] if row.constant == 0.0 && dof == row.dependent.1 => {
            is_one(factor).then_some(node)
        }
        _ => None,
    };
    let directions = draft.model.directions();
    let leader = |node: NodeIndex| {
        let moves = directions.iter().filter(|dof| !dof.is_rotation());
        let mut all = moves.map(|&dof| match rows.get(&(node, dof)) {
            Some(row) => one(row),
            None => draft.held_alike.get(&(node, dof)).copied(),
        });
        let first = all.next()??;
        let same = all.all(|own| own == Some(first));
        (same && draft.axes_of(node) == draft.axes_of(first)).then_some(first)
    };
    let dependents = rows.keys().chain(draft.held_alike.keys());
    let dependents: HashSet<NodeIndex> = dependents.map(|(node, _)| *node).collect();
    let next: HashMap<_, _> =
        dependents.into_iter().filter_map(|node| Some((node, leader(node)?))).collect();
    let last = last(&next);
    last.into_iter().filter(|(node, last)| node != last).collect()
}

/// The last one of those that each node follows. Who follows himself by way of others is no leader: that is an
/// error, said elsewhere; but where a body holds both sides of ties of two ways, one of the ring leads all.
fn last(next: &HashMap<NodeIndex, NodeIndex>) -> HashMap<NodeIndex, NodeIndex> {
    let mut last: HashMap<NodeIndex, NodeIndex> = HashMap::with_capacity(next.len());
    for &first in next.keys() {
        let (mut path, mut places) = (Vec::new(), HashMap::new());
        let mut node = first;
        let end = loop {
            if let Some(&known) = last.get(&node) {
                break known;
            }
            if let Some(&place) = places.get(&node) {
                let ring: &[NodeIndex] = &path[place..];
                break ring.iter().copied().min().unwrap_or(node);
            }
            let Some(&leader) = next.get(&node) else { break node };
            places.insert(node, path.len());
            path.push(node);
            node = leader;
        };
        last.extend(path.into_iter().map(|node| (node, end)));
    }
    last
}

/// What a dof follows, where dofs that are held alike are one: a mean beside a supported node has what
/// that node would follow, less that node.
fn told(row: &LinearConstraint, draft: &Draft) -> Vec<(NodeIndex, Dof, f64)> {
    let mut told: Vec<(NodeIndex, Dof, f64)> = Vec::with_capacity(row.terms.len());
    for &(node, dof, factor) in &row.terms {
        let node = draft.held_alike.get(&(node, dof)).copied().unwrap_or(node);
        match told.iter_mut().find(|own| (own.0, own.1) == (node, dof)) {
            Some((.., sum)) => *sum += factor,
            None => told.push((node, dof, factor)),
        }
    }
    told.retain(|(.., factor)| factor.abs() > LOOSE);
    told
}

/// Which nodes of a pair are at the place of the node that they follow, which is not one of the
/// other side.
fn taken(
    pair: &ContactPair,
    leaders: &HashMap<NodeIndex, NodeIndex>,
    draft: &Draft,
) -> HashMap<NodeIndex, NodeIndex> {
    let slaves = pair.elements.iter().map(|own| own.nodes.to_vec());
    let slaves: Vec<_> = slaves.chain(pair.faces.iter().map(|face| face.nodes.clone())).collect();
    let masters = match &pair.master {
        Master::Faces(own) => own.faces.iter().map(|face| face.nodes.clone()).collect(),
        Master::SlideLine(line) => line.nodes.windows(2).map(<[NodeIndex]>::to_vec).collect(),
        Master::RigidSurface(_) | Master::Itself(_) => Vec::new(),
    };
    let mut taken = HashMap::new();
    for (own, other) in [(&slaves, &masters), (&masters, &slaves)] {
        let led = |node: &NodeIndex| leaders.get(node).copied().unwrap_or(*node);
        let beyond: HashSet<NodeIndex> = other.iter().flatten().map(led).collect();
        for face in own {
            for &node in face {
                let Some(&leader) = leaders.get(&node) else { continue };
                if !beyond.contains(&leader) && is_at(node, leader, face, draft) {
                    taken.insert(node, leader);
                }
            }
        }
    }
    taken
}

/// Whether two nodes are at one place, as faces about the first are large. A face that has none but these two
/// tells nothing: its own ends are not at one place.
pub(super) fn is_at(node: NodeIndex, other: NodeIndex, face: &[NodeIndex], draft: &Draft) -> bool {
    let place = |node| draft.model.nodes.position(node);
    let apart = |a: NodeIndex, b: NodeIndex| size(sub(place(a), place(b)));
    let others = face.iter().filter(|&&own| own != node && own != other);
    let nearest = others.map(|&own| apart(node, own)).fold(f64::INFINITY, f64::min);
    nearest.is_finite() && apart(node, other) <= APART * nearest
}

/// Puts nodes in the place of others.
fn replace(pair: &mut ContactPair, by: &HashMap<NodeIndex, NodeIndex>) {
    if by.is_empty() {
        return;
    }
    let put = |node: &mut NodeIndex| *node = by.get(node).copied().unwrap_or(*node);
    pair.elements.iter_mut().for_each(|own| own.nodes.iter_mut().for_each(put));
    pair.elements.retain(|own| own.nodes[0] != own.nodes[1]);
    pair.faces.iter_mut().for_each(|face| face.nodes.iter_mut().for_each(put));
    pair.slaves.iter_mut().for_each(put);
    if let Adjust::Nodes(own) = &mut pair.adjust {
        own.iter_mut().for_each(put);
    }
    pair.corners.iter_mut().for_each(put);
    match &mut pair.master {
        Master::Faces(own) => {
            own.faces.iter_mut().for_each(|face| face.nodes.iter_mut().for_each(put));
        }
        Master::SlideLine(line) => {
            line.nodes.iter_mut().for_each(put);
            line.join_ends();
        }
        Master::RigidSurface(_) | Master::Itself(_) => {}
    }
    for own in &mut pair.left_out {
        let faces = own.slave.iter_mut().chain(&mut own.master);
        faces.for_each(|face| face.iter_mut().for_each(put));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: rings have one leader, rows their last one, and long ones take time that grows with their
    /// number.
    #[test]
    fn long_rings_have_one_leader() {
        let count = 100_000;
        let mut next: HashMap<NodeIndex, NodeIndex> =
            (10..count).map(|node| (node, node + 1)).collect();
        next.insert(count, 10);
        next.insert(5, 70);
        next.extend([(count + 1, count + 2), (count + 2, count + 3)]);
        let last = last(&next);
        assert!((10..=count).chain([5]).all(|node| last[&node] == 10));
        assert!([1, 2].iter().all(|own| last[&(count + own)] == count + 3));
        assert_eq!(last.len(), next.len());
    }
}
