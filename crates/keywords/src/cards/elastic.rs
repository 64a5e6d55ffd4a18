//! `*ELASTIC`: linear elasticity of a material.

use slideline_mech::material;

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
        const TYPES: &[&str] = &["ISOTROPIC", "ENGINEERING CONSTANTS", "ORTHOTROPIC"];
        let given = card.word("TYPE").is_some();
        match card.choice("TYPE", TYPES, &mut draft.log) {
            None if given => {}
            None | Some("ISOTROPIC") => {
                draft.materials[index].elastic = isotropic(card, draft);
            }
            Some(kind) => {
                draft.materials[index].anisotropic =
                    anisotropic(card, kind == "ENGINEERING CONSTANTS", draft);
            }
        }
    }
}

fn isotropic(card: &Reading<'_>, draft: &mut Draft) -> Option<material::Elastic> {
    let line = card.only_line("E, nu", &mut draft.log)?;
    // a temperature may follow; one line holds for all
    draft.log.at_most(line, 3);
    let modulus = draft.log.number(line, 0, "Young's modulus E");
    let poisson = draft.log.number_or(line, 1, 0.0);
    let (modulus, poisson) = (modulus?, poisson?);
    if modulus <= 0.0 {
        draft.log.error("SL0234", "Young's modulus must be positive", line.fields[0].span);
        return None;
    }
    if poisson <= -1.0 || poisson >= 0.5 {
        let message = format!("Poisson's ratio {poisson} is not between -1 and 0.5");
        draft.log.error("SL0234", message, line.fields[1].span);
        return None;
    }
    Some(material::Elastic { modulus, poisson })
}

/// Nine constants: of engineering, or D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323.
fn anisotropic(
    card: &Reading<'_>,
    engineering: bool,
    draft: &mut Draft,
) -> Option<material::Anisotropic> {
    let what =
        if engineering { "E1, E2, E3, nu12, nu13, nu23, G12, G13, G23" } else { "D1111 ..." };
    card.first_line(what, &mut draft.log)?;
    let values = card.numbers(&mut draft.log)?;
    // a temperature may follow; one set holds for all
    let Some(constants) = values.first_chunk::<9>().filter(|_| values.len() <= 10) else {
        let message = format!("nine constants are needed, here are {}", values.len());
        draft.log.error("SL0208", message, card.span());
        return None;
    };
    let made = if engineering {
        material::Anisotropic::engineering(constants)
    } else {
        let [d11, d12, d22, d13, d23, d33, shear @ ..] = *constants;
        let block = [[d11, d12, d13], [d12, d22, d23], [d13, d23, d33]];
        material::Anisotropic::orthotropic(&block, &shear)
    };
    if made.is_none() {
        let message = "these constants let the material release energy under some load";
        draft.log.error("SL0234", message, card.data()[0].span);
    }
    made
}
