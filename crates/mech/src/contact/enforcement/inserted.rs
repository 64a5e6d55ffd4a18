//! The law inserted: pressure and slope are those of the law.

use super::mixed::Scalar;

/// Value and slope of a law by its argument, in the form the composition needs.
pub fn inserted(value: f64, slope: f64) -> Scalar {
    Scalar { value, by_argument: slope, by_multiplier: 0.0, constraint: None }
}
