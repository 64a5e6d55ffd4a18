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
        const RULES: &[Rule] = &[Rule::required("ELSET"), Rule::flag("NONLINEAR")];
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
        if card.first_line("the dof (blank for SPRINGA)", &mut draft.log).is_none() {
            return;
        }
        let nonlinear = card.has("NONLINEAR");
        if !nonlinear {
            draft.log.at_most_lines(card.data(), 2, self.name());
        }
        let mut lines = Vec::with_capacity(card.data().len());
        // a blank first line is not kept by the deck, one of empty fields is passed over
        for line in card
            .data()
            .iter()
            .filter(|line| (0..line.fields.len()).any(|at| line.field(at).is_some()))
        {
            let values = (0..line.fields.len()).map(|at| draft.log.number_or(line, at, 0.0));
            let Some(values) = values.collect::<Vec<_>>().into_iter().collect() else { return };
            lines.push((values, line.span));
        }
        let set_span = card.span_of("ELSET");
        draft.springs.push(draft::Spring { set, set_span, nonlinear, lines, origin: card.span() });
    }
}
