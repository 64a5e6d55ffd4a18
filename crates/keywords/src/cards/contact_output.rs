//! `*CONTACT OUTPUT`: contact results for the result files.

use super::contact_print::request;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::Kind;

/// `*CONTACT OUTPUT`.
pub(crate) struct ContactOutput;

impl Keyword for ContactOutput {
    fn name(&self) -> &'static str {
        "CONTACT OUTPUT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("NSET"), Rule::value("VARIABLE")];
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
        page!("CONTACT-OUTPUT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::Output, draft);
    }
}
