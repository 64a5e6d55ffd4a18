//! `*NODE FILE`: nodal values for the result files.

use super::node_print::request;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::requests::Kind;

/// `*NODE FILE`.
pub(crate) struct NodeFile;

impl Keyword for NodeFile {
    fn name(&self) -> &'static str {
        "NODE FILE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::value("NSET"), Rule::value("FREQUENCY"), Rule::value("GLOBAL")];
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
        page!("NODE-FILE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        request(card, Kind::File, draft);
    }
}
