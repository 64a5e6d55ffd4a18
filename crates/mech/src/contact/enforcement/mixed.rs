//! Pressure (or stick traction) as unknown.
//!
//! With the Moreau-Yosida form P of the law, which solves p = P(h + p/kappa) wherever p = p(h), the
//! saddle function A [W(h + lambda/kappa) - lambda^2/(2 kappa)], W' = P, gives
//!
//! ```text
//!   force       A P(z) dh                     z = h + lambda/kappa
//!   constraint  A (P(z) - lambda)/kappa = 0
//! ```
//!
//! symmetric in (h, lambda), valid for soft and hard laws and for open points (P = 0 gives
//! lambda = 0). Eliminating lambda at the point leaves the law's own slope at the pressure reached,
//! not at the overclosure of the iterate: that is why Newton no longer overshoots an exponential law.
//! [semantics: enforcement remark; derived]

/// A law's value as a function of its argument (h, or slip) and of a multiplier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scalar {
    /// P [F/L2].
    pub value: f64,
    /// dP/d argument [F/L3].
    pub by_argument: f64,
    /// dP/d multiplier [1].
    pub by_multiplier: f64,
    /// The equation of the multiplier, if it has one.
    pub constraint: Option<Constraint>,
}

/// c = (P - lambda)/kappa [L] and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constraint {
    /// c [L].
    pub value: f64,
    /// dc/d argument [1].
    pub by_argument: f64,
    /// dc/d lambda [L3/F].
    pub by_multiplier: f64,
    /// dc/dP = 1/kappa [L3/F]: how c follows whatever else P depends on.
    pub flexibility: f64,
}

/// The argument z = argument + lambda/kappa of the Moreau-Yosida form.
pub fn argument(argument: f64, multiplier: f64, kappa: f64) -> f64 {
    argument + multiplier / kappa
}

/// Composes the mixed form from P(z) and P'(z) [F/L3].
pub fn mixed(value: f64, slope: f64, multiplier: f64, kappa: f64) -> Scalar {
    let ratio = slope / kappa;
    Scalar {
        value,
        by_argument: slope,
        by_multiplier: ratio,
        constraint: Some(Constraint {
            value: (value - multiplier) / kappa,
            by_argument: ratio,
            by_multiplier: (ratio - 1.0) / kappa,
            flexibility: 1.0 / kappa,
        }),
    }
}

/// The multiplier eliminated at the point: force at the linearised solution, its slope, and
/// the multiplier's change as an affine function of the argument's. `None` where the constraint does
/// not depend on the multiplier (hard law, closed: a true Lagrange multiplier).
pub fn condensed(scalar: &Scalar) -> Option<Condensed> {
    let constraint = scalar.constraint?;
    let pivot = constraint.by_multiplier;
    if pivot == 0.0 {
        return None;
    }
    let (shift, by_argument) = (-constraint.value / pivot, -constraint.by_argument / pivot);
    Some(Condensed {
        value: scalar.value + scalar.by_multiplier * shift,
        by_argument: scalar.by_argument + scalar.by_multiplier * by_argument,
        change: shift,
        change_by_argument: by_argument,
    })
}

/// Answer of [`condensed`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condensed {
    /// Force per area after elimination [F/L2].
    pub value: f64,
    /// Its slope by the argument [F/L3].
    pub by_argument: f64,
    /// Change of the multiplier at fixed argument [F/L2].
    pub change: f64,
    /// Change of the multiplier per change of argument [F/L3].
    pub change_by_argument: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: for p = k h, P(z) = k z/(1 + k/kappa); the condensed slope is k, the condensed
    /// force the law's own, from any multiplier. Tolerance: round-off.
    #[test]
    fn condensing_a_linear_law_gives_the_law_back() {
        let (k, kappa, h) = (7.0, 3.0, 0.2);
        for lambda in [0.0, 1.0, 20.0] {
            let slope = k / (1.0 + k / kappa);
            let z = argument(h, lambda, kappa);
            let condensed = condensed(&mixed(slope * z, slope, lambda, kappa)).unwrap();
            assert!((condensed.value - k * h).abs() < 1e-13);
            assert!((condensed.by_argument - k).abs() < 1e-13);
            assert!((lambda + condensed.change - k * h).abs() < 1e-13);
        }
    }

    #[test]
    fn a_closed_hard_point_keeps_its_multiplier() {
        assert_eq!(condensed(&mixed(2.0, 5.0, 2.0, 5.0)), None);
    }
}
