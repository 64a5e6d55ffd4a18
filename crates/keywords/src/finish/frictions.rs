//! `*CHANGE FRICTION`: the friction of every contact pair from step to step.

use std::collections::BTreeMap;

use slideline_diag::{Code, Diagnostic, Span};
use slideline_model::{ChangedFriction, Friction};

use crate::changes::{FrictionChange, FrictionOf};
use crate::draft::{Draft, StepDraft};
use crate::rule::Subject;
use crate::surfaces::Named;

/// Laws that are not those of the model, by their pairs, and where they were said.
#[derive(Default)]
pub(super) struct Frictions(BTreeMap<usize, (Friction, Span)>);

impl Frictions {
    /// How much a further step copies.
    pub fn size(&self) -> usize {
        self.0.len()
    }

    /// A law of a pair that a card of the step that comes means without being about friction.
    pub fn insert(&mut self, pair: usize, law: Friction, origin: Span) {
        self.0.insert(pair, (law, origin));
    }

    /// Follows the cards of a step: the laws in it.
    pub fn change(&mut self, step: &StepDraft, draft: &mut Draft) -> Vec<ChangedFriction> {
        let before: BTreeMap<usize, Friction> =
            self.0.iter().map(|(pair, (law, _))| (*pair, law.clone())).collect();
        for card in &step.frictions {
            self.follow(card, draft);
        }
        let own = |pair: usize| draft.model.contact_pairs[pair].interaction.friction.clone();
        let changed = self.0.iter().map(|(&pair, (to, origin))| ChangedFriction {
            pair,
            from: before.get(&pair).cloned().unwrap_or_else(|| own(pair)),
            to: to.clone(),
            origin: *origin,
        });
        let changed = changed.collect();
        // what was reset is the model's own again from the next step on
        self.0.retain(|pair, (law, _)| *law != own(*pair));
        changed
    }

    fn follow(&mut self, card: &FrictionChange, draft: &mut Draft) {
        let origin = card.interaction.origin;
        if !card.reset && card.interaction.friction_origin.is_none() {
            let message = "*CHANGE FRICTION has no *FRICTION behind it";
            let error = Diagnostic::error(Code("SL0208"), message).at(origin);
            let help = "put *FRICTION with the new coefficient behind it, or give RESET: the \
                        friction of the model again";
            draft.consequence(Subject::Steps, error.help(help));
            return;
        }
        for pair in pairs(&card.of, draft) {
            let own = draft.model.contact_pairs[pair].interaction.friction.clone();
            let law = if card.reset { own.clone() } else { card.interaction.friction.clone() };
            if [&law, &own].into_iter().any(|law| matches!(law, Friction::User { .. })) {
                let message = "friction by a law of a program cannot be changed";
                let error = Diagnostic::error(Code("SL0221"), message).at(origin);
                let help = "let the law itself depend on the time, which it is told";
                draft.consequence(Subject::Contact, error.help(help));
                continue;
            }
            self.0.insert(pair, (law, origin));
        }
    }
}

/// The pairs that are named; complains where there are none.
fn pairs(of: &FrictionOf, draft: &mut Draft) -> Vec<usize> {
    let (named, what, found) = match of {
        FrictionOf::Interaction(named) => {
            let found = draft.pairs_of_interaction.get(&named.name).cloned().unwrap_or_default();
            (named, "surface interaction", found)
        }
        FrictionOf::Elements(named) => {
            let pairs = draft.model.contact_pairs.iter().enumerate();
            let own = pairs.filter(|(_, pair)| pair.name == named.name).map(|(place, _)| place);
            (named, "contact element set", own.collect())
        }
    };
    if found.is_empty() {
        missing(named, what, draft);
    }
    found
}

/// Complains that no pair is meant.
pub(super) fn missing(named: &Named, what: &str, draft: &mut Draft) {
    let message = format!("no contact pair has the {what} {}", named.name);
    let error = Diagnostic::error(Code("SL0328"), message).at(named.span);
    let names = draft.pairs_of_interaction.keys().map(String::as_str);
    let names = names.chain(draft.model.contact_pairs.iter().map(|pair| pair.name.as_str()));
    let help = match slideline_deck::nearest(&named.name, names) {
        Some(near) => format!("did you mean {near}?"),
        None => "name the *SURFACE INTERACTION of a *CONTACT PAIR".to_owned(),
    };
    draft.consequence(Subject::Contact, error.help(help));
}
