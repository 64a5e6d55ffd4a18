//! `*VISCO`: a step in which time passes for the materials.

use slideline_diag::{Code, Diagnostic};
use slideline_model::Passage;

use super::static_::procedure;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*VISCO`.
pub(crate) struct Visco;

impl Keyword for Visco {
    fn name(&self) -> &'static str {
        "VISCO"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::maybe("DIRECT"),
            Rule::value("CETOL"),
            Rule::value("CREEP"),
            Rule::maybe("STABILIZE"),
            Rule::value("TOTAL TIME AT START"),
            Rule::flag("TIME RESET"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["SOLVER", "ALLSDTOL", "FACTOR", "CONTINUE"]
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("VISCO")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(tolerance) = card.number("CETOL", &mut draft.log) else { return };
        if tolerance.is_some_and(|own| own <= 0.0) {
            let message = "CETOL, a difference of creep strains, must be positive";
            draft.log.error("SL0246", message, card.span_of("CETOL"));
            return;
        }
        let known = &["IMPLICIT", "EXPLICIT"];
        if card.choice("CREEP", known, &mut draft.log) == Some("EXPLICIT") {
            let message = "CREEP=EXPLICIT has no effect: creep is integrated implicitly, which no \
                           increment makes unstable";
            let note = Diagnostic::note(Code("SL0257"), message).at(card.span_of("CREEP"));
            draft.log.push(note);
        }
        procedure(self.name(), card, (Passage::Passing, tolerance), draft);
    }
}
