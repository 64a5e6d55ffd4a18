//! `*OUTPUT`: opens requests for result files.

use slideline_model::PrintTarget;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::ask_for_states;

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

    fn without_effect(&self) -> &'static [&'static str] {
        crate::requests::WITHOUT_EFFECT
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
        let frequency = card.at_least(0, "FREQUENCY", 1, &mut draft.log);
        let target = match card.has("HISTORY") {
            true => PrintTarget::History,
            false => PrintTarget::Field,
        };
        if let Some(step) = draft.step() {
            step.output = Some((target, frequency));
        }
        if target == PrintTarget::Field {
            ask_for_states(frequency, draft);
        }
        if card.has("FIELD") && card.has("HISTORY") {
            let message = "FIELD and HISTORY exclude one another";
            draft.log.error("SL0215", message, card.span_of("HISTORY"));
        }
    }
}
