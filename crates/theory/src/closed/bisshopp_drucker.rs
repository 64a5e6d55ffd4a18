//! Inextensible cantilever under a dead load at its tip, by elliptic integrals.
//!
//! ```text
//!  |\
//!  |========___         P
//!  |/          ``-_     |
//!                  `\   v
//!     |<-- L - u -->|\  tip angle a, deflection v
//! ```

use super::elliptic::{first_kind, second_kind};
use crate::error::TheoryError;
use crate::numerics::root;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

/// Shape of the loaded cantilever.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tip {
    /// Angle a of the tip [rad].
    pub angle: f64,
    /// Deflection v/L [-].
    pub deflection: f64,
    /// Shortening u/L of the projection on the undeformed axis [-].
    pub shortening: f64,
}

/// Load P L^2/EI [-] that turns the tip by `angle` [rad]: (K(k) - F(p1, k))^2 with
/// k^2 = (1 + sin a)/2, sin p1 = 1/(k sqrt 2) [Bisshopp and Drucker 1945].
///
/// # Errors
/// [`TheoryError::InvalidInput`] unless 0 < angle < pi/2.
pub fn load(angle: f64) -> Result<f64, TheoryError> {
    let (k, p1) = modulus(angle)?;
    Ok((first_kind(FRAC_PI_2, k)? - first_kind(p1, k)?).powi(2))
}

/// Tip of the cantilever under the load P L^2/EI [-].
///
/// # Errors
/// [`TheoryError::InvalidInput`] for a load that is not positive, or beyond the
/// range in which the tip angle can be told from pi/2 (about 300).
pub fn tip(load_parameter: f64) -> Result<Tip, TheoryError> {
    super::positive(load_parameter, "the load must be positive")?;
    let angle = root::fallible(|a| Ok(load(a)? - load_parameter), 1e-12, FRAC_PI_2 - 1e-7)?;
    let (k, p1) = modulus(angle)?;
    let bent = second_kind(FRAC_PI_2, k)? - second_kind(p1, k)?;
    Ok(Tip {
        angle,
        deflection: 1.0 - 2.0 * bent / load_parameter.sqrt(),
        shortening: 1.0 - (2.0 * angle.sin() / load_parameter).sqrt(),
    })
}

fn modulus(angle: f64) -> Result<(f64, f64), TheoryError> {
    if !(angle > 0.0 && angle < FRAC_PI_2) {
        return Err(TheoryError::InvalidInput("the tip angle must lie between 0 and pi/2"));
    }
    let k = (0.5 * (1.0 + angle.sin())).sqrt();
    Ok((k, (FRAC_1_SQRT_2 / k).min(1.0).asin()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the table of verification section 5, to its ten decimals.
    #[test]
    fn table() {
        let table = [
            [0.25, 0.1242924421, 0.0827459154, 0.0041178184],
            [0.5, 0.2445336471, 0.1621435757, 0.0159189625],
            [1.0, 0.4613519497, 0.3017207738, 0.0564332363],
            [2.0, 0.7817498316, 0.4934574804, 0.1606417208],
            [3.0, 0.9860169467, 0.6032534411, 0.2544201846],
            [4.0, 1.1212393475, 0.6699641813, 0.3289412422],
            [5.0, 1.2153681176, 0.7137915236, 0.3876283607],
            [6.0, 1.2836972858, 0.7445711489, 0.4345888287],
            [7.0, 1.3349598575, 0.7673690997, 0.4729274284],
            [8.0, 1.3744315067, 0.7849823750, 0.5048277321],
            [10.0, 1.4302855388, 0.8106090249, 0.5549955978],
            [15.0, 1.5018401542, 0.8477156743, 0.6352857804],
        ];
        for [p, a, v, u] in table {
            let tip = tip(p).unwrap();
            assert!((tip.angle - a).abs() < 6e-11, "{p}: {tip:?}");
            assert!((tip.deflection - v).abs() < 6e-11, "{p}: {tip:?}");
            assert!((tip.shortening - u).abs() < 6e-11, "{p}: {tip:?}");
        }
    }
}
