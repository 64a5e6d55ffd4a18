//! Forward second-order differentiation: a number that carries its gradient and Hessian.
//!
//! ```text
//!   f(a) ~ f + f' . d + 1/2 d . f'' . d      every operation keeps f, f', f''
//! ```
//!
//! Formulas are written once, generic over [`Real`]; called with `f64` they give the value, called
//! with [`Second`] the exact first and second derivatives to round-off.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number as the formulas of this crate need it: `f64`, or a number carrying derivatives.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The constant `value`, with zero derivatives.
    fn from_f64(value: f64) -> Self;
    /// The value without its derivatives.
    fn value(&self) -> f64;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Sine of an angle in radians.
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    fn cos(self) -> Self;
    /// Exponential function.
    fn exp(self) -> Self;
    /// `exp(x) - 1`, accurate for small x.
    fn exp_m1(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Angle of the point (`other`, `self`): `self` is the ordinate, as in `f64::atan2`.
    fn atan2(self, other: Self) -> Self;
    /// Absolute value; the derivative at zero is that from the right.
    fn abs(self) -> Self;
    /// Integer power.
    fn powi(self, power: i32) -> Self;
}

impl Real for f64 {
    fn from_f64(value: f64) -> Self {
        value
    }
    fn value(&self) -> f64 {
        *self
    }
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    fn sin(self) -> Self {
        f64::sin(self)
    }
    fn cos(self) -> Self {
        f64::cos(self)
    }
    fn exp(self) -> Self {
        f64::exp(self)
    }
    fn exp_m1(self) -> Self {
        f64::exp_m1(self)
    }
    fn ln(self) -> Self {
        f64::ln(self)
    }
    fn atan2(self, other: Self) -> Self {
        f64::atan2(self, other)
    }
    fn abs(self) -> Self {
        f64::abs(self)
    }
    fn powi(self, power: i32) -> Self {
        f64::powi(self, power)
    }
}

/// A function of one number by its value and first two derivatives there: f + f' dx + f'' dx^2/2 with
/// dx = 0, which carries the derivatives on.
pub fn taylor<R: Real>(x: R, [f, first, second]: [f64; 3]) -> R {
    let dx = x - R::from_f64(x.value());
    R::from_f64(f) + dx * (R::from_f64(first) + dx * R::from_f64(0.5 * second))
}

/// ln(1 + x), accurate for small x.
pub fn ln_1p<R: Real>(x: R) -> R {
    let inverse = 1.0 / (1.0 + x.value());
    taylor(x, [x.value().ln_1p(), inverse, -inverse * inverse])
}

/// A number with its gradient and Hessian with respect to `N` variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Second<const N: usize> {
    /// The value.
    pub value: f64,
    /// First derivatives with respect to the `N` variables.
    pub gradient: [f64; N],
    /// Second derivatives, symmetric.
    pub hessian: [[f64; N]; N],
}

impl<const N: usize> Second<N> {
    /// A constant: all derivatives zero.
    pub fn constant(value: f64) -> Self {
        Self { value, gradient: [0.0; N], hessian: [[0.0; N]; N] }
    }

    /// The variable number `index` (0 .. N) with the given value. An index outside gives a constant.
    pub fn variable(value: f64, index: usize) -> Self {
        let mut number = Self::constant(value);
        if let Some(entry) = number.gradient.get_mut(index) {
            *entry = 1.0;
        }
        number
    }

    /// All `N` variables at the given values.
    pub fn variables(values: &[f64; N]) -> [Self; N] {
        std::array::from_fn(|i| Self::variable(values[i], i))
    }

    /// f(self), given f, f', f'' at the value (chain rule).
    fn chain(self, f: f64, first: f64, second: f64) -> Self {
        let g = &self.gradient;
        Self {
            value: f,
            gradient: std::array::from_fn(|i| first * g[i]),
            hessian: std::array::from_fn(|i| {
                std::array::from_fn(|j| first * self.hessian[i][j] + second * g[i] * g[j])
            }),
        }
    }

    fn combine(self, other: Self, a: f64, b: f64, value: f64) -> Self {
        Self {
            value,
            gradient: std::array::from_fn(|i| a * self.gradient[i] + b * other.gradient[i]),
            hessian: std::array::from_fn(|i| {
                std::array::from_fn(|j| a * self.hessian[i][j] + b * other.hessian[i][j])
            }),
        }
    }
}

impl<const N: usize> Add for Second<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.combine(other, 1.0, 1.0, self.value + other.value)
    }
}

impl<const N: usize> Sub for Second<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.combine(other, 1.0, -1.0, self.value - other.value)
    }
}

impl<const N: usize> Mul for Second<N> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (f, g) = (&self.gradient, &other.gradient);
        let mut product = self.combine(other, other.value, self.value, self.value * other.value);
        for i in 0..N {
            for j in 0..N {
                product.hessian[i][j] += f[i] * g[j] + g[i] * f[j];
            }
        }
        product
    }
}

impl<const N: usize> Div for Second<N> {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl)] // a / b = a * b^-1
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.value;
        let square = inverse * inverse;
        self * other.chain(inverse, -square, 2.0 * square * inverse)
    }
}

impl<const N: usize> Neg for Second<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0, 0.0)
    }
}

impl<const N: usize> Real for Second<N> {
    fn from_f64(value: f64) -> Self {
        Self::constant(value)
    }
    fn value(&self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root, -0.25 / (root * self.value))
    }
    fn sin(self) -> Self {
        let (s, c) = self.value.sin_cos();
        self.chain(s, c, -s)
    }
    fn cos(self) -> Self {
        let (s, c) = self.value.sin_cos();
        self.chain(c, -s, -c)
    }
    fn exp(self) -> Self {
        let e = self.value.exp();
        self.chain(e, e, e)
    }
    fn exp_m1(self) -> Self {
        let e = self.value.exp();
        self.chain(self.value.exp_m1(), e, e)
    }
    fn ln(self) -> Self {
        let inverse = 1.0 / self.value;
        self.chain(self.value.ln(), inverse, -inverse * inverse)
    }
    fn atan2(self, other: Self) -> Self {
        let (y, x) = (self.value, other.value);
        let square = x * x + y * y;
        // d theta = (x dy - y dx) / (x^2 + y^2), differentiated once more by the product rule.
        let (by_y, by_x) = (x / square, -y / square);
        let mut angle = self.combine(other, by_y, by_x, y.atan2(x));
        let mixed = (y * y - x * x) / (square * square);
        let twice = 2.0 * x * y / (square * square);
        let (f, g) = (&self.gradient, &other.gradient);
        for i in 0..N {
            for j in 0..N {
                angle.hessian[i][j] +=
                    twice * (g[i] * g[j] - f[i] * f[j]) + mixed * (f[i] * g[j] + g[i] * f[j]);
            }
        }
        angle
    }
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }
    fn powi(self, power: i32) -> Self {
        let n = f64::from(power);
        let first = if power == 0 { 0.0 } else { n * self.value.powi(power - 1) };
        let second =
            if power == 0 || power == 1 { 0.0 } else { n * (n - 1.0) * self.value.powi(power - 2) };
        self.chain(self.value.powi(power), first, second)
    }
}
