//! Derivatives of a converged increment, as they are told.

use super::frame::Frame;

/// How a converged increment follows a parameter of its model.
#[derive(Clone, Copy, Debug)]
pub struct Sensitivity<'a> {
    /// Place of the parameter among those that were given.
    pub parameter: usize,
    /// Whether the derivative is that of one side: contact, friction or a material changes where
    /// the increment stands, or changed so in one before it.
    pub one_sided: bool,
    /// Neighbours of the increment, with what each counts.
    pub(crate) frames: &'a [(f64, Frame<'a>)],
}

impl Sensitivity<'_> {
    /// The derivative of a response that is a smooth function of a frame, in the unit of the
    /// response over that of the parameter.
    pub fn of(&self, response: impl Fn(&Frame<'_>) -> f64) -> f64 {
        self.frames.iter().map(|(weight, frame)| weight * response(frame)).sum()
    }

    /// Step, increment and total time that it belongs to; 0 and 0 without neighbours.
    pub fn at(&self) -> (usize, usize, f64) {
        let first = self.frames.first();
        first.map_or((0, 0, 0.0), |(_, own)| (own.step, own.increment, own.total_time))
    }
}
