//! Curves through the nodes of a chain whose segments are chords of something round.
//!
//! ```text
//!          .-o-.
//!       o'       'o          at a node the tangent of the parabola through it and its neighbours;
//!      /           \         between two nodes the cubic with their tangents
//!     o             o---o    a ridge, a valley, a chamfer: drawn as it is
//! ```
//!
//! docs/theory.md section 5.3. (derived)

use super::{Point, cross, dot, flat, nearest_parameter, sub};
use crate::surface::round::{FLAT, ONWARD};

/// Turn from which on a node is a corner, whatever it stands in [rad].
const CORNER: f64 = std::f64::consts::FRAC_PI_4;
/// Nodes that a curve follows.
pub const CONTROLS: usize = 4;

/// The curve in place of a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// The first of the nodes that it follows.
    pub first: usize,
    /// The one of them at which it begins.
    pub begin: usize,
    /// By which weights of these nodes its derivatives at both ends are made [1].
    pub tangents: [[f64; CONTROLS]; 2],
}

/// What is drawn through the nodes of a chain: nothing of one that is smoothed at its corners.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Through {
    /// Which nodes it passes with one tangent.
    joined: Vec<bool>,
    /// The curve in place of each segment, where there is one.
    curves: Vec<Option<Curve>>,
    /// Room for the turns at the nodes [rad].
    turns: Vec<f64>,
}

impl Through {
    /// Forgets all curves.
    pub fn clear(&mut self) {
        self.joined.clear();
        self.curves.clear();
    }

    /// Draws curves through the undeformed positions of the nodes, in the room there is.
    pub fn draw(&mut self, nodes: impl Iterator<Item = [f64; 3]> + Clone, lengths: &[f64]) {
        self.turns.clear();
        self.turns.push(0.0);
        let ways = nodes.clone().zip(nodes.skip(1)).map(|(a, b)| sub(flat(b), flat(a)));
        let pairs = ways.clone().zip(ways.skip(1));
        self.turns.extend(pairs.map(|(a, b)| cross(a, b).atan2(dot(a, b))));
        self.turns.push(0.0);
        let count = lengths.len() + 1;
        let Self { joined, curves, turns } = self;
        joined.clear();
        // a curve follows four nodes
        joined.extend((0..count).map(|node| count >= CONTROLS && is_joined(turns, node)));
        curves.clear();
        let all = (0..lengths.len()).map(|part| curve(joined, lengths, part));
        curves.extend(all);
    }

    /// Whether curves were drawn where the chain is round.
    pub fn is_drawn(&self) -> bool {
        !self.joined.is_empty()
    }

    /// Whether the chain passes a node with one tangent.
    pub fn is_joined(&self, node: usize) -> bool {
        self.joined.get(node).is_some_and(|&own| own)
    }

    /// The curve in place of a segment.
    pub fn curve(&self, part: usize) -> Option<&Curve> {
        self.curves.get(part)?.as_ref()
    }
}

/// Whether a node between others is straight, or one of three or more of something round that turns to one side.
fn is_joined(turns: &[f64], node: usize) -> bool {
    let last = turns.len() - 1;
    if node == 0 || node == last {
        return false;
    }
    let turn = turns[node].abs();
    if turn <= FLAT || turn >= CORNER {
        return turn <= FLAT;
    }
    let goes_on = |from: usize, to: usize| {
        let (own, next) = (turns[from], turns[to] * turns[from].signum());
        next > ONWARD * own.abs() && next < CORNER
    };
    let before = |at: usize| (at > 1 && goes_on(at, at - 1)).then(|| at - 1);
    let behind = |at: usize| (at + 1 < last && goes_on(at, at + 1)).then(|| at + 1);
    let sides = [before(node), behind(node)];
    let more = [sides[0].and_then(before), sides[1].and_then(behind)];
    sides.iter().all(Option::is_some) || more.iter().any(Option::is_some)
}

/// The curve between two nodes of which one is joined at least.
fn curve(joined: &[bool], lengths: &[f64], part: usize) -> Option<Curve> {
    let ends = [joined[part], joined[part + 1]];
    if ends == [false; 2] {
        return None;
    }
    let first = part.saturating_sub(1).min(joined.len() - CONTROLS);
    let begin = part - first;
    let chord = |at: usize, factor: f64, into: &mut [f64; CONTROLS]| {
        into[at] -= factor;
        into[at + 1] += factor;
    };
    // of the parabola through a node and both beside it, over the length of this segment
    let of_node = |node: usize| {
        let (before, behind) = (lengths[node - 1], lengths[node]);
        let (whole, own, at) = (before + behind, lengths[part], node - first);
        let mut weights = [0.0; CONTROLS];
        chord(at - 1, own * behind / (whole * before), &mut weights);
        chord(at, own * before / (whole * behind), &mut weights);
        weights
    };
    // a corner has the chord's: so its wedge and its rounding join; an end that of the parabola with the other tangent
    let of_end = |node: usize, other: [f64; CONTROLS]| {
        let is_corner = node != 0 && node != lengths.len();
        let mut weights = if is_corner { [0.0; CONTROLS] } else { other.map(|weight| -weight) };
        chord(begin, if is_corner { 1.0 } else { 2.0 }, &mut weights);
        weights
    };
    let tangents = match ends {
        [true, true] => [of_node(part), of_node(part + 1)],
        [true, false] => [of_node(part), of_end(part + 1, of_node(part))],
        _ => [of_end(part, of_node(part + 1)), of_node(part + 1)],
    };
    Some(Curve { first, begin, tangents })
}

impl Curve {
    /// Parameter at which a point faces the curve, in a range of it, and the place there [L]; `None` where it does
    /// not. `positions` are those of all nodes.
    pub(super) fn project(
        &self,
        positions: &[[f64; 3]],
        point: Point,
        range: (f64, f64),
    ) -> Option<(f64, Point)> {
        let polynomial = self.polynomial(positions);
        let value = |s: f64| {
            let (x, first, second) = at(&polynomial, s);
            let apart = sub(point, x);
            (dot(apart, first), dot(apart, second) - dot(first, first))
        };
        let parameter = nearest_parameter(value, range)?;
        Some((parameter, at(&polynomial, parameter).0))
    }

    /// The place of the curve at a parameter, and its derivative by that [L].
    pub fn place(&self, positions: &[[f64; 3]], s: f64) -> ([f64; 2], [f64; 2]) {
        let (x, first, _) = at(&self.polynomial(positions), s);
        (x, first)
    }

    /// Its coefficients by powers of the parameter [L].
    fn polynomial(&self, positions: &[[f64; 3]]) -> [Point; 4] {
        let nodes: [Point; CONTROLS] = std::array::from_fn(|k| flat(positions[self.first + k]));
        let sum = |weights: &[f64; CONTROLS]| {
            let part = |c: usize| weights.iter().zip(&nodes).map(|(w, x)| w * x[c]).sum();
            [part(0), part(1)]
        };
        let [t0, t1] = self.tangents.each_ref().map(sum);
        let (a, b) = (nodes[self.begin], nodes[self.begin + 1]);
        let chord = sub(b, a);
        let of = |f: &dyn Fn(usize) -> f64| [f(0), f(1)];
        let second = of(&|c| 3.0 * chord[c] - 2.0 * t0[c] - t1[c]);
        let third = of(&|c| t0[c] + t1[c] - 2.0 * chord[c]);
        [a, t0, second, third]
    }
}

/// A polynomial at a parameter, with its first two derivatives.
fn at([a, b, c, d]: &[Point; 4], s: f64) -> (Point, Point, Point) {
    let of = |f: &dyn Fn(usize) -> f64| [f(0), f(1)];
    (
        of(&|k| a[k] + s * (b[k] + s * (c[k] + s * d[k]))),
        of(&|k| b[k] + s * (2.0 * c[k] + 3.0 * s * d[k])),
        of(&|k| 2.0 * c[k] + 6.0 * s * d[k]),
    )
}

#[cfg(test)]
mod tests;
