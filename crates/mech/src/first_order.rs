//! Forward first-order differentiation: a number that carries its derivatives along `N` directions.
//!
//! ```text
//!   f(a) ~ f + f' . d      every operation keeps f and f'
//! ```
//!
//! A gradient that is written by hand over [`Real`] and called with [`First`] gives columns of the
//! second derivative, at a small multiple of its own cost.

use crate::differentiate::Real;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number with its derivatives along `N` directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct First<const N: usize> {
    /// The value.
    pub value: f64,
    /// Its derivatives.
    pub gradient: [f64; N],
}

impl<const N: usize> First<N> {
    /// A constant: all derivatives zero.
    pub const fn constant(value: f64) -> Self {
        Self { value, gradient: [0.0; N] }
    }

    /// The variable that direction `index` moves; an index outside gives a constant.
    pub fn variable(value: f64, index: usize) -> Self {
        let mut number = Self::constant(value);
        if let Some(entry) = number.gradient.get_mut(index) {
            *entry = 1.0;
        }
        number
    }

    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, gradient: self.gradient.map(|own| slope * own) }
    }

    fn combine(self, other: Self, (a, b): (f64, f64), value: f64) -> Self {
        let gradient = std::array::from_fn(|k| a * self.gradient[k] + b * other.gradient[k]);
        Self { value, gradient }
    }
}

impl<const N: usize> Add for First<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.combine(other, (1.0, 1.0), self.value + other.value)
    }
}

impl<const N: usize> Sub for First<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.combine(other, (1.0, -1.0), self.value - other.value)
    }
}

impl<const N: usize> Mul for First<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.combine(other, (other.value, self.value), self.value * other.value)
    }
}

impl<const N: usize> Div for First<N> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.combine(other, (1.0 / other.value, -value / other.value), value)
    }
}

impl<const N: usize> Neg for First<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const N: usize> Real for First<N> {
    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }
    fn value(&self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    fn sin(self) -> Self {
        let (s, c) = self.value.sin_cos();
        self.chain(s, c)
    }
    fn cos(self) -> Self {
        let (s, c) = self.value.sin_cos();
        self.chain(c, -s)
    }
    fn exp(self) -> Self {
        let e = self.value.exp();
        self.chain(e, e)
    }
    fn exp_m1(self) -> Self {
        self.chain(self.value.exp_m1(), self.value.exp())
    }
    fn ln(self) -> Self {
        self.chain(self.value.ln(), 1.0 / self.value)
    }
    fn atan2(self, other: Self) -> Self {
        let (y, x) = (self.value, other.value);
        let square = x * x + y * y;
        self.combine(other, (x / square, -y / square), y.atan2(x))
    }
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }
    fn powi(self, power: i32) -> Self {
        let slope = if power == 0 { 0.0 } else { f64::from(power) * self.value.powi(power - 1) };
        self.chain(self.value.powi(power), slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::differentiate::Second;

    fn formula<R: Real>([x, y, z]: [R; 3]) -> R {
        let one = R::from_f64(1.0);
        let first = (x * y).sin() / (one + z * z).sqrt() - (x - y).abs().ln();
        let second = y.atan2(x) * z.cos() + (-x).exp_m1() * y.powi(3) + z.exp();
        first * second + x.powi(0)
    }

    /// Requirement: derivatives are those of the second-order numbers. Tolerance: rounding.
    #[test]
    fn derivatives_are_those_of_second_order_numbers() {
        let at = [0.7, -0.4, 1.3];
        let first = formula(std::array::from_fn(|k| First::<3>::variable(at[k], k)));
        let second = formula(Second::variables(&at));
        assert!((first.value - second.value).abs() < 1e-14);
        for (own, other) in first.gradient.iter().zip(second.gradient) {
            assert!((own - other).abs() < 1e-13 * other.abs().max(1.0), "{own} {other}");
        }
    }
}
