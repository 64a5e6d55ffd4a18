//! What increments turned over and left unbalanced, and sums of that.
//!
//! docs/theory.md section 10.

use crate::target::Target;
use serde::{Deserialize, Serialize};

/// What the last increment turned over and what it left unbalanced, and sums
/// of that. [F L]
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Books {
    /// Energy turned over since time 0, eq. (10.4).
    pub turned_over: f64,
    /// What the last increment left over, eq. (10.5).
    pub left: f64,
    /// Part of it that went to points for sliding until they opened.
    pub opening: f64,
    /// The same as it was counted as friction dissipation.
    pub opening_dissipation: f64,
    /// What the increments of this step left over together.
    pub step: f64,
    /// Magnitudes of that of all steps before, summed.
    pub steps: f64,
    /// The most that an increment left over, by magnitude.
    pub worst: f64,
    /// Step and number of that increment.
    pub worst_at: [usize; 2],
    /// Its length [T].
    pub worst_dt: f64,
    /// Energy that heat added and that bodies which followed it freely took back, or the other way round,
    /// eq. (10.8).
    pub heat: f64,
    /// The most that energies said nothing about, eq. (10.10).
    pub unsure: f64,
    /// Energy that the model held before and after the last increment.
    pub held: (f64, f64),
    /// The least and the most that it held.
    pub range: (f64, f64),
    /// What an increment changed at once and did not see, the worst one.
    pub sudden: Sudden,
}

/// An increment that loads or unloads the parts and leaves as much over: what happened in
/// between is in none of its ends. docs/theory.md eq. (10.11)
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Sudden {
    /// What it left over, no more than what it changed in the energy held [F L].
    pub missed: f64,
    /// Step and number of the increment.
    pub at: [usize; 2],
    /// Its length [T].
    pub dt: f64,
}

impl Books {
    /// Takes the last increment into the sums.
    pub fn enter(&mut self, target: &Target) {
        if target.increment == 1 {
            self.steps += self.step.abs();
            self.step = 0.0;
        }
        self.step += self.left;
        if self.left.abs() > self.worst.abs() {
            self.worst = self.left;
            self.worst_at = [target.step, target.increment];
            self.worst_dt = target.dt;
        }
        let (before, after) = self.held;
        self.range = (self.range.0.min(after), self.range.1.max(after));
        let missed = self.left.abs().min((after - before).abs());
        if missed > self.sudden.missed {
            self.sudden = Sudden { missed, at: [target.step, target.increment], dt: target.dt };
        }
    }

    /// Part of all that the parts stored which one increment missed [1].
    pub fn missed(&self) -> f64 {
        let range = self.range.1 - self.range.0;
        if range > 0.0 { self.sudden.missed / range } else { 0.0 }
    }

    /// What all steps left unbalanced.
    pub fn unbalanced(&self) -> f64 {
        self.steps + self.step.abs()
    }
}
