//! `*CONTACT INCLUSIONS`: which parts general contact is between.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::Two;

use super::contact::{owner, two};

/// `*CONTACT INCLUSIONS`.
pub(crate) struct ContactInclusions;

impl Keyword for ContactInclusions {
    fn name(&self) -> &'static str {
        "CONTACT INCLUSIONS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::flag("ALL EXTERIOR")];
        RULES
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
        page!("CONTACT-INCLUSIONS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(general) = owner(card, self.name(), draft) else { return };
        if card.has("ALL EXTERIOR") {
            general.inclusions.push(Two { first: None, second: None });
            draft.log.at_most_lines(card.data(), 0, "CONTACT INCLUSIONS, ALL EXTERIOR");
            return;
        }
        general.inclusions.extend(card.data().iter().map(two));
        card.data().iter().for_each(|line| draft.log.at_most(line, 2));
        card.first_line("two surfaces", &mut draft.log);
    }
}
