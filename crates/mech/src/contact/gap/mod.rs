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
pub mod edges;
pub mod face;
pub mod offset;

use std::fmt::Debug;

/// Up to which derivatives a gap is wanted. Most points of an iteration carry nothing, and their
/// second derivatives are asked for by nobody.
pub trait Order: Debug + Clone + Copy + PartialEq {
    /// What is kept of the second derivatives by `N` variables.
    type Second<const N: usize>: Debug + Clone + Copy + PartialEq;

    /// That, where `make` gives them.
    fn second<const N: usize>(make: impl FnOnce() -> Second<N>) -> Self::Second<N>;

    /// The second derivatives that are kept, if any are.
    fn kept<const N: usize>(second: &Self::Second<N>) -> Option<&Second<N>>;

    /// The same, to be written.
    fn kept_mut<const N: usize>(second: &mut Self::Second<N>) -> Option<&mut Second<N>>;
}

/// A gap with its first derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linear;

/// A gap with its first and second derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quadratic;

impl Order for Linear {
    type Second<const N: usize> = ();

    fn second<const N: usize>(_: impl FnOnce() -> Second<N>) {}

    fn kept<const N: usize>((): &()) -> Option<&Second<N>> {
        None
    }

    fn kept_mut<const N: usize>((): &mut ()) -> Option<&mut Second<N>> {
        None
    }
}

impl Order for Quadratic {
    type Second<const N: usize> = Second<N>;

    fn second<const N: usize>(make: impl FnOnce() -> Second<N>) -> Second<N> {
        make()
    }

    fn kept<const N: usize>(second: &Second<N>) -> Option<&Second<N>> {
        Some(second)
    }

    fn kept_mut<const N: usize>(second: &mut Second<N>) -> Option<&mut Second<N>> {
        Some(second)
    }
}

/// Second derivatives of a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Second<const N: usize> {
    /// d2h/dq2 [1/L].
    pub hessian: [[f64; N]; N],
    /// Derivative of `direction` i by variable j [1/L]; not symmetric.
    pub direction_derivative: [[f64; N]; N],
}

impl<const N: usize> Second<N> {
    /// None.
    pub const ZERO: Self = Self { hessian: [[0.0; N]; N], direction_derivative: [[0.0; N]; N] };
}

/// Overclosure and master coordinate of one point with their derivatives by the `N` variables of the
/// kernel (slave position first, then the master's).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap<const N: usize, O: Order = Quadratic> {
    /// Overclosure h = -g [L]: penetration positive.
    pub overclosure: f64,
    /// Coordinate sigma along the master at the projection [L].
    pub along: f64,
    /// dh/dq [1].
    pub gradient: [f64; N],
    /// d sigma/dq [1].
    pub slip_gradient: [f64; N],
    /// Direction of the tangential force on each variable [1]: d sigma/dq divided by its length at the
    /// slave, so that a traction tau drags the slave with tau A whatever the gap, and the master with
    /// the same force and moment. On a rigid master the lever arm runs to the slave point.
    pub direction: [f64; N],
    /// Its second derivatives, where they are wanted.
    pub second: O::Second<N>,
    /// Outward unit normal of the master.
    pub normal: [f64; 2],
    /// Unit tangent of the master, in the direction of travel.
    pub tangent: [f64; 2],
    /// The facing position on the master [L].
    pub position: [f64; 2],
    /// Parameter of the facing position on its piece [1] (angle in radians for a circle).
    pub parameter: f64,
    /// Turn of the tangent where the point moves along the tangent by a unit [1/L].
    pub bend: f64,
}

impl<const N: usize, O: Order> Gap<N, O> {
    /// Whether every number is finite.
    pub(crate) fn is_finite(&self) -> bool {
        let mut sum = self.overclosure + self.along;
        for i in 0..N {
            sum += self.gradient[i] + self.slip_gradient[i] + self.direction[i];
        }
        if let Some(second) = O::kept(&self.second) {
            sum += second.hessian.as_flattened().iter().sum::<f64>();
            sum += second.direction_derivative.as_flattened().iter().sum::<f64>();
        }
        sum.is_finite()
    }
}
