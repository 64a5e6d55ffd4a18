//! How sticking is carried, and the traction at which it ends.

use super::super::tangential::Tangential;

/// How sticking is carried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stick {
    /// Elastic slip up to gamma_crit > 0 [L], stiffness tau_crit/gamma_crit (`SLIP TOLERANCE`,
    /// `ELASTIC SLIP`).
    Elastic {
        /// gamma_crit [L].
        slip: f64,
    },
    /// Traction by the elastic slip with a slope of its own, whatever the pressure (CalculiX).
    Slope {
        /// The slope lambda > 0 [F/L3].
        stiffness: f64,
    },
    /// Exact, by a multiplier (`LAGRANGE`).
    Lagrange,
}

impl Stick {
    /// Slope of the traction by the slip up to a limit traction [F/L3]; infinite where it is exact.
    pub fn stiffness(&self, limit: f64) -> f64 {
        match *self {
            Self::Elastic { slip } if slip > 0.0 => limit / slip,
            Self::Slope { stiffness } => stiffness,
            Self::Elastic { .. } | Self::Lagrange => f64::INFINITY,
        }
    }
}

/// Exponential decay mu = mu_k + (mu_s - mu_k) exp(-d_c |slip rate|); mu_s is the law's coefficient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decay {
    /// Kinetic coefficient mu_k [1].
    pub kinetic: f64,
    /// Decay d_c [T/L].
    pub rate: f64,
}

/// The limit traction with its derivatives by pressure and by slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Limit {
    /// The limit [F/L2].
    pub tau: f64,
    /// By the pressure [1].
    pub by_pressure: f64,
    /// By the slip [F/L3].
    pub by_slip: Tangential,
}

impl Limit {
    /// A limit that depends on the pressure alone.
    pub fn of_pressure(tau: f64, by_pressure: f64) -> Self {
        Self { tau, by_pressure, by_slip: Tangential::ZERO }
    }
}

/// tau_crit = min(mu p, tau_max), mu from the mean slip rate of the increment.
pub(super) fn limit(
    coefficient: f64,
    largest: Option<f64>,
    decay: Option<Decay>,
    pressure: f64,
    (slip, dt): (Tangential, f64),
) -> Limit {
    let (mu, mu_by_slip) = match decay {
        Some(decay) if dt > 0.0 => {
            let fading = (coefficient - decay.kinetic) * (-decay.rate * slip.size() / dt).exp();
            (decay.kinetic + fading, (-decay.rate / dt * fading) * slip.direction())
        }
        _ => (coefficient, Tangential::ZERO),
    };
    match largest {
        Some(top) if mu * pressure >= top => Limit::of_pressure(top, 0.0),
        _ => Limit { tau: mu * pressure, by_pressure: mu, by_slip: pressure * mu_by_slip },
    }
}
