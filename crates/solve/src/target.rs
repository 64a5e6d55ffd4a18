//! What an attempt at an increment aims at.

/// What an attempt aims at.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Step number from 1.
    pub step: usize,
    /// Increment number from 1.
    pub increment: usize,
    /// Attempt number from 1.
    pub attempt: usize,
    /// Time in the step at the end of the increment [T].
    pub step_time: f64,
    /// The increment [T].
    pub dt: f64,
}
