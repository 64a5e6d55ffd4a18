//! `*RESTART`: state files to go on from.

use slideline_diag::{Code, Diagnostic};
use slideline_model::SavedStates;

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
            Rule::value("STEP"),
            Rule::value("INC"),
            Rule::flag("END STEP"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["NUMBER INTERVAL", "TIME MARKS", "NAME"]
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
        go_on(card, draft);
        if !card.has("WRITE") {
            return;
        }
        let every = card.at_least(0, "FREQUENCY", 1, &mut draft.log);
        let states = Some(SavedStates { every, overlay: card.has("OVERLAY") });
        match draft.step() {
            Some(step) => step.restart = states,
            None => draft.restart = states,
        }
    }
}

/// `READ`: the state itself is found before the deck is interpreted.
fn go_on(card: &Reading<'_>, draft: &mut Draft) {
    for name in ["STEP", "INC"] {
        card.count(name, 1, &mut draft.log);
        let needs = if name == "INC" { "STEP" } else { "READ" };
        if card.has(name) && !card.has(needs) {
            let message = format!("{name} has no meaning without {needs}");
            draft.log.error("SL0205", message, card.span_of(name));
        }
    }
    if card.has("END STEP") {
        let message = "*RESTART, READ, END STEP is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span_of("END STEP"));
        draft
            .log
            .push(error.help("without it the step is completed first, then come the new ones"));
    }
    if !card.has("READ") {
        return;
    }
    if draft.in_step {
        let message = "*RESTART, READ belongs before the first *STEP";
        draft.log.error("SL0214", message, card.span_of("READ"));
    } else if !draft.goes_on {
        let message = "this deck continues a previous job, and none is named";
        let error = Diagnostic::error(Code("SL0711"), message).at(card.span_of("READ"));
        let help = "name the job whose states are read: --oldjob OLD, where OLD.rst is";
        draft.log.push(error.help(help));
        draft.mark_all_incomplete();
    }
}
