//! `*PRE-TENSION SECTION`: every node of the cut becomes two, and the reference node says how far
//! the sides move into one another.
//!
//! ```text
//!    own side  |  other side        N: out of the own side
//!    o----o  n'| n  o----o          u_n' = u_n + N u_ref
//!    o----o  n'| n  o----o
//! ```
//! docs/theory.md eq. (4.12). The force on the reference node is the force N . f across the cut.

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Dof, Node, NodeIndex};

use super::equations::add;
use super::faces::{SolidFace, face_nodes, faces};
use crate::constraints::{Cut, PreTension};
use crate::draft::{Draft, ElementKind};
use crate::rule::Subject;

/// A section that has been cut: its nodes in pairs, other side and own side.
pub(super) struct Parted {
    pairs: Vec<(NodeIndex, NodeIndex)>,
    reference: NodeIndex,
    normal: [f64; 3],
    origin: Span,
}

/// Cuts all sections; the elements of the own sides get nodes of their own.
pub(super) fn cut(draft: &mut Draft) -> Vec<Parted> {
    let sections = std::mem::take(&mut draft.pre_tensions);
    sections.iter().filter_map(|section| one(section, draft)).collect()
}

/// Makes the own side of every cut follow the other side and the reference node.
pub(super) fn tie(parted: &[Parted], draft: &mut Draft) {
    if parted.is_empty() {
        return;
    }
    let turning = super::links::turning(draft);
    for Parted { pairs, reference, normal, origin } in parted {
        for &(other, own) in pairs {
            for &dof in draft.model.directions() {
                let mut terms = draft.along_own_axes(vec![(other, dof, 1.0)]);
                if let Some(&part) = normal.get(dof as usize).filter(|part| **part != 0.0) {
                    terms.push((*reference, Dof::U1, part));
                }
                if !dof.is_rotation() || turning.contains(&(own, dof)) {
                    add(draft, (own, dof), terms, *origin);
                }
            }
        }
    }
}

/// Reads contact with surfaces as those of the deck, which go on over cuts: neither a normal, a curve, a
/// face nor the share of a node ends where the part does not.
pub(super) fn closed(draft: &mut Draft, contact: &[fn(&mut Draft)]) {
    let open: Vec<_> = draft.elements.iter().map(|element| element.nodes).collect();
    let of_deck: Vec<_> = open.iter().map(|own| own.map(|node| draft.uncut(node))).collect();
    for (element, nodes) in draft.elements.iter_mut().zip(of_deck) {
        element.nodes = nodes;
    }
    contact.iter().for_each(|read| read(draft));
    for (element, nodes) in draft.elements.iter_mut().zip(open) {
        element.nodes = nodes;
    }
}

fn one(section: &PreTension, draft: &mut Draft) -> Option<Parted> {
    let reference = draft.reference_of(&section.reference, section.reference_span);
    let (own, nodes, outward) = match &section.cut {
        Cut::Surface(named) => {
            let surface = draft.surface(named)?;
            let faces = faces(&surface, named.span, draft);
            let outward = outward(&faces, draft);
            let nodes: HashSet<NodeIndex> = faces.iter().flat_map(|f| f.nodes.clone()).collect();
            (own_side(&faces, &nodes, section.origin, draft)?, nodes, outward)
        }
        Cut::Element(label, span) => end_of(*label, *span, draft)?,
    };
    let given = section.normal.or(outward);
    let (Some(reference), Some(normal)) = (reference, given) else {
        if reference.is_some() {
            let message = "this section has no direction: its faces have no area";
            let error = Diagnostic::error(Code("SL0347"), message).at(section.origin);
            draft.consequence(Subject::Links, error.help("give the normal on a data line"));
        }
        return None;
    };
    let along: f64 = outward.map_or(1.0, |own| (0..3).map(|k| own[k] * normal[k]).sum());
    if along < 0.0 {
        let message = "the normal points into the elements of the section: a positive load presses";
        let note = Diagnostic::note(Code("SL0253"), message).at(section.origin);
        draft.log.push(note.help("turn it round for a positive load that pulls"));
    }
    let pairs = part(&own, &nodes, section.origin, draft)?;
    Some(Parted { pairs, reference, normal, origin: section.origin })
}

/// Mean unit normal of faces, out of their elements.
fn outward(faces: &[SolidFace], draft: &Draft) -> Option<[f64; 3]> {
    let mut sum = [0.0; 3];
    for face in faces {
        let ElementKind::Structural(row) = draft.elements[face.element].kind else { continue };
        let own = slideline_mech::pressure::Face::of(row.cell.dimension, face.nodes.len(), 1.0)?;
        let x: Vec<[f64; 3]> =
            face.nodes.iter().map(|&node| draft.model.nodes.position(node)).collect();
        let mut force = vec![[0.0; 3]; x.len()];
        own.press(-1.0, &x, &mut force);
        force.iter().for_each(|f| (0..3).for_each(|k| sum[k] += f[k]));
    }
    let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0).then(|| sum.map(|x| x / length))
}

type End = (Vec<usize>, HashSet<NodeIndex>, Option<[f64; 3]>);

/// The last node of a line element, and the direction of the element.
fn end_of(label: u64, span: Span, draft: &mut Draft) -> Option<End> {
    let index = draft.element_at(label, span)?;
    let element = draft.elements[index];
    if !element.kind.is_line() {
        let message = format!("a {} element is cut by a surface", element.kind.name());
        let error = Diagnostic::error(Code("SL0325"), message).at(span);
        draft.consequence(Subject::Elements, error.help("give SURFACE= in place of ELEMENT="));
        return None;
    }
    let nodes = face_nodes(index, None, draft)?;
    let (&first, &last) = (nodes.first()?, nodes.last()?);
    let (a, b) = (draft.model.nodes.position(first), draft.model.nodes.position(last));
    let along: [f64; 3] = std::array::from_fn(|k| b[k] - a[k]);
    let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
    let direction = (length > 0.0).then(|| along.map(|x| x / length));
    Some((vec![index], HashSet::from([last]), direction))
}

/// The elements of the own side that touch the cut: those of the faces, and those that are joined
/// to them by faces which touch the cut without being part of it.
fn own_side(
    cut: &[SolidFace],
    nodes: &HashSet<NodeIndex>,
    origin: Span,
    draft: &mut Draft,
) -> Option<Vec<usize>> {
    let sorted = |nodes: &[NodeIndex]| {
        let mut key = nodes.to_vec();
        key.sort_unstable();
        key
    };
    let parted: HashSet<Vec<NodeIndex>> = cut.iter().map(|face| sorted(&face.nodes)).collect();
    // elements on both sides of every face that touches the cut
    let mut across: HashMap<Vec<NodeIndex>, Vec<usize>> = HashMap::new();
    let mut touching: HashMap<usize, Vec<Vec<NodeIndex>>> = HashMap::new();
    for index in 0..draft.elements.len() {
        let ElementKind::Structural(row) = draft.elements[index].kind else { continue };
        for face in 0..row.cell.faces.len() {
            let Some(own) = face_nodes(index, Some(face), draft) else { continue };
            if own.iter().any(|node| nodes.contains(node)) {
                let key = sorted(&own);
                across.entry(key.clone()).or_default().push(index);
                touching.entry(index).or_default().push(key);
            }
        }
    }
    let mut side: HashSet<usize> = cut.iter().map(|face| face.element).collect();
    let mut open: Vec<usize> = side.iter().copied().collect();
    while let Some(element) = open.pop() {
        for key in touching.get(&element).into_iter().flatten() {
            for &other in across.get(key).into_iter().flatten() {
                if !parted.contains(key) && side.insert(other) {
                    open.push(other);
                }
            }
        }
    }
    let through = |key: &Vec<NodeIndex>| {
        across.get(key).is_none_or(|both| both.iter().all(|element| side.contains(element)))
    };
    if parted.is_empty() || parted.iter().any(through) {
        let message = "this surface does not cut through: its sides are joined round its edge, or \
                       nothing lies behind it";
        let error = Diagnostic::error(Code("SL0347"), message).at(origin);
        let help = "name all element faces of one cross-section, from one side";
        draft.consequence(Subject::Links, error.help(help));
        return None;
    }
    let mut side: Vec<usize> = side.into_iter().collect();
    side.sort_unstable();
    Some(side)
}

/// Gives the elements of the own side new nodes in place of those of the cut.
fn part(
    own: &[usize],
    nodes: &HashSet<NodeIndex>,
    origin: Span,
    draft: &mut Draft,
) -> Option<Vec<(NodeIndex, NodeIndex)>> {
    let mut nodes: Vec<NodeIndex> = nodes.iter().copied().collect();
    nodes.sort_unstable();
    if !draft.reserve(nodes.len() as u128, "nodes of a section", origin) {
        return None;
    }
    let next = draft.model.nodes.iter().map(|node| node.label).max().unwrap_or(0) + 1;
    let mut copy_of: HashMap<u64, u64> = HashMap::new();
    let mut pairs = Vec::with_capacity(nodes.len());
    for (label, other) in (next..).zip(nodes) {
        let of = draft.model.nodes.label(other);
        copy_of.insert(of, label);
        let original = draft.uncut(of);
        draft.cut_nodes.insert(label, original);
        draft.behind_cuts.entry(original).or_default().push(label);
        let position = draft.model.nodes.position(other);
        pairs.push((other, draft.model.nodes.insert(Node { label, position, origin })));
    }
    for &index in own {
        let count = draft.elements[index].kind.node_count();
        let last = draft.elements[index].kind.is_line();
        for place in 0..count {
            if last && place + 1 < count {
                continue;
            }
            let node = &mut draft.elements[index].nodes[place];
            *node = copy_of.get(node).copied().unwrap_or(*node);
        }
    }
    Some(pairs)
}
