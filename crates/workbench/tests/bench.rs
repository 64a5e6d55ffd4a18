//! The exchange with a bench, as a page has it.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)] // a test may fail where it stands

use serde_json::{Value, json};
use slideline_workbench::Bench;

const DECK: &str = include_str!("../../../corpus/new/snap_fit.inp");

/// Everything that a bench says to a message.
fn ask(bench: &mut Bench, message: &Value) -> Vec<Value> {
    let mut said = Vec::new();
    bench.answer(&message.to_string(), &mut |text: &str| {
        if !text.is_empty() {
            said.push(serde_json::from_str(text).unwrap());
        }
        true
    });
    said
}

#[test]
fn a_deck_is_opened_and_solved() {
    let mut bench = Bench::new().with_deck("snap_fit.inp", DECK);
    let deck = &ask(&mut bench, &json!({"ask": "open", "id": 1}))[0];
    assert_eq!((&deck["say"], &deck["sound"]), (&json!("deck"), &json!(true)), "{deck}");
    let said = ask(&mut bench, &json!({"ask": "solve", "id": 2, "values": {"thickness": 2.0}}));
    let kinds: Vec<&str> = said.iter().map(|own| own["say"].as_str().unwrap()).collect();
    assert_eq!((kinds[0], kinds[1], kinds[kinds.len() - 1]), ("begin", "points", "end"));
    let end = said.last().unwrap();
    assert_eq!((&end["status"], &end["verdict"]["colour"]), (&json!("completed"), &json!("green")));
    let rows = said.iter().filter(|own| own["say"] == "points");
    let rows: usize = rows.map(|own| own["rows"].as_array().unwrap().len()).sum();
    assert_eq!(rows, 201);
}
