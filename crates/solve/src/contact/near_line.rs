//! The part of a line of master nodes that lies about a slave node, without the rounding of its corners.
//!
//! ```text
//!     o--.   x      places about the slave node are held against the segments near it
//!         '--o------o     alone: their distance costs little
//! ```

use super::master::MasterSurface;
use slideline_mech::contact::search::chain::Piece;
use slideline_mech::vector::{size, sub};
use std::ops::Range;

/// Segments of a line about a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearLine<'a> {
    /// Nodes of the whole line where they stand [L].
    stand: &'a [[f64; 3]],
    /// The first of the segments, and the one behind the last.
    parts: [usize; 2],
    /// Part of a segment by which the line is prolonged at its ends [1].
    extension: f64,
}

impl<'a> NearLine<'a> {
    /// The segments within a way along a line from the piece that a node faces; `None` for other masters.
    pub fn about(
        master: &MasterSurface,
        (piece, stand): (&Piece, &'a [[f64; 3]]),
        way: f64,
    ) -> Option<Self> {
        let MasterSurface::Line { chain, itself: None, .. } = master else { return None };
        let Range { start, end } = piece.nodes();
        let (mut parts, length) =
            ([start, end - 1], |part: usize| size(sub(stand[part + 1], stand[part])));
        let mut left = [way; 2];
        while parts[0] > 0 && left[0] > 0.0 {
            parts[0] -= 1;
            left[0] -= length(parts[0]);
        }
        while parts[1] + 1 < stand.len() && left[1] > 0.0 {
            left[1] -= length(parts[1]);
            parts[1] += 1;
        }
        Some(Self { stand, parts, extension: chain.extension })
    }

    /// How deep a place stands behind the segments, whose material is on the right [L]; `None` beyond an end.
    pub fn depth(&self, at: [f64; 3]) -> Option<f64> {
        let last = self.stand.len() - 2;
        let (mut least, mut found) = (f64::INFINITY, None);
        for part in self.parts[0]..self.parts[1] {
            let from = self.stand[part];
            let (along, way) = (sub(self.stand[part + 1], from), sub(at, from));
            let square = along[0] * along[0] + along[1] * along[1];
            let free = (along[0] * way[0] + along[1] * way[1]) / square;
            let low = if part == 0 { -self.extension } else { 0.0 };
            let high = if part == last { 1.0 + self.extension } else { 1.0 };
            let xi = free.clamp(low, high);
            let (x, y) = (way[0] - xi * along[0], way[1] - xi * along[1]);
            if x * x + y * y >= least {
                continue;
            }
            least = x * x + y * y;
            found = match (free < low, free > high) {
                (true, _) if part == 0 => None,
                (_, true) if part == last => None,
                (true, _) => Some(self.outside(part)),
                (_, true) => Some(self.outside(part + 1)),
                _ => Some(along[0] * way[1] > along[1] * way[0]),
            };
        }
        found.map(|is_outside| if is_outside { -least.sqrt() } else { least.sqrt() })
    }

    /// Whether what is nearest to a node between two segments stands outside: the line turns towards its material.
    fn outside(&self, node: usize) -> bool {
        let [before, behind] =
            [node - 1, node].map(|part| sub(self.stand[part + 1], self.stand[part]));
        before[0] * behind[1] < before[1] * behind[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: depths behind a ridge and a valley by hand, outside negative; a sharp ridge has its whole wedge
    /// outside, and what is beyond an end faces nothing.
    #[test]
    fn places_about_a_ridge_and_a_valley() {
        let line = |stand| NearLine { stand, parts: [0, 2], extension: 0.1 };
        let ridge = [[-3.0, -4.0, 0.0], [0.0; 3], [3.0, -4.0, 0.0]];
        let valley = [[-3.0, 4.0, 0.0], [0.0; 3], [3.0, 4.0, 0.0]];
        let close = |found: Option<f64>, expected: f64| {
            assert!(
                found.is_some_and(|own| (own - expected).abs() < 1e-12),
                "{found:?} {expected}"
            );
        };
        close(line(&ridge).depth([0.0, 2.0, 0.0]), -2.0);
        close(line(&ridge).depth([0.9, 0.6, 0.0]), -1.08);
        close(line(&ridge).depth([0.0, -1.0, 0.0]), 0.6);
        close(line(&ridge).depth([1.5 + 0.8, -2.0 + 0.6, 0.0]), -1.0);
        close(line(&valley).depth([0.0, -2.0, 0.0]), 2.0);
        close(line(&valley).depth([0.0, 1.0, 0.0]), -0.6);
        let sharp = [[-0.1, -1.0, 0.0], [0.0; 3], [0.1, -1.0, 0.0]];
        close(line(&sharp).depth([0.5, 0.2, 0.0]), -0.29f64.sqrt());
        assert!(line(&ridge).depth([3.6, -4.8, 0.0]).is_none());
        close(line(&ridge).depth([3.15, -4.2, 0.0]), 0.0);
    }
}
