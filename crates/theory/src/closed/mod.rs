//! Closed forms for beams, contact and friction, one subject to a file.

pub mod bisshopp_drucker;
pub mod capstan;
pub mod comb;
pub mod elliptic;
pub mod follower;
pub mod hertz;
pub mod incline;
pub mod ring;
pub mod roll_up;
pub mod snap_fit;
pub mod stick_slip;
pub mod tension;
pub mod timoshenko;
pub mod toggle;
pub mod torsion;
pub mod tube;

use crate::error::TheoryError;

/// Refuses a value that is not positive and finite.
fn positive(value: f64, message: &'static str) -> Result<f64, TheoryError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(TheoryError::InvalidInput(message))
    }
}
