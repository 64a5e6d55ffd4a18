//! `*PRINT`: what goes into the message file.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PRINT`.
pub(crate) struct Print;

impl Keyword for Print {
    fn name(&self) -> &'static str {
        "PRINT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::maybe("CONTACT"),
            Rule::value("FREQUENCY"),
            Rule::maybe("RESIDUAL"),
            Rule::maybe("SOLVE"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &[
            "ADAPTIVE MESH",
            "ALLKE",
            "CRITICAL ELEMENT",
            "DMASS",
            "ETOTAL",
            "MODEL CHANGE",
            "PLASTICITY",
        ]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("PRINT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let contact = card.yes("CONTACT", &mut draft.log);
        card.yes("RESIDUAL", &mut draft.log);
        card.yes("SOLVE", &mut draft.log);
        card.count("FREQUENCY", 1, &mut draft.log);
        if let (Some(contact), Some(step)) = (contact, draft.step()) {
            step.contact_changes = contact;
        }
    }
}
