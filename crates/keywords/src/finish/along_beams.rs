//! Contact that is integrated along beams, or along the profile of a rigid body.
//!
//! ```text
//!     o====o====o====o    beams, in the order in which they stand
//!        .-----.          an analytical surface, named first or second
//!
//!        \     /
//!         '---'           a profile, named first
//!      .--------.         another one, the master
//! ```

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ContactElement, Master, RigidSurface};

use super::chain::{Chain, Facet};
use super::sides::{Parts, Sides, Slaves, refuse};
use super::surfaces::{Found, contact_elements};
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::Pairing;

/// Contact integrated along beams that meet an analytical surface.
pub(super) fn along(
    pairing: &Pairing,
    sides: &Sides,
    (slave, master): (Found, Found),
    draft: &mut Draft,
) -> Parts {
    let (beams, surface) = match (slave, master) {
        (Found::Facets(beams), Found::Rigid(surface)) => (beams, surface),
        (Found::Rigid(surface), Found::Facets(beams)) => {
            let name = &pairing.master.name;
            let message = format!("contact is integrated along {name}, named slave or master");
            let note = Diagnostic::note(Code("SL0335"), message).at(pairing.origin);
            draft.log.push(note.help("the order of the two surfaces does not change the result"));
            (beams, surface)
        }
        (Found::Rigid(slave), Found::Rigid(master)) => {
            return along_profile(pairing, (slave, master), draft);
        }
        (Found::Facets(_), Found::Facets(_)) => {
            let message = "SURFACE TO SURFACE between two surfaces of beams is not supported";
            let error = Diagnostic::error(Code("SL0221"), message).at(pairing.origin);
            let help = "give TYPE=NODE TO SURFACE; or, if one of them is rigid, give its shape as \
                        *SURFACE, TYPE=SEGMENTS with *RIGID BODY, ANALYTICAL SURFACE=";
            draft.consequence(Subject::Contact, error.help(help));
            return None;
        }
        (slave, _) => {
            let nodes = if matches!(slave, Found::Nodes(_)) { &sides.slave } else { &sides.master };
            let named =
                if matches!(slave, Found::Nodes(_)) { &pairing.slave } else { &pairing.master };
            let message =
                format!("contact cannot be integrated along the node surface {}", named.name);
            let error = Diagnostic::error(Code("SL0332"), message).at(named.span);
            let help = "define it by elements, or give TYPE=NODE TO SURFACE";
            draft.consequence(Subject::Contact, error.label(nodes.origin, "here").help(help));
            return None;
        }
    };
    if let Some(label) = truss_of(&beams, draft) {
        let message =
            format!("contact cannot be integrated along the truss {label}, which has no rotations");
        let help = "give TYPE=NODE TO SURFACE";
        return refuse(pairing.origin, message, help, draft);
    }
    let elements = in_order(contact_elements(&beams));
    Some((Slaves { elements, ..Slaves::default() }, Master::RigidSurface(surface)))
}

/// Contact integrated along the profile of a rigid body that meets another one.
fn along_profile(
    pairing: &Pairing,
    (slave, master): (RigidSurface, RigidSurface),
    draft: &mut Draft,
) -> Parts {
    if draft.model.is_of_rings() {
        let message = "contact of two analytical surfaces is that of the plane, not of rings";
        let help = "give one of them as the faces of elements: CAX4 with *RIGID BODY, ELSET=";
        return refuse(pairing.origin, message, help, draft);
    }
    if let Some((_, span)) = &pairing.adjust {
        let message = format!(
            "ADJUST moves slave nodes, and {} has none: it is the profile of a rigid body",
            pairing.slave.name
        );
        let help = "move its points and its reference node in the deck";
        return refuse(*span, message, help, draft);
    }
    let nodes = vec![slave.reference];
    let slaves = Slaves { nodes, profile: Some(slave), ..Slaves::default() };
    Some((slaves, Master::RigidSurface(master)))
}

/// The first truss among the elements of a surface.
fn truss_of(facets: &[Facet], draft: &Draft) -> Option<u64> {
    let is_truss = |label: u64| {
        let element = draft.element_by_label.get(&label).map(|&at| draft.elements[at]);
        element.is_some_and(|own| own.kind.is_line() && !own.kind.is_beam())
    };
    facets.iter().map(|facet| facet.label).find(|&label| is_truss(label))
}

/// Along the chain where the beams are one, else as they were named. Each
/// element keeps its own direction.
fn in_order(elements: Vec<ContactElement>) -> Vec<ContactElement> {
    let facet = |&ContactElement { label, nodes, origin, .. }| Facet {
        label,
        nodes,
        middle: None,
        origin,
        side: None,
        face: None,
    };
    let facets: Vec<Facet> = elements.iter().map(facet).collect();
    match Chain::find(&facets) {
        Ok(chain) => chain.steps.iter().map(|&(place, _)| elements[place]).collect(),
        Err(_) => elements,
    }
}
