//! `*CONTACT INITIALIZATION ASSIGNMENT`: where slaves of general contact begin otherwise.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::surfaces::Named;

use super::contact::{owner, two};
use slideline_deck::normalise;

/// `*CONTACT INITIALIZATION ASSIGNMENT`.
pub(crate) struct ContactInitializationAssignment;

impl Keyword for ContactInitializationAssignment {
    fn name(&self) -> &'static str {
        "CONTACT INITIALIZATION ASSIGNMENT"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("CONTACT-INITIALIZATION-ASSIGNMENT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        card.first_line("two surfaces, *CONTACT INITIALIZATION DATA", &mut draft.log);
        for line in card.data() {
            draft.log.at_most(line, 3);
            let Some(field) = line.field(2) else {
                let message = "the name of *CONTACT INITIALIZATION DATA is missing";
                draft.log.error("SL0119", message, line.end());
                continue;
            };
            let data = Named { name: normalise(&field.text), span: field.span };
            let Some(general) = owner(card, self.name(), draft) else { return };
            general.initializations.push((two(line), data));
        }
    }
}
