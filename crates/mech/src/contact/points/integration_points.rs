//! Stations along a smooth line: where integrated contact is sampled.
//!
//! ```text
//!   node a                                            node b
//!     o----:----:----:----:----:----:----:----:----:----o      cells of equal length
//!                     [ x   x   x ]                            Gauss points of a cell
//!                       [ x x x ]                              the same, where contact begins
//!                                                              and ends inside the cell
//! ```
//!
//! History lives in the cells, which are material; the Gauss points of a cell follow the part of it
//! that is closed, so that the integral sees a smooth pressure that falls to zero at its ends. The
//! line is the cubic Hermite curve through the nodes whose end tangents turn with them.

use crate::rigid::{Blend, PointMap};

/// Gauss points of a cell.
pub const POINTS: usize = 3;

/// Places of the Gauss points on [0, 1] and their weights.
pub const GAUSS: [(f64, f64); POINTS] = [
    (0.112_701_665_379_258_31, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

/// A cubic Hermite line between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HermiteLine {
    /// Undeformed positions of the nodes [L].
    pub nodes: [[f64; 2]; 2],
    /// Undeformed tangents dx/dxi at the nodes [L], of the length of the line.
    pub tangents: [[f64; 2]; 2],
}

impl HermiteLine {
    /// The line between two nodes with these tangents at them [L], in the plane.
    pub fn new(nodes: [[f64; 3]; 2], tangents: [[f64; 3]; 2]) -> Self {
        let flat = |[x, y, _]: [f64; 3]| [x, y];
        Self { nodes: nodes.map(flat), tangents: tangents.map(flat) }
    }

    /// Corners of boxes about it for the dofs (x, y, phi) of both nodes, however they turn.
    pub fn corners(&self, dofs: &[f64; 6]) -> [[f64; 3]; 4] {
        // a cubic Hermite line leaves the box of its nodes by 4/27 of its tangents at most
        let [first, second] = self.tangents.map(|t| 0.15 * t[0].hypot(t[1]));
        let room = first + second;
        let mut corners = [[0.0; 3]; 4];
        for (k, [x, y]) in self.nodes.into_iter().enumerate() {
            let at = [x + dofs[3 * k], y + dofs[3 * k + 1]];
            corners[2 * k] = [at[0] - room, at[1] - room, 0.0];
            corners[2 * k + 1] = [at[0] + room, at[1] + room, 0.0];
        }
        corners
    }

    /// How the integration_point at `xi` in [0, 1] follows the nodes: Hermite polynomials on positions, and
    /// on the tangents as arms that turn.
    pub fn blend(&self, xi: f64) -> Blend {
        let rest = 1.0 - xi;
        let (h1, h2) = (xi * rest * rest, -xi * xi * rest);
        let first = rest * rest * (1.0 + 2.0 * xi);
        let scaled = |t: [f64; 2], by: f64| [by * t[0], by * t[1]];
        Blend {
            weights: [first, 1.0 - first],
            arms: [scaled(self.tangents[0], h1), scaled(self.tangents[1], h2)],
        }
    }

    /// Undeformed position of the integration_point at `xi` [L].
    pub fn reference(&self, xi: f64) -> [f64; 2] {
        let blend = self.blend(xi);
        let at =
            |c: usize| (0..2).map(|k| blend.weights[k] * self.nodes[k][c] + blend.arms[k][c]).sum();
        [at(0), at(1)]
    }

    /// The line in its current state, for the dofs (x, y, phi) of both nodes.
    pub fn bent(&self, dofs: &[f64; 6]) -> BentLine {
        let turned = |k: usize| {
            PointMap::Arm { arm: self.tangents[k] }.current_arm(&[0.0, 0.0, dofs[3 * k + 2]])
        };
        let (tangents, mut nodes) = ([turned(0), turned(1)], self.nodes);
        for (k, node) in nodes.iter_mut().enumerate() {
            *node = [node[0] + dofs[3 * k], node[1] + dofs[3 * k + 1]];
        }
        BentLine { nodes, tangents }
    }

    /// Undeformed chord [L].
    pub fn length(&self) -> f64 {
        let [a, b] = self.nodes;
        (b[0] - a[0]).hypot(b[1] - a[1])
    }
}

/// A Hermite line in its current state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentLine {
    nodes: [[f64; 2]; 2],
    tangents: [[f64; 2]; 2],
}

impl BentLine {
    /// Position of the integration point at `xi` [L].
    pub fn position(&self, xi: f64) -> [f64; 3] {
        let rest = 1.0 - xi;
        let (h1, h2) = (xi * rest * rest, -xi * xi * rest);
        let first = rest * rest * (1.0 + 2.0 * xi);
        let ([a, b], [s, t]) = (self.nodes, self.tangents);
        let at = |c: usize| a[c] + (1.0 - first) * (b[c] - a[c]) + h1 * s[c] + h2 * t[c];
        [at(0), at(1), 0.0]
    }
}

/// The part of a cell, in its own coordinate [0, 1], on which `f` is positive: the cell as a whole
/// where that is so at both ends and the middle, or nowhere (`None`) as far as these three and the
/// top of the parabola through them tell. `f` is the overclosure beyond the point where contact
/// begins; at most one stretch is looked for.
pub fn closed_part(f: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
    let known = [f(0.0), f(0.5), f(1.0)];
    closed_part_between(f, known)
}

/// The same where the values at both ends and the middle are known already.
pub fn closed_part_between(
    f: impl Fn(f64) -> f64,
    [left, middle, right]: [f64; 3],
) -> Option<(f64, f64)> {
    if left > 0.0 && right > 0.0 && middle > 0.0 {
        return Some((0.0, 1.0));
    }
    let inside = highest(&f, [left, middle, right])?;
    between_ends(&f, [left, right], inside)
}

/// The same of a function with one top between the ends, however sharp: that of two rounded bodies.
/// The values at both ends and the middle are known; where none is positive the top is looked for.
/// Where nothing is closed, half of the cell about the top: what closes first, and whether it is closed.
pub fn closed_part_of_one_top(
    f: impl Fn(f64) -> f64,
    [left, middle, right]: [f64; 3],
) -> ((f64, f64), bool) {
    if left > 0.0 && right > 0.0 && middle > 0.0 {
        return ((0.0, 1.0), true);
    }
    let known = [(0.5, middle), (0.0, left), (1.0, right)];
    let inside = known.into_iter().find(|own| own.1 > 0.0).unwrap_or_else(|| one_top(&f));
    let closed = if inside.1 > 0.0 { between_ends(&f, [left, right], inside) } else { None };
    match closed {
        Some(part) => (part, true),
        None => (((inside.0 - 0.25).max(0.0), (inside.0 + 0.25).min(1.0)), false),
    }
}

/// The first place where `f` turns out positive on the way to its one top on [0, 1], or that top, with its
/// value. Golden sections, to a thousandth: the top of what is smooth is as high as that to a millionth.
fn one_top(f: &impl Fn(f64) -> f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let (mut low, mut high) = (0.0, 1.0);
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let [mut a, mut b] = inner(low, high).map(|x| (x, f(x)));
    while high - low > 1e-3 {
        if a.1 > 0.0 || b.1 > 0.0 {
            break;
        }
        if a.1 > b.1 {
            high = b.0;
            b = a;
            let x = inner(low, high)[0];
            a = (x, f(x));
        } else {
            low = a.0;
            a = b;
            let x = inner(low, high)[1];
            b = (x, f(x));
        }
    }
    if a.1 > b.1 { a } else { b }
}

/// The part about a place where `f` is positive, its values at both ends known.
fn between_ends(
    f: &impl Fn(f64) -> f64,
    [left, right]: [f64; 2],
    inside: (f64, f64),
) -> Option<(f64, f64)> {
    let begin = if left > 0.0 { 0.0 } else { root(f, (0.0, left), inside) };
    let end = if right > 0.0 { 1.0 } else { root(f, (1.0, right), inside) };
    (end > begin).then_some((begin, end))
}

/// A place where `f` is positive, with its value.
fn highest(f: &impl Fn(f64) -> f64, [left, middle, right]: [f64; 3]) -> Option<(f64, f64)> {
    if middle > 0.0 {
        return Some((0.5, middle));
    }
    if left > 0.0 {
        return Some((0.0, left));
    }
    if right > 0.0 {
        return Some((1.0, right));
    }
    let bend = left - 2.0 * middle + right;
    if bend.is_nan() || bend >= 0.0 {
        return None;
    }
    // Top of the parabola, then once more about it: overclosure is close to one.
    let mut top = (0.5 - 0.25 * (right - left) / bend).clamp(0.0, 1.0);
    let step = 0.05;
    let (a, b, c) = (f(top - step), f(top), f(top + step));
    let bend = a - 2.0 * b + c;
    if bend < 0.0 {
        top = (top - 0.5 * step * (c - a) / bend).clamp(0.0, 1.0);
    }
    let value = f(top);
    (value > 0.0).then_some((top, value))
}

/// The zero of `f` between a place where it is not positive and one where it is: the false position
/// method of Illinois, which converges superlinearly and keeps its bracket.
fn root(f: &impl Fn(f64) -> f64, outside: (f64, f64), inside: (f64, f64)) -> f64 {
    let (mut low, mut high) = (outside, inside);
    let mut kept = 0;
    for _ in 0..40 {
        if (high.0 - low.0).abs() <= 1e-14 || low.1 == 0.0 {
            break;
        }
        let x = high.0 - high.1 * (high.0 - low.0) / (high.1 - low.1);
        let value = f(x);
        if value > 0.0 {
            high = (x, value);
            if kept == 1 {
                low.1 *= 0.5;
            }
            kept = 1;
        } else {
            low = (x, value);
            if kept == -1 {
                high.1 *= 0.5;
            }
            kept = -1;
        }
        if value == 0.0 {
            return x;
        }
    }
    high.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the curve passes through its nodes with the given tangents, is straight and
    /// uniform for straight reference geometry, and moves rigidly with its nodes. Tolerance:
    /// round-off.
    #[test]
    fn hermite_line() {
        let line =
            HermiteLine { nodes: [[1.0, 2.0], [4.0, 6.0]], tangents: [[3.0, 4.0], [3.0, 4.0]] };
        for xi in [0.0, 0.3, 0.5, 1.0] {
            let x = line.reference(xi);
            assert!((x[0] - 1.0 - 3.0 * xi).abs() < 1e-14 && (x[1] - 2.0 - 4.0 * xi).abs() < 1e-14);
            // Turned by phi about the origin and shifted.
            let phi = 0.7_f64;
            let (s, c) = phi.sin_cos();
            let moved = |p: [f64; 2]| [c * p[0] - s * p[1] + 0.2, s * p[0] + c * p[1] - 0.1];
            let mut dofs = [0.0; 6];
            for k in 0..2 {
                let [x, y] = line.nodes[k];
                let [u, v] = moved([x, y]);
                dofs[3 * k..3 * k + 3].copy_from_slice(&[u - x, v - y, phi]);
            }
            let u = line.blend(xi).displacement(&dofs);
            let expected = moved(x);
            let bent = line.bent(&dofs).position(xi);
            assert!((bent[0] - expected[0]).abs() < 1e-14);
            assert!((bent[1] - expected[1]).abs() < 1e-14);
            assert!((x[0] + u[0] - expected[0]).abs() < 1e-14);
            assert!((x[1] + u[1] - expected[1]).abs() < 1e-14);
        }
    }

    /// Requirement: the closed part of a parabola is found to round-off, also where it lies between
    /// the three places looked at first; none is found where there is none.
    #[test]
    fn closed_part_of_a_parabola() {
        for (centre, half) in [(0.5, 0.1), (0.3, 0.02), (0.9, 0.4), (0.05, 0.2), (0.71, 0.003)] {
            let f = |x: f64| half * half - (x - centre) * (x - centre);
            let (begin, end) = closed_part(f).unwrap();
            assert!((begin - f64::max(0.0, centre - half)).abs() < 1e-9, "{centre} {begin}");
            assert!((end - f64::min(1.0, centre + half)).abs() < 1e-9, "{centre} {end}");
        }
        assert_eq!(closed_part(|x| -1.0 - x * x), None);
        assert_eq!(closed_part(|_| 1.0), Some((0.0, 1.0)));
    }

    /// Requirement: the closed part of two circles that overlap is found to round-off however small the
    /// one with the sharp top is against the stretch; none is found where they do not overlap.
    #[test]
    fn closed_part_of_a_sharp_top() {
        for (centre, radius) in [(0.37, 0.02_f64), (0.81, 0.3), (0.06, 1e-3), (0.5, 2.0)] {
            for deep in [1e-3, 0.03, 0.3] {
                let depth = deep * radius;
                let f = |x: f64| radius - (radius - depth).hypot(x - centre);
                let half = (radius * radius - (radius - depth) * (radius - depth)).sqrt();
                let ((begin, end), closed) = closed_part_of_one_top(f, [0.0, 0.5, 1.0].map(f));
                assert!(closed);
                assert!((begin - f64::max(0.0, centre - half)).abs() < 1e-9, "{centre} {begin}");
                assert!((end - f64::min(1.0, centre + half)).abs() < 1e-9, "{centre} {end}");
                let apart = |x: f64| radius - (radius + depth).hypot(x - centre);
                let ((begin, end), closed) =
                    closed_part_of_one_top(apart, [0.0, 0.5, 1.0].map(apart));
                assert!(!closed && begin <= centre && centre <= end, "{centre}");
            }
        }
    }
}
