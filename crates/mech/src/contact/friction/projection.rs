//! A traction that is projected on its limit.

use super::super::tangential::{Tangential, TangentialMap};
use super::limit::Limit;
use super::traction::Status;

/// Answer of a projection on the limit.
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
    pub(super) fn at_limit(limit: &Limit, way: Tangential, by_z: f64) -> Self {
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
pub(super) fn turning(limit: &Limit, way: Tangential, factor: f64) -> TangentialMap {
    match way.size() {
        size if size > 0.0 && limit.tau.is_finite() => {
            TangentialMap::across(way.direction(), factor * limit.tau / size)
        }
        _ => TangentialMap::ZERO,
    }
}
