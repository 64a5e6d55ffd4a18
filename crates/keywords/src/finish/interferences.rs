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
        let Some(own) = interference(card, draft) else { continue };
        let again = found.iter().any(|other| other.pair == own.pair);
        match again {
            true => refuse(card, "a second interference of one pair in one step", draft),
            false => found.push(own),
        }
    }
    found
}

fn interference(card: &InterferenceCard, draft: &mut Draft) -> Option<Interference> {
    let name = format!("{}/{}", card.slave.name, card.master.name);
    let pairs = &draft.model.contact_pairs;
    let Some(pair) = pairs.iter().position(|pair| pair.name == name) else {
        let message = format!("there is no contact pair {name}");
        refuse(card, &message, draft);
        return None;
    };
    if card.value.is_none() && !draft.model.steps.is_empty() {
        refuse(card, "SHRINK takes away what overlaps in the undeformed model", draft);
        return None;
    }
    let amplitude = card.amplitude.as_ref().and_then(|named| amplitude(named, draft));
    let allowed = card.value.map_or(Allowed::Initial, Allowed::Value);
    Some(Interference { pair, allowed, amplitude, origin: card.origin })
}

fn refuse(card: &InterferenceCard, message: &str, draft: &mut Draft) {
    let error = Diagnostic::error(Code("SL0397"), message).at(card.origin);
    let help = "name slave and master of a line of *CONTACT PAIR, each once in a step; SHRINK belongs \
                to the first step";
    draft.consequence(Subject::Contact, error.help(help));
}
