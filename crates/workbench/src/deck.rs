//! The deck on the bench: its text, what is said about it, its parameters.

use crate::curves::Curves;
use crate::found::found;
use crate::parameters::{declared, ranges};
use crate::places::Places;
use crate::slider::{Range, Slider};
use serde_json::{Value, json};
use slideline::output::{KEY_FIGURES, record};
use slideline::{Model, Parametric, Read};
use std::sync::Arc;

/// Reads a deck: name and text.
pub(crate) type Reads = dyn Fn(&str, &str) -> Read;

/// A deck that was read.
pub(crate) struct Opened {
    /// Its name, with `.inp`.
    pub name: String,
    /// Its text.
    pub text: String,
    /// What was read of it.
    pub read: Read,
    /// What can be changed in it.
    pub sliders: Vec<Slider>,
    /// Where their numbers stand.
    pub places: Places,
    /// The deck that takes values: its own, or one whose numbers have become parameters.
    pub parametric: Option<Arc<Parametric>>,
}

impl Opened {
    /// That of a text, read by `read`. Ranges that are said stand above those of the deck.
    pub fn new(name: &str, text: &str, said: &[Range], read: &Reads) -> Self {
        let own = read(name, text);
        let limits = [ranges(&own.deck), said.to_vec()].concat();
        let (mut sliders, mut places) = declared(&own.deck, &limits);
        let mut parametric = own.model.as_ref().and_then(|_| Parametric::of(&own).ok());
        if sliders.is_empty() && parametric.is_some() {
            let found = found(&own, &limits);
            let named = Parametric::of(&Read { deck: found.deck, ..own.clone() }).ok();
            let named = named.filter(|own| !found.sliders.is_empty() && own.model(&[]).is_ok());
            if named.is_some() {
                (parametric, sliders, places) = (named, found.sliders, found.places);
            }
        }
        Self {
            name: name.to_owned(),
            text: text.to_owned(),
            read: own,
            sliders,
            places,
            parametric: parametric.map(Arc::new),
        }
    }

    /// Name of the job.
    pub fn job(&self) -> &str {
        self.name.strip_suffix(".inp").unwrap_or(&self.name)
    }

    /// What the page is told.
    pub fn told(&self, id: &Value) -> Value {
        let read = &self.read;
        let main = read.sources.files().first().map(|own| own.name.as_str());
        let said = read.diagnostics.iter().map(|own| {
            let mut own = record(own, &read.sources);
            // the page knows the deck by its name alone
            if own.get("file").and_then(Value::as_str) == main {
                own["file"] = json!(self.name);
            }
            own
        });
        json!({
            "say": "deck",
            "id": id,
            "name": self.name,
            "text": self.text,
            "diagnostics": said.collect::<Value>(),
            "sound": self.parametric.is_some(),
            "parameters": self.sliders.iter().map(parameter).collect::<Value>(),
            "responses": responses(read.model.as_ref()),
            "reaction": read.model.as_ref().map_or(Value::Null, reaction),
        })
    }
}

/// What can be solved for: of a deck that loads drive what they move.
fn responses(model: Option<&Model>) -> Value {
    let loaded = model.is_some_and(|own| Curves::of(own).is_loaded());
    let names = match loaded {
        true => &["deflection", "strain", "utilisation"][..],
        false => &KEY_FIGURES[..],
    };
    names.iter().map(|name| json!({"name": name, "unit": ""})).collect()
}

fn parameter(own: &Slider) -> Value {
    json!({
        "name": own.name,
        "value": own.value,
        "minimum": own.range[0],
        "maximum": own.range[1],
        "integer": own.whole,
        "about": own.about,
        "origin": if own.declared { "parameter" } else { "found" },
        "unit": own.unit,
    })
}

/// The first driven motion.
fn reaction(model: &Model) -> Value {
    let driven = model.driven();
    let Some(own) = driven.first() else { return Value::Null };
    let node = own.nodes.first().map(|&node| model.nodes.label(node));
    json!({"node": node, "component": own.dof.reaction_name(), "motion": own.dof.name()})
}
