//! Surfaces, contact elements and interfaces become contact pairs: the three
//! are joined by the name of their element set.

use std::collections::HashMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    ContactElement, ContactPair, Interaction, Lumping, Master, MasterFaces, NodeIndex, Numbered,
    Offset, RigidSurface, SlideLine, Vocabulary,
};

use crate::draft::{Draft, ElementKind, Shape, Surface};
use crate::rule::Subject;

pub(super) fn pairs(draft: &mut Draft) {
    let surfaces = std::mem::take(&mut draft.surfaces);
    twice(&surfaces, draft);
    let strayed = without_surface(&surfaces, draft);
    let mut in_pair: Numbered<usize, Span> = Numbered::default();
    for surface in &surfaces {
        pair(surface, strayed, &mut in_pair, draft);
    }
    let lonely = draft.elements.iter().enumerate();
    let lonely: Vec<_> = lonely
        .filter(|(index, element)| element.kind.is_contact() && !in_pair.contains_key(index))
        .map(|(_, element)| *element)
        .collect();
    if let Some(first) = lonely.first().filter(|_| draft.is_complete(Subject::Elements)) {
        let more = if lonely.len() > 1 {
            format!(" (and {} more)", lonely.len() - 1)
        } else {
            String::new()
        };
        let message = format!("contact element {}{more} has no surface to slide on", first.label);
        let error = Diagnostic::error(Code("SL0310"), message).at(first.origin);
        let help = "give its set a *RIGID SURFACE (IRS21) or a *SLIDE LINE (ISL21)";
        draft.consequence(Subject::Contact, error.help(help));
    }
}

/// An interface that names a set without a surface. It is most likely the one
/// that a surface is lacking, so that lack is not reported as well.
fn without_surface(surfaces: &[Surface], draft: &mut Draft) -> bool {
    let mut strayed = false;
    for interface in draft.interfaces.clone() {
        if surfaces.iter().any(|surface| surface.set == interface.set) {
            continue;
        }
        let message = format!("the set {} of this interface has no surface", interface.set);
        let error = Diagnostic::error(Code("SL0313"), message).at(interface.set_span);
        let lacking = |surface: &&Surface| {
            !draft.interfaces.iter().any(|interface| interface.set == surface.set)
        };
        let error = match surfaces.iter().find(lacking) {
            Some(surface) => error
                .label(surface.origin, "this surface has no *INTERFACE")
                .help(format!("did you mean ELSET={}?", surface.set)),
            None => error.help("a *SLIDE LINE or *RIGID SURFACE with the same ELSET is missing"),
        };
        draft.consequence(Subject::Contact, error);
        strayed = true;
    }
    strayed
}

/// Two cards of one kind for one set.
fn twice(surfaces: &[Surface], draft: &mut Draft) {
    let named = surfaces.iter().map(|surface| (surface.set.clone(), surface.set_span));
    let named: Vec<_> = named.collect();
    let interfaces: Vec<_> =
        draft.interfaces.iter().map(|entry| (entry.set.clone(), entry.set_span)).collect();
    for (list, what) in [(named, "surfaces"), (interfaces, "interfaces")] {
        let mut seen: HashMap<String, Span> = HashMap::new();
        for (set, span) in list {
            if let Some(&first) = seen.get(&set) {
                let message = format!("the elements of {set} have two {what}");
                let error = Diagnostic::error(Code("SL0314"), message).at(span);
                draft.consequence(Subject::Contact, error.label(first, "the first one"));
            }
            seen.entry(set).or_insert(span);
        }
    }
}

fn pair(surface: &Surface, strayed: bool, in_pair: &mut Numbered<usize, Span>, draft: &mut Draft) {
    let kind = match surface.shape {
        Shape::Rigid { .. } => ElementKind::Irs21,
        Shape::Line { .. } => ElementKind::Isl21,
    };
    let Some(found) = draft.elements_of(&surface.set, surface.set_span) else { return };
    let mut elements = Vec::new();
    let mut reference: Option<(u64, u64)> = None;
    let mut count = 0;
    for index in found {
        let element = draft.elements[index];
        if element.kind != kind {
            continue;
        }
        count += 1;
        shared(index, surface, in_pair, draft);
        if kind == ElementKind::Irs21 {
            same_reference(&element, &mut reference, draft);
        }
        let Some(nodes) = draft.ends_of(&element) else { continue };
        if !draft.has_no_length(&element, nodes) {
            elements.push(ContactElement {
                label: element.label,
                nodes,
                lumping: Lumping::Halves,
                origin: element.origin,
            });
        }
    }
    if count == 0 {
        let message = format!("the set {} has no {} elements", surface.set, kind.name());
        let error = Diagnostic::error(Code("SL0311"), message).at(surface.set_span);
        draft.consequence(Subject::Elements, error);
    }
    let interaction = interaction(surface, strayed, draft);
    let master = master(surface, reference.map(|(node, _)| node), draft);
    if let (Some(interaction), Some(master)) = (interaction, master) {
        let (name, origin) = (surface.set.clone(), surface.origin);
        let pair = ContactPair {
            name,
            is_piece: false,
            formulation: slideline_model::Formulation::NodeToSurface,
            vocabulary: Vocabulary::Elements,
            adjust: slideline_model::Adjust::Nothing,
            axes: [None; 2],
            left_out: Vec::new(),
            corners: Vec::new(),
            profile: None,
            offset: Offset::NONE,
            slaves: Vec::new(),
            counts_sides: false,
            faces: Vec::new(),
            elements,
            of_solids: false,
            master,
            interaction,
            origin,
        };
        both_sides(&pair, surface.set_span, draft);
        draft.model.contact_pairs.push(pair);
    }
}

/// An element that is in two pairs.
fn shared(index: usize, surface: &Surface, in_pair: &mut Numbered<usize, Span>, draft: &mut Draft) {
    if let Some(first) = in_pair.insert(index, surface.set_span)
        && first != surface.set_span
    {
        let message = format!("contact element {} is in two sets", draft.elements[index].label);
        let error = Diagnostic::error(Code("SL0314"), message).at(surface.set_span);
        draft.consequence(Subject::Contact, error.label(first, "the first one"));
    }
}

/// All IRS elements of a surface name one rigid body.
fn same_reference(
    element: &crate::draft::Element,
    reference: &mut Option<(u64, u64)>,
    draft: &mut Draft,
) {
    let node = element.nodes[2];
    let (first, by) = *reference.get_or_insert((node, element.label));
    if first != node {
        let message = format!(
            "element {} refers to the rigid body of node {node}, element {by} to that of {first}",
            element.label
        );
        let error = Diagnostic::error(Code("SL0318"), message).at(element.origin);
        draft.consequence(Subject::Elements, error);
    }
}

fn interaction(surface: &Surface, strayed: bool, draft: &mut Draft) -> Option<Interaction> {
    let found = draft.interfaces.iter().find(|interface| interface.set == surface.set);
    if let Some(interface) = found {
        return Some(interface.interaction.clone());
    }
    if strayed {
        return None; // an interface under another set's name has been reported
    }
    let message = format!("the contact of the set {} has no *INTERFACE", surface.set);
    let error = Diagnostic::error(Code("SL0312"), message).at(surface.origin);
    let help = format!("add *INTERFACE, ELSET={} with the width on its data line", surface.set);
    draft.consequence(Subject::Contact, error.help(help));
    None
}

fn master(surface: &Surface, reference: Option<u64>, draft: &mut Draft) -> Option<Master> {
    match &surface.shape {
        Shape::Rigid { start, segments } => Some(Master::RigidSurface(RigidSurface {
            reference: draft.model.nodes.find(reference?)?,
            start: *start,
            segments: segments.clone(),
            extension: 0.0,
            origin: surface.origin,
        })),
        Shape::Line { nodes, smooth, extension } => Some(Master::SlideLine(SlideLine {
            nodes: chain(nodes, surface, draft)?,
            middles: Vec::new(),
            smooth: Some(*smooth),
            extension: *extension,
            origin: surface.origin,
        })),
    }
}

/// The master nodes; they must exist, be at least two, and not coincide.
fn chain(nodes: &[(u64, Span)], surface: &Surface, draft: &mut Draft) -> Option<Vec<NodeIndex>> {
    let mut chain: Vec<NodeIndex> = Vec::with_capacity(nodes.len());
    for &(label, span) in nodes {
        let Some(index) = draft.model.nodes.find(label) else {
            let message = format!("node {label} of the slide line is not defined");
            let error = Diagnostic::error(Code("SL0304"), message).at(span);
            draft.consequence(Subject::Nodes, error);
            continue;
        };
        let same = |&last: &NodeIndex| {
            draft.model.nodes.position(last) == draft.model.nodes.position(index)
        };
        if chain.last().is_some_and(same) {
            let message = format!("node {label} coincides with the one before it");
            let error = Diagnostic::error(Code("SL0324"), message).at(span);
            draft.consequence(Subject::Nodes, error);
        }
        chain.push(index);
    }
    if chain.len() < 2 {
        let error = Diagnostic::error(Code("SL0324"), "a slide line needs at least two nodes");
        draft.consequence(Subject::Contact, error.at(surface.origin));
        return None;
    }
    Some(chain)
}

/// A node cannot slide on a surface that it carries itself.
pub(super) fn both_sides(pair: &ContactPair, span: Span, draft: &mut Draft) {
    let slaves = pair.slave_nodes();
    let own = match &pair.master {
        // its faces meet others alone
        Master::Itself(_) | Master::Faces(MasterFaces { meets_itself: true, .. }) => None,
        Master::RigidSurface(rigid) => slaves.contains(&rigid.reference).then_some(rigid.reference),
        Master::SlideLine(line) => {
            let masters: std::collections::HashSet<_> = line.nodes.iter().collect();
            slaves.iter().find(|node| masters.contains(node)).copied()
        }
        Master::Faces(faces) => {
            let masters: std::collections::HashSet<_> = faces.nodes().into_iter().collect();
            slaves.iter().find(|node| masters.contains(node)).copied()
        }
    };
    if let Some(node) = own {
        let label = draft.model.nodes.label(node);
        let message = format!("node {label} is slave and master of the same contact");
        let error = Diagnostic::error(Code("SL0319"), message).at(span);
        draft.consequence(Subject::Contact, error);
    }
}
