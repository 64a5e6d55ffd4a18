//! `*CONTACT EXCLUSIONS`: which surfaces general contact is not between.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

use super::contact::{owner, two};

/// `*CONTACT EXCLUSIONS`.
pub(crate) struct ContactExclusions;

impl Keyword for ContactExclusions {
    fn name(&self) -> &'static str {
        "CONTACT EXCLUSIONS"
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
        page!("CONTACT-EXCLUSIONS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(general) = owner(card, self.name(), draft) else { return };
        general.exclusions.extend(card.data().iter().map(two));
        card.data().iter().for_each(|line| draft.log.at_most(line, 2));
        card.first_line("two surfaces", &mut draft.log);
    }
}
