//! A rigid body in the plane.

use super::super::search::chain::{flat, raised};
use crate::rigid::PointMap;

/// A rigid body in the plane: x = x_ref + R(phi)(X - X_ref).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Undeformed position of the reference node X_ref [L].
    pub reference: [f64; 3],
    /// Its dofs (ux, uy, phi).
    pub dofs: [f64; 3],
}

impl Body {
    /// A body whose frame is space.
    pub const STILL: Self = Self { reference: [0.0; 3], dofs: [0.0; 3] };

    /// How an undeformed position rides on the body.
    pub fn map(&self, position: [f64; 3]) -> PointMap {
        self.ride(flat(position))
    }

    pub(super) fn ride(&self, position: [f64; 2]) -> PointMap {
        let arm = [position[0] - self.reference[0], position[1] - self.reference[1]];
        PointMap::Arm { arm }
    }

    /// Current position of an undeformed one [L].
    pub fn to_space(&self, position: [f64; 3]) -> [f64; 3] {
        raised(self.carry(flat(position)))
    }

    pub(super) fn carry(&self, position: [f64; 2]) -> [f64; 2] {
        let u = self.ride(position).displacement(&self.dofs);
        [position[0] + u[0], position[1] + u[1]]
    }

    /// The undeformed position that is now at `point` [L].
    pub fn to_body(&self, point: [f64; 3]) -> [f64; 3] {
        raised(self.in_frame(point))
    }

    pub(super) fn in_frame(&self, point: [f64; 3]) -> [f64; 2] {
        let [x, y, _] = self.reference;
        let d = [point[0] - x - self.dofs[0], point[1] - y - self.dofs[1]];
        let (s, c) = self.dofs[2].sin_cos();
        [x + c * d[0] + s * d[1], y - s * d[0] + c * d[1]]
    }

    /// A direction in space as the body sees it.
    pub fn turn_back(&self, direction: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.dofs[2].sin_cos();
        let [x, y, z] = direction;
        [cos * x + sin * y, cos * y - sin * x, z]
    }
}
