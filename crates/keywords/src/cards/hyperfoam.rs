//! `*HYPERFOAM`: foam of rubber.

use slideline_mech::material::{Foam, MOST_TERMS, Term};

use crate::draft::{Draft, Elasticity};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*HYPERFOAM`.
pub(crate) struct Hyperfoam;

impl Keyword for Hyperfoam {
    fn name(&self) -> &'static str {
        "HYPERFOAM"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("N")];
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
        page!("HYPERFOAM")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let foam = read(card, draft).map_or(Elasticity::Unread, Elasticity::Foam);
        let own = (self.name(), card.span());
        draft.give_material(own, |material| &mut material.elasticity, foam);
    }
}

/// The foam of a card: all mu and alpha in pairs, then all Poisson's ratios, then a temperature.
fn read(card: &Reading<'_>, draft: &mut Draft) -> Option<Foam> {
    let order = card.at_least(1, "N", 1, &mut draft.log);
    if order > MOST_TERMS {
        let message = format!("at most {MOST_TERMS} terms are read, here are {order}");
        draft.log.error("SL0234", message, card.span_of("N"));
        return None;
    }
    card.first_line("mu1, alpha1, ..., nu1, ...", &mut draft.log)?;
    let values = card.numbers(&mut draft.log)?;
    let (least, most) = (2 * order, 3 * order + 1);
    if values.len() < least || values.len() > most {
        let message = format!(
            "{} numbers are needed, and a temperature may follow, here are {}",
            3 * order,
            values.len()
        );
        draft.log.error("SL0208", message, card.span());
        return None;
    }
    let poisson = |k: usize| values.get(2 * order + k).copied().unwrap_or(0.0);
    let terms = (0..order).map(|k| Term {
        shear: values[2 * k],
        power: values[2 * k + 1],
        poisson: poisson(k),
    });
    sound(Foam { terms: terms.collect() }, card, draft)
}

/// Complains about a foam without stiffness at small strain.
fn sound(foam: Foam, card: &Reading<'_>, draft: &mut Draft) -> Option<Foam> {
    let wrong = |term: &Term| term.power == 0.0 || term.poisson <= -1.0 || term.poisson >= 0.5;
    let message = if foam.terms.iter().any(wrong) {
        "every term needs an alpha that is not zero and a Poisson's ratio between -1 and 0.5"
    } else if !(foam.shear_modulus() > 0.0 && foam.bulk_modulus() > 0.0) {
        "these coefficients give no positive shear and bulk modulus at small strain"
    } else {
        return Some(foam);
    };
    draft.log.error("SL0234", message, card.data()[0].span);
    None
}
