//! `*KINEMATIC`: the nodes of a coupling follow its reference node rigidly.

use slideline_model::Dof;

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
        let Some(range) = draft.dof_range(line, 0) else { continue };
        Dof::ALL
            .iter()
            .filter(|dof| range.contains(dof))
            .for_each(|dof| dofs[*dof as usize] = true);
    }
    dofs
}
