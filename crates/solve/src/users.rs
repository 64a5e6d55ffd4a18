//! Friction laws of the embedding program, by name.

use slideline_diag::{Code, Diagnostic};
use slideline_mech::contact::friction::{Registered, UserFriction};
use slideline_model::{ContactPair, Friction, Model};
use std::collections::HashMap;
use std::sync::Arc;

/// The registry handed to a run. Names count without regard to case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UserFrictions {
    laws: HashMap<String, Registered>,
}

impl UserFrictions {
    /// Registers a law under a name, in place of an earlier one.
    pub fn register(&mut self, name: &str, law: Arc<dyn UserFriction>) {
        self.laws.insert(name.to_ascii_uppercase(), Registered(law));
    }

    /// The law of that name.
    pub fn find(&self, name: &str) -> Option<Registered> {
        self.laws.get(&name.to_ascii_uppercase()).cloned()
    }

    /// An error for every pair whose friction law nobody registered.
    pub fn missing(&self, model: &Model) -> Vec<Diagnostic> {
        let of_pair = |pair: &ContactPair| match &pair.interaction.friction {
            Friction::User { name, .. } if self.find(name).is_none() => Some(
                Diagnostic::error(
                    Code("SL0326"),
                    format!("no friction law named {name} is registered with this program"),
                )
                .at(pair.interaction.friction_origin.unwrap_or(pair.interaction.origin))
                .help(
                    "*FRICTION, USER= names a law of the program that embeds the solver; register \
                     it there, or write Coulomb's law: *FRICTION with the coefficient below it",
                ),
            ),
            _ => None,
        };
        model.contact_pairs.iter().filter_map(of_pair).collect()
    }
}
