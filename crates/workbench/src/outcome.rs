//! The end of a solve: how it went, verdict, key figures, the formula of the design guides.

use crate::formula::formula;
use crate::quiet::Quiet;
use serde_json::{Map, Value, json};
use slideline::diag::Sources;
use slideline::observe::Ending;
use slideline::output::{KEY_FIGURES, Status, figures_of, record};
use slideline::{Diagnostic, Model};

/// What is said at the end of a run.
pub(crate) fn ended(model: &Model, (id, ending): (&Value, &Ending), quiet: &Quiet) -> Value {
    let (told, summary) = (&quiet.told, &quiet.told.summary);
    let of = |key: &str| summary.get(key).cloned().unwrap_or_default();
    let verdict = summary.get("verdict");
    let list = |key: &str| summary.get(key).and_then(Value::as_array).cloned().unwrap_or_default();
    let said = ["warnings", "advice", "notes"].map(list).concat();
    let figures = figures(quiet);
    let tile = |[name, text, about]: &[String; 3]| {
        let response = response(name);
        json!({
            "name": name,
            "text": text,
            "about": about,
            "response": response,
            "value": response.and_then(|own| figures.get(own)),
        })
    };
    let key: Value = tiles(quiet).iter().chain(&told.tiles).map(tile).collect();
    json!({
        "say": "end",
        "id": id,
        "status": Status::of(ending).word(),
        "diagnosis": of("diagnosis"),
        "verdict": {
            "colour": verdict.and_then(|own| own.get("colour")),
            "headline": told.headline,
            "reasons": verdict.and_then(|own| own.get("reasons")),
            "lines": sentences(quiet),
        },
        "key": key,
        "figures": figures,
        "places": {
            "curve": quiet.place,
            "push": told.places[0],
            "pull": told.places[1],
            "inward": quiet.inward(),
        },
        "peaks": of("peaks"),
        "said": said,
        "increments": of("increments"),
        "iterations": of("iterations"),
        "formula": formula(model, told),
    })
}

/// What the report says in words; of a model that loads drive also how far they move it.
fn sentences(quiet: &Quiet) -> Vec<String> {
    let Some((row, most)) = quiet.deflection() else { return quiet.told.sentences.clone() };
    let mut all = quiet.told.sentences.clone();
    all.retain(|own| !own.contains(UNDRIVEN));
    let load = shown(quiet.curve[row][1].abs());
    let own =
        format!("Loads drive this deck: what is loaded moves by {} under {load}", shown(most));
    all.insert(all.len().min(2), own);
    all
}

/// What the report says where it looks for a driven motion in vain.
const UNDRIVEN: &str = "No node is driven";

/// Tiles of a model that loads drive.
fn tiles(quiet: &Quiet) -> Vec<[String; 3]> {
    let Some((row, most)) = quiet.deflection() else { return Vec::new() };
    let load = quiet.curve.iter().map(|own| own[1].abs()).fold(0.0, f64::max);
    let under = format!("under a load of {}", shown(quiet.curve[row][1].abs()));
    let text = |name: &str, value: f64, about: String| [name.to_owned(), shown(value), about];
    vec![
        text("largest deflection", most, under),
        text("largest load", load, "sum along its axis".to_owned()),
    ]
}

fn shown(value: f64) -> String {
    let text = format!("{value:.3e}");
    let value = text.parse::<f64>().unwrap_or(value);
    if (1e-3..1e6).contains(&value) || value == 0.0 { value.to_string() } else { text }
}

/// The key figure that a tile of the report shows.
fn response(tile: &str) -> Option<&'static str> {
    let known = [
        ("push-in", "push_in"),
        ("pull-out", "pull_out"),
        ("out / in", "ratio"),
        ("work in", "work_in"),
        ("largest deflection", "deflection"),
        ("largest strain", "strain"),
        ("largest principal strain", "strain"),
    ];
    known.into_iter().find(|(begin, _)| tile.starts_with(begin)).map(|(_, name)| name)
}

/// Key figures by their names, margin and noise behind them; null where there are none.
pub(crate) fn figures(quiet: &Quiet) -> Map<String, Value> {
    let told = &quiet.told;
    let own = figures_of(&told.summary).values;
    let mut figures: Map<String, Value> = KEY_FIGURES
        .iter()
        .zip(own)
        .map(|(name, value)| ((*name).to_owned(), json!(value)))
        .collect();
    figures.insert("deflection".into(), json!(quiet.deflection().map(|own| own.1)));
    let inside = |keys: &[&str]| keys.iter().try_fold(&told.summary, |own, key| own.get(key));
    figures.insert("margin".into(), json!(inside(&["allowable", "margin"])));
    let reactions = inside(&["noise", "reactions"]).and_then(Value::as_object);
    let noises = reactions.into_iter().flat_map(Map::values);
    let noise = noises.filter_map(|own| own.get("of_mesh")?.as_f64()).reduce(f64::max);
    figures.insert("noise".into(), json!(noise));
    figures
}

/// A key figure by its name; `None`: the run has none of that name.
pub(crate) fn figure(quiet: &Quiet, name: &str) -> Option<f64> {
    figures(quiet).get(name)?.as_f64()
}

/// Values with which the deck is no model.
pub(crate) fn unread(id: &Value, errors: &[Diagnostic], sources: &Sources) -> Value {
    let said: Vec<Value> = errors.iter().map(|own| record(own, sources)).collect();
    json!({
        "say": "end",
        "id": id,
        "status": Status::InputError.word(),
        "diagnosis": said.first(),
        "verdict": {
            "colour": "red",
            "headline": "Red: with these values there is nothing to solve",
            "reasons": [],
            // the first one is the diagnosis
            "lines": errors.iter().skip(1).map(|own| own.message.clone()).collect::<Vec<_>>(),
        },
        "key": [],
        "figures": {},
        "places": {"curve": 0, "push": null, "pull": null, "inward": 1.0},
        "peaks": {},
        "said": said,
        "increments": 0,
        "iterations": 0,
        "formula": null,
    })
}
