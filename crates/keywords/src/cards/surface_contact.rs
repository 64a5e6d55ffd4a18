//! `*SURFACE CONTACT`: overclosure to pressure.

use slideline_diag::{Code, Diagnostic};
use slideline_model::{Dialect, NormalLaw};

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*SURFACE CONTACT`.
pub(crate) struct SurfaceContact;

impl Keyword for SurfaceContact {
    fn name(&self) -> &'static str {
        "SURFACE CONTACT"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::flag("SOFTENED")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn is_suboption(&self) -> bool {
        true
    }
    fn page(&self) -> &'static str {
        page!("SURFACE-CONTACT")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        let span = card.span();
        if draft.owning_interaction(self.name(), span).is_none() {
            return;
        }
        let law = if card.has("SOFTENED") {
            exponential(card, draft)
        } else {
            draft.log.at_most_lines(card.data(), 0, "SURFACE CONTACT without SOFTENED");
            Some(NormalLaw::Hard)
        };
        set_law(self.name(), card, law, draft);
    }
}

/// Gives the owning interaction its normal law.
pub(crate) fn set_law(
    keyword: &str,
    card: &Reading<'_>,
    law: Option<NormalLaw>,
    draft: &mut Draft,
) {
    let span = card.span();
    let Some((interaction, owner)) = draft.owning_interaction(keyword, span) else { return };
    let before = interaction.normal_origin.replace(span);
    if let Some(law) = law {
        interaction.normal = law;
    }
    if let Some(before) = before {
        let message = format!("a second normal law (*{keyword}) for one {owner}");
        let error = Diagnostic::error(Code("SL0242"), message).at(span);
        draft.log.push(error.label(before, "the first one"));
    }
}

/// `c0, p0`: the clearance at which the pressure vanishes and the pressure at
/// zero clearance. [semantics: softened contact]
pub(crate) fn exponential(card: &Reading<'_>, draft: &mut Draft) -> Option<NormalLaw> {
    let line = card.only_line("c0, p0", &mut draft.log)?;
    draft.log.at_most(line, 2);
    let clearance = draft.log.number(line, 0, "the clearance c0");
    let pressure = draft.log.number(line, 1, "the pressure p0");
    let (clearance, pressure) = (clearance?, pressure?);
    for (at, (value, name)) in
        [(clearance, "clearance c0"), (pressure, "pressure p0")].into_iter().enumerate()
    {
        if value <= 0.0 {
            let message = format!("the {name} of softened contact must be positive");
            draft.log.error("SL0218", message, line.fields[at].span);
            return None;
        }
    }
    Some(match draft.dialect {
        Dialect::Abaqus => NormalLaw::Exponential { clearance, pressure },
        Dialect::Calculix => NormalLaw::CalculixExponential { clearance, pressure },
    })
}
