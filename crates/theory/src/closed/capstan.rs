//! A limp chain drawn over a circle.
//!
//! ```text
//!       .---.
//!      /  o  \    wrap angle theta
//!  T1 |       | T2
//!     v       v
//! ```

use crate::error::TheoryError;

/// Ratio T2/T1 [-] of the limit of many links: exp(mu theta) (Euler).
pub fn limit_ratio(mu: f64, wrap: f64) -> f64 {
    (mu * wrap).exp()
}

/// Ratio T2/T1 [-] with all nodes of `segments` equal segments slipping:
/// [(1 + mu tan(D/2))/(1 - mu tan(D/2))]^n, D = theta/n (derived: each node turns the
/// tension by D, symmetric about its normal).
///
/// # Errors
/// [`TheoryError::InvalidInput`] for no segments or a turn of pi and more at a node;
/// [`TheoryError::Jamming`] for mu tan(D/2) >= 1.
pub fn polygon_ratio(mu: f64, wrap: f64, segments: u32) -> Result<f64, TheoryError> {
    let turn = wrap / f64::from(segments);
    if segments == 0 || turn.is_nan() || turn.abs() >= std::f64::consts::PI {
        return Err(TheoryError::InvalidInput("each node must turn the chain by less than pi"));
    }
    let t = mu * (0.5 * turn).tan();
    if t >= 1.0 {
        return Err(TheoryError::Jamming { transverse: 1.0 - t });
    }
    // log form: no loss for many segments
    Ok((2.0 * t.atanh() * f64::from(segments)).exp())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Requirement: verification section 6, to nine decimals.
    #[test]
    fn table() {
        assert!((limit_ratio(0.3, PI) - 2.566332395).abs() < 6e-10);
        assert!((limit_ratio(0.1, PI) - 1.369107771).abs() < 6e-10);
        for (n, ratio) in [(9, 2.593621883), (36, 2.568007497), (90, 2.566600144)] {
            assert!((polygon_ratio(0.3, PI, n).unwrap() - ratio).abs() < 6e-10, "{n}");
        }
        assert!(polygon_ratio(0.3, PI, 0).is_err());
        assert!(matches!(polygon_ratio(1.5, PI, 2), Err(TheoryError::Jamming { .. })));
    }
}
