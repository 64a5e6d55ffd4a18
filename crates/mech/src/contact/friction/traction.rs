//! What a friction law answers.

use super::super::tangential::{Tangential, TangentialMap};

/// Whether a closed point sticks or slips.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// No sliding.
    Stick,
    /// Sliding at the limit.
    Slip,
}

/// Answer of a friction law at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traction {
    /// tau [F/L2], of the sense of the slip.
    pub tau: Tangential,
    /// d tau/d slip [F/L3].
    pub d_tau_d_slip: TangentialMap,
    /// d tau/dp [1].
    pub d_tau_d_pressure: Tangential,
    /// Elastic slip to be committed [L].
    pub elastic_slip: Tangential,
    /// Dissipated slip of the increment [L], >= 0; times |tau| A the dissipation.
    pub dissipated_slip: f64,
    /// Stick or slip.
    pub status: Status,
}

impl Traction {
    /// No traction, no elastic slip: open, or friction not called.
    pub const ZERO: Self = Self {
        tau: Tangential::ZERO,
        d_tau_d_slip: TangentialMap::ZERO,
        d_tau_d_pressure: Tangential::ZERO,
        elastic_slip: Tangential::ZERO,
        dissipated_slip: 0.0,
        status: Status::Slip,
    };
}
