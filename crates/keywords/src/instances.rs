//! Numbers and names of instances of parts.
//!
//! ```text
//!   the deck says   ARM-2.12      ARM-2.TIP
//!   the draft       4e18 + 2e9 + 12   set ARM-2.TIP
//! ```

use slideline_model::Numbering;
use std::collections::HashMap;

/// Largest node or element number.
pub(crate) const MAX_LABEL: i64 = 999_999_999;

/// Distance between the numbers of two instances while a deck is read: more than any number
/// that a deck may give.
const APART: u64 = MAX_LABEL as u64 + 1;

/// Strides left free before the first instance: no count, label or value of a deck is as large as
/// the numbers behind them, so that they are known wherever a message says them.
const BEFORE: u64 = 4_000_000_000;

/// A node or element number, or the name of a set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    Label(u64),
    Set(String),
}

/// What the numbers and names of a part become in an instance.
#[derive(Clone, Debug)]
pub(crate) struct Placement {
    /// What is added to numbers.
    pub offset: u64,
    /// What is put before names: `ARM-1.`.
    pub prefix: String,
}

impl Placement {
    /// A number of the part.
    pub fn label(&self, label: u64) -> u64 {
        label + self.offset
    }

    /// A name of the part.
    pub fn name(&self, name: &str) -> String {
        format!("{}{name}", self.prefix)
    }
}

/// The instances so far.
#[derive(Default)]
pub(crate) struct Instances {
    /// Place of each, from 1, by its name.
    places: HashMap<String, u64>,
    names: Vec<String>,
}

impl Instances {
    /// How numbers are made while the deck is read.
    pub fn numbering(&self) -> Numbering {
        Numbering::new(APART, self.names.clone()).behind(BEFORE)
    }

    /// Takes an instance in; false where the name is taken.
    pub fn add(&mut self, name: &str) -> bool {
        if self.places.contains_key(name) {
            return false;
        }
        self.names.push(name.to_owned());
        self.places.insert(name.to_owned(), self.names.len() as u64).is_none()
    }

    /// The placement of the instance of that name.
    pub fn placement(&self, instance: &str) -> Option<Placement> {
        let place = self.places.get(instance)?;
        Some(Placement { offset: (BEFORE + place) * APART, prefix: format!("{instance}.") })
    }

    /// The node or element that a name such as `ARM-1.12` means; other names are sets.
    pub fn target(&self, name: String) -> Target {
        let dots = if self.names.is_empty() { "" } else { name.as_str() };
        let number = dots.match_indices('.').find_map(|(at, _)| {
            let placement = self.placement(&name[..at])?;
            let number = slideline_deck::parse_integer(&name[at + 1..]).ok()?;
            let own = u64::try_from(number).ok().filter(|own| (1..APART).contains(own))?;
            Some(placement.label(own))
        });
        number.map_or(Target::Set(name), Target::Label)
    }

    /// A text in which numbers of instances, larger than any of a deck, are said as the deck
    /// says them: `ARM-1.12`.
    pub fn in_words(&self, text: &str) -> Option<String> {
        if self.names.is_empty() {
            return None;
        }
        let numbering = self.numbering();
        let mut said = String::with_capacity(text.len());
        let pieces = text.split_inclusive(|c: char| !c.is_ascii_digit());
        for piece in pieces {
            let digits = piece.trim_end_matches(|c: char| !c.is_ascii_digit());
            match digits.parse::<u64>() {
                Ok(number) if number / APART > BEFORE => {
                    said.push_str(&numbering.name(number).to_string());
                    said.push_str(&piece[digits.len()..]);
                }
                _ => said.push_str(piece),
            }
        }
        Some(said)
    }

    /// Names of the instances.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter().map(String::as_str)
    }
}
