//! Questions to a bench and its answers, for tests.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use serde_json::{Value, json};
use slideline_workbench::Bench;

/// Everything that a bench says to a message, as long as it is wanted.
pub fn ask_until(
    bench: &mut Bench,
    message: &Value,
    mut wanted: impl FnMut(&[Value]) -> bool,
) -> Vec<Value> {
    let mut said = Vec::new();
    bench.answer(&message.to_string(), &mut |text: &str| {
        if !text.is_empty() {
            said.push(serde_json::from_str(text).unwrap());
        }
        wanted(&said)
    });
    said
}

/// All of it.
pub fn ask(bench: &mut Bench, message: &Value) -> Vec<Value> {
    ask_until(bench, message, |_| true)
}

/// The last thing that is said.
pub fn last(bench: &mut Bench, message: &Value) -> Value {
    ask(bench, message).pop().unwrap()
}

/// A bench with a deck, and what it says of it.
pub fn opened(name: &str, text: &str) -> (Bench, Value) {
    let mut bench = Bench::new().with_deck(name, text);
    let deck = last(&mut bench, &json!({"ask": "open", "id": 1}));
    (bench, deck)
}

/// All rows of a solve.
pub fn rows(said: &[Value]) -> Vec<Vec<f64>> {
    let points = said.iter().filter(|own| own["say"] == "points");
    let rows = points.flat_map(|own| own["rows"].as_array().unwrap());
    rows.map(|row| row.as_array().unwrap().iter().map(|own| own.as_f64().unwrap()).collect())
        .collect()
}

/// A parameter of a deck.
pub fn parameter(deck: &Value, name: &str) -> Value {
    let all = deck["parameters"].as_array().unwrap();
    all.iter().find(|own| own["name"] == name).unwrap_or(&Value::Null).clone()
}
