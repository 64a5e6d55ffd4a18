//! Slip state, slip, pressure -> traction.
//!
//! ```text
//!   tau |      mu p ________          elastic stick: slope mu p / gamma_crit up to the limit
//!       |          /                  Lagrange stick: vertical, a multiplier carries it
//!   ----+---------/------- slip       slope: lambda up to the limit, whatever the pressure
//!       |   _____/
//! ```
//!
//! Tractions have the sense of the slip; the residual receives + A tau d sigma, which dissipates.
//! Slips and tractions are vectors in the tangent plane ([`Tangential`]): in the plane the limit is
//! an interval, in space a circle, and one formula serves both.

mod traction;
mod user;

pub use super::tangential::{Tangential, TangentialMap};
pub use traction::{Status, Traction};
pub use user::{FrictionBatch, FrictionPoint, Registered, UserFriction, UserFrictionError};

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

/// Friction law. [semantics: friction]
#[derive(Debug, Clone, PartialEq, Default)]
pub enum FrictionLaw {
    /// No friction.
    #[default]
    None,
    /// Coulomb: tau_crit = min(mu p, limit).
    Coulomb {
        /// Coefficient mu [1] (static coefficient where there is decay).
        coefficient: f64,
        /// Largest traction tau_max [F/L2] (`TAUMAX`).
        limit: Option<f64>,
        /// Dependence on the slip rate.
        decay: Option<Decay>,
        /// How sticking is carried.
        stick: Stick,
    },
    /// No slip while closed (`ROUGH`). Elastic stick has the stiffness p/gamma_crit, that of Coulomb
    /// with mu = 1, without limit.
    Rough {
        /// How sticking is carried.
        stick: Stick,
    },
    /// A law registered under a name by the embedding program.
    User {
        /// Name in the registry.
        name: String,
        /// Properties of the deck, handed to the law.
        properties: Vec<f64>,
        /// Number of state values a point keeps.
        state_size: usize,
    },
}

/// The limit traction with its derivatives by pressure and by slip.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Limit {
    tau: f64,
    by_pressure: f64,
    by_slip: Tangential,
}

impl Limit {
    /// A limit that depends on the pressure alone.
    fn of_pressure(tau: f64, by_pressure: f64) -> Self {
        Self { tau, by_pressure, by_slip: Tangential::ZERO }
    }
}

/// tau_crit = min(mu p, tau_max), mu from the mean slip rate of the increment.
fn limit(
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

impl FrictionLaw {
    /// The traction min(mu p, tau_max) at which sliding begins [F/L2], with mu at the mean rate of
    /// the increment; infinite for a rough surface under pressure, zero for a user law.
    pub fn limit_traction(&self, pressure: f64, slip: Tangential, dt: f64) -> f64 {
        match self {
            _ if pressure.is_nan() || pressure <= 0.0 => 0.0,
            Self::Coulomb { coefficient, limit: top, decay, .. } => {
                limit(*coefficient, *top, *decay, pressure, (slip, dt)).tau
            }
            Self::Rough { .. } => f64::INFINITY,
            Self::None | Self::User { .. } => 0.0,
        }
    }

    /// Whether sticking needs a multiplier.
    pub fn needs_multiplier(&self) -> bool {
        matches!(
            self,
            Self::Coulomb { stick: Stick::Lagrange, .. } | Self::Rough { stick: Stick::Lagrange }
        )
    }

    /// Traction by backward Euler for elastic stick: `pressure` p [F/L2], `slip` of the increment
    /// [L], committed `elastic_slip` [L], increment `dt` [T]. With g = elastic_slip + slip: stick
    /// (|g| <= gamma_crit) tau = tau_crit g/gamma_crit; slip tau = tau_crit g/|g|.
    ///
    /// Zero for p <= 0, for no friction, for a user law, and for Lagrange stick (use
    /// [`FrictionLaw::project`]). [semantics: friction, update]
    pub fn update(
        &self,
        pressure: f64,
        slip: Tangential,
        elastic_slip: Tangential,
        dt: f64,
    ) -> Traction {
        if pressure.is_nan() || pressure <= 0.0 {
            return Traction::ZERO;
        }
        let trial = elastic_slip + slip;
        match self {
            Self::Coulomb {
                coefficient,
                limit: top,
                decay,
                stick: Stick::Elastic { slip: critical },
            } => {
                let limit = limit(*coefficient, *top, *decay, pressure, (slip, dt));
                if trial.size() <= *critical && *critical > 0.0 {
                    sticking(&limit, trial, *critical)
                } else {
                    sliding(&limit, trial, *critical)
                }
            }
            Self::Coulomb { coefficient, limit: top, decay, stick: Stick::Slope { stiffness } } => {
                let limit = limit(*coefficient, *top, *decay, pressure, (slip, dt));
                if stiffness * trial.size() <= limit.tau {
                    held(*stiffness, trial)
                } else {
                    sliding(&limit, trial, limit.tau / stiffness)
                }
            }
            Self::Rough { stick: Stick::Elastic { slip: critical } } if *critical > 0.0 => {
                let limit = Limit::of_pressure(pressure, 1.0);
                sticking(&limit, trial, *critical)
            }
            _ => Traction::ZERO,
        }
    }

    /// Lagrange stick: projects the trial traction z = tau + kappa slip [F/L2] on the limit.
    ///
    /// Stick |z| <= tau_crit: tau = z; slip: tau = tau_crit z/|z|. `slip` and `dt` only serve the
    /// decay. Zero for a law without multiplier and for p <= 0.
    pub fn project(&self, pressure: f64, z: Tangential, slip: Tangential, dt: f64) -> Projection {
        if pressure.is_nan() || pressure <= 0.0 {
            return Projection::ZERO;
        }
        let limit = match self {
            Self::Coulomb { coefficient, limit: top, decay, stick: Stick::Lagrange } => {
                limit(*coefficient, *top, *decay, pressure, (slip, dt))
            }
            Self::Rough { stick: Stick::Lagrange } => Limit::of_pressure(f64::INFINITY, 0.0),
            _ => return Projection::ZERO,
        };
        if z.size() < limit.tau {
            let by_z = TangentialMap::isotropic(1.0);
            return Projection { tau: z, by_z, status: Status::Stick, ..Projection::ZERO };
        }
        Projection::at_limit(&limit, z, 1.0)
    }

    /// Elastic stick felt through the structure's stiffness `kappa` [F/L3]: the traction for which
    /// tau = tau_crit (g + (z - tau)/kappa)/gamma_crit, at most tau_crit, with g the committed
    /// elastic slip and z = tau + kappa slip of the estimate [F/L2]. The law and the structure are
    /// two springs in series; the answer does not jump from limit to limit where the law alone,
    /// steep between its limits, would. Zero for p <= 0 and for a law without elastic stick.
    /// [derived, theory (8.9)]
    pub fn resolve(
        &self,
        pressure: f64,
        (z, kappa): (Tangential, f64),
        elastic_slip: Tangential,
        (slip, dt): (Tangential, f64),
    ) -> Projection {
        if pressure.is_nan() || pressure <= 0.0 {
            return Projection::ZERO;
        }
        let (limit, critical, slides) = match self {
            Self::Coulomb { coefficient, limit: top, decay, stick: Stick::Slope { stiffness } } => {
                let limit = limit(*coefficient, *top, *decay, pressure, (slip, dt));
                return resolve_slope(&limit, *stiffness, (elastic_slip + z / kappa, kappa));
            }
            Self::Coulomb {
                coefficient,
                limit: top,
                decay,
                stick: Stick::Elastic { slip: critical },
            } => (limit(*coefficient, *top, *decay, pressure, (slip, dt)), *critical, true),
            Self::Rough { stick: Stick::Elastic { slip: critical } } => {
                (Limit::of_pressure(pressure, 1.0), *critical, false)
            }
            _ => return Projection::ZERO,
        };
        let way = elastic_slip + z / kappa;
        if critical <= 0.0 {
            return match slides {
                true => Projection::at_limit(&limit, way, 1.0 / kappa),
                false => Projection::ZERO,
            };
        }
        let stiffness = limit.tau / critical;
        let share = kappa / (kappa + stiffness);
        let tau = (share * stiffness) * way;
        if slides && tau.size() > limit.tau {
            return Projection::at_limit(&limit, way, 1.0 / kappa);
        }
        let by_stiffness = (share * share) * way / critical;
        Projection {
            tau,
            by_z: TangentialMap::isotropic(share * stiffness / kappa),
            by_pressure: limit.by_pressure * by_stiffness,
            by_slip: by_stiffness.outer(limit.by_slip),
            status: Status::Stick,
        }
    }
}

/// Answer of [`FrictionLaw::project`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    /// tau [F/L2].
    pub tau: Tangential,
    /// d tau/dz at fixed pressure [1].
    pub by_z: TangentialMap,
    /// d tau/dp at fixed z [1].
    pub by_pressure: Tangential,
    /// d tau/d slip at fixed z and p (decay only) [F/L3].
    pub by_slip: TangentialMap,
    /// Stick or slip.
    pub status: Status,
}

impl Projection {
    /// No traction.
    pub const ZERO: Self = Self {
        tau: Tangential::ZERO,
        by_z: TangentialMap::ZERO,
        by_pressure: Tangential::ZERO,
        by_slip: TangentialMap::ZERO,
        status: Status::Slip,
    };

    /// Sliding at the limit in the direction of `way`, which follows z by the factor `by_z`. In
    /// space the traction turns with the way.
    fn at_limit(limit: &Limit, way: Tangential, by_z: f64) -> Self {
        let direction = way.direction();
        Self {
            tau: limit.tau * direction,
            by_z: turning(limit, way, by_z),
            by_pressure: limit.by_pressure * direction,
            by_slip: direction.outer(limit.by_slip),
            status: Status::Slip,
        }
    }
}

/// How a traction at its limit turns with the way that it opposes, times `factor`: zero in the plane.
fn turning(limit: &Limit, way: Tangential, factor: f64) -> TangentialMap {
    match way.size() {
        size if size > 0.0 && limit.tau.is_finite() => {
            TangentialMap::across(way.direction(), factor * limit.tau / size)
        }
        _ => TangentialMap::ZERO,
    }
}

fn sticking(limit: &Limit, trial: Tangential, critical: f64) -> Traction {
    let share = trial / critical;
    Traction {
        tau: limit.tau * share,
        d_tau_d_slip: TangentialMap::isotropic(limit.tau / critical) + share.outer(limit.by_slip),
        d_tau_d_pressure: limit.by_pressure * share,
        elastic_slip: trial,
        dissipated_slip: 0.0,
        status: Status::Stick,
    }
}

/// Sticking with a slope that no pressure changes.
fn held(stiffness: f64, trial: Tangential) -> Traction {
    Traction {
        tau: stiffness * trial,
        d_tau_d_slip: TangentialMap::isotropic(stiffness),
        d_tau_d_pressure: Tangential::ZERO,
        elastic_slip: trial,
        dissipated_slip: 0.0,
        status: Status::Stick,
    }
}

/// Such a stick in series with the stiffness `kappa` of the structure. [derived, theory (8.9)]
fn resolve_slope(limit: &Limit, stiffness: f64, (way, kappa): (Tangential, f64)) -> Projection {
    let share = kappa / (kappa + stiffness);
    let tau = (share * stiffness) * way;
    if tau.size() > limit.tau {
        return Projection::at_limit(limit, way, 1.0 / kappa);
    }
    let by_z = TangentialMap::isotropic(share * stiffness / kappa);
    Projection { tau, by_z, status: Status::Stick, ..Projection::ZERO }
}

fn sliding(limit: &Limit, trial: Tangential, critical: f64) -> Traction {
    let direction = trial.direction();
    Traction {
        tau: limit.tau * direction,
        d_tau_d_slip: turning(limit, trial, 1.0) + direction.outer(limit.by_slip),
        d_tau_d_pressure: limit.by_pressure * direction,
        elastic_slip: critical * direction,
        dissipated_slip: trial.size() - critical,
        status: Status::Slip,
    }
}

#[cfg(test)]
mod tests;
