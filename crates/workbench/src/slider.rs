//! A number that may be changed, and between which ends.

/// Where a slider ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// The parameter.
    pub name: String,
    /// From here.
    pub minimum: f64,
    /// To here.
    pub maximum: f64,
}

/// A number of the deck that may be changed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slider {
    /// Name of the parameter.
    pub name: String,
    /// Its number in the deck.
    pub value: f64,
    /// From here, to here.
    pub range: [f64; 2],
    /// Whether it is a whole number.
    pub whole: bool,
    /// The deck's own words.
    pub about: String,
    /// Its unit, as the deck calls it.
    pub unit: String,
    /// Whether it is a `*PARAMETER` of the deck, or was found among its numbers.
    pub declared: bool,
}

impl Slider {
    /// Ends that were said, or half and twice the number.
    pub fn limited(mut self, ranges: &[Range]) -> Self {
        if let Some(own) = ranges.iter().rev().find(|own| own.name == self.name) {
            self.range = [own.minimum, own.maximum];
        }
        self
    }
}

/// Half and twice a number, in ascending order; of zero nothing is known but its sign.
pub(crate) fn around(value: f64) -> [f64; 2] {
    if value == 0.0 { [0.0, 1.0] } else { [0.5 * value, 2.0 * value].sorted() }
}

trait Sorted {
    fn sorted(self) -> Self;
}

impl Sorted for [f64; 2] {
    fn sorted(self) -> Self {
        [self[0].min(self[1]), self[0].max(self[1])]
    }
}
