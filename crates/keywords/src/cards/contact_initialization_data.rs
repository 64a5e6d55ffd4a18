//! `*CONTACT INITIALIZATION DATA`: how slaves of general contact begin.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::{Adjusted, Initialization};
use slideline_diag::{Code, Diagnostic};

/// `*CONTACT INITIALIZATION DATA`.
pub(crate) struct ContactInitializationData;

impl Keyword for ContactInitializationData {
    fn name(&self) -> &'static str {
        "CONTACT INITIALIZATION DATA"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("NAME"),
            Rule::value("INITIAL CLEARANCE"),
            Rule::value("SEARCH ABOVE"),
            Rule::value("SEARCH BELOW"),
            Rule::maybe("INTERFERENCE FIT"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("CONTACT-INITIALIZATION-DATA")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let Some(named) = card.named("NAME") else { return };
        if card.has("INTERFERENCE FIT") {
            let message = "INTERFERENCE FIT of *CONTACT INITIALIZATION DATA is not supported";
            let span = card.span_of("INTERFERENCE FIT");
            let error = Diagnostic::error(Code("SL0221"), message).at(span);
            let help = "what overlaps is pressed apart over a step by *CONTACT INTERFERENCE, SHRINK \
                        with the surfaces of a *CONTACT PAIR";
            draft.consequence(Subject::Contact, error.help(help));
            return;
        }
        let clearance = card.number("INITIAL CLEARANCE", &mut draft.log);
        let above = card.number("SEARCH ABOVE", &mut draft.log);
        let (Some(clearance), Some(above)) = (clearance, above) else { return };
        if let Some(below) = above.filter(|above| *above < 0.0) {
            let message = format!("SEARCH ABOVE is a distance, {below} is below zero");
            draft.log.error("SL0210", message, card.span_of("SEARCH ABOVE"));
            return;
        }
        if card.has("SEARCH BELOW") {
            let message = "SEARCH BELOW has no effect: overclosures of any depth are adjusted";
            draft.log.note("SL0257", message, card.span_of("SEARCH BELOW"));
        }
        let adjusted = match (clearance, above) {
            (Some(value), _) => Adjusted::Clearance(value),
            (None, above) => Adjusted::Within(above.unwrap_or_default()),
        };
        draft.initializations.push(Initialization { named, adjusted });
    }
}
