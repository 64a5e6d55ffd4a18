//! Gap of a point against a face in space, with its derivatives.
//!
//! ```text
//!               x slave               x = X(xi) + g n
//!               | g                   n = a_1 x a_2 / |a_1 x a_2|
//!        _______|________             a_k = dX/dxi_k
//!       /       o X(xi) /             the place follows the point: (x - X) . a_k = 0
//!      /_______________/
//! ```
//!
//! [docs/theory.md, section 5.9]

use crate::surface::patch::{MOST_PARTS, Parts, Patch, Place};
use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// The most variables of a gap against a face.
pub const MOST_VARIABLES: usize = 3 * MOST_PARTS;

/// No force on anything.
pub const NO_PARTS: Parts = [[0.0; 3]; MOST_PARTS];

/// A point against the place of a face that faces it.
#[derive(Debug, Clone)]
pub struct FaceGap {
    patch: Patch,
    place: Place,
    /// Place on the reference cell.
    pub at: [f64; 2],
    /// Gap g, open positive [L].
    pub gap: f64,
    /// Outward unit normal [1].
    pub normal: Vector,
    /// Position on the face [L].
    pub position: Vector,
    tangents: [Vector; 2],
    /// Those with a^k . a_l = 1 where k = l, else 0 [1/L].
    duals: [Vector; 2],
    /// n . d2X/dxi_k dxi_l [L].
    bend: [[f64; 2]; 2],
    /// n . da_k by the variables.
    turn: [Parts; 2],
    /// dxi_k by the variables [1/L].
    moves: [Parts; 2],
}

/// Tangential directions that were turned with the normal the shortest way from where they stood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turned {
    from: Vector,
    before: [Vector; 2],
    /// The directions [1].
    pub directions: [Vector; 2],
    to: Vector,
}

impl Turned {
    /// The directions `before`, across the normal `from`, turned to the normal `to`; `None` where
    /// that is the opposite one.
    pub fn new(from: Vector, before: [Vector; 2], to: Vector) -> Option<Self> {
        let whole = 1.0 + dot(from, to);
        if whole <= f64::EPSILON {
            return None;
        }
        let sum = add(from, to);
        let directions = before.map(|t| sub(t, scale(sum, dot(to, t) / whole)));
        Some(Self { from, before, directions, to })
    }

    /// The vector z with m . dt_k = z . dn.
    pub fn pull(&self, k: usize, m: Vector) -> Vector {
        let (sum, t) = (add(self.from, self.to), self.before[k]);
        let (whole, along) = (1.0 + dot(self.from, self.to), dot(self.to, t));
        let over = dot(m, sum) / whole;
        let z = sub(scale(self.from, along * over / whole), scale(t, over));
        sub(z, scale(m, along / whole))
    }
}

/// Two directions across a normal, the first one as near as can be to a given one.
pub fn directions_across(normal: Vector, near: Vector) -> [Vector; 2] {
    let across = sub(near, scale(normal, dot(near, normal)));
    let first = scale(across, 1.0 / size(across));
    [first, cross(normal, first)]
}

impl FaceGap {
    /// The gap of a point against the place `at` of a face that faces it; `None` where the face has
    /// collapsed, or where the point stands at the centre of its curvature.
    pub fn new(patch: Patch, at: [f64; 2], point: Vector) -> Option<Self> {
        let place = patch.place(at);
        let (tangents, normal) = patch.frame(&place)?;
        let position = patch.position(&place.value);
        let gap = dot(normal, sub(point, position));
        let duals = duals(tangents)?;
        let bend = second(&patch, &place, normal);
        let mut new = Self {
            at,
            gap,
            normal,
            position,
            tangents,
            duals,
            bend,
            turn: [NO_PARTS; 2],
            moves: [NO_PARTS; 2],
            patch,
            place,
        };
        new.follow().then_some(new)
    }

    /// Number of variables: three a part.
    pub fn width(&self) -> usize {
        3 * self.patch.parts()
    }

    /// The face.
    pub fn patch(&self) -> &Patch {
        &self.patch
    }

    /// Tangents by the coordinates of the face [L].
    pub fn tangents(&self) -> [Vector; 2] {
        self.tangents
    }

    /// Fills in how normal and place follow the variables.
    fn follow(&mut self) -> bool {
        for k in 0..2 {
            self.patch.pull(&self.place.first[k], self.normal, 1.0, &mut self.turn[k]);
        }
        // (a_kl - g b_kl) dxi_l = a_k . (dx - X_q dq) + g n . da_k
        let metric = |k: usize, l: usize| {
            dot(self.tangents[k], self.tangents[l]) - self.gap * self.bend[k][l]
        };
        let [a, b, c] = [metric(0, 0), metric(0, 1), metric(1, 1)];
        let whole = a * c - b * b;
        let own = |k: usize| dot(self.tangents[k], self.tangents[k]);
        if whole.abs() <= f64::EPSILON * own(0) * own(1) {
            return false;
        }
        let sides = [0, 1].map(|k| {
            let mut side = self.difference(self.tangents[k]);
            add_to(&mut side, &self.turn[k], self.gap);
            side
        });
        let inverse = [[c / whole, -b / whole], [-b / whole, a / whole]];
        for (moves, row) in self.moves.iter_mut().zip(inverse) {
            *moves = NO_PARTS;
            add_to(moves, &sides[0], row[0]);
            add_to(moves, &sides[1], row[1]);
        }
        true
    }

    /// m . (dx - X_q dq) at a fixed place.
    fn difference(&self, m: Vector) -> Parts {
        let mut parts = NO_PARTS;
        self.patch.pull(&self.place.value, m, -1.0, &mut parts);
        parts[0] = m;
        parts
    }

    /// n . da_k with the place let free: n . da_k at a fixed place + b_kl dxi_l.
    fn full_turn(&self, k: usize) -> Parts {
        let mut parts = self.turn[k];
        for l in 0..2 {
            add_to(&mut parts, &self.moves[l], self.bend[k][l]);
        }
        parts
    }

    /// z . dn by the variables.
    fn normal_follows(&self, z: Vector) -> Parts {
        let mut parts = NO_PARTS;
        for k in 0..2 {
            add_to(&mut parts, &self.full_turn(k), -dot(self.duals[k], z));
        }
        parts
    }

    /// dh of the overclosure h = -g.
    pub fn gradient(&self) -> Parts {
        self.difference(scale(self.normal, -1.0))
    }

    /// Direction of the force of a traction along `t`, a tangent: the slip of the point over the
    /// face that moves with it, so that force and moment balance at any gap. [docs/theory.md, eq. (5.19)]
    pub fn drag(&self, t: Vector) -> Parts {
        let mut parts = self.difference(t);
        for k in 0..2 {
            add_to(&mut parts, &self.turn[k], self.gap * dot(t, self.duals[k]));
        }
        parts
    }

    /// How the directions that turn with the normal carry `m`: m . dt_k by the variables.
    pub fn direction_follows(&self, turned: &Turned, k: usize, m: Vector) -> Parts {
        self.normal_follows(turned.pull(k, m))
    }

    /// Derivative of `normal` dh + `tangential`_k drag_k, row-major, with the directions of
    /// `turned`; written into the first `width` squared numbers of `into`. [docs/theory.md, eqs (5.17) and (5.19)]
    pub fn derivative(
        &self,
        normal: f64,
        (turned, tangential): (&Turned, [f64; 2]),
        into: &mut [f64],
    ) {
        let width = self.width();
        into[..width * width].fill(0.0);
        self.derivative_of_gradient(normal, into);
        for (k, force) in tangential.into_iter().enumerate() {
            if force != 0.0 {
                self.derivative_of_drag((turned, k), force, into);
            }
        }
    }

    /// Adds `factor` d2h.
    fn derivative_of_gradient(&self, factor: f64, into: &mut [f64]) {
        let width = self.width();
        for k in 0..2 {
            let own = self.difference(self.duals[k]);
            outer((&own, &self.full_turn(k)), factor, (into, width));
            outer((&self.turn[k], &self.moves[k]), factor, (into, width));
        }
        let weights = &self.place.value;
        self.patch.pull_twice(weights, self.normal, factor, &mut blocks(into, width));
    }

    /// Adds `factor` times the derivative of a drag.
    fn derivative_of_drag(&self, (turned, k): (&Turned, usize), factor: f64, into: &mut [f64]) {
        let (width, t) = (self.width(), turned.directions[k]);
        let share = self.duals.map(|dual| dot(t, dual));
        // dt . (dx - X_q dq) - t . X_qq dq - t . X_qk dxi_k
        for axis in 0..3 {
            let mut unit = [0.0; 3];
            unit[axis] = factor;
            let (own, by) = (self.difference(unit), self.direction_follows(turned, k, UNITS[axis]));
            outer((&own, &by), 1.0, (into, width));
        }
        self.patch.pull_twice(&self.place.value, t, -factor, &mut blocks(into, width));
        for l in 0..2 {
            let mut along = NO_PARTS;
            self.patch.pull(&self.place.first[l], t, 1.0, &mut along);
            outer((&along, &self.moves[l]), -factor, (into, width));
        }
        // d(g c_l) v_l, c_l = t . a^l
        let mut opening = self.gradient();
        opening.iter_mut().flatten().for_each(|value| *value = -*value);
        for l in 0..2 {
            let mut by = NO_PARTS;
            add_to(&mut by, &opening, share[l]);
            add_to(&mut by, &self.direction_follows(turned, k, self.duals[l]), self.gap);
            for (m, share) in share.into_iter().enumerate() {
                add_to(&mut by, &self.stretch(l, m), -self.gap * share);
            }
            outer((&self.turn[l], &by), factor, (into, width));
        }
        // g c_l dv_l
        for (l, share) in share.into_iter().enumerate() {
            self.derivative_of_turn(l, factor * self.gap * share, into);
        }
    }

    /// a^l . da_m with the place let free.
    fn stretch(&self, l: usize, m: usize) -> Parts {
        let mut parts = NO_PARTS;
        self.patch.pull(&self.place.first[m], self.duals[l], 1.0, &mut parts);
        for j in 0..2 {
            let second = self.patch.position(self.place.second(m, j));
            add_to(&mut parts, &self.moves[j], dot(self.duals[l], second));
        }
        parts
    }

    /// Adds `factor` times the derivative of n . da_l at a fixed place.
    fn derivative_of_turn(&self, l: usize, factor: f64, into: &mut [f64]) {
        let width = self.width();
        for m in 0..2 {
            let mut along = NO_PARTS;
            self.patch.pull(&self.place.first[l], self.duals[m], 1.0, &mut along);
            outer((&along, &self.full_turn(m)), -factor, (into, width));
            let mut second = NO_PARTS;
            self.patch.pull(self.place.second(l, m), self.normal, 1.0, &mut second);
            outer((&second, &self.moves[m]), factor, (into, width));
        }
        let weights = &self.place.first[l];
        self.patch.pull_twice(weights, self.normal, factor, &mut blocks(into, width));
    }
}

const UNITS: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// n . d2X by both coordinates.
fn second(patch: &Patch, place: &Place, normal: Vector) -> [[f64; 2]; 2] {
    [0, 1].map(|k| [0, 1].map(|l| dot(normal, patch.position(place.second(k, l)))))
}

/// The dual tangents; `None` where the tangents are parallel.
fn duals([a, b]: [Vector; 2]) -> Option<[Vector; 2]> {
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let whole = aa * bb - ab * ab;
    (whole > 0.0).then(|| {
        let of = |x: f64, y: f64| add(scale(a, x / whole), scale(b, y / whole));
        [of(bb, -ab), of(-ab, aa)]
    })
}

/// Adds `factor` times other parts.
pub fn add_to(into: &mut Parts, other: &Parts, factor: f64) {
    for (into, other) in into.iter_mut().zip(other) {
        *into = add(*into, scale(*other, factor));
    }
}

/// Adds factor a b' to a square matrix.
fn outer((a, b): (&Parts, &Parts), factor: f64, (into, width): (&mut [f64], usize)) {
    let b = &b.as_flattened()[..width];
    for (row, a) in into.chunks_exact_mut(width).zip(a.as_flattened()) {
        let a = factor * a;
        if a != 0.0 {
            row.iter_mut().zip(b).for_each(|(into, b)| *into += a * b);
        }
    }
}

/// Adds blocks of two parts to a square matrix.
fn blocks(into: &mut [f64], width: usize) -> impl FnMut(usize, usize, [Vector; 3]) + '_ {
    move |first, second, block| {
        for (i, row) in block.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                into[(3 * first + i) * width + 3 * second + j] += value;
            }
        }
    }
}

#[cfg(test)]
mod tests;
