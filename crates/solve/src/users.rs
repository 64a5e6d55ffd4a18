//! Friction laws of the embedding program, by name.

use slideline_mech::contact::friction::{Registered, UserFriction};
use slideline_model::{Friction, Model};
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

    /// The first law that a model names and the registry lacks: its name and
    /// the place of the contact pair.
    pub fn missing<'a>(&self, model: &'a Model) -> Option<(&'a str, usize)> {
        model.contact_pairs.iter().enumerate().find_map(|(place, pair)| {
            match &pair.interaction.friction {
                Friction::User { name, .. } if self.find(name).is_none() => {
                    Some((name.as_str(), place))
                }
                _ => None,
            }
        })
    }
}
