//! Numbers of a deck without `*PARAMETER` that a designer would change: they become sliders.
//!
//! ```text
//!   *BEAM SECTION, SECTION=RECT, ...        *PARAMETER
//!   25.0, 1.5                         -->   at_1 = 25.0       width
//!                                           at_2 = 1.5        thickness
//!                                           ...
//!                                           <at_1>, <at_2>
//! ```
//!
//! A number is put in as it was, so that the model has the same bits. The cards are changed, not the
//! text: every place stays where it was.

use crate::found_bodies::{Body, bodies};
use crate::found_surfaces::surface;
use crate::places::{Place, Places};
use crate::search::{Search, parameter};
use crate::slider::{Range, Slider};
use crate::values::Values;
use slideline::deck::{Card, DataLine, Deck, Field, Word};
use slideline::diag::{FileId, Span};
use slideline::{Parametric, Read};
use std::collections::HashMap;

/// What was found in a deck.
pub(crate) struct Found {
    /// The deck with names in the places.
    pub deck: Deck,
    /// None where there is nothing to be changed.
    pub sliders: Vec<Slider>,
    /// Where their numbers stand.
    pub places: Places,
}

/// Looks for numbers.
pub(crate) fn found(read: &Read, ranges: &[Range]) -> Found {
    let deck = &read.deck;
    let Some(file) = deck.files.first().map(|own| own.file) else {
        let (sliders, places) = Default::default();
        return Found { deck: deck.clone(), sliders, places };
    };
    let mut search = Search::of(file);
    let mut material = String::new();
    for card in deck.cards.iter().filter(|card| card.span.file == file) {
        if card.keyword.name == "MATERIAL" {
            material = parameter(card, "NAME");
        }
        look_at(&mut search, card, &material);
    }
    for body in bodies(read).iter().filter(|own| stands_alone(own, read, file)) {
        body.search(&mut search);
    }
    let (sliders, places) = search.ended(ranges);
    Found { deck: named(deck, file, &places.list), sliders, places }
}

/// Whether the numbers that were found for a body move all of it, and nothing else.
fn stands_alone(body: &Body, read: &Read, file: FileId) -> bool {
    let mut search = Search::of(file);
    body.search(&mut search);
    let (sliders, places) = search.ended(&[]);
    let deck = named(&read.deck, file, &places.list);
    let Ok(parametric) = Parametric::of(&Read { deck, ..read.clone() }) else { return false };
    let model =
        |by: f64| parametric.model(&places.settings(&sliders, &Values(vec![by])).ok()?).ok();
    let by = body.trial();
    model(0.0).zip(model(by)).is_some_and(|(old, new)| body.is_moved_alone(by, [&old, &new]))
}

fn look_at(search: &mut Search, card: &Card, material: &str) {
    let of = |name: &str| parameter(card, name);
    let segments = of("TYPE") == "SEGMENTS";
    match card.keyword.name.as_str() {
        "BEAMSECTION" => match of("SECTION").as_str() {
            "RECT" => search.line(card, &of("ELSET"), &[WIDTH, THICKNESS]),
            "CIRC" => search.line(card, &of("ELSET"), &[RADIUS]),
            "PIPE" => search.line(card, &of("ELSET"), &[RADIUS, WALL]),
            _ => {}
        },
        "SOLIDSECTION" => search.line(card, &of("ELSET"), &[DEPTH]),
        "ELASTIC" => search.line(card, material, &[MODULUS]),
        "FRICTION" => search.line(card, "", &[FRICTION]),
        "SURFACE" if segments => surface(search, card, &of("NAME"), true),
        "RIGIDSURFACE" if segments => surface(search, card, &of("ELSET"), true),
        "SURFACE" if ["CYLINDER", "REVOLUTION"].contains(&of("TYPE").as_str()) => {
            surface(search, card, &of("NAME"), false);
        }
        "BOUNDARY" => search.sizes(card, 3, STROKE),
        "CLOAD" => search.sizes(card, 2, LOAD),
        "DLOAD" | "DSLOAD" => pressures(search, card),
        _ => {}
    }
}

/// Of loads that are spread only pressures: others are known by more than a number.
fn pressures(search: &mut Search, card: &Card) {
    for line in &card.data {
        let [_, label, value, ..] = &line.fields[..] else { continue };
        let label = label.text.trim().to_ascii_uppercase();
        let behind = label.strip_prefix('P').map(|face| face.parse::<u8>().is_ok());
        if label == "P" || behind == Some(true) {
            search.size(value, PRESSURE);
        }
    }
}

const WIDTH: (&str, &str) = ("width", "");
const THICKNESS: (&str, &str) = ("thickness", "");
const RADIUS: (&str, &str) = ("radius", "");
const WALL: (&str, &str) = ("wall", "thickness");
const DEPTH: (&str, &str) = ("depth", "thickness");
const MODULUS: (&str, &str) = ("modulus", "");
const FRICTION: (&str, &str) = ("mu", "coefficient of friction");
const STROKE: (&str, &str) = ("stroke", "prescribed motion");
const LOAD: (&str, &str) = ("load", "on nodes");
const PRESSURE: (&str, &str) = ("pressure", "on faces");

/// The deck with names in the places and their numbers in a `*PARAMETER` before all cards. Everything
/// stands where it stood, so that what is said of the model points into the deck of the user.
fn named(deck: &Deck, file: FileId, places: &[Place]) -> Deck {
    let mut named = deck.clone();
    let names: HashMap<Span, String> =
        places.iter().map(|own| (own.span, format!("<{}>", own.name))).collect();
    for card in named.cards.iter_mut().filter(|card| card.span.file == file) {
        for line in &mut card.data {
            let text_of = |own: &Field| names.get(&own.span).cloned();
            if line.fields.iter().all(|own| text_of(own).is_none()) {
                continue;
            }
            line.fields
                .iter_mut()
                .for_each(|own| own.text = text_of(own).unwrap_or(own.text.clone()));
            let texts: Vec<&str> = line.fields.iter().map(|own| own.text.as_str()).collect();
            line.text = texts.join(", ");
        }
        let words = card.parameters.iter_mut().filter_map(|own| own.value.as_mut());
        for (name, word) in words.filter_map(|own| Some((names.get(&own.span)?, own))) {
            word.raw.clone_from(name);
            word.name.clone_from(name);
        }
    }
    let line = |own: &Place| {
        let text = format!("{} = {:?}", own.name, own.value);
        let fields = vec![Field { text: text.clone(), span: own.span }];
        DataLine { text, span: own.span, fields }
    };
    let span = Span::new(file, 0, 0);
    let (raw, name) = ("PARAMETER".to_owned(), "PARAMETER".to_owned());
    let keyword = Word { raw, name, span };
    let data = places.iter().map(line).collect();
    named.cards.insert(0, Card { keyword, parameters: Vec::new(), data, span });
    named
}
