//! `*TEMPERATURE`: temperatures of nodes.

use slideline_diag::{Code, Diagnostic, Span};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*TEMPERATURE`.
pub(crate) struct Temperature;

impl Keyword for Temperature {
    fn name(&self) -> &'static str {
        "TEMPERATURE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("OP"), Rule::value("AMPLITUDE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("TEMPERATURE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        check(card, draft);
        if draft.log.first_time("ignored EXPANSION") {
            note(self.name(), card.span(), draft);
            return;
        }
        let message = "*TEMPERATURE with *EXPANSION is not supported: materials do not expand";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span());
        draft.log.push(error.help("leave both out knowingly, or only *EXPANSION"));
    }
}

/// Reads `node or set, temperature` lines for their errors.
pub(super) fn check(card: &Reading<'_>, draft: &mut Draft) {
    for line in card.data() {
        draft.log.target(line, 0, "the node or set");
        draft.log.number(line, 1, "the temperature");
    }
}

/// Says once that no result depends on temperatures.
pub(super) fn note(name: &str, span: Span, draft: &mut Draft) {
    if draft.log.first_time("temperatures") {
        let message = format!("*{name}: no material depends on temperature, so it has no effect");
        draft.log.note("SL0257", message, span);
    }
}
