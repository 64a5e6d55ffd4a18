//! `*DEFORMATION PLASTICITY`: a metal under growing loads.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::material::RambergOsgood;

use crate::draft::{Draft, Elasticity};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*DEFORMATION PLASTICITY`.
pub(crate) struct DeformationPlasticity;

impl Keyword for DeformationPlasticity {
    fn name(&self) -> &'static str {
        "DEFORMATION PLASTICITY"
    }

    fn parameters(&self) -> &'static [Rule] {
        &[]
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Properties
    }

    fn is_suboption(&self) -> bool {
        true
    }

    fn page(&self) -> &'static str {
        page!("DEFORMATION-PLASTICITY")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let law = read(card, draft).map_or(Elasticity::Unread, Elasticity::Deformation);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.elasticity, law);
    }
}

/// `E, nu, yield stress, exponent, yield offset, temperature`.
fn read(card: &Reading<'_>, draft: &mut Draft) -> Option<RambergOsgood> {
    let line = card.first_line("E, nu, yield stress, exponent, yield offset", &mut draft.log)?;
    draft.log.at_most(line, 6);
    if let Some(second) = card.data().get(1) {
        let message = "*DEFORMATION PLASTICITY over temperature is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(second.span);
        draft.log.push(error.help("give one line, for the temperature of the run"));
        return None;
    }
    let elastic = super::elastic::constants(line, draft);
    let stress = draft.log.number(line, 2, "the yield stress");
    let exponent = draft.log.number(line, 3, "the exponent");
    let offset = draft.log.number(line, 4, "the yield offset");
    let (elastic, stress, exponent, offset) = (elastic?, stress?, exponent?, offset?);
    let message = if stress <= 0.0 || offset <= 0.0 {
        "the yield stress and the yield offset must be positive"
    } else if exponent < 1.0 {
        "the exponent must be at least 1"
    } else {
        return Some(RambergOsgood { elastic, stress, exponent, offset });
    };
    draft.log.error("SL0234", message, line.span);
    None
}
