//! Contact pairs whose surfaces stick together from the start: they are ties.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{
    ContactPrint, ContactVariable, Formulation, Friction, Interaction, NormalLaw, Request,
    SectionPrint, SectionVariable,
};

use super::bodies::Bodies;
use super::faces::faces;
use super::section_prints::with_faces;
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

/// What requests for contact ask of tied pairs: force, moment and area of the slave, as of a section; once for
/// each slave, through which all passes that it is tied to.
pub(super) fn across_ties(asked: &[ContactPrint], draft: &mut Draft) -> Vec<SectionPrint> {
    let mut found = Vec::new();
    let ties: Vec<Tie> = draft.ties.clone();
    for print in asked.iter().filter(|print| print.request.target.is_table()) {
        let mut slaves: Vec<&str> = Vec::new();
        for tie in ties.iter().filter(|tie| tie.is_pair && names(print, tie)) {
            if slaves.contains(&tie.slave.name.as_str()) {
                continue;
            }
            slaves.push(&tie.slave.name);
            let of_slave = ties.iter().filter(|own| own.slave.name == tie.slave.name);
            found.extend(across(print, &of_slave.collect::<Vec<_>>(), draft));
        }
    }
    found
}

/// What passes through the slave of some ties.
fn across(print: &ContactPrint, ties: &[&Tie], draft: &mut Draft) -> Option<SectionPrint> {
    let slave = &ties.first()?.slave;
    let masters: Vec<&str> = ties.iter().map(|tie| tie.master.name.as_str()).collect();
    let (name, tied) = match masters[..] {
        [master] => {
            let name = format!("{}/{master}", slave.name);
            (name.clone(), format!("{name} is tied"))
        }
        _ => (slave.name.clone(), format!("{} is tied to {}", slave.name, masters.join(" and "))),
    };
    let variables = of_sections(&print.variables);
    let section = match is_of_faces(slave, draft) && !variables.is_empty() {
        true => {
            let request = Request { set: slave.name.clone(), ..print.request.clone() };
            let (faces, shares) = (Vec::new(), Vec::new());
            let asked = SectionPrint {
                request,
                name,
                is_tied: true,
                faces,
                shares,
                variables: variables.clone(),
            };
            with_faces(&[(asked, slave.clone())], draft).pop()
        }
        false => None,
    };
    let section = section.filter(|section| !is_rigid(section, draft));
    let what = match (&section, variables.is_empty()) {
        (_, true) => "it has no pressures and gaps to print, but CFT".to_owned(),
        (None, false) => {
            "its slave is not of faces of deforming elements alone, so that nothing is printed of it"
                .to_owned()
        }
        (Some(_), false) if masters.len() > 1 => format!(
            "the force that passes to all of them together is printed once, under the name {}, as *SECTION \
             PRINT prints it",
            slave.name
        ),
        (Some(_), false) => {
            format!(
                "the force that passes is printed as *SECTION PRINT prints that of {}",
                slave.name
            )
        }
    };
    draft.log.note("SL0253", format!("{tied}: {what}"), print.request.origin);
    section
}

/// Whether an element behind a surface does not deform: what passes through rigid bodies no element knows.
fn is_rigid(section: &SectionPrint, draft: &Draft) -> bool {
    let bodies = Bodies::of(draft);
    section.shares.is_empty()
        || section.shares.iter().any(|share| {
            let (block, member) = share.element;
            let element = draft.model.blocks[block].elements.get(member);
            bodies.hold_all(element.nodes.iter().copied())
        })
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
