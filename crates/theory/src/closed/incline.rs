//! A weight pushed up, or let down, a slope by a horizontal force.
//!
//! ```text
//!           /
//!   F ->[G]/
//!       __/ a
//! ```

use crate::error::TheoryError;

/// Horizontal force over weight F/G [-] that pushes up a slope of tangent `tan_a`:
/// (tan a + mu)/(1 - mu tan a) (derived).
///
/// # Errors
/// [`TheoryError::Jamming`] for mu tan a >= 1: no force pushes it up.
pub fn raising(tan_a: f64, mu: f64) -> Result<f64, TheoryError> {
    let transverse = 1.0 - mu * tan_a;
    if transverse > 0.0 {
        Ok((tan_a + mu) / transverse)
    } else {
        Err(TheoryError::Jamming { transverse })
    }
}

/// Horizontal force over weight F/G [-], directed down the slope, that lets the
/// weight down: (mu - tan a)/(1 + mu tan a) (derived); negative if it must be held.
pub fn lowering(tan_a: f64, mu: f64) -> f64 {
    (mu - tan_a) / (1.0 + mu * tan_a)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: NAFEMS CGS-4, verification section 6, to nine decimals.
    #[test]
    fn table() {
        for (mu, ratio) in [(0.0, 0.1), (0.1, 0.202020202), (0.3, 0.412371134)] {
            assert!((raising(0.1, mu).unwrap() - ratio).abs() < 6e-10);
        }
        assert!((lowering(0.1, 0.3) - 0.194174757).abs() < 6e-10);
        assert!(matches!(raising(2.0, 0.5), Err(TheoryError::Jamming { .. })));
    }

    /// Second derivation: balance of forces along and across the slope.
    #[test]
    fn balance() {
        let (a, mu): (f64, f64) = (0.4, 0.25);
        let f = raising(a.tan(), mu).unwrap();
        let (along, across) = (f * a.cos() - a.sin(), f * a.sin() + a.cos());
        assert!((along - mu * across).abs() < 1e-15);
    }
}
