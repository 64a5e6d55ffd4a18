//! `*END STEP`: closes a step.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*END STEP`.
pub(crate) struct EndStep;

impl Keyword for EndStep {
    fn name(&self) -> &'static str {
        "END STEP"
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("END-STEP")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if let Some(line) = card.data().first() {
            let message = "data after *END STEP are not read";
            draft.log.warning("SL0245", message, line.span);
        }
        draft.in_step = false;
    }
}
