//! Derivatives of a converged increment, as they are told.

use super::frame::Frame;
use std::fmt;

/// Frames near an increment, whose weighted sums are derivatives.
pub(crate) trait Near {
    /// The weighted sum of a response.
    fn sum(&self, response: &dyn Fn(&Frame<'_>) -> f64) -> f64;
}

/// How a converged increment follows a parameter of its model.
#[derive(Clone, Copy)]
pub struct Sensitivity<'a> {
    /// Place of the parameter among those that were given.
    pub parameter: usize,
    /// Whether the derivative is that of one side: contact, friction or a material changes where
    /// the increment stands, or changed so in one before it.
    pub one_sided: bool,
    /// Step, increment and total time.
    pub(crate) numbers: (usize, usize, f64),
    /// Frames near the increment.
    pub(crate) near: &'a dyn Near,
}

impl Sensitivity<'_> {
    /// The derivative of a response that is a smooth function of a frame, in the unit of the
    /// response over that of the parameter.
    pub fn of(&self, response: impl Fn(&Frame<'_>) -> f64) -> f64 {
        self.near.sum(&response)
    }

    /// Step, increment and total time that it belongs to.
    pub fn at(&self) -> (usize, usize, f64) {
        self.numbers
    }
}

impl fmt::Debug for Sensitivity<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { parameter, one_sided, numbers, .. } = self;
        write!(
            f,
            "Sensitivity {{ parameter: {parameter}, one_sided: {one_sided}, at: {numbers:?} }}"
        )
    }
}
