//! Fibres of a material lie along the local directions of its section's orientation.

use slideline_diag::{Code, Diagnostic};
use slideline_model as model;

use super::orientations::of_name;
use crate::draft::{Draft, Section};
use crate::rule::Subject;

/// The section with the directions of its fibres; `None` after an error.
pub(super) fn laid(
    section: &Section,
    mut made: model::Section,
    draft: &mut Draft,
) -> Option<model::Section> {
    let model::Section::Solid(solid) = &mut made else { return Some(made) };
    let families = solid.material.families();
    if families == 0 {
        return Some(made);
    }
    let directions = match &section.orientation {
        Some((name, span)) => of_name((name, *span), draft)?.directions,
        None => Vec::new(),
    };
    let Some(own) = directions.get(..families) else {
        let message = format!(
            "the material {} has {families} families of fibres, its section {} directions of them",
            section.material,
            directions.len()
        );
        let error = Diagnostic::error(Code("SL0309"), message).at(section.material_span);
        let help =
            "name an *ORIENTATION, LOCAL DIRECTIONS=n with a direction a line behind its axes";
        draft.consequence(Subject::Sections, error.help(help));
        return None;
    };
    solid.material.lay(own);
    Some(made)
}
