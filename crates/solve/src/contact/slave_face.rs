//! A face of a slave surface where it stands.
//!
//! ```text
//!          ^ normal          d o-----o c
//!     o----|----o              |     |    counter-clockwise as seen from outside
//!     b   <--   a            a o-----o b
//! ```

use crate::dofs::Translations;
use slideline_mech::vector::{cross, size, sub};
use slideline_model::NodeIndex;
use std::ops::Deref;

/// A face of a slave surface by its corners: nodes, undeformed positions [L], dofs.
#[derive(Clone, Debug)]
pub(super) struct SlaveFace {
    pub(super) corners: Vec<(NodeIndex, [f64; 3], Translations)>,
    /// Distances of its nodes along an edge: two where its middle nodes are slaves [1].
    pub(super) parts: f64,
}

impl SlaveFace {
    /// Its corners at displacements `u`.
    pub(super) fn places(&self, u: &[f64]) -> Corners {
        Corners::of(self.corners.iter().map(|(_, from, dofs)| dofs.displace(*from, u)))
    }

    /// Its normal, of any length, and its size [L], at displacements `u`.
    pub(super) fn stands(&self, u: &[f64]) -> ([f64; 3], f64) {
        let at = |k: usize| self.corners[k].2.displace(self.corners[k].1, u);
        match self.corners.len() {
            // in the plane, the material on the left
            2 => {
                let [x, y, _] = sub(at(1), at(0));
                ([y, -x, 0.0], x.hypot(y))
            }
            count => {
                let [a, b] = match count {
                    3 => [sub(at(1), at(0)), sub(at(2), at(0))],
                    _ => [sub(at(2), at(0)), sub(at(3), at(1))],
                };
                let normal = cross(a, b);
                (normal, (0.5 * size(normal)).sqrt())
            }
        }
    }
}

/// Corners of a face where it stands, two to four of them [L].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Corners {
    at: [[f64; 3]; 4],
    count: usize,
}

impl Corners {
    /// Those places, in their order.
    pub(super) fn of(places: impl Iterator<Item = [f64; 3]>) -> Self {
        let mut own = Self::default();
        for (into, at) in own.at.iter_mut().zip(places) {
            *into = at;
            own.count += 1;
        }
        own
    }
}

impl Deref for Corners {
    type Target = [[f64; 3]];

    fn deref(&self) -> &[[f64; 3]] {
        &self.at[..self.count]
    }
}
