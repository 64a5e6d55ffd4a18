//! Softened contact: pressure as an exponential function of overclosure.
//!
//! ```text
//!   p |            /
//!     |          _/
//!  p0 |........_/
//!     |    __--:
//!   --+--'-----+------ h
//!    -c0       0
//! ```

use crate::error::TheoryError;

/// Multiple of c0 beyond which the law goes on along its tangent [-]
/// [semantics: far penetration].
const LINEAR_BEYOND: f64 = 6.0;

/// The exponential pressure-overclosure law
/// p = p0/(e - 1) x (exp x - 1), x = 1 + h/c0 [semantics: softened contact, Abaqus form].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExponentialLaw {
    /// Clearance c0 at which the pressure vanishes [L].
    pub clearance: f64,
    /// Pressure p0 at zero clearance [F/L2].
    pub pressure: f64,
}

/// Pressure, its slope, and the energy stored, at one overclosure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawValue {
    /// Pressure p [F/L2].
    pub pressure: f64,
    /// Slope dp/dh [F/L3].
    pub slope: f64,
    /// Energy per area, the integral of p over h [F/L].
    pub energy: f64,
}

impl ExponentialLaw {
    /// The law of the 1995 decks: c0 = 1e-5 m, p0 = 4.8e6 Pa.
    pub const fn diehl() -> Self {
        Self { clearance: 1.0e-5, pressure: 4.8e6 }
    }

    /// Pressure, slope and energy at the overclosure `h` [L]. Zero for h <= -c0;
    /// continued along the tangent beyond h = 6 c0.
    pub fn at(&self, h: f64) -> LawValue {
        if h <= -self.clearance {
            return LawValue { pressure: 0.0, slope: 0.0, energy: 0.0 };
        }
        self.continued(h)
    }

    /// As [`ExponentialLaw::at`], but continued analytically below -c0: for
    /// integration up to the very point where the pressure ends.
    pub(crate) fn continued(&self, h: f64) -> LawValue {
        let limit = LINEAR_BEYOND * self.clearance;
        if h <= limit {
            return self.exponential(h);
        }
        let (end, beyond) = (self.exponential(limit), h - limit);
        LawValue {
            pressure: end.pressure + end.slope * beyond,
            slope: end.slope,
            energy: end.energy + (end.pressure + 0.5 * end.slope * beyond) * beyond,
        }
    }

    fn exponential(&self, h: f64) -> LawValue {
        let x = 1.0 + h / self.clearance;
        let (e, scale) = (x.exp_m1(), self.pressure / 1f64.exp_m1());
        LawValue {
            pressure: scale * x * e,
            slope: scale / self.clearance * (e + x * (e + 1.0)),
            energy: scale * self.clearance * energy_factor(x),
        }
    }

    /// Overclosure at which the pressure is `p` [F/L2]; `p` must be positive.
    ///
    /// # Errors
    /// [`TheoryError::InvalidInput`] for a pressure that is not positive and finite.
    pub fn overclosure(&self, p: f64) -> Result<f64, TheoryError> {
        if !(p.is_finite() && p > 0.0) {
            return Err(TheoryError::InvalidInput("the pressure must be positive"));
        }
        let limit = LINEAR_BEYOND * self.clearance;
        let end = self.exponential(limit);
        if p >= end.pressure {
            return Ok(limit + (p - end.pressure) / end.slope);
        }
        crate::numerics::root::bracketed(|h| self.at(h).pressure - p, -self.clearance, limit)
    }

    pub(crate) fn check(&self) -> Result<(), TheoryError> {
        if self.clearance > 0.0
            && self.pressure > 0.0
            && (self.clearance * self.pressure).is_finite()
        {
            Ok(())
        } else {
            Err(TheoryError::InvalidInput("c0 and p0 of the softened law must be positive"))
        }
    }
}

/// (x - 1) exp x + 1 - x^2/2, by its series where the terms cancel.
fn energy_factor(x: f64) -> f64 {
    if x > 0.3 {
        return (x - 1.0) * x.exp() + 1.0 - 0.5 * x * x;
    }
    // sum over n >= 3 of (n - 1) x^n / n!
    let (mut term, mut sum) = (0.5 * x * x, 0.0);
    for n in 3..24 {
        term *= x / f64::from(n);
        sum += f64::from(n - 1) * term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: the table of the law, to the seven digits it is given with.
    #[test]
    fn law_table() {
        let law = ExponentialLaw { clearance: 2.0, pressure: 3.0 };
        let table = [
            (-0.9, 0.006120702, 0.1255254, 0.0002015),
            (-0.5, 0.1887704, 0.8572994, 0.0294709),
            (-0.1, 0.7645095, 2.137744, 0.2031330),
            (0.0, 1.0, 2.581977, 0.2909883),
            (0.5, 3.039393, 5.938620, 1.231372),
            (1.0, 7.436564, 12.31880, 3.718282),
            (2.0, 33.32201, 46.17528, 21.34171),
            (3.0, 124.7715, 158.2923, 91.25072),
            (6.0, 4463.431, 5105.138, 3815.613),
        ];
        for (h, p, slope, energy) in table {
            let value = law.at(2.0 * h);
            assert!((value.pressure / 3.0 / p - 1.0).abs() < 5e-7, "p at {h}");
            assert!((value.slope * 2.0 / 3.0 / slope - 1.0).abs() < 5e-7, "slope at {h}");
            assert!((value.energy / 6.0 - energy).abs() < 6e-8 + 2e-7 * energy, "energy at {h}");
        }
    }

    /// Requirement: verification section 6, to the nine digits given.
    #[test]
    fn law_in_si_units() {
        let law = ExponentialLaw::diehl();
        for (h, p) in [
            (-9e-6, 29379.3718),
            (-5e-6, 906097.605),
            (0.0, 4.8e6),
            (5e-6, 14589086.0),
            (1e-5, 35695505.6),
        ] {
            let value = law.at(h).pressure;
            assert!((value / p - 1.0).abs() < 5e-9, "{h}: {value}");
        }
        assert!((law.at(0.0).slope / 1.23934882e12 - 1.0).abs() < 5e-9);
        assert_eq!(law.at(-1e-5).pressure, 0.0);
    }

    /// Slope and pressure are the derivatives of pressure and energy, also
    /// beyond 6 c0; the tolerance is that of the central difference.
    #[test]
    fn derivatives_agree_with_differences() {
        let law = ExponentialLaw { clearance: 1.0, pressure: 1.0 };
        for h in [-0.999, -0.8, -0.7001, 0.2, 3.0, 5.9, 7.0, 20.0] {
            let d = 1e-5;
            let (a, b) = (law.at(h - d), law.at(h + d));
            let here = law.at(h);
            assert!(
                ((b.pressure - a.pressure) / (2.0 * d) - here.slope).abs()
                    < 1e-6 * here.slope.max(1e-2)
            );
            assert!(
                ((b.energy - a.energy) / (2.0 * d) - here.pressure).abs()
                    < 1e-6 * here.pressure.max(1e-3)
            );
        }
    }

    #[test]
    fn overclosure_inverts_pressure() {
        let law = ExponentialLaw::diehl();
        for h in [-9.9e-6, -5e-6, 0.0, 3e-5, 5.9e-5, 9e-5] {
            let back = law.overclosure(law.at(h).pressure).unwrap();
            assert!((back - h).abs() < 1e-17 + 1e-12 * h.abs(), "{h} {back}");
        }
        assert!(law.overclosure(0.0).is_err());
    }
}
