//! `*EMBEDDED ELEMENT`: nodes of bars, beams or solids follow the solids that they lie in.

use crate::constraints::{Embedment, Outside};
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// Part of the mean size of the hosts by which a node may lie outside. (manual)
const OUTSIDE: f64 = 0.05;

/// `*EMBEDDED ELEMENT`.
pub(crate) struct EmbeddedElement;

impl Keyword for EmbeddedElement {
    fn name(&self) -> &'static str {
        "EMBEDDED ELEMENT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::value("HOST ELSET"),
            Rule::value("EXTERIOR TOLERANCE"),
            Rule::value("ABSOLUTE EXTERIOR TOLERANCE"),
        ];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        // below it shares of a host's nodes are left out as rounding
        &["ROUNDOFF TOLERANCE"]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Links
    }

    fn page(&self) -> &'static str {
        page!("EMBEDDED-ELEMENT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if card.first_line("an embedded element or set", &mut draft.log).is_none() {
            return;
        }
        let Some(outside) = outside(card, draft) else { return };
        let mut embedded = Vec::new();
        for line in card.data() {
            for at in (0..line.fields.len()).filter(|&at| line.field(at).is_some()) {
                let target = draft.log.target(line, at, "an embedded element or set");
                embedded.extend(target.map(|target| (target, line.fields[at].span)));
            }
        }
        let hosts = card.named("HOST ELSET");
        draft.embedments.push(Embedment { hosts, embedded, outside, origin: card.span() });
    }
}

/// The tolerances: the usual one where none is given.
fn outside(card: &Reading<'_>, draft: &mut Draft) -> Option<Outside> {
    let names = ["ABSOLUTE EXTERIOR TOLERANCE", "EXTERIOR TOLERANCE"];
    let mut given = [None; 2];
    for (own, name) in given.iter_mut().zip(names) {
        // zero stands for none
        *own = card.number(name, &mut draft.log)?.filter(|value| *value != 0.0);
        if own.is_some_and(|value| value < 0.0) {
            draft.log.error("SL0210", format!("{name} must not be negative"), card.span_of(name));
            return None;
        }
    }
    let [distance, part] = given;
    let usual = if distance.is_some() { f64::INFINITY } else { OUTSIDE };
    Some(Outside { distance: distance.unwrap_or(f64::INFINITY), part: part.unwrap_or(usual) })
}
