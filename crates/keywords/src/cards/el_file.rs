//! `*EL FILE`: beam results for the result files.

use super::el_print::request;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::Kind;

/// `*EL FILE`.
pub(crate) struct ElFile;

impl Keyword for ElFile {
    fn name(&self) -> &'static str {
        "EL FILE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::value("ELSET"), Rule::value("FREQUENCY"), Rule::flag("SECTION FORCES")];
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
        page!("EL-FILE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::File, draft);
    }
}
