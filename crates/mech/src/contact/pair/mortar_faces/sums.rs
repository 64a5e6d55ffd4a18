//! The mortar integrals of an overlap.
//!
//! ```text
//!   area of a corner  D = int L dA      weighted gap  r = int L g dA
//! ```
//!
//! docs/theory.md eq. (5.33)

use super::clip::Overlap;
use super::couple::Couple;
use super::places::{Place, add_scaled, sub, zero};
use super::shapes::{MOST_CORNERS, MOST_NODES, corners};

/// Integrals of the corners of a slave face over an overlap, or over several.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sums {
    /// D [L2].
    pub areas: [f64; MOST_CORNERS],
    /// r, positive where open [L3].
    pub gaps: [f64; MOST_CORNERS],
}

/// Weights of the nodes of both sides in the integrals of the corners [L2].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Weights {
    /// int L N of the slave, a corner each.
    pub slave: [[f64; MOST_NODES]; MOST_CORNERS],
    /// int L N of the master.
    pub master: [[f64; MOST_NODES]; MOST_CORNERS],
}

impl Sums {
    /// Adds those of another overlap.
    pub fn add(&mut self, other: &Self) {
        for k in 0..MOST_CORNERS {
            self.areas[k] += other.areas[k];
            self.gaps[k] += other.gaps[k];
        }
    }
}

impl Weights {
    /// Weighted way from the slave to the master of a corner, at places of both [L3].
    pub fn way(
        &self,
        corner: usize,
        slave: &[Place<f64>; MOST_NODES],
        master: &[Place<f64>; MOST_NODES],
    ) -> Place<f64> {
        let blended = |of: &[Place<f64>; MOST_NODES], by: &[f64; MOST_NODES]| {
            of.iter().zip(by).fold(zero(), |sum, (&at, &by)| add_scaled(sum, by, at))
        };
        sub(blended(master, &self.master[corner]), blended(slave, &self.slave[corner]))
    }
}

impl Couple<'_, f64> {
    /// The integrals over an overlap with the weights of the nodes; `None` where a place faces
    /// nothing.
    pub fn sums(&self, overlap: &Overlap) -> Option<(Sums, Weights)> {
        let placed = self.place(overlap)?;
        let (mut sums, mut weights) = (Sums::default(), Weights::default());
        let is_whole = self.stations(overlap, &placed, |station| {
            for corner in 0..corners(self.slave.count) {
                let share = station.share(corner);
                sums.areas[corner] += share;
                sums.gaps[corner] += share * station.met.gap;
                for node in 0..MOST_NODES {
                    weights.slave[corner][node] += share * station.slave.value[node];
                    weights.master[corner][node] += share * station.met.shapes.value[node];
                }
            }
        });
        is_whole.then_some((sums, weights))
    }
}
