//! How far is a point from the master, and how much has it slid? Value and derivatives.
//!
//! ```text
//!              x slave point          n
//!              |  g = -h              ^
//!     ---------+------------->  t     |      n = 90 degrees counter-clockwise of travel
//!              sigma
//! ```
//!
//! Kernels know positions of control points only; how these follow dofs is
//! [`crate::rigid::PointMap`]'s affair.

pub mod circle;
pub mod curve;
pub mod face;

/// Overclosure and master coordinate of one point with their derivatives by the `N` variables of the
/// kernel (slave position first, then the master's).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap<const N: usize> {
    /// Overclosure h = -g [L]: penetration positive.
    pub overclosure: f64,
    /// Coordinate sigma along the master at the projection [L].
    pub along: f64,
    /// dh/dq [1].
    pub gradient: [f64; N],
    /// d sigma/dq [1].
    pub slip_gradient: [f64; N],
    /// d2h/dq2 [1/L].
    pub hessian: [[f64; N]; N],
    /// Direction of the tangential force on each variable [1]: d sigma/dq divided by its length at the
    /// slave, so that a traction tau drags the slave with tau A whatever the gap, and the master with
    /// the same force and moment. On a rigid master the lever arm runs to the slave point.
    pub direction: [f64; N],
    /// Derivative of `direction` i by variable j [1/L]; not symmetric.
    pub direction_derivative: [[f64; N]; N],
    /// Outward unit normal of the master.
    pub normal: [f64; 2],
    /// Unit tangent of the master, in the direction of travel.
    pub tangent: [f64; 2],
    /// The facing position on the master [L].
    pub position: [f64; 2],
    /// Parameter of the facing position on its piece [1] (angle in radians for a circle).
    pub parameter: f64,
}

impl<const N: usize> Gap<N> {
    /// Whether every number is finite.
    pub(crate) fn checked(self) -> Option<Self> {
        let sums =
            self.gradient.iter().chain(&self.slip_gradient).chain(&self.direction).sum::<f64>()
                + self.hessian.as_flattened().iter().sum::<f64>()
                + self.direction_derivative.as_flattened().iter().sum::<f64>();
        (self.overclosure + self.along + sums).is_finite().then_some(self)
    }
}
