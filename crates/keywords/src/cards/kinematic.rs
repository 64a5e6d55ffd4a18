//! `*KINEMATIC`: the nodes of a coupling follow its reference node rigidly.

use crate::constraints::CouplingKind;
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*KINEMATIC`.
pub(crate) struct Kinematic;

impl Keyword for Kinematic {
    fn name(&self) -> &'static str {
        "KINEMATIC"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("KINEMATIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let dofs = dofs(card, draft);
        match draft.owner {
            Owner::Coupling(index) => {
                if let Some(coupling) = draft.couplings.get_mut(index) {
                    coupling.kind = CouplingKind::Kinematic(dofs);
                }
            }
            _ => draft.orphan(self.name(), "COUPLING", card.span()),
        }
    }
}

/// The dofs of lines `first, last`; all of them where there is no line.
pub(super) fn dofs(card: &Reading<'_>, draft: &mut Draft) -> [bool; 6] {
    if card.data().is_empty() {
        return [true; 6];
    }
    let mut dofs = [false; 6];
    for line in card.data() {
        draft.log.at_most(line, 2);
        let Some(first) = draft.log.integer_or(line, 0, 1) else { continue };
        let Some(last) = draft.log.integer_or(line, 1, first) else { continue };
        let ends = draft.dof(first, line, 0).zip(draft.dof(last, line, 1));
        let Some((first, last)) = ends else { continue };
        (first as usize..=last as usize).for_each(|dof| dofs[dof] = true);
    }
    dofs
}
