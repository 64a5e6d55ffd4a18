//! `*VISCOELASTIC`: what of an elastic stress fades with time.

use slideline_deck::DataLine;
use slideline_mech::material::Relaxation;

use crate::draft::Draft;
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*VISCOELASTIC`.
pub(crate) struct Viscoelastic;

impl Keyword for Viscoelastic {
    fn name(&self) -> &'static str {
        "VISCOELASTIC"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("TIME"), Rule::value("TYPE")];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["ERRTOL", "NMAX", "PRELOAD"]
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
        page!("VISCOELASTIC")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_material(self.name(), card.span()).is_none() {
            return;
        }
        let own = (self.name(), card.span());
        let series = is_prony(card, draft).then(|| series(card, draft)).flatten();
        draft.give_material(own, |material| &mut material.relaxation, series);
    }
}

const TIMES: &[&str] = &["PRONY", "CREEP TEST DATA", "RELAXATION TEST DATA", "FREQUENCY DATA"];

/// Whether the card gives a Prony series; complains if not.
fn is_prony(card: &Reading<'_>, draft: &mut Draft) -> bool {
    if card.has("TYPE") && card.choice("TYPE", &["ISOTROPIC"], &mut draft.log).is_none() {
        return false;
    }
    let given = card.word("TIME").is_some();
    match card.choice("TIME", TIMES, &mut draft.log) {
        Some("PRONY") => true,
        None if given => false,
        _ => {
            let message = "relaxation is read as a Prony series alone: write TIME=PRONY and lines \
                           `g, k, tau`";
            draft.log.error("SL0234", message, card.span());
            false
        }
    }
}

/// The terms, whose parts leave some stress in the long term.
fn series(card: &Reading<'_>, draft: &mut Draft) -> Option<Vec<Relaxation>> {
    card.first_line("g, k, tau", &mut draft.log)?;
    let terms: Option<Vec<Relaxation>> = card.data().iter().map(|line| term(line, draft)).collect();
    let terms = terms?;
    for (name, sum) in [
        ("g", terms.iter().map(|term| term.shear).sum::<f64>()),
        ("k", terms.iter().map(|term| term.bulk).sum::<f64>()),
    ] {
        if sum >= 1.0 {
            let message = format!("all {name} sum to {sum}: nothing is left in the long term");
            draft.log.error("SL0234", message, card.span());
            return None;
        }
    }
    Some(terms)
}

fn term(line: &DataLine, draft: &mut Draft) -> Option<Relaxation> {
    draft.log.at_most(line, 3);
    let shear = draft.log.number_or(line, 0, 0.0)?;
    let bulk = draft.log.number_or(line, 1, 0.0)?;
    let time = draft.log.number(line, 2, "the time of relaxation")?;
    let at = |field: usize| line.fields.get(field).map_or(line.span, |field| field.span);
    for (field, value) in [shear, bulk].into_iter().enumerate() {
        if !(0.0..1.0).contains(&value) {
            let message = format!("the part {value} that fades is not between 0 and 1");
            draft.log.error("SL0234", message, at(field));
            return None;
        }
    }
    if time <= 0.0 {
        draft.log.error("SL0234", "the time of relaxation must be positive", at(2));
        return None;
    }
    Some(Relaxation { shear, bulk, time })
}
