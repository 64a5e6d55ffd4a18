//! `*CHANGE MATERIAL`: other constants of a material from a step on.

use crate::draft::{Draft, Owner, PropertyChange};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CHANGE MATERIAL`.
pub(crate) struct ChangeMaterial;

impl Keyword for ChangeMaterial {
    fn name(&self) -> &'static str {
        "CHANGE MATERIAL"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("NAME")];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("CHANGE-MATERIAL")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.owner = Owner::Broken;
        let Some(material) = card.named("NAME") else { return };
        let origin = card.span();
        draft.owner = Owner::MaterialChange;
        // the *CHANGE PLASTIC behind it says what changes
        if let Some(step) = draft.step() {
            step.properties.push(PropertyChange::Material { material, yielding: None, origin });
        }
    }
}
