//! Numbers of a deck without `*PARAMETER` that a designer would change: they become parameters.
//!
//! ```text
//!   *BEAM SECTION, SECTION=RECT, ...        *PARAMETER
//!   25.0, 1.5                         -->   width = 25.0
//!                                           thickness = 1.5
//!                                           ...
//!                                           <width>, <thickness>
//! ```
//!
//! The text is rewritten and nothing else: a parameter is put in as the number that it was, so that
//! the model has the same bits.

use crate::parameters::{Form, Place, Range, Slider, around};
use slideline::deck::{Card, Deck, Field, apply, parse_number};
use slideline::diag::{Edit, FileId, Span};
use std::fmt::Write as _;

/// Rewritten deck and sliders; no sliders where there is nothing to be changed.
pub(crate) fn found(deck: &Deck, ranges: &[Range]) -> (String, Vec<Slider>) {
    let Some(file) = deck.files.first().map(|own| own.file) else { return Default::default() };
    let mut search = Search { file, found: Vec::new() };
    let mut material = String::new();
    for card in deck.cards.iter().filter(|card| card.span.file == file) {
        if card.keyword.name == "MATERIAL" {
            material = parameter(card, "NAME").unwrap_or_default();
        }
        search.card(card, &material);
    }
    let sliders: Vec<Slider> = search.named().into_iter().map(|own| own.limited(ranges)).collect();
    (rewritten(deck, file, &sliders), sliders)
}

/// Value of a parameter of a keyword line.
fn parameter(card: &Card, name: &str) -> Option<String> {
    let own = card.parameters.iter().find(|own| own.name.name == name)?;
    own.value.as_ref().map(|value| value.name.clone())
}

/// A number that was found.
struct Found {
    /// What it is called where there is one of its kind.
    name: &'static str,
    /// Whose it is.
    owner: String,
    about: &'static str,
    value: f64,
    places: Vec<Place>,
}

struct Search {
    file: FileId,
    found: Vec<Found>,
}

impl Search {
    fn card(&mut self, card: &Card, material: &str) {
        let of = |name: &str| parameter(card, name).unwrap_or_default();
        match card.keyword.name.as_str() {
            "BEAMSECTION" => match of("SECTION").as_str() {
                "RECT" => self.line(card, &of("ELSET"), &[WIDTH, THICKNESS]),
                "CIRC" => self.line(card, &of("ELSET"), &[RADIUS]),
                _ => {}
            },
            "SOLIDSECTION" => self.line(card, &of("ELSET"), &[DEPTH]),
            "ELASTIC" => self.line(card, material, &[MODULUS]),
            "FRICTION" => self.line(card, "", &[FRICTION]),
            "SURFACE" if of("TYPE") == "SEGMENTS" => self.surface(card, &of("NAME")),
            "RIGIDSURFACE" if of("TYPE") == "SEGMENTS" => self.surface(card, &of("NAME")),
            "BOUNDARY" => self.strokes(card),
            _ => {}
        }
    }

    /// The first values of the first data line.
    fn line(&mut self, card: &Card, owner: &str, names: &[(&'static str, &'static str)]) {
        let Some(line) = card.data.first() else { return };
        for ((name, about), field) in names.iter().zip(&line.fields) {
            let Some(value) = self.number(field).filter(|value| *value != 0.0) else { continue };
            let places = vec![Place { span: field.span, form: Form::Same }];
            self.found.push(Found { name, owner: owner.to_owned(), about, value, places });
        }
    }

    /// The radius of its corners, and where its points are.
    fn surface(&mut self, card: &Card, owner: &str) {
        let fillet = card.parameters.iter().find(|own| own.name.name == "FILLETRADIUS");
        if let Some(word) = fillet.and_then(|own| own.value.as_ref())
            && let Ok(value) = parse_number(&word.raw)
        {
            let (name, about) = FILLET;
            let places = vec![Place { span: word.span, form: Form::Same }];
            self.found.push(Found { name, owner: owner.to_owned(), about, value, places });
        }
        for (axis, (name, about)) in [SHIFT_X, SHIFT_Y].into_iter().enumerate() {
            let points = card.data.iter().flat_map(|line| line.fields.get(1..).unwrap_or_default());
            let along = points.enumerate().filter(|(place, _)| place % 2 == axis);
            let moved = |field: &Field| {
                let from = self.number(field)?;
                Some(Place { span: field.span, form: Form::Moved(from) })
            };
            let places: Option<Vec<Place>> = along.map(|(_, field)| moved(field)).collect();
            if let Some(places) = places.filter(|own| !own.is_empty()) {
                let owner = owner.to_owned();
                self.found.push(Found { name, owner, about, value: 0.0, places });
            }
        }
    }

    /// Motions: numbers of the same size are one.
    fn strokes(&mut self, card: &Card) {
        for field in card.data.iter().filter_map(|line| line.fields.get(3)) {
            let Some(value) = self.number(field).filter(|value| *value != 0.0) else { continue };
            let known = self.found.iter_mut().find(|own| {
                own.name == STROKE.0 && own.value.abs().to_bits() == value.abs().to_bits()
            });
            match known {
                Some(own) => {
                    let same = own.value.to_bits() == value.to_bits();
                    let form = if same { Form::Same } else { Form::Negative };
                    own.places.push(Place { span: field.span, form });
                }
                None => {
                    let (name, about) = STROKE;
                    let places = vec![Place { span: field.span, form: Form::Same }];
                    let owner = String::new();
                    self.found.push(Found { name, owner, about, value, places });
                }
            }
        }
    }

    fn number(&self, field: &Field) -> Option<f64> {
        let own = parse_number(&field.text).ok().filter(|value| value.is_finite());
        own.filter(|_| field.span.file == self.file)
    }

    /// Sliders with names of their own.
    fn named(self) -> Vec<Slider> {
        let count = |name: &str| self.found.iter().filter(|own| own.name == name).count();
        let mut taken: Vec<String> = Vec::new();
        let mut sliders = Vec::new();
        for own in &self.found {
            let mut name = own.name.to_owned();
            if count(own.name) > 1 && !own.owner.is_empty() {
                name = format!("{name}_{}", as_name(&own.owner));
            }
            let base = name.clone();
            let mut number = 1;
            while taken.contains(&name) {
                number += 1;
                name = format!("{base}_{number}");
            }
            taken.push(name.clone());
            let of =
                if own.owner.is_empty() { String::new() } else { format!(" of {}", own.owner) };
            sliders.push(Slider {
                name,
                value: own.value,
                text: format!("{:?}", own.value),
                range: if own.value == 0.0 { shift(&own.places) } else { around(own.value) },
                places: own.places.clone(),
                whole: false,
                about: format!("{}{of}", own.about),
                unit: String::new(),
                declared: false,
            });
        }
        sliders
    }
}

const WIDTH: (&str, &str) = ("width", "width");
const THICKNESS: (&str, &str) = ("thickness", "thickness");
const RADIUS: (&str, &str) = ("radius", "radius");
const DEPTH: (&str, &str) = ("depth", "thickness out of the plane");
const MODULUS: (&str, &str) = ("modulus", "Young's modulus");
const FRICTION: (&str, &str) = ("mu", "coefficient of friction");
const FILLET: (&str, &str) = ("fillet", "radius of the corners");
const SHIFT_X: (&str, &str) = ("shift_x", "shift along x");
const SHIFT_Y: (&str, &str) = ("shift_y", "shift along y");
const STROKE: (&str, &str) = ("stroke", "prescribed motion");

/// A tenth of the size of what is moved, to both sides.
fn shift(places: &[Place]) -> [f64; 2] {
    let from = places.iter().filter_map(|own| match own.form {
        Form::Moved(from) => Some(from),
        _ => None,
    });
    let ends = from.fold(None, |ends: Option<[f64; 2]>, own| match ends {
        None => Some([own; 2]),
        Some([low, high]) => Some([low.min(own), high.max(own)]),
    });
    let size = ends.map_or(0.0, |[low, high]| high - low);
    let size = if size > 0.0 { 0.1 * size } else { 1.0 };
    [-size, size]
}

/// A name of the deck as the name of a parameter may be written.
fn as_name(text: &str) -> String {
    text.chars().map(|own| if own.is_ascii_alphanumeric() { own } else { '_' }).collect()
}

/// The deck with `*PARAMETER` before its first card and names in the places.
fn rewritten(deck: &Deck, file: FileId, sliders: &[Slider]) -> String {
    let mut lines = String::from("*PARAMETER\n");
    let mut edits: Vec<Edit> = Vec::new();
    for own in sliders {
        let _ = writeln!(lines, "{} = {}", own.name, own.text); // a String takes any text
        for (number, place) in own.places.iter().enumerate() {
            let computed = format!("{}_at_{number}", own.name);
            let name = match place.form {
                Form::Same => own.name.clone(),
                Form::Negative => {
                    let _ = writeln!(lines, "{computed} = -{}", own.name); // as above
                    computed
                }
                Form::Moved(from) => {
                    let _ = writeln!(lines, "{computed} = {from:?} + {}", own.name); // as above
                    computed
                }
            };
            edits.push(Edit { span: place.span, replacement: format!("<{name}>") });
        }
    }
    let first = deck.cards.iter().find(|card| card.span.file == file);
    let start = first.map_or(0, |card| card.span.start as usize);
    edits.push(Edit { span: Span::new(file, start, start), replacement: lines });
    String::from_utf8_lossy(&apply(deck, file, &edits).bytes).into_owned()
}
