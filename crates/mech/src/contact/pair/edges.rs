//! Gap and slip put together for two edges that cross in space.
//!
//! ```text
//!     p0, q0   the places that are nearest now
//!     p_c, q_c the material places that were nearest at the last commit: slip = t . (p_c - q_c)
//! ```
//!
//! [docs/theory.md, section 5.18]

use super::super::gap::edges::{EdgeGap, VARIABLES, way_between, weights};
use super::super::search::faces::FacePlace;
use super::super::tangential::Tangential;
use super::faces::Footing;
use crate::vector::{Vector, add, dot, scale};

/// The places of two edges that were nearest at the last commit, where they stand now.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgesBefore {
    /// Ends of the slave edge and of the master edge [L].
    pub ends: [[Vector; 2]; 2],
    /// Shares of the second ends [1].
    pub at: [f64; 2],
}

/// Two edges that cross, with their slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Where they cross.
    pub gap: EdgeGap,
    /// Slip since the last commit [L].
    pub slip: Tangential,
    /// p_c - q_c [L], and the shares of these places.
    before: Option<(Vector, [f64; 2])>,
}

impl EdgePoint {
    /// A crossing; `before` is where it was. docs/theory.md eq. (5.51)
    pub fn new(gap: EdgeGap, before: Option<EdgesBefore>) -> Self {
        let before = before.map(|own| (way_between(own.ends, own.at), own.at));
        let slip = before
            .map_or(Tangential::ZERO, |(way, _)| Tangential(gap.directions.map(|t| dot(t, way))));
        Self { gap, slip, before }
    }

    /// The place on the slave edge [L].
    pub fn position(&self, slave: [Vector; 2]) -> Vector {
        let s = self.gap.at[0];
        add(scale(slave[0], 1.0 - s), scale(slave[1], s))
    }

    /// What is kept of it were its state committed, under the number of the crossing of these edges.
    pub fn footing(&self, number: usize) -> Footing {
        Footing {
            place: FacePlace { face: number, at: self.gap.at },
            normal: self.gap.normal,
            direction: self.gap.directions[0],
            bearing: [1.0, 0.0],
        }
    }

    /// Rows of overclosure, slips and drags, in this order: `add(row, is_before, end, value)` with the ends of the
    /// edges that cross, or of those that did at the last commit.
    pub fn rows(&self, mut add: impl FnMut(usize, bool, usize, Vector)) {
        let mut own = |row: usize, values: [f64; VARIABLES]| {
            for (end, value) in values.as_chunks::<3>().0.iter().enumerate() {
                add(row, false, end, *value);
            }
        };
        own(0, self.gap.gradient());
        for k in 0..2 {
            own(3 + k, self.gap.drag(k));
            match self.before {
                None => own(1 + k, self.gap.drag(k)),
                Some((way, _)) => own(1 + k, self.gap.direction_follows(k, way)),
            }
        }
        let Some((_, at)) = self.before else { return };
        for (k, t) in self.gap.directions.into_iter().enumerate() {
            for (end, weight) in weights(at).into_iter().enumerate() {
                add(1 + k, true, end, scale(t, weight));
            }
        }
    }
}
