//! `*RESTART`: state files to go on from.

use slideline_diag::{Code, Diagnostic};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*RESTART`.
pub(crate) struct Restart;

impl Keyword for Restart {
    fn name(&self) -> &'static str {
        "RESTART"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::flag("WRITE"),
            Rule::flag("READ"),
            Rule::value("FREQUENCY"),
            Rule::flag("OVERLAY"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("RESTART")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        if card.has("READ") {
            let message = "*RESTART, READ is not read from a deck";
            let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("READ"));
            draft.log.push(error.help("go on from a saved state with `slideline run --restart`"));
        }
        if !card.has("WRITE") {
            return;
        }
        let every = Some(card.count("FREQUENCY", 1, &mut draft.log));
        match draft.step() {
            Some(step) => step.restart_every = every,
            None => draft.restart_every = every,
        }
    }
}
