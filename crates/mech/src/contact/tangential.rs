//! Vectors in the tangent plane of a contact point.
//!
//! ```text
//!        n
//!        |  / t2          plane: one direction t1, along the travel of the master
//!        | /              space: two directions t1, t2
//!        o------> t1
//! ```
//!
//! A slip, a traction or an elastic slip has D - 1 components in D dimensions. Both have room
//! here; in the plane the second one is zero and stays so, to the bit.

use std::ops::{Add, AddAssign, Div, Index, Mul, Neg, Sub};

/// Most tangential directions that a contact point has: those in space.
pub const MOST_DIRECTIONS: usize = 2;

/// A vector in the tangent plane, by the directions of the master at the point.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct Tangential(pub [f64; MOST_DIRECTIONS]);

/// A linear map of such vectors, row by row.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TangentialMap(pub [[f64; MOST_DIRECTIONS]; MOST_DIRECTIONS]);

impl Tangential {
    /// The zero vector.
    pub const ZERO: Self = Self([0.0; MOST_DIRECTIONS]);

    /// A vector along the first direction: all there is in the plane.
    pub const fn along(value: f64) -> Self {
        Self([value, 0.0])
    }

    /// Its length.
    pub fn size(self) -> f64 {
        match self.0 {
            [first, 0.0] => first.abs(),
            [first, second] => first.hypot(second),
        }
    }

    /// Its unit vector; zero of the zero vector.
    pub fn direction(self) -> Self {
        match self.size() {
            size if size > 0.0 => self / size,
            _ => Self::ZERO,
        }
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> f64 {
        self.0[0] * other.0[0] + self.0[1] * other.0[1]
    }

    /// Each component times that of another one.
    pub fn along_each(self, other: Self) -> Self {
        Self([self.0[0] * other.0[0], self.0[1] * other.0[1]])
    }

    /// The map v -> self (other . v).
    pub fn outer(self, other: Self) -> TangentialMap {
        TangentialMap(self.0.map(|own| other.0.map(|value| own * value)))
    }

    /// Whether every component is a finite number.
    pub fn is_finite(self) -> bool {
        self.0.iter().all(|value| value.is_finite())
    }
}

impl TangentialMap {
    /// The map that turns every vector into zero.
    pub const ZERO: Self = Self([[0.0; MOST_DIRECTIONS]; MOST_DIRECTIONS]);

    /// The map v -> factor v.
    pub const fn isotropic(factor: f64) -> Self {
        Self([[factor, 0.0], [0.0, factor]])
    }

    /// The map v -> factor (v - d (d . v)): what is left of a vector across the unit vector d.
    pub fn across(direction: Tangential, factor: f64) -> Self {
        let [x, y] = direction.0;
        Self([
            [factor * (1.0 - x * x), factor * (-x * y)],
            [factor * (-x * y), factor * (1.0 - y * y)],
        ])
    }

    /// The same with every row and every column times a factor of its own.
    pub fn scaled(self, rows: Tangential, columns: Tangential) -> Self {
        let row = |i: usize| Tangential(self.0[i]).along_each(rows.0[i] * columns).0;
        Self([row(0), row(1)])
    }

    /// Its entry in a row and column.
    pub fn at(self, row: usize, column: usize) -> f64 {
        self.0[row][column]
    }

    /// The map of a vector.
    pub fn apply(self, vector: Tangential) -> Tangential {
        Tangential(self.0.map(|row| Tangential(row).dot(vector)))
    }

    /// Whether every entry is a finite number.
    pub fn is_finite(self) -> bool {
        self.0.as_flattened().iter().all(|value| value.is_finite())
    }
}

impl Index<usize> for Tangential {
    type Output = f64;

    fn index(&self, direction: usize) -> &f64 {
        &self.0[direction]
    }
}

impl Add for Tangential {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }
}

impl AddAssign for Tangential {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Tangential {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self([self.0[0] - other.0[0], self.0[1] - other.0[1]])
    }
}

impl Neg for Tangential {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|value| -value))
    }
}

impl Mul<Tangential> for f64 {
    type Output = Tangential;

    fn mul(self, vector: Tangential) -> Tangential {
        Tangential(vector.0.map(|value| self * value))
    }
}

impl Div<f64> for Tangential {
    type Output = Self;

    fn div(self, by: f64) -> Self {
        Self(self.0.map(|value| value / by))
    }
}

impl Add for TangentialMap {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let mut sum = self;
        for (sum, other) in sum.0.as_flattened_mut().iter_mut().zip(other.0.as_flattened()) {
            *sum += other;
        }
        sum
    }
}

impl Mul<TangentialMap> for f64 {
    type Output = TangentialMap;

    fn mul(self, map: TangentialMap) -> TangentialMap {
        TangentialMap(map.0.map(|row| row.map(|value| self * value)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: in the plane all is as with numbers, to the bit.
    #[test]
    fn in_the_plane_a_vector_is_a_number() {
        for value in [-3.1e-7, 0.0, 0.1, 7e300] {
            let vector = Tangential::along(value);
            assert_eq!(vector.size(), value.abs());
            let sign = if value == 0.0 { 0.0 } else { value.signum() };
            assert_eq!(vector.direction(), Tangential::along(sign));
            assert_eq!(
                TangentialMap::across(Tangential::along(sign), 5.0).at(0, 0),
                5.0 - 5.0 * sign * sign
            );
        }
    }

    /// Requirement: what is across a direction has nothing along it. Tolerance: rounding.
    #[test]
    fn across_leaves_nothing_along() {
        let d = Tangential([3.0, -4.0]).direction();
        assert_eq!(d, Tangential([0.6, -0.8]));
        let left = TangentialMap::across(d, 2.0).apply(Tangential([0.3, 0.7]));
        assert!(left.dot(d).abs() < 1e-15);
        let whole = left + 2.0 * d.outer(d).apply(Tangential([0.3, 0.7]));
        assert!((whole - Tangential([0.6, 1.4])).size() < 1e-15);
    }
}
