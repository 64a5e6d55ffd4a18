//! `*CHANGE SOLID SECTION`: another material of solids from a step on.

use crate::draft::{Draft, PropertyChange};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CHANGE SOLID SECTION`.
pub(crate) struct ChangeSolidSection;

impl Keyword for ChangeSolidSection {
    fn name(&self) -> &'static str {
        "CHANGE SOLID SECTION"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::required("ELSET"), Rule::required("MATERIAL"), Rule::value("ORIENTATION")];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("CHANGE-SOLID-SECTION")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let Some((set, material)) = card.named("ELSET").zip(card.named("MATERIAL")) else { return };
        let orientation = card.named("ORIENTATION").map(|own| (own.name, own.span));
        let origin = card.span();
        if let Some(step) = draft.step() {
            step.properties.push(PropertyChange::Section { set, material, orientation, origin });
        }
    }
}
