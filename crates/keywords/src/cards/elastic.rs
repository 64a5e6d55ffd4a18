//! `*ELASTIC`: linear elasticity of a material.

use crate::draft::Draft;
use crate::draft::Owner;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*ELASTIC`.
pub(crate) struct Elastic;

impl Keyword for Elastic {
    fn name(&self) -> &'static str {
        "ELASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("TYPE")];
        RULES
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
        page!("ELASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let Owner::Material(index) = draft.owner else {
            draft.orphan(self.name(), "MATERIAL", card.span());
            return;
        };
        draft.materials[index].has_card = true;
        card.choice("TYPE", &["ISOTROPIC"], &mut draft.log);
        let Some(line) = card.only_line("E, nu", &mut draft.log) else { return };
        draft.log.at_most(line, 2);
        let modulus = draft.log.number(line, 0, "Young's modulus E");
        let poisson = draft.log.number_or(line, 1, 0.0);
        let (Some(modulus), Some(poisson)) = (modulus, poisson) else { return };
        if modulus <= 0.0 {
            draft.log.error("SL0234", "Young's modulus must be positive", line.fields[0].span);
            return;
        }
        if poisson <= -1.0 || poisson >= 0.5 {
            let message = format!("Poisson's ratio {poisson} is not between -1 and 0.5");
            draft.log.error("SL0234", message, line.fields[1].span);
            return;
        }
        draft.materials[index].elastic =
            Some(slideline_mech::material::Elastic { modulus, poisson });
    }
}
