//! `*SPRING`: stiffness of spring elements.

use crate::draft;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*SPRING`.
pub(crate) struct Spring;

impl Keyword for Spring {
    fn name(&self) -> &'static str {
        "SPRING"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("ELSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("SPRING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(set) = card.name("ELSET") else { return };
        let Some(first) = card.first_line("the dof (blank for SPRINGA)", &mut draft.log) else {
            return;
        };
        draft.log.at_most_lines(card.data(), 2, self.name());
        // A blank first line is not kept by the deck: one line alone is the stiffness.
        let (dof_line, stiffness_line) = match card.data().get(1) {
            Some(second) => (Some(first), second),
            None => (None, first),
        };
        let dof = dof_line.filter(|line| line.field(0).is_some()).and_then(|line| {
            let number = draft.log.integer_or(line, 0, 1)?;
            draft.dof(number, line, 0)
        });
        let Some(stiffness) = draft.log.number(stiffness_line, 0, "the stiffness") else { return };
        if stiffness < 0.0 {
            let message = "a negative spring stiffness";
            draft.log.warning("SL0210", message, stiffness_line.fields[0].span);
        }
        let set_span = card.span_of("ELSET");
        draft.springs.push(draft::Spring { set, set_span, dof, stiffness, origin: card.span() });
    }
}
