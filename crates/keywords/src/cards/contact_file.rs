//! `*CONTACT FILE`: contact results for the result files.

use super::contact_print::request;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::Kind;

/// `*CONTACT FILE`.
pub(crate) struct ContactFile;

impl Keyword for ContactFile {
    fn name(&self) -> &'static str {
        "CONTACT FILE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("NSET"), Rule::value("FREQUENCY")];
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
        page!("CONTACT-FILE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::File, draft);
    }
}
