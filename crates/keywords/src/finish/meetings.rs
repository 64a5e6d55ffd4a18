//! Sides that may meet in general contact.
//!
//! ```text
//!    [ A | B ]   a meeting: faces of one part with faces of another, or an analytical surface
//!    - [ a | b ]   leaves  [ A - a | B ]  and  [ a | B - b ]    where another line has a and b
//!                  leaves  [ A | B ] in which a does not meet b    where they are left out: b hides
//!                                                               what lies behind it from a
//! ```

use slideline_model::{LeftOut, NodeIndex};

use super::faces::faces;
use super::skin::{Patch, Skin};
use crate::draft::Draft;
use crate::surfaces::{Named, Two};

/// One side of a meeting.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Side {
    /// Faces of one part.
    Faces(Patch),
    /// An analytical surface.
    Analytical(String),
}

/// Two sides that may touch.
pub(super) type Meeting = [Side; 2];

/// The sides that a name, or no name, stands for: faces part by part, or analytical surfaces.
fn side(named: Option<&Named>, skin: &Skin, draft: &mut Draft) -> Option<Vec<Side>> {
    let by_parts = |patch: &Patch| {
        skin.by_parts(patch).into_iter().map(|(_, own)| Side::Faces(own)).collect::<Vec<_>>()
    };
    let Some(named) = named else {
        let owned = draft.bodies.iter().filter_map(|body| body.surface.as_ref());
        let rigid = owned.map(|surface| Side::Analytical(surface.name.clone()));
        return Some(by_parts(&skin.whole()).into_iter().chain(rigid).collect());
    };
    let surface = draft.surface(named)?;
    if surface.extent.is_analytical() {
        return Some(vec![Side::Analytical(named.name.clone())]);
    }
    let found = faces(&surface, named.span, draft);
    Some(by_parts(&skin.patch(&found)))
}

/// The sides of two names.
pub(super) fn both(two: &Two, skin: &Skin, draft: &mut Draft) -> Option<[Vec<Side>; 2]> {
    let first = side(two.first.as_ref(), skin, draft)?;
    let second = match two.is_alone() {
        true => first.clone(),
        false => side(two.second.as_ref(), skin, draft)?,
    };
    Some([first, second])
}

/// All meetings of the sides of two names, each in one order.
pub(super) fn sides(two: &Two, skin: &Skin, draft: &mut Draft) -> Option<Vec<Meeting>> {
    let [first, second] = both(two, skin, draft)?;
    let pairs = first.iter().flat_map(|a| second.iter().map(|b| [a.clone(), b.clone()]));
    Some(pairs.collect())
}

/// The part of a patch.
pub(super) fn part(patch: &Patch, skin: &Skin) -> Option<usize> {
    patch.first().map(|&face| skin.part_of[face])
}

/// What two sides have in common, and what of the first is not in the second.
fn split(own: &Side, by: &Side) -> (Option<Side>, Option<Side>) {
    match (own, by) {
        (Side::Faces(own), Side::Faces(by)) => {
            let some = |patch: Patch| (!patch.is_empty()).then_some(Side::Faces(patch));
            let inside = own.intersection(by).copied().collect();
            (some(inside), some(own.difference(by).copied().collect()))
        }
        (own, by) if own == by => (Some(own.clone()), None),
        (own, _) => (None, Some(own.clone())),
    }
}

/// What of a meeting is in another one, in its order, and what is not.
fn cut(meeting: &Meeting, by: &Meeting) -> (Option<Meeting>, Vec<Meeting>) {
    let (first, first_left) = split(&meeting[0], &by[0]);
    let (second, second_left) = split(&meeting[1], &by[1]);
    let (Some(first), Some(second)) = (first, second) else {
        return (None, vec![meeting.clone()]);
    };
    let mut left = Vec::new();
    left.extend(first_left.map(|other| [other, meeting[1].clone()]));
    left.extend(second_left.map(|other| [first.clone(), other]));
    (Some([first, second]), left)
}

/// What of meetings is not in another one, in either order.
pub(super) fn outside(meetings: Vec<Meeting>, by: &Meeting) -> Vec<Meeting> {
    let turned = [by[1].clone(), by[0].clone()];
    let left = meetings.iter().flat_map(|meeting| cut(meeting, by).1);
    let left: Vec<Meeting> = left.collect();
    left.iter().flat_map(|meeting| cut(meeting, &turned).1).collect()
}

/// A meeting with what of it does not meet.
#[derive(Clone, Debug)]
pub(super) struct Parted {
    /// What of both parts may meet.
    pub sides: Meeting,
    /// The sides before lines with other properties took some of their faces: as masters they
    /// are whole.
    pub whole: Meeting,
    /// What of them does not meet, in their order.
    left_out: Vec<Meeting>,
}

impl Parted {
    /// All of a meeting.
    pub fn whole(sides: Meeting) -> Self {
        Self { whole: sides.clone(), sides, left_out: Vec::new() }
    }

    /// What of it is in a meeting, in its order, and what is not, which does not meet the first.
    pub fn cut(self, by: &Meeting) -> (Option<Self>, Vec<Self>) {
        let (inside, others) = cut(&self.sides, by);
        let mut rest = self.clone();
        rest.left_out.extend(inside.clone());
        let others = others.into_iter().map(|sides| Self { sides, ..rest.clone() }).collect();
        (inside.map(|sides| Self { sides, ..self }), others)
    }

    /// What is left of it where another one does not meet.
    pub fn without(mut self, by: &Meeting) -> Vec<Self> {
        let of_faces = by.iter().chain(&self.sides).all(|side| matches!(side, Side::Faces(_)));
        if !of_faces {
            let Self { left_out, .. } = &self;
            let rest = outside(vec![self.sides.clone()], by).into_iter();
            return rest
                .map(|own| Self { left_out: left_out.clone(), ..Self::whole(own) })
                .collect();
        }
        let turned = [by[1].clone(), by[0].clone()];
        let common = |by| cut(&self.sides, by).0;
        let found: Vec<Meeting> = [by, &turned].into_iter().filter_map(common).collect();
        if found.contains(&self.sides) {
            return Vec::new();
        }
        self.left_out.extend(found);
        vec![self]
    }

    /// Slave and whole master, and their faces that do not meet; the second side is the slave where
    /// the meeting is `turned`.
    pub fn between(self, turned: bool, skin: &Skin) -> ([Side; 2], Vec<LeftOut>) {
        let (own, other) = if turned { (1, 0) } else { (0, 1) };
        let (slave, master) = (self.sides[own].clone(), self.whole[other].clone());
        let rest = split(&master, &self.sides[other]).1;
        let others = rest.map(|rest| [slave.clone(), rest]);
        let left = self.left_out.iter().map(|by| [by[own].clone(), by[other].clone()]);
        let faces = left.chain(others).map(|[slave, master]| LeftOut {
            slave: nodes_of(&slave, skin),
            master: nodes_of(&master, skin),
        });
        let faces = faces.collect();
        ([slave, master], faces)
    }
}

/// The faces of a side by their nodes.
fn nodes_of(side: &Side, skin: &Skin) -> Vec<Vec<NodeIndex>> {
    match side {
        Side::Faces(patch) => patch.iter().map(|&face| skin.faces[face].nodes.clone()).collect(),
        Side::Analytical(_) => Vec::new(),
    }
}
