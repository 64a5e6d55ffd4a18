//! `*TEMPERATURE`: temperatures of nodes.

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::temperatures;

/// `*TEMPERATURE`.
pub(crate) struct Temperature;

impl Keyword for Temperature {
    fn name(&self) -> &'static str {
        "TEMPERATURE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("OP"),
            Rule::value("AMPLITUDE"),
            Rule::value("TIME DELAY"),
            Rule::value("INPUT"),
        ];
        RULES
    }

    fn level(&self) -> Level {
        Level::History
    }

    fn subject(&self) -> Subject {
        Subject::Steps
    }

    fn page(&self) -> &'static str {
        page!("TEMPERATURE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let new = card.choice("OP", &["MOD", "NEW"], &mut draft.log) == Some("NEW");
        let amplitude = crate::curves::of_card(card, draft);
        let mut lines = temperatures::lines(card, draft);
        lines.iter_mut().for_each(|line| line.amplitude.clone_from(&amplitude));
        if let Some(step) = draft.step() {
            step.new_temperatures |= new;
            step.temperatures.extend(lines);
        }
    }
}
