//! What a run came to: what its report says, and the curve that it is about.

use crate::curves::{Curves, farthest};
use slideline::output::report::Told;

/// A run that came to its end.
pub(crate) struct Quiet {
    /// What the report says of it.
    pub told: Told,
    /// Which of the curves it is about: the motion that does most work, or the loaded point that
    /// moves most.
    pub place: usize,
    /// Motion and force of that curve, from the start on.
    pub curve: Vec<[f64; 2]>,
    /// Whether it is a load over the way of what is loaded.
    pub loaded: bool,
    /// Whether signs of motion and force belong together.
    directed: bool,
}

impl Quiet {
    /// That of a run with rows of all its curves.
    pub fn of(told: Told, rows: &[Vec<[f64; 2]>], curves: &Curves) -> Self {
        let (loaded, directed) = (curves.is_loaded(), curves.is_directed());
        let place = if loaded { farthest(rows) } else { told.driven.unwrap_or_default() };
        let own = rows.iter().filter_map(|row| row.get(place).copied());
        let curve = std::iter::once([0.0; 2]).chain(own).collect();
        Self { told, place, curve, loaded, directed }
    }

    /// Sign of the motion that the page shows as positive.
    pub fn inward(&self) -> f64 {
        match self.deflection() {
            Some((row, _)) if self.directed && self.curve[row][0] < 0.0 => -1.0,
            Some(_) => 1.0,
            None => self.told.inward,
        }
    }

    /// The state in which what is loaded has moved most, where the model is driven by loads alone.
    pub fn deflection(&self) -> Option<(usize, f64)> {
        let sizes = self.curve.iter().map(|own| own[0].abs()).enumerate();
        let most = sizes.reduce(|most, own| if own.1 > most.1 { own } else { most });
        most.filter(|_| self.loaded)
    }
}
