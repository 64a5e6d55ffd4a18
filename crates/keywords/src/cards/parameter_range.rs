//! `*PARAMETER RANGE`: between which numbers a parameter means anything. A card of our own.

use slideline_deck::DataLine;

use crate::draft::{Draft, ParameterRange};
use crate::expression::is_name;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*PARAMETER RANGE`.
pub(crate) struct OfParameters;

impl Keyword for OfParameters {
    fn name(&self) -> &'static str {
        "PARAMETER RANGE"
    }

    fn parameters(&self) -> &'static [Rule] {
        &[]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Other
    }

    fn page(&self) -> &'static str {
        page!("PARAMETER-RANGE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        for line in card.data() {
            range(line, draft);
        }
    }
}

/// `name, low, high`; a number that is left out is no limit.
fn range(line: &DataLine, draft: &mut Draft) {
    draft.log.at_most(line, 3);
    let low = draft.log.number_or(line, 1, f64::NEG_INFINITY);
    let high = draft.log.number_or(line, 2, f64::INFINITY);
    let (Some(low), Some(high)) = (low, high) else { return };
    let name = line.field(0).map(|field| field.text.clone()).filter(|name| is_name(name));
    let Some(name) = name.filter(|_| low < high) else {
        let message =
            "a range is `name, low, high`, its name that of a parameter and low below high";
        draft.log.error("SL0287", message, line.span);
        return;
    };
    if draft.parameters.contains_key(&name) {
        let message =
            format!("the range of {name} must stand above the line that gives it a value");
        draft.log.error("SL0287", message, line.span);
        return;
    }
    draft.ranges.insert(name, ParameterRange { low, high, origin: line.span });
}
