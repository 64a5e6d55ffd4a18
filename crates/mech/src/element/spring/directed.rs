//! A spring that acts along a direction that stays: GAPUNI.

use super::law::SpringLaw;
use crate::element::kernel::{Element, Scale};

/// Spring between two nodes along a direction n of the model; relative displacement
/// n.(u2 - u1), in small and large motion.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectedSpring<const D: usize> {
    /// Unit vector from the first to the second node.
    pub direction: [f64; D],
    /// Its law.
    pub law: SpringLaw,
}

impl<const D: usize> DirectedSpring<D> {
    /// Writes internal force and tangent (row-major, symmetric), returns the energy [F L].
    pub fn force_and_tangent(&self, q: &[f64], force: &mut [f64], tangent: &mut [f64]) -> f64 {
        let n = &self.direction;
        let row = |place: usize| if place < D { -n[place] } else { n[place - D] };
        let apart = (0..2 * D).map(|place| row(place) * q[place]).sum();
        let [energy, pull, stiffness] = self.law.answer(apart);
        for i in 0..2 * D {
            force[i] = pull * row(i);
            for j in 0..2 * D {
                tangent[2 * D * i + j] = stiffness * row(i) * row(j);
            }
        }
        energy
    }
}

macro_rules! directed_spring {
    ($dimension:literal, $variables:literal, $entries:literal) => {
        impl Element<$variables, $entries> for DirectedSpring<$dimension> {
            fn linear(
                &self,
                q: &[f64; $variables],
                force: &mut [f64; $variables],
                tangent: &mut [f64; $entries],
            ) -> f64 {
                self.force_and_tangent(q, force, tangent)
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

directed_spring!(2, 4, 16);
directed_spring!(3, 6, 36);
