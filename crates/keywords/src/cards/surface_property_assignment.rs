//! `*SURFACE PROPERTY ASSIGNMENT`: the thickness with which surfaces of beams touch.

use slideline_deck::normalise;

use super::contact_pair::surface;
use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use crate::surfaces::SurfaceThickness;

/// `*SURFACE PROPERTY ASSIGNMENT`.
pub(crate) struct SurfacePropertyAssignment;

impl Keyword for SurfacePropertyAssignment {
    fn name(&self) -> &'static str {
        "SURFACE PROPERTY ASSIGNMENT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::required("PROPERTY")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn page(&self) -> &'static str {
        page!("SURFACE-PROPERTY-ASSIGNMENT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let property = card.word("PROPERTY").map(|word| normalise(&word.raw));
        if property.as_deref() != Some("THICKNESS") {
            let message =
                "*SURFACE PROPERTY ASSIGNMENT of another property than THICKNESS is ignored";
            draft.log.note("SL0257", message, card.span());
            return;
        }
        card.first_line("a surface, its thickness", &mut draft.log);
        for line in card.data() {
            draft.log.at_most(line, 3);
            let said = line.field(1).map(|field| normalise(&field.text));
            let is_original = matches!(said.as_deref(), None | Some("ORIGINAL"));
            if line.field(0).is_none() && is_original {
                let message = "the thickness of all surfaces is ignored: name surfaces of beams";
                draft.log.note("SL0257", message, line.span);
                continue;
            }
            let Some(named) = surface(line, 0, "the surface", &mut draft.log) else { continue };
            let value = match is_original {
                true => Some(None),
                false => draft.log.number(line, 1, "the thickness").map(Some),
            };
            let factor = draft.log.number_or(line, 2, 1.0);
            let (Some(value), Some(factor)) = (value, factor) else { continue };
            if value.is_some_and(|value| value < 0.0) || factor < 0.0 {
                let message = "a thickness, and its factor, must not be negative";
                draft.log.error("SL0210", message, line.span);
                continue;
            }
            draft.surface_thicknesses.push(SurfaceThickness { named, value, factor });
        }
    }
}
