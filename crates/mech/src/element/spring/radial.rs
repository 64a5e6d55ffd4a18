//! A gap that closes where its nodes come too near to one another or too far apart: GAPCYL about an
//! axis, GAPSPHER about a point.
//!
//! ```text
//!   inside   ( o-->  )   closes at a distance r       outside   o-->  <--o   closes at r
//! ```

use super::ends::{fill, length, push};
use super::law::SpringLaw;
use crate::element::kernel::{Element, Scale};

/// Gap by the distance s of two nodes, across an axis if there is one: its opening is r - s inside
/// and s - r outside, in small and large motion. docs/theory.md eq. (3.112)
#[derive(Debug, Clone, PartialEq)]
pub struct RadialSpring<const D: usize> {
    /// Undeformed way from the first to the second node [L].
    pub apart: [f64; D],
    /// Unit vector along which the nodes move freely; `None`: none.
    pub axis: Option<[f64; D]>,
    /// Whether the distance must stay below r, as of a bar in a tube; above it otherwise.
    pub inside: bool,
    /// Distance r at which the gap closes [L].
    pub radius: f64,
    /// Force by the opening less r.
    pub law: SpringLaw,
}

impl<const D: usize> RadialSpring<D> {
    fn across(&self, way: [f64; D]) -> [f64; D] {
        let Some(axis) = self.axis else { return way };
        let along: f64 = axis.iter().zip(way).map(|(a, x)| a * x).sum();
        std::array::from_fn(|k| way[k] - along * axis[k])
    }

    /// Sign of the opening with the distance.
    fn sign(&self) -> f64 {
        if self.inside { -1.0 } else { 1.0 }
    }

    fn answer(&self, distance: f64) -> [f64; 3] {
        self.law.answer(self.sign() * (distance - self.radius) - self.radius)
    }

    /// Writes internal force and tangent (row-major, symmetric), returns the energy [F L], which is
    /// zero at rest. Where both nodes meet there is no direction, and so no force.
    pub fn force_and_tangent(&self, q: &[f64], force: &mut [f64], tangent: &mut [f64]) -> f64 {
        let way = self.across(std::array::from_fn(|k| self.apart[k] + q[D + k] - q[k]));
        let distance = length(&way);
        let [energy, pull, stiffness] = self.answer(distance);
        let energy = energy - self.answer(length(&self.across(self.apart)))[0];
        if distance <= 0.0 {
            force.fill(0.0);
            tangent.fill(0.0);
            return energy;
        }
        let t = way.map(|x| x / distance);
        let pull = self.sign() * pull;
        push(&t, pull, force);
        let unit: [[f64; D]; D] = std::array::from_fn(|i| {
            self.across(std::array::from_fn(|k| if i == k { 1.0 } else { 0.0 }))
        });
        let turns = pull / distance;
        fill(tangent, D, |i, j| stiffness * t[i] * t[j] + turns * (unit[i][j] - t[i] * t[j]));
        energy
    }
}

macro_rules! radial_spring {
    ($dimension:literal, $variables:literal, $entries:literal) => {
        impl Element<$variables, $entries> for RadialSpring<$dimension> {
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

radial_spring!(2, 4, 16);
radial_spring!(3, 6, 36);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::normal::NormalLaw;

    fn gap(axis: Option<[f64; 3]>, inside: bool, radius: f64) -> RadialSpring<3> {
        let law = Box::new(NormalLaw::Linear { stiffness: 7.0 });
        let law = SpringLaw::Gap { clearance: radius, law };
        RadialSpring { apart: [0.3, -0.2, 0.5], axis, inside, radius, law }
    }

    /// Requirement: open gaps carry nothing; closed ones press along the distance, or across the
    /// axis, by stiffness times what is beyond. By hand.
    #[test]
    fn round_gaps_close() {
        let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
        let q = [0.0, 0.0, 0.0, 2.7, 4.2, 0.5];
        // way (3, 4, 1)
        for (own, expected) in [
            (gap(None, true, 6.0), [0.0; 3]),
            (gap(None, false, 4.0), [0.0; 3]),
            (gap(Some([0.0, 0.0, 1.0]), true, 4.0), [4.2, 5.6, 0.0]),
            (gap(Some([0.0, 0.0, 1.0]), false, 7.0), [-8.4, -11.2, 0.0]),
        ] {
            own.force_and_tangent(&q, &mut force, &mut tangent);
            for k in 0..3 {
                assert!((force[3 + k] - expected[k]).abs() < 1e-12, "{own:?} {force:?}");
                assert!((force[k] + expected[k]).abs() < 1e-12, "{own:?} {force:?}");
            }
        }
    }

    /// Requirement: force and tangent are the derivatives of the energy, which is zero at rest.
    #[test]
    fn round_gaps_have_an_energy() {
        let turned = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
        let q = [0.1, 0.3, -0.2, 0.7, -0.4, 0.6];
        let at = |own: &RadialSpring<3>, q: &[f64; 6]| {
            let (mut force, mut tangent) = ([0.0; 6], [0.0; 36]);
            let energy = own.force_and_tangent(q, &mut force, &mut tangent);
            (energy, force, tangent)
        };
        for own in [
            gap(None, true, 0.4),
            gap(None, false, 2.0),
            gap(Some(turned), true, 0.2),
            gap(Some(turned), false, 3.0),
        ] {
            assert_eq!(at(&own, &[0.0; 6]).0, 0.0);
            let (energy, force, tangent) = at(&own, &q);
            assert!(energy != 0.0 && force.iter().any(|f| f.abs() > 1e-3), "{own:?} is open");
            for i in 0..6 {
                let moved = |h: f64| {
                    let mut q = q;
                    q[i] += h;
                    at(&own, &q)
                };
                let (after, before) = (moved(1e-5), moved(-1e-5));
                assert!((force[i] - (after.0 - before.0) / 2e-5).abs() < 1e-8);
                for j in 0..6 {
                    let slope = (after.1[j] - before.1[j]) / 2e-5;
                    assert!((tangent[6 * i + j] - slope).abs() < 1e-7, "{i} {j} {own:?}");
                }
            }
        }
    }
}
