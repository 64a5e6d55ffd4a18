//! Springs: SPRING1 between a dof and the ground, SPRING2 between dofs of two nodes, SPRINGA
//! between two nodes along their axis, GAPUNI between two nodes along a direction that stays,
//! GAPCYL and GAPSPHER by their distance.
//!
//! ```text
//!   SPRING1   |/\/\/\o--> u      SPRING2   o/\/\/\o  u1 - u2      SPRINGA   1 o/\/\/\o 2
//! ```
//!
//! SPRINGA turns with its ends. The force is proportional to the relative displacement, or a table
//! of it, or that of a gap that closes.

mod directed;
mod ends;
mod law;
mod radial;

pub use directed::DirectedSpring;
pub use law::SpringLaw;
pub use radial::RadialSpring;

use super::kernel::{Element, Scale};
use crate::differentiate::Real;
use ends::{fill, length, push};

/// SPRING1: a spring between one dof and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundSpring(pub SpringLaw);

impl Element<1, 1> for GroundSpring {
    fn linear(&self, [u]: &[f64; 1], force: &mut [f64; 1], tangent: &mut [f64; 1]) -> f64 {
        let [energy, pull, stiffness] = self.0.answer(*u);
        (*force, *tangent) = ([pull], [stiffness]);
        energy
    }

    fn exact(&self, q: &[f64; 1], force: &mut [f64; 1], tangent: &mut [f64; 1]) -> f64 {
        self.linear(q, force, tangent)
    }

    fn scale(&self) -> Scale {
        Scale { stiffness: self.0.stiffest(), length: None }
    }

    fn results(&self, _q: &[f64; 1], _linear: bool, _into: &mut [f64]) {}
}

/// SPRING2: a spring between a dof of one node and that of another; relative displacement u1 - u2.
#[derive(Debug, Clone, PartialEq)]
pub struct RelativeSpring(pub SpringLaw);

impl Element<2, 4> for RelativeSpring {
    fn linear(&self, [a, b]: &[f64; 2], force: &mut [f64; 2], tangent: &mut [f64; 4]) -> f64 {
        let [energy, pull, stiffness] = self.0.answer(a - b);
        *force = [pull, -pull];
        *tangent = [stiffness, -stiffness, -stiffness, stiffness];
        energy
    }

    fn exact(&self, q: &[f64; 2], force: &mut [f64; 2], tangent: &mut [f64; 4]) -> f64 {
        self.linear(q, force, tangent)
    }

    fn scale(&self) -> Scale {
        Scale { stiffness: self.0.stiffest(), length: None }
    }

    fn results(&self, _q: &[f64; 2], _linear: bool, _into: &mut [f64]) {}
}

/// SPRINGA: a spring between two nodes, acting along their current axis; relative displacement
/// is its change of length.
#[derive(Debug, Clone, PartialEq)]
pub struct AxialSpring<const D: usize> {
    /// Undeformed positions of the two nodes [L].
    pub reference: [[f64; D]; 2],
    /// Its law.
    pub law: SpringLaw,
}

impl<const D: usize> AxialSpring<D> {
    fn axis(&self) -> [f64; D] {
        let [first, second] = self.reference;
        std::array::from_fn(|k| second[k] - first[k])
    }

    /// Change of length [L] at the displacements of both nodes: (2 e.w + w.w)/(L + l) with
    /// w = u2 - u1, e = X2 - X1, which keeps its digits for small displacements.
    pub fn elongation<R: Real>(&self, q: &[R]) -> R {
        let number = R::from_f64;
        let axis = self.axis();
        let (mut grown, mut current) = (number(0.0), number(0.0));
        for (k, &e) in axis.iter().enumerate() {
            let w = q[D + k] - q[k];
            let d = number(e) + w;
            grown = grown + (number(2.0 * e) + w) * w;
            current = current + d * d;
        }
        grown / (current.sqrt() + number(length(&axis)))
    }

    /// Writes internal force and tangent (row-major, symmetric), returns the energy [F L].
    ///
    /// Where both ends coincide the axis is undefined: the force is then zero and the tangent that
    /// of a spring in every direction.
    pub fn force_and_tangent(&self, q: &[f64], force: &mut [f64], tangent: &mut [f64]) -> f64 {
        let axis = self.axis();
        let d: [f64; D] = std::array::from_fn(|k| axis[k] + q[D + k] - q[k]);
        let current = length(&d);
        if current <= 0.0 {
            let [energy, _, stiffness] = self.law.answer(-length(&axis));
            force.fill(0.0);
            fill(tangent, D, |i, j| if i == j { stiffness } else { 0.0 });
            return energy;
        }
        let [energy, pull, stiffness] = self.law.answer(self.elongation(q));
        let t = d.map(|x| x / current);
        push(&t, pull, force);
        let across = pull / current;
        let unit = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        fill(tangent, D, |i, j| stiffness * t[i] * t[j] + across * (unit(i, j) - t[i] * t[j]));
        energy
    }

    /// Force and tangent of a step without NLGEOM: axis and stiffness of the undeformed spring.
    pub fn linear_force_and_tangent(
        &self,
        q: &[f64],
        force: &mut [f64],
        tangent: &mut [f64],
    ) -> f64 {
        let axis = self.axis();
        let length = length(&axis);
        let t = axis.map(|x| if length > 0.0 { x / length } else { 0.0 });
        let elongation = (0..D).map(|k| t[k] * (q[D + k] - q[k])).sum();
        let [energy, pull, stiffness] = self.law.answer(elongation);
        push(&t, pull, force);
        fill(tangent, D, |i, j| stiffness * t[i] * t[j]);
        energy
    }
}

macro_rules! axial_spring {
    ($dimension:literal, $variables:literal, $entries:literal) => {
        impl Element<$variables, $entries> for AxialSpring<$dimension> {
            fn linear(
                &self,
                q: &[f64; $variables],
                force: &mut [f64; $variables],
                tangent: &mut [f64; $entries],
            ) -> f64 {
                self.linear_force_and_tangent(q, force, tangent)
            }

            fn exact(
                &self,
                q: &[f64; $variables],
                force: &mut [f64; $variables],
                tangent: &mut [f64; $entries],
            ) -> f64 {
                self.force_and_tangent(q, force, tangent)
            }

            fn scale(&self) -> Scale {
                Scale { stiffness: self.law.stiffest(), length: None }
            }

            fn results(&self, _q: &[f64; $variables], _linear: bool, _into: &mut [f64]) {}
        }
    };
}

axial_spring!(2, 4, 16);
axial_spring!(3, 6, 36);
