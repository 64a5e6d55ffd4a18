//! `*ELEMENT OUTPUT`: beam results for the result files.

use super::el_print::request;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::Kind;

/// `*ELEMENT OUTPUT`.
pub(crate) struct ElementOutput;

impl Keyword for ElementOutput {
    fn name(&self) -> &'static str {
        "ELEMENT OUTPUT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::value("ELSET"), Rule::value("VARIABLE"), Rule::maybe("DIRECTIONS")];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        crate::requests::WITHOUT_EFFECT
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("ELEMENT-OUTPUT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::Output, draft);
    }
}
