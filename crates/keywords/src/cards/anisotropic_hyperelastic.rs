//! `*ANISOTROPIC HYPERELASTIC`: soft tissue with families of fibres.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::material::Fibrous;

use crate::draft::{Draft, Elasticity};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*ANISOTROPIC HYPERELASTIC`.
pub(crate) struct AnisotropicHyperelastic;

/// Most families of fibres.
const MOST_FAMILIES: usize = 3;

impl Keyword for AnisotropicHyperelastic {
    fn name(&self) -> &'static str {
        "ANISOTROPIC HYPERELASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::flag("HOLZAPFEL"), Rule::value("LOCAL DIRECTIONS")];
        RULES
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
        page!("ANISOTROPIC-HYPERELASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let law = read(card, draft).map_or(Elasticity::Unread, Elasticity::Fibrous);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.elasticity, law);
    }
}

/// `C10, D, k1, k2, kappa, temperature`. The directions are those of the section, as many as the card says:
/// until then they are not set.
fn read(card: &Reading<'_>, draft: &mut Draft) -> Option<Fibrous> {
    if !card.has("HOLZAPFEL") {
        let message = "*ANISOTROPIC HYPERELASTIC without HOLZAPFEL is Fung's: not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(card.span());
        draft.log.push(error.help("give the law of Holzapfel, Gasser and Ogden: HOLZAPFEL"));
        return None;
    }
    let families = card.at_least(1, "LOCAL DIRECTIONS", 1, &mut draft.log);
    if families > MOST_FAMILIES {
        let message = format!("at most {MOST_FAMILIES} families of fibres are read");
        draft.log.error("SL0234", message, card.span_of("LOCAL DIRECTIONS"));
        return None;
    }
    let line = card.first_line("C10, D, k1, k2, kappa", &mut draft.log)?;
    draft.log.at_most(line, 6);
    if let Some(second) = card.data().get(1) {
        let message = "*ANISOTROPIC HYPERELASTIC over temperature is not supported";
        let error = Diagnostic::error(Code("SL0221"), message).at(second.span);
        draft.log.push(error.help("give one line, for the temperature of the run"));
        return None;
    }
    let matrix = draft.log.number(line, 0, "C10")?;
    let softness = draft.log.number(line, 1, "D")?;
    let stiffness = draft.log.number(line, 2, "k1")?;
    let exponent = draft.log.number(line, 3, "k2")?;
    let dispersion = draft.log.number_or(line, 4, 0.0)?;
    let message = if matrix <= 0.0 || softness <= 0.0 {
        "C10 and D must be positive: D is two over the bulk modulus"
    } else if stiffness < 0.0 || exponent <= 0.0 {
        "k1 must not be negative, and k2 must be positive"
    } else if !(0.0..=1.0 / 3.0 + 1e-6).contains(&dispersion) {
        "kappa is from 0, all fibres along one direction, to 1/3, all ways"
    } else {
        let directions = vec![[0.0; 3]; families];
        let dispersion = dispersion.min(1.0 / 3.0);
        return Some(Fibrous { matrix, softness, stiffness, exponent, dispersion, directions });
    };
    draft.log.error("SL0234", message, line.span);
    None
}
