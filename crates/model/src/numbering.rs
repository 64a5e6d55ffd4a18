//! Numbers of a model whose parts are numbered alike.
//!
//! ```text
//!   deck          ARM-1.12      ARM-2.12      12 of the assembly
//!   number          1012          2012          12                 stride 1000
//! ```
//!
//! Nodes and elements have one number each in the whole model: that of the deck, and where
//! instances of parts use the same numbers, that of the deck plus a round number for each
//! instance. Messages say the name.

use std::fmt;

/// How a number of the model is made of an instance and a number of its part.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Numbering {
    stride: u64,
    /// How many strides lie before those of the first instance.
    before: u64,
    instances: Vec<String>,
}

impl Numbering {
    /// The `k`-th instance (from 1) has the numbers of its part plus `k` times the stride;
    /// with a stride of zero they are those of the part.
    pub fn new(stride: u64, instances: Vec<String>) -> Self {
        Self { stride, before: 0, instances }
    }

    /// The same with so many strides left free before the first instance: its numbers are then
    /// larger than any that a deck may give.
    #[must_use]
    pub fn behind(self, before: u64) -> Self {
        Self { before, ..self }
    }

    /// What is added to the numbers of the `k`-th instance (from 1).
    pub fn offset(&self, instance: u64) -> u64 {
        (self.before + instance) * self.stride
    }

    /// What is added to the numbers of the first instance, twice for the second and so on.
    pub fn stride(&self) -> u64 {
        self.stride
    }

    /// Names of the instances in order.
    pub fn instances(&self) -> &[String] {
        &self.instances
    }

    /// The name of a number: `ARM-1.12`, or the number itself where there are no
    /// instances to tell apart.
    pub fn name(&self, number: u64) -> Name<'_> {
        let instance = number.checked_div(self.stride).unwrap_or(0).saturating_sub(self.before);
        let place = usize::try_from(instance).ok().and_then(|k| k.checked_sub(1));
        match place.and_then(|k| self.instances.get(k)) {
            Some(instance) => Name { instance: Some(instance), number: number % self.stride },
            None => Name { instance: None, number },
        }
    }

    /// The number with another stride.
    pub fn restride(&self, number: u64, stride: u64) -> u64 {
        match number.checked_div(self.stride) {
            Some(place) => number % self.stride + place.saturating_sub(self.before) * stride,
            None => number,
        }
    }
}

/// A node or element in the deck's words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name<'a> {
    instance: Option<&'a str>,
    number: u64,
}

impl Name<'_> {
    /// The instance that it belongs to.
    pub fn instance(&self) -> Option<&str> {
        self.instance
    }

    /// Its number in the deck.
    pub fn number(&self) -> u64 {
        self.number
    }
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.instance {
            Some(instance) => write!(f, "{instance}.{}", self.number),
            None => write!(f, "{}", self.number),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_says_instance_and_own_number() {
        let numbering = Numbering::new(1000, vec!["ARM-1".into(), "ARM-2".into()]);
        let names = [12, 1012, 2999].map(|number| numbering.name(number).to_string());
        assert_eq!(names, ["12", "ARM-1.12", "ARM-2.999"]);
        assert_eq!(numbering.restride(2012, 100), 212);
        assert_eq!(numbering.restride(2012, 0), 12);
        assert_eq!(Numbering::default().name(2012).to_string(), "2012");
        let far = Numbering::new(1000, vec!["ARM-1".into()]).behind(5);
        let names = [12, 1012, far.offset(1) + 12].map(|number| far.name(number).to_string());
        assert_eq!(names, ["12", "1012", "ARM-1.12"]);
        assert_eq!(far.restride(far.offset(1) + 12, 100), 112);
    }
}
