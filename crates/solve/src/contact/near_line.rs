//! The part of a line of master nodes that lies about a slave node, as it is drawn: without the rounding of its corners,
//! through its nodes where it is round.
//!
//! ```text
//!     o--.   x      places about the slave node are held against the segments near it
//!         '--o------o     alone: their distance costs little
//! ```

use super::master::MasterSurface;
use slideline_mech::contact::search::chain::{Chain, Piece, flat, raised};
use slideline_mech::vector::{size, sub};
use std::ops::Range;

/// Segments of a line about a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearLine<'a> {
    chain: &'a Chain,
    /// Nodes of the whole line where they stand [L].
    stand: &'a [[f64; 3]],
    /// The first of the segments, and the one behind the last.
    parts: [usize; 2],
}

impl<'a> NearLine<'a> {
    /// The segments within a way along a line from the piece that a node faces; `None` for other masters.
    pub fn about(
        master: &'a MasterSurface,
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
        Some(Self { chain, stand, parts })
    }

    /// How deep a place stands behind the segments, whose material is on the right [L]; `None` beyond an end.
    pub fn depth(&self, at: [f64; 3]) -> Option<f64> {
        let (last, extension) = (self.stand.len() - 2, self.chain.extension);
        let (mut least, mut found) = (f64::INFINITY, None);
        for part in self.parts[0]..self.parts[1] {
            let from = self.stand[part];
            let (along, way) = (sub(self.stand[part + 1], from), sub(at, from));
            let square = along[0] * along[0] + along[1] * along[1];
            let free = (along[0] * way[0] + along[1] * way[1]) / square;
            let low = if part == 0 { -extension } else { 0.0 };
            let high = if part == last { 1.0 + extension } else { 1.0 };
            let (foot, along) = self.foot(part, free.clamp(low, high));
            let [x, y, _] = sub(at, foot);
            if x * x + y * y >= least {
                continue;
            }
            least = x * x + y * y;
            found = match (free < low, free > high) {
                (true, _) if part == 0 => None,
                (_, true) if part == last => None,
                (true, _) if self.is_drawn(part) => Some(self.outside(part)),
                (_, true) if self.is_drawn(part + 1) => Some(self.outside(part + 1)),
                _ => Some(along[0] * y > along[1] * x),
            };
        }
        found.map(|is_outside| if is_outside { -least.sqrt() } else { least.sqrt() })
    }

    /// The place of a segment, or of the curve in its place, at a parameter, and its direction there [L].
    fn foot(&self, part: usize, xi: f64) -> ([f64; 3], [f64; 3]) {
        if let Some(curve) = self.chain.curve(part) {
            let (foot, along) = curve.place(self.stand, xi);
            return (raised(foot), raised(along));
        }
        let [from, to] = [part, part + 1].map(|node| flat(self.stand[node]));
        let along = [to[0] - from[0], to[1] - from[1]];
        (raised([0, 1].map(|axis| from[axis] + xi * along[axis])), raised(along))
    }

    /// Whether the line has a corner at a node.
    fn is_drawn(&self, node: usize) -> bool {
        !self.chain.is_joined(node)
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
        let chain = Chain::of_lengths([5.0; 2].into_iter(), 0.0, 0.1).unwrap();
        let line = |stand| NearLine { chain: &chain, stand, parts: [0, 2] };
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
