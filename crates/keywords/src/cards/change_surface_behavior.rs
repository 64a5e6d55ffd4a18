//! `*CHANGE SURFACE BEHAVIOR`: another pressure law from a step on.

use crate::changes::PressureChange;
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::unsaid;

/// `*CHANGE SURFACE BEHAVIOR`.
pub(crate) struct ChangeSurfaceBehavior;

impl Keyword for ChangeSurfaceBehavior {
    fn name(&self) -> &'static str {
        "CHANGE SURFACE BEHAVIOR"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("INTERACTION")];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("CHANGE-SURFACE-BEHAVIOR")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        draft.owner = Owner::Broken;
        let Some(of) = card.named("INTERACTION") else { return };
        draft.owner = Owner::PressureChange;
        // the *SURFACE BEHAVIOR behind it fills in the law
        let interaction = unsaid(card.span());
        if let Some(step) = draft.step() {
            step.pressures.push(PressureChange { of, interaction });
        }
    }
}
