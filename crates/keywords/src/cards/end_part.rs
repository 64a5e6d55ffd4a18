//! `*END PART`: closes a part.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*END PART`.
pub(crate) struct EndPart;

impl Keyword for EndPart {
    fn name(&self) -> &'static str {
        "END PART"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("END-PART")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.end_part(card.span());
    }
}
