//! Contact pairs whose surfaces stick together from the start: they are ties.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Formulation, Friction, Interaction, NormalLaw};

use crate::constraints::Tie;
use crate::draft::Draft;
use crate::surfaces::{Adjusted, NamedInteraction, Pairing};

/// Whether the surfaces of a pair are tied, by the pair or by its interaction, and stay so.
pub(super) fn is_tied(pairing: &Pairing, draft: &Draft) -> bool {
    let name = &pairing.interaction.name;
    let named = |entry: &&NamedInteraction| entry.named.name == *name;
    let stays = || !changes(name, draft);
    let entry = draft.interactions.iter().find(named);
    pairing.is_tied || entry.is_some_and(|entry| entry.is_tied && stays())
}

/// Whether a step changes the pressure law of an interaction.
fn changes(name: &str, draft: &Draft) -> bool {
    let cards = draft.steps.iter().flat_map(|step| &step.pressures);
    cards.into_iter().any(|card| card.of.name == name)
}

/// The laws of contact that is tied until a step says otherwise: it sticks, and does not separate.
pub(super) fn until_it_changes(entry: &NamedInteraction) -> Interaction {
    let own = entry.interaction.clone();
    match entry.is_tied {
        true => Interaction { friction: Friction::Rough, no_separation: true, ..own },
        false => own,
    }
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
        Some((Adjusted::Clearance(_), _)) | None => (None, false),
    };
    let named = |entry: &&NamedInteraction| entry.named.name == pairing.interaction.name;
    let law = draft.interactions.iter().find(named).filter(|entry| entry.is_tied);
    if let Some(card) = law.and_then(|entry| {
        let own = &entry.interaction;
        own.normal_origin.filter(|_| own.normal != NormalLaw::Hard)
    }) {
        let message = "the stiffness of tied contact has no effect: surfaces are tied exactly";
        draft.log.note("SL0257", message, card);
    }
    let message = format!("{} is tied to {}, as by *TIE", slave.name, master.name);
    draft.log.push(Diagnostic::note(Code("SL0391"), message).at(origin));
    let by_faces = pairing.formulation != Formulation::NodeToSurface;
    draft.ties.push(Tie { slave, master, tolerance, adjust, by_faces, origin });
}
