//! Faces of contact surfaces that lie inside a part.
//!
//! ```text
//!   o-----o-----o
//!   |  A  |  B  |     the face between A and B belongs to both: nothing can touch it
//!   o-----o-----o
//! ```

use std::collections::BTreeSet;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{NodeIndex, Numbered, NumberedSet};

use super::faces::face_nodes;
use crate::draft::{Draft, ElementKind};
use crate::rule::Subject;
use crate::surfaces::{Extent, NamedSurface, Pairing};

/// A face that a surface names: place of its element in the draft, number of the face.
type Named = (usize, usize);
/// Nodes of a face, ascending.
type Key = Vec<NodeIndex>;

/// SL0398: surfaces of contact pairs that name faces which two elements have.
pub(super) fn warn_of_inner_faces(pairings: &[Pairing], draft: &mut Draft) {
    let names: BTreeSet<&str> = pairings
        .iter()
        .flat_map(|pairing| [pairing.slave.name.as_str(), pairing.master.name.as_str()])
        .collect();
    let mut surfaces = draft.named_surfaces.clone();
    surfaces.retain(|surface| names.contains(surface.named.name.as_str()));
    let faces: Vec<Vec<(Named, Key)>> =
        surfaces.iter().map(|surface| named_faces(surface, draft)).collect();
    if faces.iter().all(Vec::is_empty) {
        return;
    }
    let owners = owners(&faces, draft);
    for (surface, faces) in surfaces.iter().zip(&faces) {
        let other = |(named, key): &(Named, Key)| {
            let own = owners.get(key)?.iter().copied().find(|&element| element != named.0)?;
            Some((*named, own))
        };
        let inner: Vec<(Named, usize)> = faces.iter().filter_map(other).collect();
        if let Some(first) = inner.first() {
            say(surface, *first, inner.len(), draft);
        }
    }
}

/// The faces that a surface names by their numbers.
fn named_faces(surface: &NamedSurface, draft: &mut Draft) -> Vec<(Named, Key)> {
    let Extent::Elements(stretches) = &surface.extent else { return Vec::new() };
    let mut found = Vec::new();
    for stretch in stretches {
        let Some(face) = stretch.face else { continue };
        for element in draft.elements_at(&stretch.elements, stretch.span) {
            let is_beam = draft.elements[element].kind.is_beam();
            if let (false, Some(nodes)) = (is_beam, face_nodes(element, Some(face), draft)) {
                found.push(((element, face), sorted(nodes)));
            }
        }
    }
    found
}

/// The elements that have these faces.
fn owners(faces: &[Vec<(Named, Key)>], draft: &Draft) -> Numbered<Key, Vec<usize>> {
    let keys = faces.iter().flatten().map(|(_, key)| key);
    let nodes: NumberedSet<NodeIndex> = keys.clone().flatten().copied().collect();
    let mut owners: Numbered<Key, Vec<usize>> = keys.map(|key| (key.clone(), Vec::new())).collect();
    for element in 0..draft.elements.len() {
        let ElementKind::Structural(row) = draft.elements[element].kind else { continue };
        for face in 0..row.cell.faces.len() {
            let Some(own) = face_nodes(element, Some(face), draft) else { continue };
            if !own.iter().all(|node| nodes.contains(node)) {
                continue;
            }
            if let Some(elements) = owners.get_mut(&sorted(own)) {
                elements.push(element);
            }
        }
    }
    owners
}

fn sorted(mut nodes: Vec<NodeIndex>) -> Key {
    nodes.sort_unstable();
    nodes
}

fn say(
    surface: &NamedSurface,
    ((element, face), other): (Named, usize),
    count: usize,
    draft: &mut Draft,
) {
    let [element, other] = [element, other].map(|place| draft.elements[place].label);
    let are = if count == 1 { "face of {} lies" } else { "faces of {} lie" };
    let are = are.replace("{}", &surface.named.name);
    let message = format!(
        "{count} {are} inside the part: face {} of element {element} is one of element {other} too",
        face + 1
    );
    let warning = Diagnostic::warning(Code("SL0398"), message).at(surface.origin);
    let help = "name faces on the outside: an element set without a label of its faces stands for \
                its free ones; if the elements are there twice, leave one copy out";
    draft.consequence(Subject::Contact, warning.help(help));
}
