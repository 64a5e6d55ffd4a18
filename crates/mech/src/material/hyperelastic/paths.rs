//! Rubber in the tests of a laboratory: its volume kept, its sides free or held.
//!
//! ```text
//!      uniaxial            equibiaxial           planar                volumetric
//!    <--[   ]-->            ^  [   ]            <--[| |]-->           -> [   ] <-
//!    1, -1/2, -1/2       1,  1, -2              1, 0, -1              p over J
//! ```
//!
//! The numbers are logarithmic strains along the axes for one along the pulled one. docs/theory.md
//! eqs. (3.82) and (3.83).

use super::rubber::Rubber;
use crate::differentiate::{Real, Second};

/// How a specimen is pulled or pressed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Along one direction, the sides free.
    Uniaxial,
    /// Along two directions alike, the third free.
    Biaxial,
    /// Along one direction, the second held, the third free: pure shear.
    Planar,
}

impl Mode {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Uniaxial, Self::Biaxial, Self::Planar];

    /// Its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Uniaxial => "uniaxial",
            Self::Biaxial => "equibiaxial",
            Self::Planar => "planar",
        }
    }

    /// Logarithmic strains along the first two axes at one logarithmic strain of the pulled axis [1].
    pub fn axes(self, log: f64) -> [f64; 2] {
        match self {
            Self::Uniaxial => [log, -0.5 * log],
            Self::Biaxial => [log, log],
            Self::Planar => [log, 0.0],
        }
    }

    /// Number of axes that are pulled.
    fn pulled(self) -> f64 {
        if self == Self::Biaxial { 2.0 } else { 1.0 }
    }
}

/// Logarithmic strains along all three axes where the volume is kept.
pub(super) fn three<R: Real>([first, second]: [R; 2]) -> [R; 3] {
    [first, second, -(first + second)]
}

impl Rubber {
    /// Energy at two logarithmic strains, the volume kept: docs/theory.md eq. (3.82) [F/L2].
    pub(super) fn kept<R: Real>(&self, axes: [R; 2]) -> R {
        let logs = three(axes);
        // the sum of l^a - 1, which keeps its digits at small strain
        let grown = |power: f64| {
            let [x, y, z] = logs.map(|log| (R::from_f64(power) * log).exp_m1());
            x + y + z
        };
        match self {
            Self::Ogden { terms, .. } => {
                let of = |&[shear, power]: &[f64; 2]| {
                    R::from_f64(2.0 * shear / (power * power)) * grown(power)
                };
                terms.iter().map(of).fold(R::from_f64(0.0), |sum, term| sum + term)
            }
            _ => self.energy(grown(2.0), grown(-2.0), R::from_f64(0.0)),
        }
    }

    /// Nominal stress along a pulled axis at a nominal strain above -1, the volume kept [F/L2]:
    /// docs/theory.md eq. (3.83).
    pub fn nominal_stress(&self, mode: Mode, strain: f64) -> f64 {
        let [first, second] = mode.axes(1.0);
        let w: Second<2> = self.kept(Second::variables(&mode.axes(strain.ln_1p())));
        let work = first * w.gradient[0] + second * w.gradient[1];
        work / (mode.pulled() * (1.0 + strain))
    }

    /// Pressure at a change of volume J - 1 alike along all axes [F/L2].
    pub fn pressure(&self, dilation: f64) -> f64 {
        -self.volume_stress(dilation)[0]
    }
}

/// Nominal stress of a term for a coefficient of one, with its derivative by the term's own
/// parameter: docs/theory.md eq. (3.84).
pub(super) fn term(
    mode: Mode,
    strain: f64,
    stress: impl Fn([f64; 3], [f64; 3]) -> Second<1>,
) -> [f64; 2] {
    let logs = three(mode.axes(strain.ln_1p()));
    let rates = three(mode.axes(1.0));
    let found = stress(logs, rates);
    let by = 1.0 / (mode.pulled() * (1.0 + strain));
    [by * found.value, by * found.gradient[0]]
}
