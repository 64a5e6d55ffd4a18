//! The one place where the contact axes are multiplied.
//!
//! ```text
//!   gap (h, sigma, derivatives) --+--> normal law --> p --+
//!                                 |                       +--> force A (p dh + tau d sigma), tangent
//!   committed state, onset -------+--> friction ---> tau -+     new state, energies
//! ```
//!
//! Everything is a pure function of the gap, the committed state and the multipliers of the trial.

use super::enforcement::mixed::{self, Scalar};
use super::enforcement::{Enforcement, inserted};
use super::friction::{FrictionLaw, FrictionPoint, Status, Traction};
use super::gap::Gap;
use super::normal::NormalLaw;
use super::onset::Onset;

mod surface;

pub use surface::{AnyGap, Body, RigidSurface, StencilAttachments, chain_attachments, chain_gap};

/// What a contact point obeys.
#[derive(Debug, Clone, PartialEq)]
pub struct Interaction {
    /// Overclosure -> pressure.
    pub normal: NormalLaw,
    /// Slip, pressure -> traction.
    pub friction: FrictionLaw,
    /// When friction is called.
    pub onset: Onset,
    /// How the laws are imposed.
    pub enforcement: Enforcement,
}

/// What a contact point remembers between increments.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PointState {
    /// Whether the point carried pressure.
    pub closed: bool,
    /// Coordinate sigma on the master [L], kept for open points too; `None` while nothing faces the
    /// point, whose slip then counts from its next facing.
    pub along: Option<f64>,
    /// Elastic slip [L].
    pub elastic_slip: f64,
}

/// Multipliers of a point in the trial state, (pressure, traction) [F/L2]; ignored when inserted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Multipliers {
    /// Pressure unknown.
    pub pressure: f64,
    /// Traction unknown of Lagrange stick.
    pub traction: f64,
}

/// The increment as a contact point sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointTrial {
    /// State at the last commit.
    pub committed: PointState,
    /// Multipliers of the trial.
    pub multipliers: Multipliers,
    /// Length after which sigma repeats [L] (closed rigid surfaces).
    pub period: Option<f64>,
    /// Increment [T].
    pub dt: f64,
}

impl PointTrial {
    /// Slip of the increment, sigma - committed sigma, the short way round on a closed surface; zero
    /// if the point faced nothing.
    pub fn slip(&self, along: f64) -> f64 {
        let Some(from) = self.committed.along else { return 0.0 };
        let slip = along - from;
        match self.period {
            Some(period) if period > 0.0 => slip - period * (slip / period).round(),
            _ => slip,
        }
    }
}

/// Pressure and traction at a point with their derivatives, before any geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// Pressure as a function of h and its multiplier.
    pub pressure: Scalar,
    /// Traction as a function of the slip and its multiplier, at fixed pressure.
    pub traction: Scalar,
    /// d tau/dp [1].
    pub traction_by_pressure: f64,
    /// Stick or slip; `None` if friction is not called.
    pub status: Option<Status>,
    /// State to be committed.
    pub state: PointState,
    /// Energy per area stored in the normal law [F/L].
    pub energy: f64,
    /// Dissipation per area of the increment [F/L], >= 0.
    pub dissipation: f64,
}

/// Force and tangent of a contact stencil over the `N` variables of its gap, and its multipliers'
/// equations. Index 0 is the pressure, 1 the traction; a multiplier that is not in use has a zero
/// row and column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stencil<const N: usize> {
    /// Residual contribution dW/dq [F].
    pub force: [f64; N],
    /// Its derivative by q [F/L]; unsymmetric with friction.
    pub tangent: [[f64; N]; N],
    /// Derivative of the force by each multiplier [L2].
    pub columns: [[f64; N]; 2],
    /// Derivative of each constraint by q [L2].
    pub rows: [[f64; N]; 2],
    /// Constraints A (P - lambda)/kappa [L3].
    pub constraint: [f64; 2],
    /// Derivative of the constraints by the multipliers [L5/F].
    pub block: [[f64; 2]; 2],
    /// Which multipliers are in use.
    pub in_use: [bool; 2],
}

/// Pressure at the overclosure `h`, law inserted or mixed.
pub fn pressure(interaction: &Interaction, h: f64, multiplier: f64) -> Scalar {
    match interaction.enforcement {
        Enforcement::Inserted => {
            let (p, slope) = interaction.normal.pressure(h).unwrap_or((0.0, 0.0));
            inserted::inserted(p, slope)
        }
        Enforcement::Mixed { normal: kappa, .. } => {
            let z = mixed::argument(h, multiplier, kappa);
            let (p, slope) = interaction.normal.resolvent(z, kappa);
            mixed::mixed(p, slope, multiplier, kappa)
        }
    }
}

/// Whether friction is called, for a pressure.
pub fn friction_called(interaction: &Interaction, trial: &PointTrial, pressure: f64) -> bool {
    interaction.onset.called(trial.committed.closed, pressure > 0.0)
        && interaction.friction != FrictionLaw::None
}

/// What a user law is told of this point, if friction is called.
pub fn user_point(
    interaction: &Interaction,
    overclosure: f64,
    along: f64,
    trial: &PointTrial,
) -> Option<FrictionPoint> {
    let p = pressure(interaction, overclosure, trial.multipliers.pressure).value;
    friction_called(interaction, trial, p).then(|| FrictionPoint {
        pressure: p,
        slip: trial.slip(along),
        elastic_slip: trial.committed.elastic_slip,
    })
}

/// Pressure, traction and new state at a point. `user` is the answer of a user law, if there is one
/// and friction is called.
pub fn respond(
    interaction: &Interaction,
    overclosure: f64,
    along: f64,
    trial: &PointTrial,
    user: Option<Traction>,
) -> Response {
    let normal = pressure(interaction, overclosure, trial.multipliers.pressure);
    let p = normal.value;
    let slip = trial.slip(along);
    let called = friction_called(interaction, trial, p);
    let lagrange = match interaction.enforcement {
        Enforcement::Mixed { tangential, .. } if interaction.friction.needs_multiplier() => {
            Some(tangential)
        }
        _ => None,
    };
    let tangential = match lagrange {
        Some(kappa) => lagrange_stick(interaction, (p, slip), trial, kappa, called),
        None => elastic_stick(interaction, (p, slip), trial, called, user),
    };
    let law_overclosure = match interaction.enforcement {
        Enforcement::Inserted => overclosure,
        Enforcement::Mixed { normal: kappa, .. } => {
            mixed::argument(overclosure, trial.multipliers.pressure, kappa) - p / kappa
        }
    };
    Response {
        pressure: normal,
        traction: tangential.scalar,
        traction_by_pressure: tangential.by_pressure,
        status: called.then_some(tangential.status),
        state: PointState {
            closed: p > 0.0,
            along: Some(along),
            elastic_slip: tangential.elastic_slip,
        },
        energy: interaction.normal.energy(law_overclosure),
        dissipation: tangential.dissipation,
    }
}

struct Tangential {
    scalar: Scalar,
    by_pressure: f64,
    status: Status,
    elastic_slip: f64,
    dissipation: f64,
}

fn elastic_stick(
    interaction: &Interaction,
    (pressure, slip): (f64, f64),
    trial: &PointTrial,
    called: bool,
    user: Option<Traction>,
) -> Tangential {
    let traction = if called {
        let elastic_slip = trial.committed.elastic_slip;
        user.unwrap_or_else(|| interaction.friction.update(pressure, slip, elastic_slip, trial.dt))
    } else {
        Traction::ZERO
    };
    Tangential {
        scalar: inserted::inserted(traction.tau, traction.d_tau_d_slip),
        by_pressure: traction.d_tau_d_pressure,
        status: traction.status,
        elastic_slip: traction.elastic_slip,
        dissipation: traction.tau.abs() * traction.dissipated_slip,
    }
}

fn lagrange_stick(
    interaction: &Interaction,
    (pressure, slip): (f64, f64),
    trial: &PointTrial,
    kappa: f64,
    called: bool,
) -> Tangential {
    // Not called or open: tau = 0, and the constraint sets the multiplier to zero.
    let multiplier = trial.multipliers.traction;
    let pressure = if called { pressure } else { 0.0 };
    let z = multiplier + kappa * slip;
    let projected = interaction.friction.project(pressure, z, slip, trial.dt);
    let mut scalar = mixed::mixed(projected.tau, kappa * projected.by_z, multiplier, kappa);
    scalar.by_argument += projected.by_slip;
    if let Some(constraint) = &mut scalar.constraint {
        constraint.by_argument += projected.by_slip / kappa;
    }
    let slipping = called && projected.status == Status::Slip;
    Tangential {
        scalar,
        by_pressure: projected.by_pressure,
        status: projected.status,
        elastic_slip: 0.0,
        dissipation: if slipping { (projected.tau * slip).max(0.0) } else { 0.0 },
    }
}

/// Multiplies the response at a point of tributary area `area` [L2] with the geometry of its gap:
/// force A (p dh + tau d sigma), tangent with the second derivatives of h and sigma.
pub fn assemble<const N: usize>(area: f64, gap: &Gap<N>, response: &Response) -> Stencil<N> {
    let (p, t) = (&response.pressure, &response.traction);
    let by_pressure = response.traction_by_pressure;
    // d(tau) = t_s d sigma + t_p P' dh: rows of the two derivatives.
    let pressure_row: [f64; N] = std::array::from_fn(|j| p.by_argument * gap.gradient[j]);
    let traction_row: [f64; N] = std::array::from_fn(|j| {
        t.by_argument * gap.slip_gradient[j] + by_pressure * pressure_row[j]
    });
    let (h, s) = (&gap.gradient, &gap.slip_gradient);
    let mut stencil = Stencil {
        force: std::array::from_fn(|i| area * (p.value * h[i] + t.value * s[i])),
        tangent: std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                area * (h[i] * pressure_row[j]
                    + s[i] * traction_row[j]
                    + p.value * gap.hessian[i][j]
                    + t.value * gap.slip_hessian[i][j])
            })
        }),
        columns: [[0.0; N]; 2],
        rows: [[0.0; N]; 2],
        constraint: [0.0; 2],
        block: [[0.0; 2]; 2],
        in_use: [p.constraint.is_some(), t.constraint.is_some()],
    };
    if let Some(c) = p.constraint {
        stencil.constraint[0] = area * c.value;
        stencil.block[0][0] = area * c.by_multiplier;
        for i in 0..N {
            stencil.rows[0][i] = area * c.by_argument * h[i];
            stencil.columns[0][i] = area * p.by_multiplier * (h[i] + by_pressure * s[i]);
        }
    }
    if let Some(c) = t.constraint {
        let follows = by_pressure * c.flexibility;
        stencil.constraint[1] = area * c.value;
        stencil.block[1][1] = area * c.by_multiplier;
        stencil.block[1][0] = area * follows * p.by_multiplier;
        for i in 0..N {
            stencil.rows[1][i] = area * (c.by_argument * s[i] + follows * pressure_row[i]);
            stencil.columns[1][i] = area * t.by_multiplier * s[i];
        }
    }
    stencil
}

/// How an eliminated multiplier follows the rest:
/// change = `change` + `by_variables` . dq + `by_other` times the change of the other multiplier.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recovery<const N: usize> {
    /// Change at fixed q [F/L2].
    pub change: f64,
    /// By q [F/L3].
    pub by_variables: [f64; N],
    /// By the change of the other multiplier [1].
    pub by_other: f64,
}

impl<const N: usize> Stencil<N> {
    /// Eliminates multiplier `which` (0 pressure, 1 traction) from the linearised equations
    /// tangent dq + columns dl = -force, rows dq + block dl = -constraint. `None` where the constraint
    /// does not depend on its own multiplier (closed hard contact, Lagrange stick: a border column)
    /// or the multiplier is not in use.
    pub fn condense(&self, which: usize) -> Option<(Self, Recovery<N>)> {
        let other = 1 - which.min(1);
        let which = which.min(1);
        let pivot = self.block[which][which];
        if !self.in_use[which] || pivot == 0.0 {
            return None;
        }
        let recovery = Recovery {
            change: -self.constraint[which] / pivot,
            by_variables: std::array::from_fn(|i| -self.rows[which][i] / pivot),
            by_other: -self.block[which][other] / pivot,
        };
        let mut rest = *self;
        rest.in_use[which] = false;
        for i in 0..N {
            let column = self.columns[which][i];
            rest.force[i] += column * recovery.change;
            rest.columns[other][i] += column * recovery.by_other;
            rest.rows[other][i] += self.block[other][which] * recovery.by_variables[i];
            for j in 0..N {
                rest.tangent[i][j] += column * recovery.by_variables[j];
            }
        }
        rest.constraint[other] += self.block[other][which] * recovery.change;
        rest.block[other][other] += self.block[other][which] * recovery.by_other;
        rest.columns[which] = [0.0; N];
        rest.rows[which] = [0.0; N];
        rest.constraint[which] = 0.0;
        rest.block[which] = [0.0; 2];
        rest.block[other][which] = 0.0;
        Some((rest, recovery))
    }
}

#[cfg(test)]
mod tests;
