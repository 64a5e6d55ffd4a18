//! `*SURFACE BEHAVIOR`: overclosure to pressure, the modern spelling.

use slideline_model::{Dialect, NormalLaw};

use super::surface_contact::{exponential, set_law};
use crate::draft::{Draft, Owner};
use crate::keyword::{Keyword, Level, Rule, Subject};
use crate::reading::Reading;

/// `*SURFACE BEHAVIOR`.
pub(crate) struct SurfaceBehavior;

impl Keyword for SurfaceBehavior {
    fn name(&self) -> &'static str {
        "SURFACE BEHAVIOR"
    }

    fn parameters(&self) -> &'static [Rule] {
        const RULES: &[Rule] = &[Rule::value("PRESSURE-OVERCLOSURE"), Rule::flag("NO SEPARATION")];
        RULES
    }

    fn without_effect(&self) -> &'static [&'static str] {
        &["AUGMENTED LAGRANGE", "PENALTY", "DIRECT"]
    }

    fn level(&self) -> Level {
        Level::Both
    }

    fn subject(&self) -> Subject {
        Subject::Contact
    }

    fn is_suboption(&self) -> bool {
        true
    }
    fn page(&self) -> &'static str {
        page!("SURFACE-BEHAVIOR")
    }

    fn read(&self, card: &Reading<'_>, draft: &mut Draft) {
        if draft.owning_interaction(self.name(), card.span()).is_none() {
            return;
        }
        let known = &["HARD", "LINEAR", "EXPONENTIAL", "TABULAR", "TIED"];
        let law = match card.choice("PRESSURE-OVERCLOSURE", known, &mut draft.log) {
            Some("LINEAR") => linear(card, draft),
            Some("EXPONENTIAL") => exponential(card, draft),
            Some("TABULAR") => tabular(card, draft),
            Some("TIED") => tied(card, draft),
            _ if card.has("PRESSURE-OVERCLOSURE")
                && card.word("PRESSURE-OVERCLOSURE").is_none() =>
            {
                None
            }
            _ => {
                if let Some(line) = card.data().first() {
                    let message = "data of hard contact have no effect: it is imposed exactly";
                    draft.log.note("SL0257", message, line.span);
                }
                Some(NormalLaw::Hard)
            }
        };
        if card.has("NO SEPARATION") {
            keep_closed(card, law.as_ref(), draft);
        }
        set_law(self.name(), card, law, draft);
    }
}

/// `NO SEPARATION`: what has closed carries tension from then on.
fn keep_closed(card: &Reading<'_>, law: Option<&NormalLaw>, draft: &mut Draft) {
    let span = card.span_of("NO SEPARATION");
    if law.is_some_and(|law| law.bonded().is_none()) {
        let message = "NO SEPARATION goes with a hard or a linear law";
        draft.log.error("SL0215", message, span);
        return;
    }
    let named = "SURFACE BEHAVIOR";
    if let Some((interaction, _)) = draft.owning_interaction(named, card.span()) {
        interaction.no_separation = true;
    }
}

/// CalculiX: the pairs of the interaction are ties. Its stiffness is that of a penalty, which counts
/// where the law changes in a step.
fn tied(card: &Reading<'_>, draft: &mut Draft) -> Option<NormalLaw> {
    let Owner::Interaction(place) = draft.owner else {
        let message = "TIED belongs to a *SURFACE INTERACTION";
        draft.log.error("SL0215", message, card.span_of("PRESSURE-OVERCLOSURE"));
        return None;
    };
    draft.interactions[place].is_tied = true;
    match card.data().is_empty() {
        true => Some(NormalLaw::Hard),
        false => linear(card, draft),
    }
}

/// `K`; CalculiX adds the largest pull of its rounded law.
fn linear(card: &Reading<'_>, draft: &mut Draft) -> Option<NormalLaw> {
    let line = card.only_line("the stiffness K", &mut draft.log)?;
    let calculix = draft.dialect == Dialect::Calculix;
    draft.log.at_most(line, if calculix { 3 } else { 1 });
    if let Some(field) = line.field(2).filter(|_| calculix) {
        let message = "the distance up to which open surfaces pull (c0) has no effect: what is open \
                       carries nothing";
        draft.log.note("SL0257", message, field.span);
    }
    let stiffness = draft.log.number(line, 0, "the stiffness K")?;
    let tension = draft.log.maybe_number(line, 1)?.filter(|_| calculix);
    if stiffness <= 0.0 || tension.is_some_and(|tension| tension < 0.0) {
        let message = "the stiffness of a linear law must be positive, and its pull not negative";
        draft.log.error("SL0218", message, line.span);
        return None;
    }
    // rounded law: p = K h (1/2 + atan(h/e)/pi), e = pi pull/K; without a pull its corner is sharp
    Some(match tension.filter(|tension| *tension > 0.0) {
        Some(tension) => NormalLaw::CalculixLinear { stiffness, tension, pulls: false },
        None => NormalLaw::Linear { stiffness },
    })
}

/// Lines of pressure and overclosure, ascending in overclosure.
fn tabular(card: &Reading<'_>, draft: &mut Draft) -> Option<NormalLaw> {
    let mut pairs: Vec<(f64, f64)> = Vec::new();
    for line in card.data() {
        draft.log.at_most(line, 2);
        let pressure = draft.log.number(line, 0, "the pressure");
        let overclosure = draft.log.number(line, 1, "the overclosure");
        let (pressure, overclosure) = (pressure?, overclosure?);
        let falls = |&(p, h): &(f64, f64)| overclosure <= h || pressure < p;
        if pressure < 0.0 || pairs.last().is_some_and(falls) {
            let message = "the table must ascend in overclosure, and its pressure must not fall";
            draft.log.error("SL0218", message, line.span);
            return None;
        }
        pairs.push((pressure, overclosure));
    }
    if pairs.len() < 2 {
        let message = "a tabular law needs at least two lines of pressure, overclosure";
        draft.log.error("SL0208", message, card.span());
        return None;
    }
    Some(NormalLaw::Tabular(pairs))
}
