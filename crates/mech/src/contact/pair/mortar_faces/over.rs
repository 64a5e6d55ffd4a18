//! Where both surfaces end.
//!
//! ```text
//!   slave  ______________          the end of the master passes that of the slave: what it bounds
//!                        |         goes over smoothly into the end of the slave, and so does the
//!   master ----------------|       force that follows the bound
//! ```
//!
//! docs/theory.md section 5.11, where both surfaces end

use super::clip::{Corner, Overlap};
use super::couple::Couple;
use super::ends::Ends;
use super::shapes::{edge_between, pieces};
use crate::differentiate::Real;

/// Part of a cell beside an end of the slave in which bounds stand at it: there surfaces end together
/// [1].
const TOGETHER: f64 = 0.01;
/// Part of a cell beside an end of the slave in which bounds go over into it [1].
const WIDTH: f64 = 0.05;

/// A place on a cell after it went over, with its derivatives by the one before.
pub(super) type Moved<R> = ([R; 2], [[R; 2]; 2]);

impl<R: Real> Couple<'_, R> {
    /// Where a corner of the master upon a piece stands after it went over into the end of the slave; in
    /// coordinates of the piece.
    pub(super) fn end_upon(&self, overlap: &Overlap, corner: Corner, at: [R; 2]) -> Moved<R> {
        if !self.is_end(overlap, corner) {
            return unmoved(at);
        }
        let piece = pieces(self.slave.count)[overlap.piece];
        let edges = (0..piece.len()).filter(|&edge| self.is_at_end(piece, edge));
        edges.fold(unmoved(at), |(at, by), edge| {
            let (at, more) = match piece.len() {
                3 => on_triangle(edge, at),
                _ => on_square(edge, at),
            };
            (at, product(more, by))
        })
    }

    /// How far along an edge of a piece a corner stands after it went over into the end of the slave that
    /// the edge leaves, with the derivative.
    pub(super) fn end_along(
        &self,
        overlap: &Overlap,
        corner: Corner,
        (edge, along): (usize, R),
    ) -> (R, R) {
        let one = R::from_f64(1.0);
        if !self.is_end(overlap, corner) {
            return (along, one);
        }
        let piece = pieces(self.slave.count)[overlap.piece];
        let count = piece.len();
        let is_at_end = |edge: usize| self.is_at_end(piece, edge % count);
        // what runs along an end leaves those that meet it at its corners alone
        let [first, second] = if is_at_end(edge) {
            [is_at_end(edge + count - 1), is_at_end(edge + 1)]
        } else {
            [edge, (edge + 1) % count].map(|place| self.ends.slave.nodes[piece[place]])
        };
        let from = |distance: R, is_end: bool| blunt(distance).filter(|_| is_end);
        if let Some(moved) = from(along, first) {
            moved
        } else if let Some((distance, slope)) = from(one - along, second) {
            (one - distance, slope)
        } else {
            (along, one)
        }
    }

    /// Whether an edge of a piece of the slave, given its nodes, is one at which its surface ends.
    fn is_at_end(&self, piece: &[usize], edge: usize) -> bool {
        let ends = [piece[edge], piece[(edge + 1) % piece.len()]];
        let own = edge_between(self.slave.count, ends[0], ends[1]);
        own.is_some_and(|edge| self.ends.slave.edges[edge])
    }

    /// Whether a corner is where the surface of the master ends, and that of the slave near.
    fn is_end(&self, overlap: &Overlap, corner: Corner) -> bool {
        self.ends.slave.nodes.contains(&true) && self.is_bound(overlap, corner)
    }

    /// Whether a corner bounds what the master covers: where its surface ends or has a crease.
    pub(super) fn is_bound(&self, overlap: &Overlap, corner: Corner) -> bool {
        let Ends { master, .. } = &self.ends;
        let piece = pieces(self.master.count)[overlap.master_piece];
        match corner {
            Corner::Slave(_) => false,
            Corner::Master(k) | Corner::Upon { master: k, .. } => master.nodes[piece[k]],
            Corner::Crossing { master: ends, .. } => {
                let [a, b] = ends.map(|k| piece[k]);
                edge_between(self.master.count, a, b).is_some_and(|edge| master.edges[edge])
            }
        }
    }
}

/// The distance from an end after it went over, and its derivative.
fn blunt<R: Real>(distance: R) -> Option<(R, R)> {
    let number = |value: f64| R::from_f64(value);
    let (wide, over) = (number(WIDTH), number(WIDTH - TOGETHER));
    let sigma = (distance - number(TOGETHER)) / over;
    if sigma.value() >= 1.0 {
        return None;
    }
    if sigma.value() <= 0.0 {
        return Some((number(0.0), number(0.0)));
    }
    let (one, two, three) = (number(1.0), number(2.0), number(3.0));
    let whole = sigma * sigma * (wide * (three - two * sigma) - over * (one - sigma));
    let slope = sigma * (number(6.0) * wide * (one - sigma) / over + three * sigma - two);
    Some((whole, slope))
}

fn unmoved<R: Real>(at: [R; 2]) -> Moved<R> {
    (at, identity())
}

/// No change of place, by its derivatives.
pub(super) fn identity<R: Real>() -> [[R; 2]; 2] {
    let [nothing, one] = [0.0, 1.0].map(R::from_f64);
    [[one, nothing], [nothing, one]]
}

fn on_square<R: Real>(edge: usize, at: [R; 2]) -> Moved<R> {
    let [one, two] = [1.0, 2.0].map(R::from_f64);
    let axis = (edge + 1) % 2;
    let is_low = edge == 0 || edge == 3;
    let from = if is_low { one + at[axis] } else { one - at[axis] };
    let Some((distance, slope)) = blunt(from / two) else { return unmoved(at) };
    let (mut moved, mut by) = unmoved(at);
    moved[axis] = if is_low { two * distance - one } else { one - two * distance };
    by[axis][axis] = slope;
    (moved, by)
}

/// One barycentric coordinate goes over; the others keep their ratio.
fn on_triangle<R: Real>(edge: usize, at: [R; 2]) -> Moved<R> {
    let [nothing, one] = [0.0, 1.0].map(R::from_f64);
    let [x, y] = at;
    // the coordinate that vanishes along the edge, and its derivatives
    let (own, by_place) = match edge {
        0 => (y, [nothing, one]),
        1 => (one - x - y, [-one, -one]),
        _ => (x, [one, nothing]),
    };
    let Some((distance, slope)) = blunt(own) else { return unmoved(at) };
    let ratio = (one - distance) / (one - own);
    let by_own = (ratio - slope) / (one - own);
    let scaled = |axis: usize| {
        let by = std::array::from_fn(|other: usize| {
            let kept = if other == axis { ratio } else { nothing };
            kept + at[axis] * by_own * by_place[other]
        });
        (at[axis] * ratio, by)
    };
    let ([mut first, mut second], along) = ([scaled(0), scaled(1)], by_place.map(|by| slope * by));
    match edge {
        0 => second = (distance, along),
        1 => {}
        _ => first = (distance, along),
    }
    ([first.0, second.0], [first.1, second.1])
}

fn product<R: Real>(a: [[R; 2]; 2], b: [[R; 2]; 2]) -> [[R; 2]; 2] {
    a.map(|row| [0, 1].map(|column: usize| row[0] * b[0][column] + row[1] * b[1][column]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the map is continuous with its slope where it begins, ends at the edge with slope
    /// zero, and its derivatives are those of differences.
    #[test]
    fn bounds_go_over_smoothly() {
        for (edge, on) in [0, 1, 2].map(|edge| (edge, on_triangle as fn(usize, [f64; 2]) -> _)) {
            check(edge, [[0.4, 0.02], [0.6, 0.38], [0.02, 0.4]][edge], on);
        }
        for (edge, on) in [0, 1, 2, 3].map(|edge| (edge, on_square as fn(usize, [f64; 2]) -> _)) {
            check(edge, [[0.2, -0.96], [0.96, 0.3], [-0.2, 0.96], [-0.96, 0.1]][edge], on);
        }
        let (whole, slope) = blunt(WIDTH * (1.0 - 1e-9)).unwrap();
        assert!((whole - WIDTH).abs() < 1e-10 && (slope - 1.0).abs() < 1e-8);
        assert_eq!(blunt(TOGETHER), Some((0.0, 0.0)));
        assert_eq!(blunt(-1e-9), Some((0.0, 0.0)));
        assert_eq!(blunt(WIDTH), None);
    }

    fn check(edge: usize, at: [f64; 2], on: fn(usize, [f64; 2]) -> Moved<f64>) {
        let (moved, by) = on(edge, at);
        assert!((moved[0] - at[0]).abs() + (moved[1] - at[1]).abs() > 1e-4, "{edge}: {moved:?}");
        for axis in 0..2 {
            let h = 1e-7;
            let [up, down] = [h, -h].map(|h| {
                let mut at = at;
                at[axis] += h;
                on(edge, at).0
            });
            for k in 0..2 {
                let found = (up[k] - down[k]) / (2.0 * h);
                assert!((found - by[k][axis]).abs() < 1e-7, "{edge}: {found} {by:?}");
            }
        }
    }
}
