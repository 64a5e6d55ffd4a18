//! Contact pairs whose surfaces stick together from the start: they are ties.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{
    ContactPrint, ContactVariable, Formulation, Friction, Interaction, NormalLaw, Request,
    SectionPrint, SectionVariable,
};

use super::faces::faces;
use crate::constraints::Tie;
use crate::draft::Draft;
use crate::surfaces::{Adjusted, Extent, Named, NamedInteraction, Pairing};

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
    draft.ties.push(Tie { slave, master, tolerance, adjust, by_faces, is_pair: true, origin });
}

/// Whether a request for contact names surfaces that are tied.
pub(super) fn wants_tied(print: &ContactPrint, draft: &Draft) -> bool {
    draft.ties.iter().any(|tie| tie.is_pair && names(print, tie))
}

fn names(print: &ContactPrint, tie: &Tie) -> bool {
    let is = |wanted: &String, own: &str| wanted.is_empty() || wanted == own;
    is(&print.surfaces[0], &tie.slave.name) && is(&print.surfaces[1], &tie.master.name)
}

/// What requests for contact ask of tied pairs: force, moment and area of the slave, as of a section.
pub(super) fn across_ties(asked: &[ContactPrint], draft: &mut Draft) -> Vec<(SectionPrint, Named)> {
    let mut found = Vec::new();
    let ties: Vec<Tie> = draft.ties.iter().filter(|tie| tie.is_pair).cloned().collect();
    for print in asked.iter().filter(|print| print.request.target.is_table()) {
        let variables = of_sections(&print.variables);
        for tie in ties.iter().filter(|tie| names(print, tie)) {
            let of_faces = is_of_faces(&tie.slave, draft);
            let name = format!("{}/{}", tie.slave.name, tie.master.name);
            let message = match (variables.is_empty(), of_faces) {
                (false, true) => format!(
                    "{name} is tied: the force that passes is printed as *SECTION PRINT prints that of {}",
                    tie.slave.name
                ),
                (true, true) => {
                    format!("{name} is tied: it has no pressures and gaps to print, but CFT")
                }
                (_, false) => {
                    format!("{name} is tied and its slave has no faces: nothing is printed of it")
                }
            };
            draft.log.note("SL0253", message, print.request.origin);
            if of_faces && !variables.is_empty() {
                let set = tie.slave.name.clone();
                let request = Request { set, ..print.request.clone() };
                let variables = variables.clone();
                let (faces, shares) = (Vec::new(), Vec::new());
                let section =
                    SectionPrint { request, name, is_tied: true, faces, shares, variables };
                found.push((section, tie.slave.clone()));
            }
        }
    }
    found
}

/// Whether a surface is made of faces of solids.
fn is_of_faces(named: &Named, draft: &mut Draft) -> bool {
    let Some(surface) = draft.surface(named) else { return false };
    let has_elements = matches!(surface.extent, Extent::Elements(_));
    has_elements && faces(&surface, named.span, draft).iter().all(|face| face.face.is_some())
}

/// Forces, moments and areas of pairs as those of sections.
fn of_sections(variables: &[ContactVariable]) -> Vec<SectionVariable> {
    type Contact = ContactVariable;
    let mut found = Vec::new();
    for variable in variables {
        let own = match variable {
            Contact::CFN | Contact::CFS | Contact::CFT => SectionVariable::SOF,
            Contact::CMN | Contact::CMS | Contact::CMT => SectionVariable::SOM,
            Contact::CAREA => SectionVariable::SOAREA,
            _ => continue,
        };
        if !found.contains(&own) {
            found.push(own);
        }
    }
    found
}
