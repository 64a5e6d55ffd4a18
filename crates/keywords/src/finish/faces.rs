//! Faces of solids: those that a surface names, and those on its outside.
//!
//! ```text
//!    o-----o-----o     S1..S6 name a face of an element;
//!    |     |     |     without a label a set stands for its free faces,
//!    o-----o-----o     those that no other element of the set shares
//! ```

use std::collections::{HashMap, HashSet};

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::NodeIndex;

use crate::draft::{Draft, ElementKind};
use crate::rule::Subject;
use crate::surfaces::{Extent, NamedSurface, Stretch};

/// A face of a solid, or a beam as a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SolidFace {
    /// Place of its element in the draft.
    pub element: usize,
    /// Number of the face from 0; `None` for a line element as a whole.
    pub face: Option<usize>,
    /// Its nodes in the order of the cell.
    pub nodes: Vec<NodeIndex>,
    /// Where it was named.
    pub span: Span,
}

impl SolidFace {
    /// The ends of a face of the plane.
    pub fn ends(&self) -> [NodeIndex; 2] {
        [self.nodes[0], self.nodes[self.nodes.len() - 1]]
    }
}

/// The faces of a surface of elements, each once; `user` names it. Complains about other surfaces.
pub(super) fn faces(surface: &NamedSurface, user: Span, draft: &mut Draft) -> Vec<SolidFace> {
    let stretches = match &surface.extent {
        Extent::Elements(stretches) => stretches,
        Extent::Nodes(_) => {
            wrong_kind(surface, "is made of nodes and has no faces", user, draft);
            return Vec::new();
        }
        Extent::Rigid { .. } | Extent::Swept { .. } => {
            wrong_kind(surface, "is analytical and has no faces of elements", user, draft);
            return Vec::new();
        }
    };
    let mut faces = Vec::new();
    for stretch in stretches {
        let found = draft.elements_at(&stretch.elements, stretch.span);
        faces.extend(of_stretch(&found, stretch, draft));
    }
    // a surface is a set: a face that two of its lines name is there once
    let mut seen = HashSet::new();
    faces.retain(|face| seen.insert((face.element, face.face)));
    faces
}

/// The faces that a line of a surface names of elements, or their free ones.
pub(super) fn of_stretch(found: &[usize], stretch: &Stretch, draft: &mut Draft) -> Vec<SolidFace> {
    let mut faces = Vec::new();
    match stretch.face {
        Some(face) => named(found, face, stretch, draft, &mut faces),
        None => free(found, stretch.span, draft, &mut faces),
    }
    faces
}

/// Complains about faces that elements do not have, whoever uses the surface.
pub(super) fn check(draft: &mut Draft) {
    for surface in draft.named_surfaces.clone() {
        let Extent::Elements(stretches) = &surface.extent else { continue };
        for stretch in stretches {
            let Some(face) = stretch.face else { continue };
            let found = draft.elements_at(&stretch.elements, stretch.span);
            let lacks = |&&index: &&usize| face_nodes(index, Some(face), draft).is_none();
            if let Some(&index) = found.iter().find(lacks) {
                no_face(index, face, stretch.span, draft);
            }
        }
    }
}

fn wrong_kind(surface: &NamedSurface, what: &str, user: Span, draft: &mut Draft) {
    let message = format!("the surface {} {what}", surface.named.name);
    let error = Diagnostic::error(Code("SL0332"), message).at(user);
    let help = "name a *SURFACE of elements and their faces here";
    draft.consequence(Subject::Contact, error.label(surface.origin, "here").help(help));
}

/// The nodes of a surface of elements or nodes, each once; `user` names it. Complains about a
/// surface without nodes.
pub(super) fn nodes_of_surface(
    surface: &NamedSurface,
    user: Span,
    draft: &mut Draft,
) -> Vec<NodeIndex> {
    let mut nodes = Vec::new();
    match &surface.extent {
        Extent::Elements(_) => {
            nodes.extend(faces(surface, user, draft).into_iter().flat_map(|face| face.nodes));
        }
        Extent::Nodes(targets) => {
            for (target, span) in targets {
                nodes.extend(draft.nodes_of(target, *span));
            }
        }
        Extent::Rigid { .. } | Extent::Swept { .. } => {
            wrong_kind(surface, "is analytical and has no nodes", user, draft);
        }
    }
    let mut seen = HashSet::new();
    nodes.retain(|node| seen.insert(*node));
    nodes
}

/// One face of each element.
fn named(
    found: &[usize],
    face: usize,
    stretch: &Stretch,
    draft: &mut Draft,
    into: &mut Vec<SolidFace>,
) {
    for &index in found {
        match face_nodes(index, Some(face), draft) {
            Some(nodes) => {
                into.push(SolidFace {
                    element: index,
                    face: Some(face),
                    nodes,
                    span: stretch.span,
                });
            }
            None => no_face(index, face, stretch.span, draft),
        }
    }
}

pub(super) fn no_face(index: usize, face: usize, span: Span, draft: &mut Draft) {
    let element = draft.elements[index];
    let count = match element.kind {
        ElementKind::Structural(row) => row.cell.faces.len(),
        _ => 0,
    };
    if face < count {
        return; // its nodes do not exist, which has been said
    }
    let message = format!("a {} element has no face {}", element.kind.name(), face + 1);
    let error = Diagnostic::error(Code("SL0256"), message).at(span);
    let help = match count {
        0 if element.kind.is_beam() => "the sides of a beam are SPOS and SNEG".to_owned(),
        0 => "it has no faces".to_owned(),
        _ => format!("its faces are 1 to {count}"),
    };
    if count == 0 {
        draft.consequence(Subject::Elements, error.help(help));
    } else if draft.log.first_time(&format!("SL0256 {} {}", span.file.0, span.start)) {
        // whatever else is wrong with elements: those of this type have no such face
        draft.log.push(error.help(help));
        draft.mark_incomplete(Subject::Contact);
    }
}

/// The nodes of a face; of the whole element where it is a line. `None` where there is no such
/// face or a node does not exist.
pub(super) fn face_nodes(
    index: usize,
    face: Option<usize>,
    draft: &Draft,
) -> Option<Vec<NodeIndex>> {
    let element = draft.elements[index];
    let find = |place: usize| draft.model.nodes.find(*element.nodes().get(place)?);
    let ElementKind::Structural(row) = element.kind else {
        // a rigid mesh has one face an element
        let mesh = element.kind.bare().filter(|_| face == Some(0))?;
        return (0..mesh.nodes).map(find).collect();
    };
    match face {
        Some(face) => row.cell.faces.get(face)?.iter().map(|&place| find(place)).collect(),
        None => (0..row.cell.nodes).map(find).collect(),
    }
}

/// The faces that only one element of the list has.
pub(super) fn free_faces(found: &[usize], span: Span, draft: &Draft) -> Vec<SolidFace> {
    let mut faces = Vec::new();
    free(found, span, draft, &mut faces);
    faces
}

/// The faces that only one element of the list has; lines are surfaces themselves. What a
/// pre-tension section has cut is within.
fn free(found: &[usize], span: Span, draft: &Draft, into: &mut Vec<SolidFace>) {
    let whole = |&node: &NodeIndex| draft.uncut(draft.model.nodes.label(node));
    let mut owners: HashMap<Vec<u64>, usize> = HashMap::new();
    let mut all = Vec::new();
    for &index in found {
        let faces: Vec<Option<usize>> = match draft.elements[index].kind {
            ElementKind::Structural(row) if row.cell.faces.is_empty() => vec![None],
            ElementKind::Structural(row) => (0..row.cell.faces.len()).map(Some).collect(),
            kind if kind.bare().is_some() => vec![Some(0)],
            _ => continue,
        };
        for face in faces {
            let Some(nodes) = face_nodes(index, face, draft) else { continue };
            let mut key: Vec<u64> = nodes.iter().map(whole).collect();
            key.sort_unstable();
            *owners.entry(key.clone()).or_insert(0) += 1;
            all.push((key, SolidFace { element: index, face, nodes, span }));
        }
    }
    let single = all.into_iter().filter(|(key, face)| face.face.is_none() || owners[key] == 1);
    into.extend(single.map(|(_, face)| face));
}
