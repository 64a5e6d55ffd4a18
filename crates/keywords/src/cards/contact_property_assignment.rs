//! `*CONTACT PROPERTY ASSIGNMENT`: which surface interaction acts where in general contact.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;
use crate::surfaces::Named;

use super::contact::{owner, two};
use slideline_deck::normalise;

/// `*CONTACT PROPERTY ASSIGNMENT`.
pub(crate) struct ContactPropertyAssignment;

impl Keyword for ContactPropertyAssignment {
    fn name(&self) -> &'static str {
        "CONTACT PROPERTY ASSIGNMENT"
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
        page!("CONTACT-PROPERTY-ASSIGNMENT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        card.first_line("two surfaces, surface interaction", &mut draft.log);
        for line in card.data() {
            draft.log.at_most(line, 3);
            let Some(field) = line.field(2) else {
                draft.log.error("SL0119", "the surface interaction is missing", line.end());
                continue;
            };
            let interaction = Named { name: normalise(&field.text), span: field.span };
            let Some(general) = owner(card, self.name(), draft) else { return };
            general.properties.push((two(line), interaction));
        }
    }
}
