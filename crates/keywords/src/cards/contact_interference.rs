//! `*CONTACT INTERFERENCE`: an overclosure that a pair is allowed, and that a step takes away.

use super::contact_pair::surface;
use crate::changes::InterferenceCard;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*CONTACT INTERFERENCE`.
pub(crate) struct ContactInterference;

impl Keyword for ContactInterference {
    fn name(&self) -> &'static str {
        "CONTACT INTERFERENCE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[
            Rule::flag("SHRINK"),
            Rule::value("AMPLITUDE"),
            Rule::value("TYPE"),
            Rule::value("OP"),
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
        page!("CONTACT-INTERFERENCE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        card.choice("TYPE", &["CONTACT PAIR"], &mut draft.log);
        card.choice("OP", &["MOD", "NEW"], &mut draft.log);
        if card.first_line("the slave surface", &mut draft.log).is_none() {
            return;
        }
        let shrink = card.has("SHRINK");
        let amplitude = card.name("AMPLITUDE").map(|name| (name, card.span_of("AMPLITUDE")));
        for line in card.data() {
            let given = line.fields.iter().skip(2).find(|field| !field.text.is_empty());
            if let (true, Some(value)) = (shrink, given) {
                let message = "SHRINK takes no value: what overlaps in the undeformed model is what it \
                               takes away";
                draft.log.error("SL0209", message, value.span);
            } else {
                // a direction to shift along would stand behind the value
                draft.log.at_most(line, 3);
            }
            let slave = surface(line, 0, "the slave surface", &mut draft.log);
            let master = surface(line, 1, "the master surface", &mut draft.log);
            let value = match shrink {
                true => Some(None),
                false => draft.log.number(line, 2, "the interference that is allowed").map(Some),
            };
            let (Some(slave), Some(master), Some(value)) = (slave, master, value) else {
                continue;
            };
            if value.is_some_and(|value| value <= 0.0) {
                let message = "the interference that is allowed must be positive";
                draft.log.error("SL0210", message, line.fields[2].span);
                continue;
            }
            let amplitude = amplitude.clone();
            let own = InterferenceCard { slave, master, value, amplitude, origin: line.span };
            if let Some(step) = draft.step() {
                step.interferences.push(own);
            }
        }
    }
}
