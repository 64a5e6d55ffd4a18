//! `*ALLOWABLE`: what a material may be strained to. A card of our own: it
//! changes no result, the verdict is held against it.

use crate::draft::{self, Draft};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;
use slideline_model::Limit;

/// `*ALLOWABLE`.
pub(crate) struct Allowable;

impl Keyword for Allowable {
    fn name(&self) -> &'static str {
        "ALLOWABLE"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] =
            &[Rule::required("MATERIAL"), Rule::value("STRAIN"), Rule::value("STRESS")];
        RULES
    }

    fn level(&self) -> Level {
        Level::Model
    }

    fn subject(&self) -> Subject {
        Subject::Sections
    }

    fn page(&self) -> &'static str {
        page!("ALLOWABLE")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        draft.log.at_most_lines(card.data(), 0, self.name());
        let Some(material) = card.name("MATERIAL") else { return };
        let strain = card.number("STRAIN", &mut draft.log);
        let stress = card.number("STRESS", &mut draft.log);
        let (Some(strain), Some(stress)) = (strain, stress) else { return };
        let (value, limit, name) = match (strain, stress) {
            (Some(value), None) => (value, Limit::Strain(value), "STRAIN"),
            (None, Some(value)) => (value, Limit::Stress(value), "STRESS"),
            _ => {
                let message = "*ALLOWABLE takes either STRAIN or STRESS";
                draft.log.error("SL0270", message, card.span());
                return;
            }
        };
        if value <= 0.0 {
            let message = format!("the allowable {} must be positive", name.to_lowercase());
            draft.log.error("SL0270", message, card.span_of(name));
            return;
        }
        if draft.allowables.iter().any(|old| old.material == material) {
            let message = format!("the material {material} has two allowables");
            draft.log.error("SL0270", message, card.span());
            return;
        }
        let material_span = card.span_of("MATERIAL");
        let origin = card.span();
        draft.allowables.push(draft::Allowable { material, material_span, limit, origin });
    }
}
