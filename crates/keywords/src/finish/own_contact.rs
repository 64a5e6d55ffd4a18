//! `*CONTACT`: parts that meet themselves.
//!
//! ```text
//!     .------------.
//!     |  .------.  |      a part that folds: what ALL EXTERIOR, or a surface with itself, includes
//!     |  |      v  |      of it, less what is excluded, is one surface that meets itself
//!     '--'     -+--'
//! ```

use std::collections::{BTreeMap, HashMap, HashSet};

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ElementBlock, NodeIndex, Section};

use super::meetings::{Side, both, part};
use super::skin::{Patch, Skin};
use crate::draft::Draft;
use crate::surfaces::{GeneralContact, Named};

/// What of parts meets itself, part by part.
#[derive(Default)]
pub(super) struct Alone(BTreeMap<usize, Patch>);

impl Alone {
    /// Takes what two patches of a part include; whether they do: those that share no node are two
    /// sides of a contact like any other, and rigid parts never fold.
    pub fn include<'a>(&mut self, (a, b): (&'a Patch, &'a Patch), skin: &'a Skin) -> bool {
        let Some(number) = part(a, skin).filter(|_| part(a, skin) == part(b, skin)) else {
            return false;
        };
        if skin.parts[number].body.is_some() {
            return true;
        }
        let nodes = |patch: &'a Patch| patch.iter().flat_map(|&face| &skin.faces[face].nodes);
        let first: HashSet<NodeIndex> = nodes(a).copied().collect();
        let shares = nodes(b).any(|node| first.contains(node));
        if shares {
            self.0.entry(number).or_default().extend(a.union(b));
        }
        shares
    }

    /// Leaves out what two patches exclude: faces that are in both.
    pub fn exclude(&mut self, a: &Side, b: &Side) {
        let (Side::Faces(a), Side::Faces(b)) = (a, b) else { return };
        for own in self.0.values_mut() {
            own.retain(|face| !(a.contains(face) && b.contains(face)));
        }
    }

    /// What meets itself in the end, with the interaction of the last line both of whose sides have some of it.
    pub fn patches(
        self,
        general: &GeneralContact,
        skin: &Skin,
        draft: &mut Draft,
    ) -> Vec<(Option<Named>, Patch)> {
        let lines = general.properties.iter().rev();
        let lines = lines.filter_map(|(two, named)| Some((both(two, skin, draft)?, named)));
        let lines: Vec<([Vec<Side>; 2], &Named)> = lines.collect();
        let mut found = Vec::new();
        for (number, patch) in self.0.into_iter().filter(|(_, own)| can_meet(own, skin)) {
            if let Some(why) = hindrance(&patch, skin, draft) {
                let name = &skin.parts[number].name;
                let message = format!(
                    "contact of {name} with itself is left out of this general contact: {why}"
                );
                draft.log.push(Diagnostic::note(Code("SL0393"), message).at(general.origin));
                continue;
            }
            let fits = lines.iter().find(|(sides, _)| has_within(sides, &patch));
            found.push((fits.map(|(_, named)| (*named).clone()), patch));
        }
        found
    }
}

/// Whether a node of a patch can meet one of its faces: one that shares no node with the faces about it.
fn can_meet(patch: &Patch, skin: &Skin) -> bool {
    let nodes = |face: &usize| skin.faces[*face].nodes.iter();
    let mut at: HashMap<NodeIndex, Vec<&usize>> = HashMap::new();
    for face in patch {
        nodes(face).for_each(|&node| at.entry(node).or_default().push(face));
    }
    let is_apart = |around: &Vec<&usize>, other: &usize| {
        around.iter().all(|face| nodes(face).all(|node| !skin.faces[*other].nodes.contains(node)))
    };
    at.values().any(|around| patch.iter().any(|other| is_apart(around, other)))
}

/// Why a patch is not made to meet itself, if it is not.
fn hindrance(patch: &Patch, skin: &Skin, draft: &Draft) -> Option<&'static str> {
    if draft.model.is_in_space() {
        return None;
    }
    if branches(patch, skin) {
        return Some("its outline touches itself at one of its nodes");
    }
    is_stepped(patch, skin, draft).then_some("it is not equally thick everywhere")
}

/// Whether more than two faces of the plane end at a node.
fn branches(patch: &Patch, skin: &Skin) -> bool {
    let mut ends: HashMap<NodeIndex, usize> = HashMap::new();
    patch
        .iter()
        .flat_map(|&face| skin.faces[face].ends())
        .for_each(|node| *ends.entry(node).or_default() += 1);
    ends.values().any(|&count| count > 2)
}

/// Whether sections behind a patch have more than one thickness.
fn is_stepped(patch: &Patch, skin: &Skin, draft: &Draft) -> bool {
    let label = |&face: &usize| draft.elements[skin.faces[face].element].label;
    let labels: HashSet<u64> = patch.iter().map(label).collect();
    let behind = |block: &&ElementBlock| {
        block.elements.iter().any(|element| labels.contains(&element.label))
    };
    let mut thicknesses = draft.model.blocks.iter().filter(behind).filter_map(|block| {
        let Section::Solid(section) = &block.section else { return None };
        Some(section.thickness)
    });
    let first = thicknesses.next();
    !thicknesses.all(|own| Some(own) == first)
}

/// Whether both sides of a line have faces of a patch.
fn has_within(sides: &[Vec<Side>; 2], patch: &Patch) -> bool {
    let has = |side: &Side| matches!(side, Side::Faces(own) if !own.is_disjoint(patch));
    sides.iter().all(|own| own.iter().any(has))
}
