//! Named surfaces: what they are made of.

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_mech::element::solid::Kinematics as Strains;
use slideline_model::{
    ContactElement, ContactFace, Kinematics, Lumping, MasterFaces, NodeIndex, ProfilePoint,
    RigidSurface, SurfaceSegment,
};

use super::chain::Facet;
use super::faces::{free_faces, of_stretch};
use super::owners::owner;
use super::rigid_faces;
use super::swept::swept;
use crate::draft::{Draft, Element, ElementKind};
use crate::log::Target;
use crate::rule::Subject;
use crate::surfaces::{Extent, Named, NamedSurface, Side, Stretch};

/// A surface whose references are resolved.
#[derive(Clone)]
pub(super) enum Found {
    Facets(Vec<Facet>),
    /// Faces of solids in space.
    Faces(Vec<ContactFace>),
    Nodes(Vec<NodeIndex>),
    Rigid(RigidSurface),
    /// An analytical surface in space.
    Swept(MasterFaces),
}

impl Draft {
    /// The surface of that name; complains where there is none.
    pub(super) fn surface(&mut self, named: &Named) -> Option<NamedSurface> {
        let list = &self.named_surfaces;
        let found = list.iter().find(|surface| surface.named.name == named.name).cloned();
        if found.is_none() {
            let message = format!("there is no surface {}", named.name);
            let error = Diagnostic::error(Code("SL0327"), message).at(named.span);
            let names = list.iter().map(|surface| surface.named.name.as_str());
            let help = match slideline_deck::nearest(&named.name, names) {
                Some(near) => format!("did you mean {near}?"),
                None => format!("define it: *SURFACE, NAME={}", named.name),
            };
            self.consequence(Subject::Contact, error.help(help));
        }
        found
    }

    /// The end nodes of a beam or of a rigid line, and its middle node, if it has one; `None`
    /// where undefined, which has been reported.
    fn line_nodes(&self, beam: &Element) -> Option<([NodeIndex; 2], Option<NodeIndex>)> {
        let find = |at: usize| self.model.nodes.find(*beam.nodes.get(at)?);
        let last = beam.kind.node_count().checked_sub(1)?;
        let middle = if last == 2 { Some(find(1)?) } else { None };
        Some(([find(0)?, find(last)?], middle))
    }
}

/// Resolves a surface; `user` is where a pair names it.
pub(super) fn found(surface: &NamedSurface, user: Span, draft: &mut Draft) -> Option<Found> {
    match &surface.extent {
        Extent::Elements(stretches) if is_in_space(stretches, draft) => {
            spatial_faces(surface, draft).map(Found::Faces)
        }
        Extent::Elements(stretches) => facets(surface, stretches, draft).map(Found::Facets),
        Extent::Nodes(targets) => nodes(surface, targets, draft).map(Found::Nodes),
        Extent::Rigid { start, segments } => {
            rigid(surface, *start, segments, user, draft).map(Found::Rigid)
        }
        Extent::Swept { start, segments, axes } => {
            swept(surface, (*start, segments, axes), user, draft).map(Found::Swept)
        }
    }
}

/// Whether a surface names volumes, or rigid meshes of space.
fn is_in_space(stretches: &[Stretch], draft: &mut Draft) -> bool {
    let volume = |&index: &usize, draft: &Draft| match draft.elements[index].kind {
        ElementKind::Structural(row) => row.cell.dimension == 3,
        kind => kind.bare().is_some_and(|mesh| mesh.spatial),
    };
    stretches.iter().any(|stretch| {
        draft
            .elements_at(&stretch.elements, stretch.span)
            .first()
            .is_some_and(|index| volume(index, draft))
    })
}

/// The faces of volumes and of rigid meshes of a surface, each once.
fn spatial_faces(surface: &NamedSurface, draft: &mut Draft) -> Option<Vec<ContactFace>> {
    let Extent::Elements(stretches) = &surface.extent else { return None };
    let (mut found, mut seen) = (Vec::new(), HashSet::new());
    for stretch in stretches {
        let elements = draft.elements_at(&stretch.elements, stretch.span);
        let (rigid, others) = rigid_faces::apart(&elements, draft);
        for index in rigid {
            let Some(nodes) = rigid_faces::of(index, stretch, draft) else { continue };
            let element = draft.elements[index];
            if seen.insert((index, None)) {
                found.push(ContactFace { label: element.label, nodes, origin: element.origin });
            }
        }
        for face in of_stretch(&others, stretch, draft) {
            let element = draft.elements[face.element];
            if face.nodes.len() < 3 {
                no_surface(surface, face.element, stretch.span, draft);
                return None;
            }
            if seen.insert((face.element, face.face)) {
                let (label, origin) = (element.label, element.origin);
                found.push(ContactFace { label, nodes: face.nodes, origin });
            }
        }
    }
    if found.is_empty() {
        empty(surface, "elements", draft);
        return None;
    }
    Some(found)
}

/// Which nodes a face has in common with a surface of nodes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Touching {
    AllNodes,
    AnyNode,
}

/// The free faces of volumes that have all their nodes, or any of them, among `nodes`: what the
/// nodes of a surface stand for.
pub(super) fn faces_between(
    nodes: &[NodeIndex],
    touching: Touching,
    span: Span,
    draft: &Draft,
) -> Vec<ContactFace> {
    let members: HashSet<NodeIndex> = nodes.iter().copied().collect();
    let all: Vec<usize> = (0..draft.elements.len()).collect();
    let free = free_faces(&all, span, draft).into_iter();
    let is_member = |node: &NodeIndex| members.contains(node);
    let touches = |nodes: &[NodeIndex]| match touching {
        Touching::AllNodes => nodes.iter().all(is_member),
        Touching::AnyNode => nodes.iter().any(is_member),
    };
    let touched = free.filter(|face| face.nodes.len() > 2 && touches(&face.nodes));
    touched
        .map(|face| {
            let element = draft.elements[face.element];
            ContactFace { label: element.label, nodes: face.nodes, origin: element.origin }
        })
        .collect()
}

/// The beams and the faces of plane solids of a surface, each once; a beam twice if it is named with
/// both faces.
fn facets(surface: &NamedSurface, stretches: &[Stretch], draft: &mut Draft) -> Option<Vec<Facet>> {
    let mut facets: Vec<Facet> = Vec::new();
    let mut seen = HashSet::new();
    for stretch in stretches {
        let all = draft.elements_at(&stretch.elements, stretch.span);
        let (rigid, others) = rigid_faces::apart(&all, draft);
        let (beams, others): (Vec<usize>, Vec<usize>) =
            others.into_iter().partition(|&index| draft.elements[index].kind.is_line());
        let without = |&&index: &&usize| !has_edges(draft.elements[index].kind);
        if let Some(&index) = others.iter().find(without) {
            no_surface(surface, index, stretch.span, draft);
            return None;
        }
        for index in rigid.into_iter().chain(beams) {
            let element = draft.elements[index];
            let Some((nodes, middle)) = draft.line_nodes(&element) else { continue };
            let side = stretch.side;
            if !draft.has_no_length(&element, nodes) && seen.insert((index, None, side)) {
                let (label, origin) = (element.label, element.origin);
                facets.push(Facet { label, nodes, middle, origin, side, face: None });
            }
        }
        for edge in of_stretch(&others, stretch, draft) {
            let element = draft.elements[edge.element];
            let (Some(&first), Some(&last)) = (edge.nodes.first(), edge.nodes.last()) else {
                continue;
            };
            if seen.insert((edge.element, edge.face, None)) {
                facets.push(Facet {
                    label: element.label,
                    nodes: [first, last],
                    middle: (edge.nodes.len() == 3).then(|| edge.nodes[1]),
                    origin: element.origin,
                    // the material is on the left of its direction, the outside on the right
                    side: Some(Side::Negative),
                    face: edge.face,
                });
            }
        }
    }
    if facets.is_empty() {
        empty(surface, "elements", draft);
        return None;
    }
    Some(facets)
}

/// Whether elements of the kind are solids of the plane, whose faces are edges.
fn has_edges(kind: ElementKind) -> bool {
    let ElementKind::Structural(row) = kind else { return false };
    matches!(row.kinematics, Kinematics::Solid { strains, .. } if strains != Strains::Space)
}

fn no_surface(surface: &NamedSurface, index: usize, span: Span, draft: &mut Draft) {
    let element = draft.elements[index];
    let message = format!(
        "element {} of the surface {} is of type {}, whose contact is not supported",
        element.label,
        surface.named.name,
        element.kind.name()
    );
    let error = Diagnostic::error(Code("SL0332"), message).at(span);
    let help = "contact is between beams, trusses, faces of solids and analytical surfaces";
    draft.consequence(Subject::Elements, error.help(help));
}

fn nodes(
    surface: &NamedSurface,
    targets: &[(Target, Span)],
    draft: &mut Draft,
) -> Option<Vec<NodeIndex>> {
    let mut seen = HashSet::new();
    let mut nodes = Vec::new();
    for (target, span) in targets {
        let found = draft.nodes_of(target, *span);
        nodes.extend(found.into_iter().filter(|&node| seen.insert(node)));
    }
    if nodes.is_empty() {
        empty(surface, "nodes", draft);
        return None;
    }
    Some(nodes)
}

fn empty(surface: &NamedSurface, what: &str, draft: &mut Draft) {
    if !(draft.is_complete(Subject::Nodes) && draft.is_complete(Subject::Elements)) {
        return;
    }
    let already = draft.log.errors() > 0; // the members that do not exist have been reported
    if !already {
        let message = format!("the surface {} has no {what}", surface.named.name);
        let error = Diagnostic::error(Code("SL0311"), message).at(surface.origin);
        draft.consequence(Subject::Contact, error);
    }
}

/// An analytical surface with the reference node of its body.
fn rigid(
    surface: &NamedSurface,
    start: ProfilePoint,
    segments: &[SurfaceSegment],
    user: Span,
    draft: &mut Draft,
) -> Option<RigidSurface> {
    let (_, reference) = owner(surface, user, draft)?;
    let (segments, origin) = (segments.to_vec(), surface.origin);
    Some(RigidSurface { reference, start, segments, extension: 0.0, origin })
}

/// Stretches between the nodes of a node surface, for their tributary areas:
/// the beams that join its nodes, where they reach every one of them; else
/// from each node to the next in the order given.
pub(super) fn stretches(
    surface: &NamedSurface,
    nodes: &[NodeIndex],
    draft: &mut Draft,
) -> Vec<ContactElement> {
    let members: HashSet<NodeIndex> = nodes.iter().copied().collect();
    let mut reached = HashSet::new();
    let mut beams = Vec::new();
    for element in draft.elements.iter().filter(|element| element.kind.is_line()) {
        let Some((nodes, middle)) = draft.line_nodes(element) else { continue };
        if nodes.iter().all(|node| members.contains(node)) && nodes[0] != nodes[1] {
            let middle = middle.filter(|node| members.contains(node));
            reached.extend(nodes.into_iter().chain(middle));
            let (label, origin) = (element.label, element.origin);
            beams.extend(stretches_of(&Facet {
                label,
                nodes,
                middle,
                origin,
                side: None,
                face: None,
            }));
        }
    }
    let origin = surface.origin;
    let joined = reached.len() == members.len();
    let how = if joined { "the beams between them" } else { "the distances from node to node" };
    // two nodes have no order that could be wrong
    if nodes.len() > 2 {
        let message = format!("the areas of the nodes of {} come from {how}", surface.named.name);
        let note = Diagnostic::note(Code("SL0254"), message).at(origin);
        draft.consequence(
            Subject::Contact,
            note.help(match draft.model.is_of_rings() {
                true => "half the distance to both neighbours, times the way round the axis",
                false => "half the distance to both neighbours, times the thickness",
            }),
        );
    }
    if joined {
        return beams;
    }
    let mut stretches = Vec::new();
    for (pair, label) in nodes.windows(2).zip(1..) {
        let ends = [pair[0], pair[1]];
        if draft.model.nodes.position(ends[0]) == draft.model.nodes.position(ends[1]) {
            let [a, b] = ends.map(|node| draft.model.nodes.label(node));
            let message = format!("nodes {a} and {b} of the surface coincide: they have no area");
            let error = Diagnostic::error(Code("SL0306"), message).at(origin);
            draft.consequence(Subject::Nodes, error);
        }
        stretches.push(ContactElement { label, nodes: ends, lumping: Lumping::Halves, origin });
    }
    stretches
}

/// Each beam of a slave surface once, whichever of its faces were named, from
/// end to end.
pub(super) fn contact_elements(facets: &[Facet]) -> Vec<ContactElement> {
    once(facets).map(whole).collect()
}

/// The same from node to node: a middle node carries contact like any other.
pub(super) fn between_nodes(facets: &[Facet]) -> Vec<ContactElement> {
    once(facets).flat_map(stretches_of).collect()
}

fn once(facets: &[Facet]) -> impl Iterator<Item = &Facet> {
    let mut seen = HashSet::new();
    facets.iter().filter(move |facet| seen.insert((facet.label, facet.face)))
}

fn whole(facet: &Facet) -> ContactElement {
    let Facet { label, nodes, origin, .. } = *facet;
    ContactElement { label, nodes, lumping: Lumping::Halves, origin }
}

fn stretches_of(facet: &Facet) -> Vec<ContactElement> {
    let mut parts: Vec<ContactElement> = facet.parts().map(|part| whole(&part)).collect();
    if let [first, last] = parts.as_mut_slice() {
        (first.lumping, last.lumping) = (Lumping::ToMiddle, Lumping::FromMiddle);
    }
    parts
}
