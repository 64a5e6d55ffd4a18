//! The two precisions in which factors are held.

use faer::traits::ComplexField;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A real number of one of the two precisions.
pub(crate) trait Real:
    ComplexField
    + Copy
    + Send
    + Sync
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
{
    const ZERO: Self;
    const ONE: Self;
    /// Distance of one to the next number.
    const ROUNDING: f64;
    /// Half of all digits.
    const HALF: f64;

    /// The nearest number.
    fn from_double(value: f64) -> Self;
    fn to_double(self) -> f64;
}

impl Real for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const ROUNDING: f64 = f64::EPSILON;
    const HALF: f64 = 1.5e-8;

    #[inline(always)]
    fn from_double(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn to_double(self) -> f64 {
        self
    }
}

impl Real for f32 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const ROUNDING: f64 = f32::EPSILON as f64;
    const HALF: f64 = 3.5e-4;

    #[inline(always)]
    fn from_double(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn to_double(self) -> f64 {
        f64::from(self)
    }
}
