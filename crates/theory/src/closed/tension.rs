//! A round bar of metal in tension, before and after it necks.
//!
//! ```text
//!   <--|      )__(      |-->     a: radius of the neck, r: radius of its profile
//!   <--|      )  (      |-->     F = A s exp(-e) while the bar is even
//! ```

use crate::error::TheoryError;
use crate::numerics::root;

/// A bar of E, nu and a yield stress s(p) over the plastic strain; stresses are Kirchhoff's, strains
/// logarithmic.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    /// Young's modulus E [F/L2].
    pub modulus: f64,
    /// Yield stress [F/L2] at a plastic strain [1].
    pub yield_stress: fn(f64) -> f64,
}

impl Bar {
    /// Force for each undeformed area [F/L2] of an even bar at the plastic strain `plastic`, and its
    /// stretch [1]: P = s exp(-e), e = p + s/E.
    pub fn even(&self, plastic: f64) -> [f64; 2] {
        let stress = (self.yield_stress)(plastic);
        let strain = plastic + stress / self.modulus;
        [stress * (-strain).exp(), strain.exp()]
    }

    /// The largest force for each undeformed area [F/L2], ds/de = s. [considere1885]
    ///
    /// # Errors
    /// [`TheoryError`] where there is none up to a plastic strain of 1.
    pub fn largest(&self) -> Result<f64, TheoryError> {
        let slope = |plastic: f64| {
            let step = 1e-5;
            self.even(plastic + step)[0] - self.even(plastic - step)[0]
        };
        Ok(self.even(root::bracketed(slope, 1e-4, 1.0)?)[0])
    }
}

/// Mean axial stress over the neck by the flow stress [1], (1 + 2 r/a) ln(1 + a/(2 r)).
/// [bridgman1944]
pub fn bridgman(radius: f64, profile: f64) -> f64 {
    (1.0 + 2.0 * profile / radius) * (0.5 * radius / profile).ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: a power law s = K p^n in a stiff bar has its largest force at p = n; no neck has
    /// no factor. Source: Considere. Tolerance: the elastic strain.
    #[test]
    fn power_law() {
        let bar = Bar { modulus: 1e9, yield_stress: |plastic| plastic.powf(0.2) };
        let exact = 0.2f64.powf(0.2) * (-0.2f64).exp();
        assert!((bar.largest().unwrap_or(0.0) - exact).abs() < 1e-8);
        assert!((bridgman(1.0, 1e9) - 1.0).abs() < 1e-8);
        assert!((bridgman(1.0, 1.0) - 3.0 * 1.5f64.ln()).abs() < 1e-15);
    }
}
