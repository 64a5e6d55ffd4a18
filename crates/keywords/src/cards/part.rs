//! `*PART`: a mesh with numbers and names of its own.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PART`.
pub(crate) struct Part;

impl Keyword for Part {
    fn name(&self) -> &'static str {
        "PART"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NAME")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("PART")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let Some(name) = card.name("NAME") else { return };
        draft.open_part(name, card.span_of("NAME"), card.span());
    }
}
