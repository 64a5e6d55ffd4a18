//! `*GAP`: clearance and direction of gap elements.

use crate::draft;
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*GAP`.
pub(crate) struct Gap;

impl Keyword for Gap {
    fn name(&self) -> &'static str {
        "GAP"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("ELSET")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("GAP")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.owner = Owner::Gap;
        let Some(set) = card.name("ELSET") else { return };
        let Some(line) = card.only_line("the clearance, the direction", &mut draft.log) else {
            return;
        };
        draft.log.at_most(line, 7);
        let Some(clearance) = draft.log.number(line, 0, "the clearance") else { return };
        let way = [1, 2, 3].map(|at| draft.log.number_or(line, at, 0.0));
        let [Some(x), Some(y), Some(z)] = way else { return };
        let Some(stiffness) = draft.log.maybe_number(line, 5) else { return };
        let Some(tension) = draft.log.maybe_number(line, 6) else { return };
        for (value, what) in [(stiffness, "stiffness of a gap"), (tension, "pull of an open gap")] {
            if let Some(value) = value.filter(|value| *value <= 0.0) {
                let message = format!("the {what} must be positive, not {value}");
                draft.log.error("SL0210", message, line.span);
                return;
            }
        }
        // the largest of the components first: no square under- or overflows
        let most = x.abs().max(y.abs()).max(z.abs());
        let [x, y, z] = [x, y, z].map(|component| component / most);
        let long = x.hypot(y).hypot(z);
        let direction = (most > 0.0).then(|| [x, y, z].map(|component| component / long));
        let (set_span, origin) = (card.span_of("ELSET"), card.span());
        let gap = draft::Gap { set, set_span, clearance, direction, stiffness, tension, origin };
        draft.gaps.push(gap);
    }
}
