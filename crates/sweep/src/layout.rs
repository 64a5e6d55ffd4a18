//! What a study varies, and how its cases are laid out.

use crate::design::Kind;
use crate::spread::Spread;

/// Most cases of a study: two weeks of a core.
pub const MOST_CASES: u64 = 1_000_000_000;

/// A parameter of the deck and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name, as `*PARAMETER` of the deck has it.
    pub name: String,
    /// Its values.
    pub spread: Spread,
}

/// How the cases of a study are laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// How.
    pub kind: Kind,
    /// Number of cases; a grid and lists side by side have their own.
    pub cases: u64,
    /// What random numbers follow from.
    pub seed: u64,
    /// Matrix of correlations of the parameters [1], row by row: those of a Gaussian copula. Empty:
    /// none are correlated.
    pub correlations: Vec<Vec<f64>>,
}
