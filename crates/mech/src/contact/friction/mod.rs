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
//! an interval, in space a circle, and one formula serves both; two coefficients make it an ellipse,
//! which is seen as a circle ([`Ellipse`]).

mod ellipse;
mod limit;
mod projection;
mod traction;
mod user;

pub use super::tangential::{Tangential, TangentialMap};
pub use ellipse::Ellipse;
pub use limit::{Decay, Stick};
pub use projection::Projection;
pub use traction::{Status, Traction};
pub use user::{FrictionBatch, FrictionPoint, Registered, UserFriction, UserFrictionError};

use limit::{Limit, limit};
use projection::turning;

/// Friction law. [semantics: friction]
#[derive(Debug, Clone, PartialEq, Default)]
pub enum FrictionLaw {
    /// No friction.
    #[default]
    None,
    /// Coulomb: tau_crit = min(mu p, limit).
    Coulomb {
        /// Coefficient mu [1] (static coefficient where there is decay), of the circle.
        coefficient: f64,
        /// The limits along both directions over that of the circle.
        ellipse: Ellipse,
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

impl FrictionLaw {
    /// How the limit differs by direction.
    pub fn ellipse(&self) -> Ellipse {
        match self {
            Self::Coulomb { ellipse, .. } => *ellipse,
            Self::None | Self::Rough { .. } | Self::User { .. } => Ellipse::CIRCLE,
        }
    }

    /// The law in the pole of a surface of revolution: all ways out of it are along the profile, axis 1.
    #[must_use]
    pub fn in_pole(&self) -> Self {
        let mut own = self.clone();
        if let Self::Coulomb { coefficient, ellipse, .. } = &mut own {
            match ellipse.of_first() {
                Some(first) => *ellipse = first,
                None => (*coefficient, *ellipse) = (0.0, Ellipse::CIRCLE),
            }
        }
        own
    }

    /// The traction min(mu p, tau_max) on the circle at which sliding begins [F/L2], with mu at the
    /// mean rate of the increment; infinite for a rough surface under pressure, zero for a user law.
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
        let ellipse = self.ellipse();
        let (slip, elastic_slip) =
            (ellipse.slip_on_circle(slip), ellipse.slip_on_circle(elastic_slip));
        ellipse.answer(self.update_on_circle(pressure, slip, elastic_slip, dt))
    }

    fn update_on_circle(
        &self,
        pressure: f64,
        slip: Tangential,
        elastic_slip: Tangential,
        dt: f64,
    ) -> Traction {
        let trial = elastic_slip + slip;
        match self {
            Self::Coulomb {
                coefficient,
                limit: top,
                decay,
                stick: Stick::Elastic { slip: critical },
                ..
            } => {
                let limit = limit(*coefficient, *top, *decay, pressure, (slip, dt));
                if trial.size() <= *critical && *critical > 0.0 {
                    sticking(&limit, trial, *critical)
                } else {
                    sliding(&limit, trial, *critical)
                }
            }
            Self::Coulomb {
                coefficient,
                limit: top,
                decay,
                stick: Stick::Slope { stiffness },
                ..
            } => {
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
            Self::Coulomb { coefficient, limit: top, decay, stick: Stick::Lagrange, .. } => {
                limit(*coefficient, *top, *decay, pressure, (slip, dt))
            }
            Self::Rough { stick: Stick::Lagrange } => Limit::of_pressure(f64::INFINITY, 0.0),
            _ => return Projection::ZERO,
        };
        let ellipse = self.ellipse();
        let on_circle = ellipse.traction_on_circle(z);
        if on_circle.size() < limit.tau {
            let by_z = TangentialMap::isotropic(1.0);
            let tau = on_circle;
            let status = Status::Stick;
            return ellipse.projection(Projection { tau, by_z, status, ..Projection::ZERO });
        }
        ellipse.projection(Projection::at_limit(&limit, on_circle, 1.0))
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
        let ellipse = self.ellipse();
        let z = (ellipse.traction_on_circle(z), ellipse.kappa_on_circle(kappa));
        let elastic_slip = ellipse.slip_on_circle(elastic_slip);
        ellipse.projection(self.resolve_on_circle(pressure, z, elastic_slip, (slip, dt)))
    }

    fn resolve_on_circle(
        &self,
        pressure: f64,
        (z, kappa): (Tangential, f64),
        elastic_slip: Tangential,
        (slip, dt): (Tangential, f64),
    ) -> Projection {
        let (limit, critical, slides) = match self {
            Self::Coulomb {
                coefficient,
                limit: top,
                decay,
                stick: Stick::Slope { stiffness },
                ..
            } => {
                let limit = limit(*coefficient, *top, *decay, pressure, (slip, dt));
                return resolve_slope(&limit, *stiffness, (elastic_slip + z / kappa, kappa));
            }
            Self::Coulomb {
                coefficient,
                limit: top,
                decay,
                stick: Stick::Elastic { slip: critical },
                ..
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
