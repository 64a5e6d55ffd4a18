//! `*PHYSICAL CONSTANTS`: absolute zero and others, which no static step needs.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PHYSICAL CONSTANTS`.
pub(crate) struct PhysicalConstants;

impl Keyword for PhysicalConstants {
    fn name(&self) -> &'static str {
        "PHYSICAL CONSTANTS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("ABSOLUTE ZERO"),
            Rule::value("STEFAN BOLTZMANN"),
            Rule::value("NEWTON GRAVITY"),
            Rule::value("UNIVERSAL GAS CONSTANT"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("PHYSICAL-CONSTANTS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        for rule in self.parameters() {
            // a number where there is one
            let _ = card.number(rule.name, &mut draft.log);
        }
        let message = "*PHYSICAL CONSTANTS is read: no law here needs absolute temperatures";
        draft.log.note("SL0257", message, card.span());
    }
}
