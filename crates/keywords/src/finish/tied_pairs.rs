//! Contact pairs whose surfaces stick together from the start: they are ties.

use slideline_diag::{Code, Diagnostic};

use crate::constraints::Tie;
use crate::draft::Draft;
use crate::surfaces::{Adjusted, NamedInteraction, Pairing};

/// Whether the surfaces of a pair are tied, by the pair or by its interaction.
pub(super) fn is_tied(pairing: &Pairing, draft: &Draft) -> bool {
    let named = |entry: &&NamedInteraction| entry.named.name == pairing.interaction.name;
    pairing.is_tied || draft.interactions.iter().find(named).is_some_and(|entry| entry.is_tied)
}

/// Makes a tie of a pair, which a distance of `ADJUST` limits.
pub(super) fn tie(pairing: &Pairing, draft: &mut Draft) {
    let Pairing { slave, master, origin, .. } = pairing.clone();
    let (tolerance, adjust) = match &pairing.adjust {
        Some((Adjusted::Within(distance), _)) => (Some(*distance), true),
        Some((Adjusted::Set(_), span)) => {
            let message = "ADJUST with a set of nodes has no effect on surfaces that are tied";
            draft.log.note("SL0257", message, *span);
            (None, false)
        }
        None => (None, false),
    };
    let message = format!("{} is tied to {}, as by *TIE", slave.name, master.name);
    draft.log.push(Diagnostic::note(Code("SL0391"), message).at(origin));
    draft.ties.push(Tie { slave, master, tolerance, adjust, origin });
}
