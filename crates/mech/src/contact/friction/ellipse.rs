//! Two coefficients of friction: the limit is an ellipse of the tangent plane.
//!
//! ```text
//!        t2                         in S g and S^-1 tau it is a circle: law, projection and
//!     ___|___   S = diag(s1, s2)    step are those of one coefficient
//!    (___|___)---> t1
//!        |
//! ```
//!
//! [docs/theory.md, section 7, eqs. (7.7) to (7.9)]

use super::super::tangential::{Tangential, TangentialMap};
use super::projection::Projection;
use super::traction::Traction;

/// Shares s of the larger coefficient along both tangential directions [1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse(Tangential);

impl Ellipse {
    /// One coefficient in all directions.
    pub const CIRCLE: Self = Self(Tangential([1.0; 2]));

    /// The larger one of two coefficients, both not negative, and the shares of both [1].
    pub fn of(coefficients: [f64; 2]) -> (f64, Self) {
        let largest = coefficients[0].max(coefficients[1]);
        match largest > 0.0 {
            true => (largest, Self(Tangential(coefficients.map(|own| own / largest)))),
            false => (largest, Self::CIRCLE),
        }
    }

    /// The first coefficient in all directions; `None` where it is zero.
    pub fn of_first(&self) -> Option<Self> {
        (self.0[0] > 0.0).then_some(Self(Tangential([self.0[0]; 2])))
    }

    /// Both coefficients where the larger one is `coefficient` [1].
    pub fn coefficients(&self, coefficient: f64) -> [f64; 2] {
        (coefficient * self.0).0
    }

    /// S g: a slip as the circle sees it [L].
    pub fn slip_on_circle(&self, slip: Tangential) -> Tangential {
        slip.along_each(self.0)
    }

    /// S^-1 tau: a traction as the circle sees it [F/L2]; none along a direction without friction.
    pub fn traction_on_circle(&self, traction: Tangential) -> Tangential {
        self.over_shares(traction)
    }

    /// S t: the traction that the circle sees as t [F/L2].
    pub fn traction(&self, on_circle: Tangential) -> Tangential {
        on_circle.along_each(self.0)
    }

    /// S M S: the derivative of a traction by a slip, of that on the circle [F/L3].
    pub fn stiffness(&self, on_circle: TangentialMap) -> TangentialMap {
        on_circle.scaled(self.0, self.0)
    }

    /// A stiffness on the circle, as the mean of both directions [F/L3].
    pub fn mean_stiffness(&self, on_circle: f64) -> f64 {
        on_circle * 0.5 * self.0.dot(self.0)
    }

    /// The stiffness on the circle whose mean of both directions is kappa [F/L3].
    pub fn kappa_on_circle(&self, kappa: f64) -> f64 {
        kappa / (0.5 * self.0.dot(self.0))
    }

    /// What a stiffness kappa makes of a slip, by the directions [F/L2].
    pub fn carried(&self, kappa: f64, slip: Tangential) -> Tangential {
        self.kappa_on_circle(kappa) * slip.along_each(self.0).along_each(self.0)
    }

    /// The derivative by the slip that is carried, from that by the traction [F/L3].
    pub fn by_slip(&self, kappa: f64, by_traction: TangentialMap) -> TangentialMap {
        let squares = self.0.along_each(self.0);
        by_traction.scaled(Tangential([1.0; 2]), self.kappa_on_circle(kappa) * squares)
    }

    /// The way along a traction that dissipates what a way on the circle does there [L].
    pub fn way(&self, on_circle: f64, traction: Tangential) -> f64 {
        match traction.size() {
            size if size > 0.0 => on_circle * (self.traction_on_circle(traction).size() / size),
            _ => on_circle,
        }
    }

    /// The answer of a law on the circle.
    pub fn answer(&self, on_circle: Traction) -> Traction {
        let tau = self.traction(on_circle.tau);
        Traction {
            tau,
            d_tau_d_slip: self.stiffness(on_circle.d_tau_d_slip),
            d_tau_d_pressure: self.traction(on_circle.d_tau_d_pressure),
            elastic_slip: self.over_shares(on_circle.elastic_slip),
            dissipated_slip: self.way(on_circle.dissipated_slip, tau),
            status: on_circle.status,
        }
    }

    /// A projection on the circle.
    pub fn projection(&self, on_circle: Projection) -> Projection {
        let inverse = self.over_shares(Tangential([1.0; 2]));
        Projection {
            tau: self.traction(on_circle.tau),
            by_z: on_circle.by_z.scaled(self.0, inverse),
            by_pressure: self.traction(on_circle.by_pressure),
            by_slip: on_circle.by_slip.scaled(self.0, Tangential([1.0; 2])),
            status: on_circle.status,
        }
    }

    fn over_shares(&self, vector: Tangential) -> Tangential {
        let own = |k: usize| if self.0[k] > 0.0 { vector[k] / self.0[k] } else { 0.0 };
        Tangential([own(0), own(1)])
    }
}
