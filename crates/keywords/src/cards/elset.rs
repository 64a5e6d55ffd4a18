//! `*ELSET`: a named set of elements.

use super::nset::read_members;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*ELSET`.
pub(crate) struct Elset;

impl Keyword for Elset {
    fn name(&self) -> &'static str {
        "ELSET"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::required("ELSET"),
            Rule::flag("GENERATE"),
            Rule::flag("UNSORTED"),
            Rule::value("INSTANCE"),
            Rule::flag("INTERNAL"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["SORTED"]
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Elements
    }

    fn page(&self) -> &'static str {
        page!("ELSET")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Some(name) = card.name("ELSET") else { return };
        draft.element_sets.open(&name, card.span());
        for (item, span) in read_members(card, draft) {
            draft.element_sets.join(&name, item, span);
        }
    }
}
