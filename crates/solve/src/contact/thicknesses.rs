//! How thick the parts of pairs are, in the plane: what `parts` measures.
//!
//! ```text
//!     o--v--o--v--o      a number behind every face
//!     |  .  |  .  |
//! ```

/// How thick the parts of pairs are [L]; infinite where nothing is known.
#[derive(Clone, Debug, Default)]
pub struct Thicknesses {
    /// Behind the faces of every point that is spread over faces.
    pub(super) of_points: Vec<f64>,
    /// Behind the segments of every master.
    pub(super) of_masters: Vec<Vec<f64>>,
}

impl Thicknesses {
    /// Behind the faces of a point [L].
    pub fn of_point(&self, place: usize) -> f64 {
        self.of_points.get(place).copied().unwrap_or(f64::INFINITY)
    }

    /// Behind a segment of a master, by its place among those of the master itself [L].
    pub fn of_master(&self, pair: usize, segment: usize) -> f64 {
        let own = self.of_masters.get(pair).and_then(|own| own.get(segment));
        own.copied().unwrap_or(f64::INFINITY)
    }
}
