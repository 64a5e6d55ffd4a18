//! How is a law imposed?
//!
//! ```text
//!   inserted:    p = p(h) goes straight into the equations                      (penalty)
//!   held:        p = P(h + lambda/kappa), lambda follows p from time to time    (augmented)
//!   multiplier:  lambda is an unknown; lambda = P(h + lambda/kappa)             (dense, matrix-free)
//! ```
//!
//! Either way a law asks for a value of the multiplier: [`Complementarity`]. The equation lambda less
//! that value = 0 is what the contact step solves; with P the Moreau-Yosida form of the law it is single-valued and
//! piecewise smooth for soft and hard laws alike, and kappa changes the path, not the solution.
//! [semantics: enforcement remark; derived]

use super::tangential::{Tangential, TangentialMap};

/// How contact is solved in a Newton iteration.
///
/// The converged result is the same: only the way there and its cost differ. The first two keep the
/// laws in every iteration, the other two linearise them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Enforcement {
    /// Multipliers, with the matrix of the condensed problem formed and eliminated.
    #[default]
    Dense,
    /// Multipliers, by products with that matrix alone (GMRES).
    MatrixFree,
    /// No multipliers: the laws are inserted and linearised with everything else. Only for laws that
    /// are functions of overclosure and slip.
    Penalty,
    /// Laws inserted in their Moreau-Yosida form about multipliers that are held, and moved to what
    /// was found until the laws are met (augmented Lagrangian, Uzawa).
    Augmented,
}

impl Enforcement {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Dense => "dense",
            Self::MatrixFree => "matrix-free",
            Self::Penalty => "penalty",
            Self::Augmented => "augmented",
        }
    }

    /// Whether the laws stand in the equations of the structure, and not in a problem of their own.
    pub fn inserts_laws(self) -> bool {
        matches!(self, Self::Penalty | Self::Augmented)
    }
}

/// Multipliers about which laws are inserted, with the stiffness that stands between them and the
/// laws: infinite where a law is inserted as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldMultiplier {
    /// Pressure [F/L2].
    pub pressure: f64,
    /// Traction [F/L2].
    pub traction: Tangential,
    /// kappa along the normal [F/L3].
    pub normal_stiffness: f64,
    /// kappa along the tangents [F/L3].
    pub tangential_stiffness: f64,
}

impl HeldMultiplier {
    /// Laws inserted as they are.
    pub const NONE: Self = Self {
        pressure: 0.0,
        traction: Tangential::ZERO,
        normal_stiffness: f64::INFINITY,
        tangential_stiffness: f64::INFINITY,
    };
}

/// What a normal law says a pressure should be, with derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Complementarity {
    /// The value [F/L2].
    pub value: f64,
    /// Its derivative by the multiplier itself [1].
    pub by_multiplier: f64,
    /// By the overclosure [F/L3].
    pub by_value: f64,
}

/// What a friction law says a traction should be, with derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TangentialComplementarity {
    /// The value [F/L2].
    pub value: Tangential,
    /// Its derivative by the multiplier itself [1].
    pub by_multiplier: TangentialMap,
    /// By the slip [F/L3].
    pub by_value: TangentialMap,
    /// By the pressure of the same point [1].
    pub by_pressure: Tangential,
}

impl Complementarity {
    /// A law inserted: `value` and `slope` at the overclosure.
    pub fn inserted(value: f64, slope: f64) -> Self {
        Self { value, by_value: slope, ..Self::default() }
    }

    /// A law asked through its Moreau-Yosida form at z = e + lambda/kappa, where it gives `value` with
    /// the slope `slope` = dP/dz.
    pub fn multiplier(value: f64, slope: f64, kappa: f64) -> Self {
        Self { value, by_multiplier: slope / kappa, by_value: slope }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: for p = k h, P(z) = k z/(1 + k/kappa), and the equation lambda = P(h + lambda/kappa)
    /// has the solution lambda = k h. Tolerance: round-off.
    #[test]
    fn a_linear_law_is_met_by_its_own_pressure() {
        let (k, kappa, h) = (7.0, 3.0, 0.2);
        let slope = k / (1.0 + k / kappa);
        let lambda = k * h;
        let complementarity =
            Complementarity::multiplier(slope * (h + lambda / kappa), slope, kappa);
        assert!((complementarity.value - lambda).abs() < 1e-14);
        // Newton from any multiplier lands there in one step, for the complementarity is affine in it.
        let guess = 5.0;
        let complementarity =
            Complementarity::multiplier(slope * (h + guess / kappa), slope, kappa);
        let step = (guess - complementarity.value) / (1.0 - complementarity.by_multiplier);
        assert!((guess - step - lambda).abs() < 1e-13);
    }
}
