//! `*INITIAL CONDITIONS`: the state before the first step.

use slideline_diag::{Code, Diagnostic};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::temperatures;

/// `*INITIAL CONDITIONS`.
pub(crate) struct InitialConditions;

impl Keyword for InitialConditions {
    fn name(&self) -> &'static str {
        "INITIAL CONDITIONS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("TYPE")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("INITIAL-CONDITIONS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        match card.name("TYPE").as_deref() {
            Some("TEMPERATURE") => {
                let lines = temperatures::lines(card, draft);
                draft.initial_temperatures.extend(lines);
            }
            Some("VELOCITY") => {
                let message = "initial velocities have no effect in a static step";
                draft.log.note("SL0257", message, card.span());
            }
            other => {
                let kind = other.unwrap_or_default();
                let message = format!("*INITIAL CONDITIONS, TYPE={kind} is not supported");
                let error = Diagnostic::error(Code("SL0221"), message);
                let error = error.at(card.span_of("TYPE"));
                draft.log.push(error.help("the first step starts undeformed and free of stress"));
            }
        }
    }
}
