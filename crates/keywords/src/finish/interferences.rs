//! `*CONTACT INTERFERENCE`: the overclosures that a step takes away.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Allowed, Interference};

use super::amplitudes::amplitude;
use crate::changes::InterferenceCard;
use crate::draft::{Draft, StepDraft};
use crate::rule::Subject;

/// Those of a step.
pub(super) fn interferences(step: &StepDraft, draft: &mut Draft) -> Vec<Interference> {
    let mut found: Vec<Interference> = Vec::new();
    for card in &step.interferences {
        let own = of_card(card, draft);
        let again = found.iter().any(|other| own.iter().any(|own| own.pair == other.pair));
        match again {
            true => refuse(card, "a second interference of one pair in one step", draft),
            false => found.extend(own),
        }
    }
    found
}

/// Those of a card: one, or one for each piece of the master.
fn of_card(card: &InterferenceCard, draft: &mut Draft) -> Vec<Interference> {
    let name = format!("{}/{}", card.slave.name, card.master.name);
    let pairs = draft.model.contact_pairs.iter().enumerate();
    let own: Vec<usize> = pairs.filter(|own| own.1.is_called(&name)).map(|own| own.0).collect();
    if own.is_empty() {
        let message = format!("there is no contact pair {name}");
        refuse(card, &message, draft);
        return Vec::new();
    }
    if card.value.is_none() && !draft.model.steps.is_empty() {
        refuse(card, "SHRINK takes away what overlaps in the undeformed model", draft);
        return Vec::new();
    }
    let amplitude = card.amplitude.as_ref().and_then(|named| amplitude(named, draft));
    let allowed = card.value.map_or(Allowed::Initial, Allowed::Value);
    let of_pair = |pair| Interference { pair, allowed, amplitude, origin: card.origin };
    own.into_iter().map(of_pair).collect()
}

fn refuse(card: &InterferenceCard, message: &str, draft: &mut Draft) {
    let error = Diagnostic::error(Code("SL0397"), message).at(card.origin);
    let help = "name slave and master of a line of *CONTACT PAIR, each once in a step; SHRINK belongs \
                to the first step";
    draft.consequence(Subject::Contact, error.help(help));
}
