//! A comb of axial springs over the crest of a circle: an exact test of contact
//! force and friction onset [verification: comb].
//!
//! ```text
//!   ||  ||  ||  ||   columns of stiffness k, tips on one line
//!   ||  ||  ||  ||
//!          .--.      crest d above the line of tips
//!         (    )  -> one tip touched after every increment
//! ```

use crate::error::TheoryError;
use crate::numerics::root;
use crate::softened_law::ExponentialLaw;

/// Force k d [F] of a column of stiffness `stiffness` [F/L] under hard contact
/// with a crest `rise` [L] above its tip.
pub fn hard_force(stiffness: f64, rise: f64) -> f64 {
    stiffness * rise
}

/// Force [F] and overclosure [L] under softened contact of tributary area `area`
/// [L2]: the root h of k (d - h) = A p(h).
///
/// # Errors
/// [`TheoryError::InvalidInput`] for values that are not positive,
/// [`TheoryError::NoContact`] if the crest stays c0 or more below the tip.
pub fn softened_force(
    stiffness: f64,
    rise: f64,
    area: f64,
    law: &ExponentialLaw,
) -> Result<(f64, f64), TheoryError> {
    law.check()?;
    super::positive(stiffness, "the stiffness must be positive")?;
    super::positive(area, "the tributary area must be positive")?;
    if rise <= -law.clearance {
        return Err(TheoryError::NoContact { gap: -rise });
    }
    let h = root::bracketed(
        |h| stiffness * (rise - h) - area * law.at(h).pressure,
        -law.clearance,
        rise,
    )?;
    Ok((area * law.at(h).pressure, h))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the table of verification section 4 (gate 1e-9 relative).
    #[test]
    fn table() {
        let law = ExponentialLaw::diehl();
        assert!((hard_force(1e6, 2e-5) - 20.0).abs() < 1e-13);
        for (area, normal, friction) in
            [(2.5e-4, 28.0894659, 8.42683976), (1.25e-4, 27.3809727, 8.21429182)]
        {
            let (force, h) = softened_force(1e6, 2e-5, area, &law).unwrap();
            assert!((force - normal).abs() < 6e-8, "{force}");
            assert!((0.3 * force - friction).abs() < 6e-9, "{force}");
            assert!((1e6 * (2e-5 - h) / force - 1.0).abs() < 1e-13);
        }
        assert!(softened_force(1e6, -1e-5, 1e-4, &law).is_err());
    }
}
