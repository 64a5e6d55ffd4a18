//! Which values a parameter takes.

use crate::normal::{below, quantile};

/// A value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number {
    /// Without a point: it may count elements.
    Whole(i64),
    /// With one.
    Real(f64),
}

impl Number {
    /// As it is put into the deck; it reads back to the same bits.
    pub fn text(self) -> String {
        match self {
            Self::Whole(number) => number.to_string(),
            Self::Real(number) => format!("{number:?}"),
        }
    }

    /// As a double.
    #[allow(clippy::cast_precision_loss)] // a column has one kind of numbers
    pub fn real(self) -> f64 {
        match self {
            Self::Whole(number) => number as f64,
            Self::Real(number) => number,
        }
    }
}

/// The values of a parameter, in its own unit.
#[derive(Clone, Debug, PartialEq)]
pub enum Spread {
    /// These, one after the other.
    List(Vec<Number>),
    /// So many from one to another, evenly, both ends among them.
    Levels {
        /// The first and the last.
        ends: [f64; 2],
        /// How many, at least two.
        count: u64,
    },
    /// Any between two, all as likely.
    Uniform([f64; 2]),
    /// Normally distributed, where `within` is said only the part between two values.
    Normal {
        /// Mean of the whole distribution.
        mean: f64,
        /// Standard deviation of the whole distribution.
        deviation: f64,
        /// What is left of it.
        within: Option<[f64; 2]>,
    },
}

impl Spread {
    /// How many values there are; `None`: any number.
    pub fn count(&self) -> Option<u64> {
        match self {
            Self::List(values) => Some(values.len() as u64),
            Self::Levels { count, .. } => Some(*count),
            Self::Uniform(_) | Self::Normal { .. } => None,
        }
    }

    /// The value of that place, from 0, among those that are counted.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // counts are small
    pub(crate) fn level(&self, place: u64) -> Number {
        match self {
            Self::List(values) if values.len() == 1 => values[0],
            Self::List(values) => values[place as usize],
            Self::Levels { ends: [from, to], count } => {
                let share = place as f64 / (count - 1) as f64;
                Number::Real(if place + 1 == *count { *to } else { from + share * (to - from) })
            }
            Self::Uniform(_) | Self::Normal { .. } => self.at(0.5),
        }
    }

    /// The value below which the share `u` of the distribution lies; values that are counted have
    /// equal shares.
    #[allow(clippy::cast_precision_loss, clippy::cast_sign_loss, clippy::cast_possible_truncation)]
    pub(crate) fn at(&self, u: f64) -> Number {
        if let Some(count) = self.count() {
            return self.level(((u * count as f64) as u64).min(count - 1));
        }
        Number::Real(match *self {
            Self::Uniform([from, to]) => from + u * (to - from),
            Self::Normal { mean, deviation, within: None } => mean + deviation * quantile(u),
            Self::Normal { mean, deviation, within: Some(ends) } => {
                truncated(u, mean, deviation, ends)
            }
            Self::List(_) | Self::Levels { .. } => f64::NAN, // they are counted
        })
    }
}

/// Quantile of the part of a normal distribution between two values. It is turned about where it
/// lies above the mean, so that shares near one do not lose their digits.
fn truncated(u: f64, mean: f64, deviation: f64, [from, to]: [f64; 2]) -> f64 {
    if from > mean {
        return 2.0 * mean
            - truncated(1.0 - u, mean, deviation, [2.0 * mean - to, 2.0 * mean - from]);
    }
    let [low, high] = [from, to].map(|end| below((end - mean) / deviation));
    (mean + deviation * quantile(low + u * (high - low))).clamp(from, to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_every_spread() {
        let list = Spread::List(vec![Number::Whole(3), Number::Real(0.5)]);
        assert_eq!([0.1, 0.6, 0.999].map(|u| list.at(u).real()), [3.0, 0.5, 0.5]);
        assert_eq!(list.level(0).text(), "3");
        let levels = Spread::Levels { ends: [1.0, 2.0], count: 5 };
        assert_eq!([0, 2, 4].map(|place| levels.level(place).real()), [1.0, 1.5, 2.0]);
        assert_eq!(Spread::Uniform([2.0, 4.0]).at(0.25), Number::Real(2.5));
        let normal = Spread::Normal { mean: 10.0, deviation: 2.0, within: None };
        assert!((normal.at(0.975).real() - 13.919_927_969_080_108).abs() < 1e-12);
    }

    /// Requirement: a truncated distribution stays within its ends, its middle is where half of the
    /// part lies, and mirrored ones give mirrored values.
    #[test]
    fn truncated_distributions() {
        let of = |within| Spread::Normal { mean: 0.0, deviation: 1.0, within: Some(within) };
        assert!(of([-1.0, 1.0]).at(0.5).real().abs() < 1e-15);
        for u in [1e-12, 0.2, 0.7, 1.0 - 1e-12] {
            let [above, under] = [of([6.0, 7.0]).at(u).real(), of([-7.0, -6.0]).at(1.0 - u).real()];
            assert!((6.0..=7.0).contains(&above) && (above + under).abs() < 1e-12);
            let share = |z: f64| below(-z);
            let expected = (share(6.0) - share(above)) / (share(6.0) - share(7.0));
            assert!((expected - u).abs() < 1e-9, "{u} {expected}");
        }
    }
}
