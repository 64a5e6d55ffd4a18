//! The mean magnitude of nodal forces and moments: the flux q that residuals are held against.

/// Mean nodal force and moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flux {
    force: (f64, f64),
    moment: (f64, f64),
}

impl Flux {
    /// Counts a nodal force [F].
    pub fn force(&mut self, magnitude: f64) {
        self.force = (self.force.0 + magnitude, self.force.1 + 1.0);
    }

    /// Counts a nodal moment [F L].
    pub fn moment(&mut self, magnitude: f64) {
        self.moment = (self.moment.0 + magnitude, self.moment.1 + 1.0);
    }

    /// Mean force [F].
    pub fn mean_force(&self) -> f64 {
        if self.force.1 > 0.0 { self.force.0 / self.force.1 } else { 0.0 }
    }

    /// Mean moment [F L].
    pub fn mean_moment(&self) -> f64 {
        if self.moment.1 > 0.0 { self.moment.0 / self.moment.1 } else { 0.0 }
    }
}
