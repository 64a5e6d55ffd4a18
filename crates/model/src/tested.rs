//! Rubber and the tests that it was fitted to.

use slideline_diag::Span;
use slideline_mech::material::Rubber;
use slideline_mech::material::hyperelastic::Measured;

/// A rubber with its test data.
#[derive(Clone, Debug, PartialEq)]
pub struct Tested {
    /// Name of the material.
    pub material: String,
    /// The law that fits best.
    pub rubber: Rubber,
    /// Points of the tests that strain a specimen.
    pub tests: Vec<Measured>,
    /// Pressures [F/L2] and ratios of volumes [1].
    pub volumes: Vec<[f64; 2]>,
    /// The card that asks for the fit.
    pub origin: Span,
}
