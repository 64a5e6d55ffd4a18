//! `*CHANGE SURFACE BEHAVIOR`: the pressure law of every contact pair from step to step.

use std::collections::BTreeMap;

use slideline_diag::{Code, Diagnostic};
use slideline_model::{ChangedPressure, Friction};

use super::frictions::{Frictions, missing};
use super::laws_of_pairs::as_read;
use crate::changes::PressureChange;
use crate::draft::{Draft, StepDraft};
use crate::rule::Subject;

/// Laws that are not those of the model, by their pairs.
#[derive(Default)]
pub(super) struct Pressures(BTreeMap<usize, ChangedPressure>);

impl Pressures {
    /// How much a further step copies.
    pub fn size(&self) -> usize {
        self.0.len()
    }

    /// Follows the cards of a step: the laws in it. What was tied rubs from then on.
    pub fn change(
        &mut self,
        step: &StepDraft,
        frictions: &mut Frictions,
        draft: &mut Draft,
    ) -> Vec<ChangedPressure> {
        for card in &step.pressures {
            self.follow(card, frictions, draft);
        }
        self.0.values().cloned().collect()
    }

    fn follow(&mut self, card: &PressureChange, frictions: &mut Frictions, draft: &mut Draft) {
        let own = &card.interaction;
        let origin = own.origin;
        if own.normal_origin.is_none() {
            let message = "*CHANGE SURFACE BEHAVIOR has no *SURFACE BEHAVIOR behind it";
            let error = Diagnostic::error(Code("SL0208"), message).at(origin);
            let help = "put *SURFACE BEHAVIOR with the new law behind it";
            draft.consequence(Subject::Steps, error.help(help));
            return;
        }
        let name = &card.of.name;
        let pairs = draft.pairs_of_interaction.get(name).cloned().unwrap_or_default();
        if pairs.is_empty() {
            missing(&card.of, "surface interaction", draft);
        }
        for pair in pairs {
            let formulation = draft.model.contact_pairs[pair].formulation;
            let normal = as_read(formulation, &own.normal, draft.dialect);
            let no_separation = own.no_separation;
            self.0.insert(pair, ChangedPressure { pair, normal, no_separation, origin });
            if let Some(law) = friction_when_let_go(name, draft) {
                frictions.insert(pair, law, origin);
            }
        }
    }
}

/// The friction of surfaces that were tied until now.
fn friction_when_let_go(interaction: &str, draft: &Draft) -> Option<Friction> {
    let entry = draft.interactions.iter().find(|entry| entry.named.name == interaction)?;
    entry.is_tied.then(|| entry.interaction.friction.clone())
}
