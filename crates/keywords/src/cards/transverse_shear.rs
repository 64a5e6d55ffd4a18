//! `*TRANSVERSE SHEAR STIFFNESS`: shear stiffness of a section.

use slideline_model::ShearRule;

use crate::draft::{Body, Draft};
use crate::keyword::{Keyword, Level, Subject};
use crate::reading::Reading;

/// `*TRANSVERSE SHEAR STIFFNESS`.
pub(crate) struct TransverseShearStiffness;

impl Keyword for TransverseShearStiffness {
    fn name(&self) -> &'static str {
        "TRANSVERSE SHEAR STIFFNESS"
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn is_suboption(&self) -> bool {
        true
    }
    fn page(&self) -> &'static str {
        page!("TRANSVERSE-SHEAR-STIFFNESS")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let beams = |index: &usize| matches!(draft.sections[*index].body, Body::Beam { .. });
        let Some(index) = draft.owner.section().filter(beams) else {
            draft.orphan(self.name(), "BEAM SECTION", card.span());
            return;
        };
        let Some(line) = card.only_line("K23, K13, SCF", &mut draft.log) else { return };
        draft.log.at_most(line, 3);
        let Some(stiffness) = draft.log.maybe_number(line, 0) else { return };
        let Some(across) = draft.log.maybe_number(line, 1) else { return };
        let Some(compensation) = draft.log.number_or(line, 2, 0.25) else { return };
        if stiffness.is_some_and(|value| value <= 0.0) {
            draft.log.error("SL0210", "the shear stiffness must be positive", line.fields[0].span);
        }
        if across.is_some_and(|value| value < 0.0) {
            let message = "the shear stiffness K13 must not be negative";
            draft.log.error("SL0210", message, line.fields[1].span);
        }
        // one of the two counts for both
        let across = across.filter(|value| *value > 0.0).or(stiffness);
        if compensation < 0.0 {
            let message = "the slenderness compensation factor must not be negative";
            draft.log.error("SL0210", message, line.fields[2].span);
        }
        if let Body::Beam { shear, .. } = &mut draft.sections[index].body {
            let slenderness_compensation = compensation;
            *shear = ShearRule { stiffness, across, slenderness_compensation };
        }
    }
}
