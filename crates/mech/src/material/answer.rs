//! What a material is asked and what it answers.

use super::tensor::{Matrix, Moduli, Symmetric};
use std::fmt::Debug;

/// What a material answers under.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conditions {
    /// Whether strains are not linearised.
    pub large: bool,
    /// Temperature [theta].
    pub temperature: f64,
    /// Temperature before the first step, at which it is free of stress [theta].
    pub initial: f64,
    /// What the clock shows.
    pub clock: Clock,
}

/// What a clock shows to a material.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Clock {
    /// Time that passes on the way from the committed state [T]: zero for instantaneous, infinite
    /// for long-term behaviour.
    pub passed: f64,
    /// Total time at the end of that way [T].
    pub total: f64,
}

/// What a material answers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    /// Cauchy stress where strains are small, Kirchhoff stress where large [F/L2].
    pub stress: Symmetric,
    /// Its moduli [F/L2].
    pub moduli: Moduli,
    /// Work done on the undeformed volume so far, dissipation included [F/L2].
    pub energy: f64,
    /// The part of it that is not given back [F/L2].
    pub dissipation: f64,
}

/// A material that somebody else has written.
pub trait Law: Debug + Send + Sync {
    /// Number of state variables of a point.
    fn states(&self) -> usize;

    /// Answers the displacement gradient H.
    fn respond(
        &self,
        gradient: &Matrix,
        under: &Conditions,
        committed: &[f64],
        state: &mut [f64],
    ) -> Answer;

    /// A stiffness that bounds that of a stretch [F/L2], for the rounding floor of residuals.
    fn stiffest(&self) -> f64;

    /// Shear modulus of small strains [F/L2].
    fn shear_modulus(&self) -> f64;
}
