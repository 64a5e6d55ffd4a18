//! `*CHANGE FRICTION`: another friction from a step on.

use slideline_diag::{Code, Diagnostic};

use crate::changes::{FrictionChange, FrictionOf};
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::unsaid;

/// `*CHANGE FRICTION`.
pub(crate) struct ChangeFriction;

impl Keyword for ChangeFriction {
    fn name(&self) -> &'static str {
        "CHANGE FRICTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::value("INTERACTION"), Rule::value("ELSET"), Rule::flag("RESET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("CHANGE-FRICTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let of = match (card.named("INTERACTION"), card.named("ELSET")) {
            (Some(own), None) => FrictionOf::Interaction(own),
            (None, Some(own)) => FrictionOf::Elements(own),
            (None, None) => {
                let message = "*CHANGE FRICTION needs the parameter INTERACTION= or ELSET=";
                draft.log.error("SL0205", message, card.span());
                draft.owner = Owner::Broken;
                return;
            }
            (Some(_), Some(own)) => {
                let message = "INTERACTION and ELSET exclude one another";
                let error = Diagnostic::error(Code("SL0215"), message).at(own.span);
                draft.log.push(error.help("give a *CHANGE FRICTION card for each"));
                draft.owner = Owner::Broken;
                return;
            }
        };
        // the *FRICTION behind it fills in the law
        let interaction = unsaid(card.span());
        let reset = card.has("RESET");
        draft.owner = Owner::FrictionChange;
        if let Some(step) = draft.step() {
            step.frictions.push(FrictionChange { of, reset, interaction });
        }
    }
}
