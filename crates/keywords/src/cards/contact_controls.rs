//! `*CONTACT CONTROLS`: when friction begins to act.

use slideline_diag::{Code, Diagnostic};
use slideline_model::Onset;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CONTACT CONTROLS`.
pub(crate) struct ContactControls;

impl Keyword for ContactControls {
    fn name(&self) -> &'static str {
        "CONTACT CONTROLS"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("FRICTION ONSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("CONTACT-CONTROLS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        if draft.in_step {
            let message = "the friction onset is a property of the model";
            let error = Diagnostic::error(Code("SL0214"), message).at(card.span());
            draft.log.push(error.help("put *CONTACT CONTROLS before the first *STEP"));
        }
        let known = &["IMMEDIATE", "DELAYED", "MATFRU"];
        match card.choice("FRICTION ONSET", known, &mut draft.log) {
            Some("IMMEDIATE") => draft.model.friction_onset = Onset::Immediate,
            Some("DELAYED") => draft.model.friction_onset = Onset::Delayed,
            Some("MATFRU") => draft.model.friction_onset = Onset::Matfru,
            _ => {}
        }
    }
}
