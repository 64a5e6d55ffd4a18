//! Weights of the masses of points.
//!
//! ```text
//!     o m      GRAV: m g d          CENTRIF: m omega^2 times the way from the axis
//! ```

use slideline_diag::{Code, Diagnostic};

use super::load_forces::{
    Resolved, What, per_volume, places, refuse, shares, turned, weight_leaves,
};
use crate::distributed::Distributed;
use crate::draft::{Draft, Element};
use crate::rule::Subject;

/// `*MASS` with its elements.
pub(super) fn masses(draft: &mut Draft) {
    for card in draft.masses.clone() {
        for index in draft.elements_of(&card.set, card.set_span).unwrap_or_default() {
            let element = draft.elements[index];
            if element.kind.is_mass() {
                draft.mass_of.entry(element.label).or_insert(card.mass);
                continue;
            }
            let (label, name) = (element.label, element.kind.name());
            let message = format!(
                "element {label} of the set {} is of type {name}, which is not MASS",
                card.set
            );
            let error = Diagnostic::error(Code("SL0325"), message).at(card.set_span);
            let error = error.label(card.origin, "here it is given a mass");
            draft.consequence(Subject::Elements, error.help("solids have a *DENSITY"));
            break;
        }
    }
}

/// The weight of a MASS element, on its node.
pub(super) fn on_mass(
    element: Element,
    line: &Distributed,
    draft: &mut Draft,
) -> Option<<Resolved as IntoIterator>::Item> {
    let Some(&mass) = draft.mass_of.get(&element.label) else {
        without_mass(element, line, draft);
        return None;
    };
    let index = *draft.element_by_label.get(&element.label)?;
    let node = draft.model.nodes.find(*element.nodes().first()?)?;
    let ring = draft.model.is_of_rings();
    if !draft.model.is_in_space()
        && let Some(why) = weight_leaves(line.kind, ring)
    {
        refuse(why, element.kind.name(), ring, line, draft);
        return None;
    }
    let at = places(&[node], draft);
    let forces: Vec<_> = at.into_iter().map(|at| per_volume((line.kind, None), mass, at)).collect();
    let what = turned(line.kind, &[node], draft, || Some(vec![mass]));
    let what = what.unwrap_or_else(|| What::Forces(shares(&[node], &forces, draft)));
    Some(((index, line.key(0, draft.dialect)), what))
}

fn without_mass(element: Element, line: &Distributed, draft: &mut Draft) {
    let message = format!("the MASS element {} has no *MASS and weighs nothing", element.label);
    let error = Diagnostic::error(Code("SL0309"), message).at(line.origin);
    let help = "give its set a *MASS, or leave it out of the load";
    draft.consequence(Subject::Sections, error.help(help));
}
