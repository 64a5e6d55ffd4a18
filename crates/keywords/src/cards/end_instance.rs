//! `*END INSTANCE`: closes an instance.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*END INSTANCE`.
pub(crate) struct EndInstance;

impl Keyword for EndInstance {
    fn name(&self) -> &'static str {
        "END INSTANCE"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("END-INSTANCE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.end_instance(card.span());
    }
}
