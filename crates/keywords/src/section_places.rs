//! Cards that say where the centroid and the shear centre of a general section are.

use slideline_diag::{Code, Diagnostic};
use slideline_model::Shape;

use crate::draft::{Body, Draft};
use crate::reading::Reading;

/// What is placed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// Where a pull does not bend.
    Centroid,
    /// Where a push across does not twist.
    ShearCenter,
}

/// Reads the coordinates along axes 1 and 2 and places the section before.
pub(crate) fn read((name, card): (&str, &Reading<'_>), place: Place, draft: &mut Draft) {
    let beams = |index: &usize| matches!(draft.sections[*index].body, Body::Beam { .. });
    let Some(index) = draft.owner.section().filter(beams) else {
        draft.orphan(name, "BEAM GENERAL SECTION", card.span());
        return;
    };
    let Some(line) = card.only_line("coordinates along axes 1 and 2", &mut draft.log) else {
        return;
    };
    draft.log.at_most(line, 2);
    let Some(first) = draft.log.number_or(line, 0, 0.0) else { return };
    let Some(second) = draft.log.number_or(line, 1, 0.0) else { return };
    let Body::Beam { shape, .. } = &mut draft.sections[index].body else { return };
    let Shape::General { centroid, shear_center, .. } = shape else {
        let message = format!("*{name} belongs to SECTION=GENERAL; a shape has its own");
        let error = Diagnostic::error(Code("SL0215"), message).at(card.span());
        draft.log.push(error.help("leave the card out"));
        return;
    };
    match place {
        Place::Centroid => *centroid = [first, second],
        Place::ShearCenter => *shear_center = [first, second],
    }
}
