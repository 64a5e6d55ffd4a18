//! Half the thickness of the surfaces of a pair: how far they stand off the lines of beams.
//!
//! ```text
//!    SPOS  --------------------   distance of the face from the line of nodes
//!          o--------o--------o
//!    SNEG  --------------------
//! ```

use std::collections::HashSet;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{Formulation, Master, Offset, Section};

use super::chain::Facet;
use super::sides::Sides;
use super::surfaces::Found;
use crate::draft::Draft;
use crate::rule::Subject;
use crate::surfaces::{Named, Pairing, Side, SurfaceThickness};

/// Faces that stand off by lengths within this part of them stand off equally [1].
const SAME: f64 = 1e-9;

/// How far the surfaces of a pair stand off; `None` where that cannot be counted, which is said.
pub(super) fn offset(
    (first, second): (&Found, &Found),
    sides: &Sides,
    draft: &mut Draft,
) -> Option<Offset> {
    let slave = half(&sides.slave.named, first, draft)?;
    let master = half(&sides.master.named, second, draft)?;
    // contact is integrated along the beams, whichever side is named first
    Some(match first {
        Found::Rigid(_) => Offset { slave: master, master: slave },
        _ => Offset { slave, master },
    })
}

/// Whether surfaces that stand off can meet as a pair wants it; complains where they cannot.
pub(super) fn fits(
    (pairing, formulation): (&Pairing, Formulation),
    offset: Offset,
    master: &Master,
    draft: &mut Draft,
) -> bool {
    let why = match (master, formulation) {
        _ if offset.is_none() => return true,
        (_, Formulation::Mortar) => "contact that is spread over faces is of the faces",
        (Master::Faces(_), _) => "in space contact is of the nodes",
        (Master::Itself(_), _) => "a surface that meets itself has none",
        _ => return true,
    };
    let named = if offset.slave > 0.0 { &pairing.slave } else { &pairing.master };
    refuse(named, pairing.origin, why, draft);
    false
}

/// Surfaces with a thickness that no pair names.
pub(super) fn unused(pairings: &[Pairing], draft: &mut Draft) {
    for SurfaceThickness { named, .. } in draft.surface_thicknesses.clone() {
        let is_named =
            |own: &Pairing| [&own.slave, &own.master].iter().any(|s| s.name == named.name);
        if draft.surface(&named).is_some() && !pairings.iter().any(is_named) {
            let message = format!("no *CONTACT PAIR names the surface {}", named.name);
            let warning = Diagnostic::warning(Code("SL0362"), message).at(named.span);
            let help = "its thickness counts in contact alone";
            draft.consequence(Subject::Contact, warning.help(help));
        }
    }
}

/// How far a surface stands off its line: zero where no thickness is said.
pub(super) fn half(named: &Named, found: &Found, draft: &mut Draft) -> Option<f64> {
    let said =
        draft.surface_thicknesses.iter().rev().find(|own| own.named.name == named.name).cloned();
    let Some(said) = said else { return Some(0.0) };
    let why = match (found, said.value) {
        (Found::Facets(facets), None) if facets.iter().all(|facet| facet.face.is_none()) => {
            return of_sections(&said, facets, draft).map(|half| said.factor * half);
        }
        (Found::Facets(facets), Some(value)) if facets.iter().all(|facet| facet.face.is_none()) => {
            return Some(0.5 * said.factor * value);
        }
        (Found::Nodes(_), Some(value)) => return Some(0.5 * said.factor * value),
        (Found::Nodes(_), None) => "nodes have no section: give a number",
        // solids have none beyond their faces
        (Found::Facets(_) | Found::Faces(_), None) => return Some(0.0),
        (Found::Facets(_) | Found::Faces(_), Some(_)) => "faces of solids stand where they are",
        (Found::Rigid(_) | Found::Swept(_), _) => "an analytical surface stands where it is",
    };
    refuse(&said.named, named.span, why, draft);
    None
}

/// The distance of the faces of beams from their nodes, by their sections.
fn of_sections(said: &SurfaceThickness, facets: &[Facet], draft: &mut Draft) -> Option<f64> {
    let labels: HashSet<u64> = facets.iter().map(|facet| facet.label).collect();
    let side = facets.first().and_then(|facet| facet.side);
    let (mut found, mut seen): (Vec<(f64, Span)>, usize) = (Vec::new(), 0);
    for block in &draft.model.blocks {
        let Section::Beam(section) = &block.section else { continue };
        let own = block.elements.iter().filter(|element| labels.contains(&element.label)).count();
        if own == 0 {
            continue;
        }
        seen += own;
        let (below, height) = (-section.shape.bottom(), section.shape.height());
        let above = height - below;
        match side {
            Some(Side::Positive) => found.push((above, block.origin)),
            Some(Side::Negative) => found.push((below, block.origin)),
            None => found.extend([(above, block.origin), (below, block.origin)]),
        }
    }
    let Some(&(half, at)) = found.first().filter(|_| seen >= labels.len()) else {
        let why = "some of its elements have no *BEAM SECTION: give a number";
        refuse(&said.named, said.named.span, why, draft);
        return None;
    };
    if let Some(&(other, there)) = found.iter().find(|own| (own.0 - half).abs() > SAME * half.abs())
    {
        let message = format!(
            "the faces of {} stand off its nodes by {half} here and by {other} there",
            said.named.name
        );
        let error = Diagnostic::error(Code("SL0362"), message).at(said.named.span);
        let error = error.label(at, "one section").label(there, "another one, or its other face");
        let help = "a pair has one thickness: make a *SURFACE and a *CONTACT PAIR for each, name the \
                    faces (SPOS, SNEG), or give a number";
        draft.consequence(Subject::Contact, error.help(help));
        return None;
    }
    Some(half)
}

fn refuse(named: &Named, user: Span, why: &str, draft: &mut Draft) {
    let message = format!("the thickness of {} cannot be counted: {why}", named.name);
    let error = Diagnostic::error(Code("SL0362"), message).at(named.span);
    let error = if user == named.span { error } else { error.label(user, "here") };
    let help = "a thickness is that of beams and trusses in the plane, at nodes (TYPE=NODE TO SURFACE) or \
                along beams against an analytical surface";
    draft.consequence(Subject::Contact, error.help(help));
}
