//! What three rotation dofs of a node in space mean: a rotation vector, begun anew before it is a
//! full turn long.
//!
//! ```text
//!   R(u) = exp(u - c) B       at rest c = 0, B = 1: u is the rotation vector of the node
//!                             |u - c| > pi when committed: B := R(u), c := u
//! ```
//! docs/theory.md eq. (3.70).

use crate::rotation::{self, Quaternion};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Where the rotation dofs of a node count from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Turn {
    /// Rotations u at the start, c [1].
    pub start: [f64; 3],
    /// What the node had turned by then, B.
    pub before: Quaternion,
}

impl Turn {
    /// From the undeformed model on.
    pub const REST: Self = Self { start: [0.0; 3], before: rotation::REST };

    /// The rotation vector since the start, u - c [1].
    pub fn vector(&self, u: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| u[k] - self.start[k])
    }

    /// The rotation at the dofs `u` [1].
    pub fn rotation(&self, u: [f64; 3]) -> Quaternion {
        rotation::after(&rotation::quaternion(&self.vector(u)), &self.before)
    }

    /// How an arm [L] stands at the start, and how far its end had moved by then.
    pub fn arm(&self, arm: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let moved = rotation::displacement_by(&self.before, &arm);
        (std::array::from_fn(|k| arm[k] + moved[k]), moved)
    }

    /// What committed rotations `u` count from: a new start where they are more than half a turn
    /// away from this one.
    pub fn committed(self, u: [f64; 3]) -> Self {
        let [x, y, z] = self.vector(u);
        if x * x + y * y + z * z <= PI * PI {
            return self;
        }
        let before = self.rotation(u);
        let size = before.iter().map(|part| part * part).sum::<f64>().sqrt();
        Self { start: u, before: before.map(|part| part / size) }
    }
}

impl Default for Turn {
    fn default() -> Self {
        Self::REST
    }
}
