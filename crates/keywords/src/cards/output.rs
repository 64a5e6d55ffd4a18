//! `*OUTPUT`: opens requests for result files.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*OUTPUT`.
pub(crate) struct Output;

impl Keyword for Output {
    fn name(&self) -> &'static str {
        "OUTPUT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::flag("FIELD"),
            Rule::flag("HISTORY"),
            Rule::value("FREQUENCY"),
            Rule::value("VARIABLE"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("OUTPUT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let frequency = card.count("FREQUENCY", 1, &mut draft.log);
        if let Some(step) = draft.step() {
            step.output_frequency = frequency;
        }
        if card.has("FIELD") && card.has("HISTORY") {
            let message = "FIELD and HISTORY exclude one another";
            draft.log.error("SL0215", message, card.span_of("HISTORY"));
        }
    }
}
