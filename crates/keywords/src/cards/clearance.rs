//! `*CLEARANCE`: the gap at which the slaves of a contact pair begin.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::Clearance as Asked;

/// `*CLEARANCE`.
pub(crate) struct Clearance;

impl Keyword for Clearance {
    fn name(&self) -> &'static str {
        "CLEARANCE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::required("MASTER"), Rule::required("SLAVE"), Rule::required("VALUE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("CLEARANCE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let (slave, master) = (card.named("SLAVE"), card.named("MASTER"));
        let value = card.number("VALUE", &mut draft.log).flatten();
        if let (Some(slave), Some(master), Some(value)) = (slave, master, value) {
            draft.clearances.push(Asked { slave, master, value, origin: card.span() });
        }
    }
}
