//! What was found in a deck so far: numbers that become sliders, and where they stand.

use crate::places::{Drawn, Follows, Place, Places};
use crate::slider::{Range, Slider, around};
use slideline::deck::{Card, Field, parse_number};
use slideline::diag::{FileId, Span};

/// Value of a parameter of a keyword line; empty where there is none.
pub(crate) fn parameter(card: &Card, name: &str) -> String {
    let own = card.parameters.iter().find(|own| own.name.name == name);
    own.and_then(|own| own.value.as_ref()).map_or_else(String::new, |value| value.name.clone())
}

/// A number that was found.
pub(crate) struct Number {
    /// What it is called where there is one of its kind.
    pub name: &'static str,
    /// Whose it is.
    pub owner: String,
    /// In words.
    pub about: String,
    pub unit: &'static str,
    pub value: f64,
    pub range: [f64; 2],
}

impl Number {
    pub fn new((name, about): (&'static str, &str), owner: &str, value: f64) -> Self {
        let of = if owner.is_empty() { String::new() } else { format!(" of {owner}") };
        let (owner, range) = (owner.to_owned(), around(value));
        Self {
            name,
            owner,
            about: format!("{about}{of}").trim().to_owned(),
            unit: "",
            value,
            range,
        }
    }

    /// What is added along an axis to a body that reaches from end to end.
    pub fn shift(axis: usize, owner: &str, ends: [[f64; 2]; 3]) -> Self {
        let mut own = Self::new(SHIFTS[axis], owner, 0.0);
        let size = shifted(axis, ends);
        own.range = [-size, size];
        own
    }
}

const SHIFTS: [(&str, &str); 3] =
    [("shift_x", "along x,"), ("shift_y", "along y,"), ("shift_z", "along z,")];

/// How far a body may be moved along an axis: a tenth of its length there, of its largest one where
/// it has none, or of where a mere point stands.
pub(crate) fn shifted(axis: usize, ends: [[f64; 2]; 3]) -> f64 {
    let long = ends.map(|[low, high]| if high > low { high - low } else { 0.0 });
    let most = |all: &[f64]| all.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    let all = ends.as_flattened().iter().filter(|own| own.is_finite());
    let far = most(&all.copied().collect::<Vec<_>>());
    let size = [long[axis], most(&long), far].into_iter().find(|own| *own > 0.0);
    0.1 * size.unwrap_or(10.0)
}

/// What was found so far.
#[derive(Default)]
pub(crate) struct Search {
    file: Option<FileId>,
    numbers: Vec<Number>,
    places: Vec<Place>,
    profiles: Vec<Drawn>,
}

impl Search {
    /// Of a deck in this file.
    pub fn of(file: FileId) -> Self {
        Self { file: Some(file), ..Self::default() }
    }

    /// A number that is a slider; its place among them.
    pub fn add(&mut self, number: Number) -> usize {
        self.numbers.push(number);
        self.numbers.len() - 1
    }

    /// A number of the deck that follows.
    pub fn follow(&mut self, span: Span, value: f64, follows: Follows) {
        let name = format!("at_{}", self.places.len() + 1);
        self.places.push(Place { span, name, value, follows });
    }

    /// A profile that sliders draw; its place among them.
    pub fn draw(&mut self, drawn: Drawn) -> usize {
        self.profiles.push(drawn);
        self.profiles.len() - 1
    }

    /// The first values of the first data line.
    pub fn line(&mut self, card: &Card, owner: &str, names: &[(&'static str, &'static str)]) {
        let Some(line) = card.data.first() else { return };
        for (name, field) in names.iter().zip(&line.fields) {
            let Some(value) = self.number(field).filter(|value| *value != 0.0) else { continue };
            let slider = self.add(Number::new(*name, owner, value));
            self.follow(field.span, value, Follows::Same(slider));
        }
    }

    /// Motions and loads: numbers of the same size are one.
    pub fn sizes(&mut self, card: &Card, at: usize, name: (&'static str, &'static str)) {
        for field in card.data.iter().filter_map(|line| line.fields.get(at)) {
            self.size(field, name);
        }
    }

    pub fn size(&mut self, field: &Field, name: (&'static str, &'static str)) {
        let Some(value) = self.number(field).filter(|value| *value != 0.0) else { return };
        let known = self.numbers.iter().position(|own| {
            own.name == name.0 && own.value.abs().to_bits() == value.abs().to_bits()
        });
        let slider = match known {
            Some(slider) => slider,
            None => self.add(Number::new(name, "", value)),
        };
        let same = self.numbers[slider].value.to_bits() == value.to_bits();
        let follows = if same { Follows::Same(slider) } else { Follows::Negative(slider) };
        self.follow(field.span, value, follows);
    }

    /// A number in the file of the deck; those of others are not changed.
    pub fn number(&self, field: &Field) -> Option<f64> {
        let own = parse_number(&field.text).ok().filter(|value| value.is_finite());
        own.filter(|_| Some(field.span.file) == self.file)
    }

    /// Sliders with names of their own.
    pub fn ended(self, ranges: &[Range]) -> (Vec<Slider>, Places) {
        let mut taken: Vec<String> = Vec::new();
        let mut sliders = Vec::new();
        for own in &self.numbers {
            let mut owners = self.numbers.iter().filter(|one| one.name == own.name);
            let alone = owners.all(|one| one.owner == own.owner) || own.owner.is_empty();
            let base = match alone {
                true => own.name.to_owned(),
                false => format!("{}_{}", own.name, as_name(&own.owner)),
            };
            let names = (2..).map(|number| format!("{base}_{number}"));
            let mut names = std::iter::once(base.clone()).chain(names);
            let name = names.find(|name| !taken.contains(name)).unwrap_or_default();
            taken.push(name.clone());
            let slider = Slider {
                name,
                value: own.value,
                range: own.range,
                whole: false,
                about: own.about.clone(),
                unit: own.unit.to_owned(),
                declared: false,
            };
            sliders.push(slider.limited(ranges));
        }
        let places = Places { list: self.places, profiles: self.profiles };
        (sliders, places)
    }
}

/// A name of the deck as the name of a parameter may be written.
fn as_name(text: &str) -> String {
    text.chars().map(|own| if own.is_ascii_alphanumeric() { own } else { '_' }).collect()
}
