//! What is worth knowing about a contact pair that can be solved.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dialect, Formulation, Interaction, Master, NormalLaw, Offset};

use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::Pairing;

/// What is worth knowing about a pair that can be solved.
pub(super) fn remarks(
    (pairing, formulation): (&Pairing, Formulation),
    (master, offset, is_profile): (&Master, Offset, bool),
    interaction: &Interaction,
    draft: &mut Draft,
) {
    let why = match (master, formulation) {
        (_, Formulation::Mortar) => Some("contact is integrated over the faces as they are"),
        (Master::RigidSurface(_), _) => Some("the master is analytical"),
        _ => None,
    };
    if let (Some((name, span)), Some(why)) = (pairing.chain_parameter, why) {
        let message = format!("{name} changes nothing here: {why}");
        let note = Diagnostic::note(Code("SL0253"), message).at(span);
        draft.consequence(Subject::Contact, note);
    }
    if draft.dialect == Dialect::Calculix && interaction.normal_origin.is_none() {
        let message = format!(
            "the surface interaction {} has no *SURFACE BEHAVIOR: contact is hard",
            pairing.interaction.name
        );
        let warning = Diagnostic::warning(Code("SL0399"), message).at(interaction.origin);
        let help = "CalculiX itself refuses such an interaction: give its law behind it";
        draft.consequence(Subject::Contact, warning.help(help));
    }
    if formulation != Formulation::SurfaceToSurface {
        return;
    }
    if !pairing.no_thickness && offset.is_none() && !is_profile {
        let message = "contact acts on the centre line of the beams: their thickness is not \
                       counted";
        let note = Diagnostic::note(Code("SL0336"), message).at(pairing.origin);
        let help = "NO THICKNESS on *CONTACT PAIR says the same; to count it, name the surface of the \
                    beams under *SURFACE PROPERTY ASSIGNMENT, PROPERTY=THICKNESS";
        draft.log.push(note.help(help));
    }
    if interaction.normal == NormalLaw::Hard {
        let message = "integrated hard contact is imposed by a penalty";
        let advice = Diagnostic::advice(Code("SL0401"), message).at(pairing.origin);
        let advice = match interaction.normal_origin {
            Some(span) => advice.label(span, "hard contact is requested here"),
            None => advice.label(interaction.origin, "no law is given here: contact is hard"),
        };
        let of_beam = "give the stiffness of the contact: *SURFACE BEHAVIOR, \
                       PRESSURE-OVERCLOSURE=EXPONENTIAL with c0 a small fraction of the thickness of \
                       the beam";
        let of_profile = "give the stiffness of the contact: *SURFACE BEHAVIOR, \
                          PRESSURE-OVERCLOSURE=LINEAR with the modulus of the softer part over the \
                          size of the zone of contact";
        draft.log.push(advice.help(if is_profile { of_profile } else { of_beam }));
    }
}
