//! `*HEADING`: the title of the job.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*HEADING`.
pub(crate) struct Heading;

impl Keyword for Heading {
    fn name(&self) -> &'static str {
        "HEADING"
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("HEADING")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let lines: Vec<&str> = card.data().iter().map(|line| line.text.as_str()).collect();
        draft.model.heading = lines.join("\n");
    }
}
