//! The curves over time that cards of loads and motions name.

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::Amplitude;

use crate::draft::Draft;
use crate::reading::Reading;

/// The curve of a card, `AMPLITUDE=` later by `TIME DELAY=` [T], by its name.
pub(crate) fn of_card(card: &Reading<'_>, draft: &mut Draft) -> Option<(String, Span)> {
    let own = card.name("AMPLITUDE").map(|name| (name, card.span_of("AMPLITUDE")));
    if !card.has("TIME DELAY") {
        return own;
    }
    let delay = card.number("TIME DELAY", &mut draft.log)??;
    let curve = own.as_ref().and_then(|(name, _)| draft.model.amplitude(name)).cloned();
    let Some(curve) = curve else {
        let message = "TIME DELAY shifts a curve, and the card names none that is known here";
        let error = Diagnostic::error(Code("SL0321"), message).at(card.span_of("TIME DELAY"));
        draft.log.push(error.help("name an *AMPLITUDE that stands above: AMPLITUDE=..."));
        return None;
    };
    let name = format!("{} LATER BY {delay:e}", curve.name);
    if draft.model.amplitude(&name).is_none() {
        if draft.absolute_amplitudes.contains(&curve.name) {
            draft.absolute_amplitudes.insert(name.clone());
        }
        let later = curve.curve.delayed(delay);
        draft.model.amplitudes.push(Amplitude { name: name.clone(), curve: later, ..curve });
    }
    Some((name, card.span_of("AMPLITUDE")))
}
