//! `*CONTACT PAIR`: which surface carries the points, which is slid upon.
//!
//! ```text
//!                    master: rigid surface    master: beams
//!   NODE TO SURFACE
//!     slave: beams    points at its nodes      points at its nodes, slide line
//!     or faces of plane solids, on either side
//!     slave: nodes    the same                 the same
//!     slave: rigid    -                        -
//!   SURFACE TO SURFACE
//!     slave: beams    along the beams          -
//!     slave: faces    over the faces           over the faces, of beams and of solids
//!     slave: nodes    -                        -
//!     slave: rigid    -                        along the beams, over the faces
//! ```

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{
    Adjust, ContactPair, Formulation, Interaction, Master, Offset, Section, Vocabulary,
    corners_of_line, nodes_at_creases,
};

use super::along_beams::along;
use super::clearances::clearances;
use super::contact::both_sides;
use super::facing;
use super::general_contact;
use super::half_thickness;
use super::in_space::{self, at_nodes_in_space};
use super::inner_faces::warn_of_inner_faces;
use super::laws_of_pairs::as_read;
use super::master_chain::slide_line;
use super::orientations::of_pair;
use super::own_surface::own_surface;
use super::owners::bodies;
use super::pieces::{numbered, pieces};
use super::remarks::remarks;
use super::sides::{Parts, Sides, Slaves, areas_of_nodes, is_of_solids, refuse};
use super::spread::spread;
use super::surfaces::{Found, between_nodes, found, stretches};
use super::tied_pairs::{is_tied, tie, until_it_changes};
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::{Adjusted, NamedSurface, Pairing};

pub(super) fn pairs(draft: &mut Draft) {
    bodies(draft);
    general_contact::pairings(draft);
    let pairings = std::mem::take(&mut draft.pairings);
    for (place, pairing) in pairings.iter().enumerate() {
        let same = |other: &&Pairing| {
            let names =
                |pairing: &Pairing| [pairing.slave.name.clone(), pairing.master.name.clone()];
            names(other) == names(pairing)
        };
        if let Some(first) = pairings[..place].iter().find(same) {
            let message = "this pair of surfaces is given twice";
            let error = Diagnostic::error(Code("SL0242"), message).at(pairing.origin);
            draft.consequence(Subject::Contact, error.label(first.origin, "the first one"));
            continue;
        }
        match is_tied(pairing, draft) && interaction(pairing, draft).is_some() {
            true => tie(pairing, draft),
            false => pair(pairing, draft),
        }
    }
    clearances(draft);
    if draft.log.errors() == 0 {
        warn_of_inner_faces(&pairings, draft);
    }
    unused(&pairings, draft);
    half_thickness::unused(&pairings, draft);
}

/// Laws that no pair refers to: most likely a pair runs under another one.
/// Where a pair refers to none, that has been said.
fn unused(pairings: &[Pairing], draft: &mut Draft) {
    let entries = draft.interactions.clone();
    let known = |pairing: &Pairing| {
        entries.iter().any(|entry| entry.named.name == pairing.interaction.name)
    };
    if !pairings.iter().all(known) {
        return;
    }
    for entry in &entries {
        let name = &entry.named.name;
        if !pairings.iter().any(|pairing| pairing.interaction.name == *name) {
            let message = format!("no *CONTACT PAIR refers to the surface interaction {name}");
            let warning = Diagnostic::warning(Code("SL0338"), message).at(entry.named.span);
            draft.consequence(Subject::Contact, warning);
        }
    }
}

pub(super) fn interaction(pairing: &Pairing, draft: &mut Draft) -> Option<Interaction> {
    let named = &pairing.interaction;
    let list = &draft.interactions;
    let found = list.iter().find(|entry| entry.named.name == named.name);
    if let Some(entry) = found {
        return Some(until_it_changes(entry));
    }
    let message = format!("there is no surface interaction {}", named.name);
    let error = Diagnostic::error(Code("SL0328"), message).at(named.span);
    let names = list.iter().map(|entry| entry.named.name.as_str());
    let help = match slideline_deck::nearest(&named.name, names) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("add *SURFACE INTERACTION, NAME={} with the thickness", named.name),
    };
    draft.consequence(Subject::Contact, error.help(help));
    None
}

fn pair(pairing: &Pairing, draft: &mut Draft) {
    let interaction = interaction(pairing, draft);
    let slave = draft.surface(&pairing.slave);
    let master = draft.surface(&pairing.master);
    let (Some(interaction), Some(slave), Some(master)) = (interaction, slave, master) else {
        return;
    };
    if pairing.slave.name == pairing.master.name {
        itself(pairing, &slave, interaction, draft);
        return;
    }
    let first = found(&slave, pairing.slave.span, draft);
    let second = found(&master, pairing.master.span, draft);
    let (Some(first), Some(mut second)) = (first, second) else { return };
    let turned = facing::turned(pairing, &master, (&first, &mut second), draft);
    if facing::cannot_be_slave(pairing, &first, draft) || turned.is_none() {
        return;
    }
    if !in_space::lines_fit(pairing, (&first, &second), draft) {
        return;
    }
    areas_of_nodes(&slave, &interaction, draft);
    let sides = Sides { slave, master };
    let thickness = thickness_of(pairing, &first, draft);
    let of_solids = [&first, &second].into_iter().any(is_of_solids);
    let vocabulary = if of_solids { Vocabulary::Faces } else { Vocabulary::Surfaces };
    let ((first, second), sides) = analytical_second(pairing, (first, second), sides);
    let offset = match pairing.no_thickness {
        true => Some(Offset::NONE),
        false => half_thickness::offset((&first, &second), &sides, draft),
    };
    let formulation = match pairing.formulation {
        Formulation::SurfaceToSurface if matches!(second, Found::Swept(_)) => {
            let message = "contact with an analytical surface in space is sampled at the nodes";
            draft.log.push(Diagnostic::note(Code("SL0396"), message).at(pairing.origin));
            Formulation::NodeToSurface
        }
        Formulation::SurfaceToSurface if of_solids => Formulation::Mortar,
        Formulation::NodeToSurface if both_analytical(&first, &second) => {
            let message = format!(
                "{} has no nodes: contact is integrated along its profile",
                pairing.slave.name
            );
            draft.log.push(Diagnostic::note(Code("SL0396"), message).at(pairing.origin));
            Formulation::SurfaceToSurface
        }
        given => given,
    };
    let law = (interaction, thickness, vocabulary);
    let masters = pieces(pairing, &sides.master, (&first, second), draft);
    let count = masters.len();
    for (piece, second) in masters.into_iter().enumerate() {
        let piece = (count > 1).then_some(piece);
        let given = (pairing, formulation, piece);
        of_piece(given, (&sides, first.clone(), second), (law.clone(), offset), draft);
    }
}

/// The pair of a master, or of this piece of it.
fn of_piece(
    (pairing, formulation, piece): (&Pairing, Formulation, Option<usize>),
    (sides, first, second): (&Sides, Found, Found),
    (law, offset): (Law, Option<Offset>),
    draft: &mut Draft,
) {
    let parts = match formulation {
        Formulation::NodeToSurface => at_nodes(pairing, sides, (first, second), draft),
        Formulation::Mortar => spread(pairing, sides, (first, second), draft),
        Formulation::SurfaceToSurface => along(pairing, sides, (first, second), draft),
    };
    let (Some(parts), Some(offset)) = (parts, offset) else { return };
    if half_thickness::fits((pairing, formulation), offset, &parts.1, draft) {
        put_together((pairing, formulation, piece), parts, (law, offset), draft);
    }
}

/// A surface that meets itself, at its nodes.
fn itself(pairing: &Pairing, surface: &NamedSurface, interaction: Interaction, draft: &mut Draft) {
    let Some(found) = found(surface, pairing.slave.span, draft) else { return };
    let thickness = thickness_of(pairing, &found, draft);
    if half_thickness::half(&surface.named, &found, draft).is_none() {
        return;
    }
    let Some(parts) = own_surface(pairing, surface, found, draft) else { return };
    let formulation = Formulation::NodeToSurface;
    let law = (interaction, thickness, Vocabulary::Faces);
    put_together((pairing, formulation, None), parts, (law, Offset::NONE), draft);
}

/// What happens between the sides of a pair: its interaction, its thickness out of the plane where the
/// slaves give one, the words for it.
type Law = (Interaction, Option<f64>, Vocabulary);

/// The pair of these slaves and this master, or this piece of it.
fn put_together(
    (pairing, formulation, piece): (&Pairing, Formulation, Option<usize>),
    (slaves, master): (Slaves, Master),
    ((interaction, thickness, vocabulary), offset): (Law, Offset),
    draft: &mut Draft,
) {
    let width = match slaves.faces.is_empty() {
        true => width(pairing, thickness, draft),
        false => 1.0,
    };
    let interaction = Interaction { width, ..interaction };
    let adjust = match &pairing.adjust {
        None => Adjust::Nothing,
        Some((Adjusted::Within(distance), _)) => Adjust::Within(*distance),
        Some((Adjusted::Clearance(value), _)) => Adjust::Clearance(*value),
        Some((Adjusted::Set(set), span)) => Adjust::Nodes(draft.nodes_of(set, *span)),
    };
    let normal = as_read(pairing.formulation, &interaction.normal, draft.dialect);
    let interaction = Interaction { normal, ..interaction };
    let is_profile = slaves.profile.is_some();
    remarks((pairing, formulation), (&master, offset, is_profile), &interaction, draft);
    let corners = match formulation {
        Formulation::Mortar if slaves.faces.is_empty() => {
            corners_of_line(&slaves.elements, |node| draft.model.nodes.position(node))
        }
        Formulation::Mortar => {
            nodes_at_creases(&slaves.faces, |node| draft.model.nodes.position(node))
        }
        _ => Vec::new(),
    };
    let of_master = piece.map(|piece| numbered(&pairing.master.name, piece));
    let of_master = of_master.as_ref().unwrap_or(&pairing.master.name);
    let name = match pairing.slave.name == pairing.master.name {
        true => pairing.slave.name.clone(),
        false => format!("{}/{of_master}", pairing.slave.name),
    };
    let Some(axes) = of_pair(pairing, &master, draft) else { return };
    let pair = ContactPair {
        name,
        is_piece: piece.is_some(),
        formulation,
        vocabulary,
        elements: slaves.elements,
        of_solids: slaves.of_solids,
        faces: slaves.faces,
        slaves: slaves.nodes,
        counts_sides: slaves.counts_sides,
        corners,
        profile: slaves.profile,
        master,
        interaction,
        offset,
        adjust,
        axes,
        left_out: pairing.left_out.clone(),
        origin: pairing.origin,
    };
    both_sides(&pair, pairing.origin, draft);
    let place = draft.model.contact_pairs.len();
    let named = pairing.interaction.name.clone();
    draft.pairs_of_interaction.entry(named).or_default().push(place);
    draft.model.contact_pairs.push(pair);
}

/// Whether both sides are profiles of the plane.
fn both_analytical(first: &Found, second: &Found) -> bool {
    matches!((first, second), (Found::Rigid(_), Found::Rigid(_)))
}

/// Both sides with an analytical surface of space as the master, where the order is left open: it
/// has no nodes to carry points.
fn analytical_second(
    pairing: &Pairing,
    (first, second): (Found, Found),
    sides: Sides,
) -> ((Found, Found), Sides) {
    let turns = matches!(first, Found::Swept(_)) && !matches!(second, Found::Swept(_));
    match turns && pairing.formulation == Formulation::SurfaceToSurface {
        true => ((second, first), Sides { slave: sides.master, master: sides.slave }),
        false => ((first, second), sides),
    }
}

/// Thickness of the solids whose faces are slaves [L]; `None` for others. Complains where they
/// differ: a pair has one.
fn thickness_of(pairing: &Pairing, slave: &Found, draft: &mut Draft) -> Option<f64> {
    let Found::Facets(facets) = slave else { return None };
    let of_solids = facets.iter().filter(|facet| facet.face.is_some());
    let labels: HashSet<u64> = of_solids.map(|facet| facet.label).collect();
    let mut found: Vec<(f64, Span)> = Vec::new();
    for block in &draft.model.blocks {
        let Section::Solid(section) = &block.section else { continue };
        let known = found.iter().any(|(thickness, _)| *thickness == section.thickness);
        if !known && block.elements.iter().any(|element| labels.contains(&element.label)) {
            found.push((section.thickness, block.origin));
        }
    }
    let (&(thickness, at), others) = found.split_first()?;
    let named = &pairing.interaction.name;
    let entry = draft.interactions.iter().find(|entry| entry.named.name == *named);
    if let (Some((other, there)), None) = (others.first(), entry.and_then(|own| own.thickness)) {
        let message = format!(
            "the slave surface {} is {thickness} thick here and {other} there",
            pairing.slave.name
        );
        let error = Diagnostic::error(Code("SL0332"), message).at(pairing.slave.span);
        let error = error.label(at, "one thickness").label(*there, "another one");
        let help = "make a *SURFACE and a *CONTACT PAIR for each thickness, or give the one that \
                    counts behind *SURFACE INTERACTION";
        draft.consequence(Subject::Contact, error.help(help));
    }
    Some(thickness)
}

/// Thickness of a contact out of the plane [L]: that of its interaction, of the solids whose faces
/// are slaves, or 1.0, which is said.
fn width(pairing: &Pairing, of_solids: Option<f64>, draft: &mut Draft) -> f64 {
    let named = &pairing.interaction.name;
    let entry = draft.interactions.iter().find(|entry| entry.named.name == *named);
    let (given, origin) =
        entry.map_or((None, pairing.origin), |own| (own.thickness, own.interaction.origin));
    given.or(of_solids).unwrap_or_else(|| {
        if draft.model.is_of_rings() {
            return 1.0;
        }

        let message = "the contact is 1.0 thick out of the plane: no thickness is given";
        let note = Diagnostic::note(Code("SL0255"), message).at(origin);
        let help = "the data line is the thickness, as the width of *INTERFACE";
        draft.consequence(Subject::Contact, note.help(help));
        1.0
    })
}

/// Contact sampled at the slave's nodes.
fn at_nodes(
    pairing: &Pairing,
    sides: &Sides,
    (slave, master): (Found, Found),
    draft: &mut Draft,
) -> Parts {
    let (slave_name, master_name) = (&pairing.slave.name, &pairing.master.name);
    let master = match master {
        Found::Faces(faces) => {
            let faces = in_space::faces_of(pairing, sides, faces);
            return at_nodes_in_space(pairing, (&sides.slave, slave, faces), draft);
        }
        Found::Swept(surface) => {
            return at_nodes_in_space(pairing, (&sides.slave, slave, surface), draft);
        }
        plane => plane,
    };
    let mut of_solids = false;
    let elements = match slave {
        Found::Faces(_) => {
            let message = format!("{slave_name} is made of faces in space, {master_name} is not");
            let help = "contact in space is between faces of solids: give the master as elements \
                        with their faces";
            return refuse(pairing.master.span, message, help, draft);
        }
        Found::Facets(facets) => {
            of_solids = facets.iter().all(|facet| facet.face.is_some());
            between_nodes(&facets)
        }
        Found::Nodes(nodes) if nodes.len() < 2 => {
            let message = format!("the slave surface {slave_name} has one node, which has no area");
            let help = "name its neighbours too: areas come from the distances between them";
            return refuse(pairing.slave.span, message, help, draft);
        }
        Found::Nodes(nodes) => stretches(&sides.slave, &nodes, draft),
        Found::Rigid(_) | Found::Swept(_) => {
            let message = format!(
                "the analytical surface {slave_name} has no nodes and cannot be the slave of \
                 NODE TO SURFACE"
            );
            let help = "name it second, as the master, or give TYPE=SURFACE TO SURFACE";
            return refuse(pairing.slave.span, message, help, draft);
        }
    };
    let master = match master {
        Found::Rigid(surface) => {
            let extension = if of_solids { pairing.extension } else { 0.0 };
            Master::RigidSurface(slideline_model::RigidSurface { extension, ..surface })
        }
        Found::Facets(facets) => {
            Master::SlideLine(slide_line(pairing, &sides.master, (&facets, &elements), draft)?)
        }
        Found::Faces(_) | Found::Swept(_) | Found::Nodes(_) => {
            let message = format!("the node surface {master_name} has no segments to slide on");
            let help = "name it first, as the slave, or give the master as elements";
            return refuse(pairing.master.span, message, help, draft);
        }
    };
    Some((Slaves { elements, of_solids, ..Slaves::default() }, master))
}
