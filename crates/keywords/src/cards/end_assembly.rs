//! `*END ASSEMBLY`: closes the assembly.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*END ASSEMBLY`.
pub(crate) struct EndAssembly;

impl Keyword for EndAssembly {
    fn name(&self) -> &'static str {
        "END ASSEMBLY"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Nodes
    }

    fn page(&self) -> &'static str {
        page!("END-ASSEMBLY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.end_assembly(card.span());
    }
}
