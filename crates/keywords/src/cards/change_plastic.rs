//! `*CHANGE PLASTIC`: the yield stresses of a `*CHANGE MATERIAL`.

use slideline_diag::{Code, Diagnostic};

use super::plastic::{Plastic, read_yielding};
use crate::draft::{Draft, Owner, PropertyChange};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CHANGE PLASTIC`.
pub(crate) struct ChangePlastic;

impl Keyword for ChangePlastic {
    fn name(&self) -> &'static str {
        "CHANGE PLASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        Plastic.parameters()
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("CHANGE-PLASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owner != Owner::MaterialChange {
            draft.orphan(self.name(), "CHANGE MATERIAL", card.span());
            return;
        }
        let Some(read) = read_yielding(card, draft) else {
            draft.owner = Owner::Broken;
            return;
        };
        let open = draft.step().and_then(|step| step.properties.last_mut());
        let Some(PropertyChange::Material { yielding, material, .. }) = open else { return };
        if yielding.replace(read).is_some() {
            let message = format!("a second *CHANGE PLASTIC of the material {}", material.name);
            draft.log.push(Diagnostic::error(Code("SL0242"), message).at(card.span()));
        }
    }
}
