//! How far are two edges in space that cross, and how much has one slid along the other? Value and
//! derivatives.
//!
//! ```text
//!             d /
//!              /          p0 on the slave edge, q0 on the master edge: nearest places of both lines
//!   a --------x---- b     p0 - q0 = g n, n across both edges and out of the master
//!            /
//!           / c
//! ```
//!
//! [docs/theory.md, section 5.18]

use crate::vector::{Vector, add, cross, dot, scale, size, sub};

/// Sine of the angle between two edges below which they lie along one another and cross nowhere [1]: 5 degrees.
const PARALLEL: f64 = 0.087;

/// Coordinates of both edges: a, b of the slave, c, d of the master.
pub const VARIABLES: usize = 12;

/// Derivatives by the coordinates of both edges.
pub type Row = [f64; VARIABLES];

/// Shares of the second ends in a place of a slave edge and in one of a master edge [1].
pub type Shares = [f64; 2];

/// Two edges that cross.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeGap {
    /// Shares s and t of the second ends in the places that are nearest [1].
    pub at: Shares,
    /// Gap [L].
    pub gap: f64,
    /// Unit normal, out of the master [1].
    pub normal: Vector,
    /// Tangential directions: along the slave edge, and across it [1].
    pub directions: [Vector; 2],
    /// b - a and d - c [L].
    ways: [Vector; 2],
    /// Their duals in the plane across the normal [1/L].
    duals: [Vector; 2],
}

impl EdgeGap {
    /// The gap of two edges, a slave and a master, by their ends; `outward` tells on which side the master has its
    /// outside. `None` where they lie along one another. docs/theory.md eq. (5.50)
    pub fn new([slave, master]: [[Vector; 2]; 2], outward: Vector) -> Option<Self> {
        let ways @ [e, f] = [sub(slave[1], slave[0]), sub(master[1], master[0])];
        let across = cross(e, f);
        let whole = size(across);
        if !whole.is_finite() || whole <= PARALLEL * size(e) * size(f) {
            return None;
        }
        let sign = if dot(across, outward) < 0.0 { -1.0 } else { 1.0 };
        let normal = scale(across, sign / whole);
        let [by_e, by_f] = [cross(f, normal), cross(normal, e)];
        let duals = [scale(by_e, 1.0 / dot(e, by_e)), scale(by_f, 1.0 / dot(f, by_f))];
        let way = sub(slave[0], master[0]);
        let at = [-dot(duals[0], way), dot(duals[1], way)];
        let first = scale(e, 1.0 / size(e));
        let directions = [first, cross(normal, first)];
        Some(Self { at, gap: dot(normal, way), normal, directions, ways, duals })
    }

    /// Shares of a, b, c and d in p0 - q0 [1].
    pub fn weights(&self) -> [f64; 4] {
        weights(self.at)
    }

    /// Derivative of the overclosure -g [1].
    pub fn gradient(&self) -> Row {
        self.along(scale(self.normal, -1.0))
    }

    /// The drag along a tangential direction. docs/theory.md eq. (5.51)
    pub fn drag(&self, direction: usize) -> Row {
        self.drag_along(self.directions[direction])
    }

    /// Derivative of `vector` . t of a tangential direction t.
    pub fn direction_follows(&self, direction: usize, vector: Vector) -> Row {
        let first = self.directions[0];
        if direction == 0 {
            let mut row = self.of_way(0, vector);
            add_to(&mut row, &self.of_way(0, first), -dot(vector, first));
            return row.map(|own| own / size(self.ways[0]));
        }
        let mut row = self.direction_follows(0, cross(vector, self.normal));
        add_to(&mut row, &self.normal_follows(cross(first, vector)), 1.0);
        row
    }

    /// Derivative of `normal` d(-g) + `tangential` . drags: row-major. docs/theory.md eq. (5.52)
    pub fn derivative(
        &self,
        normal: f64,
        tangential: [f64; 2],
        into: &mut [f64; VARIABLES * VARIABLES],
    ) {
        let turns = [0, 1].map(|k| self.of_way(k, self.normal));
        let places = self.duals.map(|dual| self.along(dual));
        for k in 0..2 {
            add_product(into, normal, &turns[k], &places[k]);
            add_product(into, normal, &places[k], &turns[k]);
            for l in 0..2 {
                let both = self.gap * dot(self.duals[k], self.duals[l]);
                add_product(into, normal * both, &turns[k], &turns[l]);
            }
        }
        let shares = self.shares_follow(&turns, &places);
        for (direction, force) in tangential.into_iter().enumerate() {
            if force != 0.0 {
                self.add_turning_drag(direction, force, (&turns, &shares), into);
            }
        }
    }

    /// Derivatives of s and t.
    fn shares_follow(&self, turns: &[Row; 2], places: &[Row; 2]) -> [Row; 2] {
        [(0, -1.0), (1, 1.0)].map(|(own, sign)| {
            let mut row = places[own].map(|value| sign * value);
            for (turn, dual) in turns.iter().zip(self.duals) {
                add_to(&mut row, turn, sign * self.gap * dot(self.duals[own], dual));
            }
            row
        })
    }

    /// Adds the derivative of a drag, times a force.
    fn add_turning_drag(
        &self,
        direction: usize,
        force: f64,
        (turns, shares): (&[Row; 2], &[Row; 2]),
        into: &mut [f64; VARIABLES * VARIABLES],
    ) {
        let t = self.directions[direction];
        for axis in 0..3 {
            let mut unit = [0.0; 3];
            unit[axis] = 1.0;
            let follows = self.direction_follows(direction, unit);
            add_product(into, force, &self.drag_along(unit), &follows);
        }
        add_product(into, force, &self.of_way(0, t), &shares[0]);
        add_product(into, -force, &self.of_way(1, t), &shares[1]);
        let along_normal = self.along(self.normal);
        let parts = self.duals.map(|dual| dot(t, dual));
        for (turn, part) in turns.iter().zip(parts) {
            add_product(into, force * part, turn, &along_normal);
        }
        let of_gap = force * self.gap;
        for k in 0..2 {
            for l in 0..2 {
                add_product(into, -of_gap * parts[l], &turns[k], &self.of_way(l, self.duals[k]));
                add_product(into, -of_gap * parts[k], &self.of_way(k, self.duals[l]), &turns[l]);
            }
        }
    }

    /// `vector` . (dp0 - dq0) at fixed shares.
    fn along(&self, vector: Vector) -> Row {
        row_of(self.weights().map(|weight| scale(vector, weight)))
    }

    /// `vector` . (dp0 - dq0 - g dn).
    fn drag_along(&self, vector: Vector) -> Row {
        let mut row = self.along(vector);
        add_to(&mut row, &self.normal_follows(vector), -self.gap);
        row
    }

    /// `vector` . dn, of one across n.
    fn normal_follows(&self, vector: Vector) -> Row {
        let mut row = [0.0; VARIABLES];
        for (k, dual) in self.duals.into_iter().enumerate() {
            add_to(&mut row, &self.of_way(k, self.normal), -dot(vector, dual));
        }
        row
    }

    /// `vector` . d(b - a), or . d(d - c).
    fn of_way(&self, way: usize, vector: Vector) -> Row {
        let mut parts = [[0.0; 3]; 4];
        (parts[2 * way], parts[2 * way + 1]) = (scale(vector, -1.0), vector);
        row_of(parts)
    }
}

/// Shares of the ends of both edges in the way from a place of the master edge to one of the slave edge [1].
pub fn weights([s, t]: Shares) -> [f64; 4] {
    [1.0 - s, s, t - 1.0, -t]
}

/// The way from a place of the master edge to one of the slave edge [L].
pub fn way_between([slave, master]: [[Vector; 2]; 2], at: Shares) -> Vector {
    let ends = [slave[0], slave[1], master[0], master[1]];
    let parts = ends.into_iter().zip(weights(at));
    parts.fold([0.0; 3], |sum, (end, weight)| add(sum, scale(end, weight)))
}

fn row_of(parts: [Vector; 4]) -> Row {
    std::array::from_fn(|k| parts[k / 3][k % 3])
}

fn add_to(into: &mut Row, row: &Row, factor: f64) {
    into.iter_mut().zip(row).for_each(|(into, own)| *into += factor * own);
}

fn add_product(into: &mut [f64; VARIABLES * VARIABLES], factor: f64, row: &Row, column: &Row) {
    for (into, own) in into.chunks_exact_mut(VARIABLES).zip(row) {
        into.iter_mut().zip(column).for_each(|(into, by)| *into += factor * own * by);
    }
}

#[cfg(test)]
mod tests;
