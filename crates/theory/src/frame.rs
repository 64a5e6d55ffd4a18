//! Beam axes: origin at the clamp, xi along the beam, eta towards the circle.
//!
//! ```text
//!        eta
//!         |      ( O )
//!   clamp |=====================--> xi
//! ```

use crate::cantilever::Cantilever;

/// A circle in beam axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Circle {
    /// Centre (xi_c, eta_c) [L].
    pub centre: [f64; 2],
    /// Radius r [L].
    pub radius: f64,
}

/// Beam axes in the plane of the model.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    origin: [f64; 2],
    /// Unit vector xi.
    pub along: [f64; 2],
    /// Unit vector eta, on the side of the circle.
    pub across: [f64; 2],
    /// +1 if (xi, eta) is right-handed, else -1.
    pub handed: f64,
}

impl Frame {
    /// Axes of `beam` with eta towards `centre`. Diehl (1995) Figure 1a.
    pub fn facing(beam: &Cantilever, centre: [f64; 2]) -> Self {
        let length = beam.length();
        let along = [(beam.tip[0] - beam.base[0]) / length, (beam.tip[1] - beam.base[1]) / length];
        let left = [-along[1], along[0]];
        let to_centre = [centre[0] - beam.base[0], centre[1] - beam.base[1]];
        let handed = if dot(left, to_centre) < 0.0 { -1.0 } else { 1.0 };
        Self { origin: beam.base, along, across: [handed * left[0], handed * left[1]], handed }
    }

    /// Beam coordinates of a point. Diehl (1995) eq. (5).
    pub fn local(&self, point: [f64; 2]) -> [f64; 2] {
        let from_base = [point[0] - self.origin[0], point[1] - self.origin[1]];
        [dot(self.along, from_base), dot(self.across, from_base)]
    }

    /// Model components of a vector given in beam axes.
    pub fn vector(&self, v: [f64; 2]) -> [f64; 2] {
        [v[0] * self.along[0] + v[1] * self.across[0], v[0] * self.along[1] + v[1] * self.across[1]]
    }

    /// Model coordinates of a point given in beam axes.
    pub fn point(&self, p: [f64; 2]) -> [f64; 2] {
        let v = self.vector(p);
        [self.origin[0] + v[0], self.origin[1] + v[1]]
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
