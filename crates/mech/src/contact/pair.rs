//! The one place where the contact axes are multiplied.
//!
//! ```text
//!   gap (h, sigma) ------------+--> normal law --> p --+
//!                              |                       +--> pressure, traction, status,
//!   committed state, onset ----+--> friction ---> tau -+    new history, energies
//! ```
//!
//! Everything is a pure function of the gap, the committed state and the multipliers of the trial.

use super::enforcement::{Complementarity, TangentialComplementarity};
use super::friction::{
    FrictionBatch, FrictionLaw, FrictionPoint, Projection, Registered, Status, Traction,
    UserFrictionError,
};
use super::normal::NormalLaw;
use super::onset::Onset;
use super::tangential::{Tangential, TangentialMap};

mod body;
mod chain;
mod edges;
mod ends_within;
mod faces;
pub mod mortar;
pub mod mortar_faces;
mod nose;
mod stencil;
mod stretch;
mod surface;
mod tied;

pub use body::Body;
pub use chain::{chain_attachments, chain_gap, chain_overclosure};
pub use edges::{EdgePoint, EdgesBefore};
pub use faces::{FacePoint, FaceRoom, Footing};
pub use nose::{Nose, Reach};
pub use stencil::{AnyGap, Derivatives, StencilAttachments};
pub use stretch::{CarriedStretch, Stretch};
pub use surface::RigidSurface;
pub use tied::{TiedFace, TiedRow, own_part, share_of_corner};

/// What the points of a pair obey.
#[derive(Debug, Clone, PartialEq)]
pub struct Laws {
    /// Overclosure -> pressure.
    pub normal: NormalLaw,
    /// Slip, pressure -> traction.
    pub friction: FrictionLaw,
    /// When friction is called.
    pub onset: Onset,
    /// The embedding program's law, where `friction` names one.
    pub user: Option<Registered>,
}

/// The state_variables of a user law at a point.
#[derive(Debug)]
pub struct UserState<'a> {
    /// Total time at the end of the increment [T].
    pub time: f64,
    /// Committed state.
    pub committed: &'a [f64],
    /// New state, written by the law.
    pub state: &'a mut [f64],
    /// What the law complained of.
    pub fault: &'a mut Option<UserFrictionError>,
}

/// What a contact point remembers between increments.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct History {
    /// Whether the point carried pressure.
    pub closed: bool,
    /// Coordinates sigma on the master [L], kept for open points too; `None` while nothing faces the
    /// point, whose slip then counts from its next facing.
    pub along: Option<Tangential>,
    /// Elastic slip [L].
    pub elastic_slip: Tangential,
}

/// A point in its trial state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointTrial {
    /// Overclosure h [L]; minus infinity where the point faces nothing.
    pub overclosure: f64,
    /// Change of sigma since the commit [L].
    pub slip: Tangential,
    /// Estimate of the pressure [F/L2]: a hard law takes it as it is.
    pub pressure: f64,
    /// Estimate of the traction [F/L2]: exact stick takes it as it is.
    pub traction: Tangential,
    /// Stiffness that tells sliding from rounding where stick is exact [F/L3].
    pub stiffness: f64,
    /// Increment [T].
    pub dt: f64,
}

/// Pressure, traction and new history of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Pressure [F/L2].
    pub pressure: f64,
    /// Traction and what it commits.
    pub traction: Traction,
    /// Whether the point carries pressure.
    pub closed: bool,
    /// Whether friction was called; a closed point with friction that is not called drops it.
    pub called: bool,
}

impl Laws {
    /// Whether there is friction at all.
    pub fn has_friction(&self) -> bool {
        self.friction != FrictionLaw::None
    }

    /// Whether pressure and traction are functions of overclosure and slip, so that the laws can be
    /// inserted: neither hard contact nor exact stick is one.
    pub fn are_functions(&self) -> bool {
        self.normal.pressure(0.0).is_some() && !self.friction.needs_multiplier()
    }

    /// Pressure at an overclosure; of a hard law, the estimate.
    pub fn pressure(&self, overclosure: f64, estimate: f64) -> f64 {
        if overclosure == f64::NEG_INFINITY {
            return 0.0;
        }
        self.normal.pressure(overclosure).map_or(estimate, |(pressure, _)| pressure)
    }

    /// The pressure that friction goes by [F/L2]: a rough surface that does not separate grips
    /// under tension too, Coulomb's law does not.
    fn gripping(&self, pressure: f64) -> f64 {
        match (&self.friction, self.normal.is_bonded()) {
            (FrictionLaw::Rough { .. }, true) => f64::INFINITY,
            _ => pressure.max(0.0),
        }
    }

    /// The traction on the circle at which sliding begins under a pressure [F/L2].
    pub fn limit_traction(&self, pressure: f64, slip: Tangential, dt: f64) -> f64 {
        self.friction.limit_traction(self.gripping(pressure), slip, dt)
    }

    /// What a point does in a trial state; `state_variables` is that of a user law. [semantics: friction onset]
    pub fn respond(
        &self,
        history: &History,
        trial: &PointTrial,
        state_variables: &mut UserState<'_>,
    ) -> Response {
        let pressure = self.pressure(trial.overclosure, trial.pressure);
        let stands = trial.overclosure > f64::NEG_INFINITY;
        let closed = pressure != 0.0 || self.normal.is_bonded() && stands;
        let called = self.has_friction() && self.onset.called(history.closed, closed);
        let traction = match called {
            true => self.traction(pressure, history, trial, state_variables),
            false => Traction::ZERO,
        };
        Response { pressure, traction, closed, called }
    }

    fn traction(
        &self,
        pressure: f64,
        history: &History,
        trial: &PointTrial,
        state_variables: &mut UserState<'_>,
    ) -> Traction {
        let (slip, dt) = (trial.slip, trial.dt);
        if self.user.is_some() {
            let point = FrictionPoint { pressure, slip, elastic_slip: history.elastic_slip };
            return self.ask_user(point, dt, state_variables);
        }
        let pressure = self.gripping(pressure);
        if !self.friction.needs_multiplier() {
            return self.friction.update(pressure, slip, history.elastic_slip, dt);
        }
        // A slip that is none of rounding counts as sliding, although the estimate may stand a
        // rounding error below the limit.
        let ellipse = self.friction.ellipse();
        let z = trial.traction + ellipse.carried(trial.stiffness, slip);
        let projected = self.friction.project(pressure, z, slip, dt);
        let way = ellipse.way(ellipse.slip_on_circle(slip).size(), projected.tau);
        let sticks = projected.status == Status::Stick;
        Traction {
            tau: if sticks { trial.traction } else { projected.tau },
            dissipated_slip: if sticks { 0.0 } else { way },
            status: projected.status,
            ..Traction::ZERO
        }
    }

    /// Slope of the friction law by the slip where a point sticks, at the slip of the estimate
    /// [F/L3]; infinite for exact stick, `None` where it slides, and for a user law.
    pub fn stick_stiffness(
        &self,
        pressure: f64,
        (traction, slip): (Tangential, Tangential),
        dt: f64,
    ) -> Option<f64> {
        let pressure = self.gripping(pressure);
        let limit = self.friction.limit_traction(pressure, slip, dt);
        match &self.friction {
            FrictionLaw::Coulomb { stick, ellipse, .. }
                if ellipse.traction_on_circle(traction).size() < limit =>
            {
                Some(ellipse.mean_stiffness(stick.stiffness(limit)))
            }
            FrictionLaw::Rough { stick } if pressure > 0.0 => Some(stick.stiffness(pressure)),
            _ => None,
        }
    }

    /// Asks the embedding program's law about one point. An answer that is no number is a fault.
    fn ask_user(
        &self,
        point: FrictionPoint,
        dt: f64,
        state_variables: &mut UserState<'_>,
    ) -> Traction {
        let (Some(law), FrictionLaw::User { properties, .. }) = (&self.user, &self.friction) else {
            return Traction::ZERO;
        };
        if point.pressure <= 0.0 {
            state_variables.state.copy_from_slice(state_variables.committed);
            return Traction::ZERO;
        }
        let mut tractions = [Traction::ZERO];
        let answer = law.0.update(&mut FrictionBatch {
            properties,
            time: state_variables.time,
            dt,
            points: &[point],
            committed: state_variables.committed,
            state: state_variables.state,
            tractions: &mut tractions,
        });
        let given = tractions[0];
        let is_finite = given.tau.is_finite()
            && given.d_tau_d_slip.is_finite()
            && given.d_tau_d_pressure.is_finite();
        match answer {
            Ok(()) if is_finite => given,
            Ok(()) => {
                let message = "the answer is not a finite number".to_string();
                *state_variables.fault = Some(UserFrictionError { message });
                Traction::ZERO
            }
            Err(fault) => {
                *state_variables.fault = Some(fault);
                Traction::ZERO
            }
        }
    }

    /// What the normal law asks of a pressure at an overclosure, felt through the structure's
    /// stiffness `kappa` [F/L3]; infinite: nothing yields, the law is inserted.
    pub fn complementarity_of_pressure(
        &self,
        pressure: f64,
        overclosure: f64,
        kappa: f64,
    ) -> Complementarity {
        if kappa.is_infinite() {
            let (value, slope) = self.normal.pressure(overclosure).unwrap_or((0.0, 0.0));
            return Complementarity::inserted(value, slope);
        }
        let (value, slope) =
            self.normal.resolvent(overclosure + pressure / kappa, kappa, overclosure);
        Complementarity::multiplier(value, slope, kappa)
    }

    /// What the friction law asks of a traction: `slip` and `pressure` as the contact step has
    /// them, `kappa` as for the pressure.
    pub fn complementarity_of_traction(
        &self,
        (traction, slip, pressure): (Tangential, Tangential, f64),
        elastic_slip: Tangential,
        (kappa, dt): (f64, f64),
        state_variables: &mut UserState<'_>,
    ) -> TangentialComplementarity {
        let closed = self.gripping(pressure);
        let of_pressure = if pressure > 0.0 { 1.0 } else { 0.0 };
        let ellipse = self.friction.ellipse();
        let projected = |projected: Projection| TangentialComplementarity {
            value: projected.tau,
            by_multiplier: projected.by_z,
            by_value: ellipse.by_slip(kappa, projected.by_z) + projected.by_slip,
            by_pressure: of_pressure * projected.by_pressure,
        };
        if self.friction.needs_multiplier() {
            let z = traction + ellipse.carried(kappa, slip);
            return projected(self.friction.project(closed, z, slip, dt));
        }
        if self.user.is_none() && kappa.is_finite() {
            let z = (traction + ellipse.carried(kappa, slip), kappa);
            return projected(self.friction.resolve(closed, z, elastic_slip, (slip, dt)));
        }
        let updated = if self.user.is_some() {
            self.ask_user(
                FrictionPoint { pressure: closed, slip, elastic_slip },
                dt,
                state_variables,
            )
        } else {
            self.friction.update(closed, slip, elastic_slip, dt)
        };
        TangentialComplementarity {
            value: updated.tau,
            by_multiplier: TangentialMap::ZERO,
            by_value: updated.d_tau_d_slip,
            by_pressure: of_pressure * updated.d_tau_d_pressure,
        }
    }
}

/// Change of the coordinates sigma since a commit [L], the short way round on a surface that closes
/// after `period` of its first one; zero where the point faced nothing then.
pub fn slip(history: &History, along: Tangential, period: Option<f64>) -> Tangential {
    let Some(from) = history.along else { return Tangential::ZERO };
    let Tangential([first, second]) = along - from;
    match period {
        Some(period) if period > 0.0 => {
            Tangential([first - period * (first / period).round(), second])
        }
        _ => Tangential([first, second]),
    }
}

#[cfg(test)]
mod tests;
