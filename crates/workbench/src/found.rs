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
//! The text is rewritten and nothing else: a number is put in as it was, so that the model has the
//! same bits.

use crate::found_surfaces::surface;
use crate::parameters::{Range, Slider};
use crate::places::{Place, Places};
use crate::search::{Search, parameter};
use slideline::deck::{Card, Deck, apply};
use slideline::diag::{Edit, FileId, Span};
use std::fmt::Write as _;

/// What was found in a deck.
pub(crate) struct Found {
    /// The deck with names in the places.
    pub text: String,
    /// None where there is nothing to be changed.
    pub sliders: Vec<Slider>,
    /// Where their numbers stand.
    pub places: Places,
}

/// Looks for numbers.
pub(crate) fn found(deck: &Deck, ranges: &[Range]) -> Found {
    let Some(file) = deck.files.first().map(|own| own.file) else {
        let (text, sliders, places) = Default::default();
        return Found { text, sliders, places };
    };
    let mut search = Search::of(file);
    let mut material = String::new();
    for card in deck.cards.iter().filter(|card| card.span.file == file) {
        if card.keyword.name == "MATERIAL" {
            material = parameter(card, "NAME");
        }
        read(&mut search, card, &material);
    }
    let (sliders, places) = search.ended(ranges);
    Found { text: rewritten(deck, file, &places.list), sliders, places }
}

fn read(search: &mut Search, card: &Card, material: &str) {
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

const WIDTH: (&str, &str) = ("width", "width");
const THICKNESS: (&str, &str) = ("thickness", "thickness");
const RADIUS: (&str, &str) = ("radius", "radius");
const WALL: (&str, &str) = ("wall", "thickness of the wall");
const DEPTH: (&str, &str) = ("depth", "thickness out of the plane");
const MODULUS: (&str, &str) = ("modulus", "Young's modulus");
const FRICTION: (&str, &str) = ("mu", "coefficient of friction");
const STROKE: (&str, &str) = ("stroke", "prescribed motion");
const LOAD: (&str, &str) = ("load", "force");
const PRESSURE: (&str, &str) = ("pressure", "pressure");

/// The deck with `*PARAMETER` before its first card and names in the places.
fn rewritten(deck: &Deck, file: FileId, places: &[Place]) -> String {
    let mut lines = String::from("*PARAMETER\n");
    let mut edits: Vec<Edit> = Vec::new();
    for own in places {
        let _ = writeln!(lines, "{} = {:?}", own.name, own.value); // a String takes any text
        edits.push(Edit { span: own.span, replacement: format!("<{}>", own.name) });
    }
    let first = deck.cards.iter().find(|card| card.span.file == file);
    let start = first.map_or(0, |card| card.span.start as usize);
    edits.push(Edit { span: Span::new(file, start, start), replacement: lines });
    String::from_utf8_lossy(&apply(deck, file, &edits).bytes).into_owned()
}
