//! `*ASSEMBLY`: where instances of parts are put together.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*ASSEMBLY`.
pub(crate) struct Assembly;

impl Keyword for Assembly {
    fn name(&self) -> &'static str {
        "ASSEMBLY"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("NAME")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("ASSEMBLY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.open_assembly(card.span());
    }
}
