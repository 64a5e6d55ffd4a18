//! Deformation plasticity: a metal under growing loads as an elastic one of a curved law, after
//! [ramberg1943].
//!
//! ```text
//!   stress |        ___---  E eps = q + alpha (q/s0)^(n-1) q   along one axis
//!    s0 ---|   __--
//!          |  /             the change of volume stays linear, the law gives back
//!          | /              all of its work: no loading and unloading differ
//!          |/_________ strain
//! ```
//!
//! docs/theory.md eqs. (3.101) to (3.103).

use super::answer::Answer;
use super::elastic::Elastic;
use super::logarithmic;
use super::tensor::{Matrix, Symmetric, add_dyad, add_unit, contract, deviator, trace};

/// A metal after Ramberg and Osgood.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RambergOsgood {
    /// Elasticity of small stresses.
    pub elastic: Elastic,
    /// Yield stress s0 [F/L2].
    pub stress: f64,
    /// Exponent n, at least one [1].
    pub exponent: f64,
    /// Yield offset alpha [1].
    pub offset: f64,
}

/// Newton's steps to a stress, from above: the curve is convex, and the first one is near.
const STEPS: usize = 60;

impl RambergOsgood {
    /// Factor of the power of the stress: alpha / (E s0^(n-1)), times q^(n-1) [L2/F].
    fn offset_at(&self, stress: f64) -> f64 {
        self.offset / self.elastic.modulus * (stress / self.stress).powf(self.exponent - 1.0)
    }

    /// Equivalent stress [F/L2] of an equivalent strain of the shape, and its slope:
    /// docs/theory.md eq. (3.102).
    fn equivalent(&self, strain: f64) -> [f64; 2] {
        let three = 3.0 * self.elastic.shear_modulus();
        let slope = |stress: f64| 1.0 / (1.0 / three + self.exponent * self.offset_at(stress));
        if strain == 0.0 {
            return [0.0, slope(0.0)];
        }
        // what either part alone would need bounds the stress from above
        let part = strain * self.elastic.modulus / (self.offset * self.stress);
        let mut stress = (three * strain).min(self.stress * part.powf(1.0 / self.exponent));
        for _ in 0..STEPS {
            let excess = stress * (1.0 / three + self.offset_at(stress)) - strain;
            let step = excess * slope(stress);
            stress -= step;
            if step <= f64::EPSILON * stress {
                break;
            }
        }
        [stress, slope(stress)]
    }

    /// Answer to a small strain: docs/theory.md eqs. (3.101) and (3.103).
    pub fn small(&self, strain: &Symmetric) -> Answer {
        let (shape, volume) = (deviator(strain), trace(strain));
        let size = contract(&shape, &shape).sqrt();
        let equivalent = (2.0 / 3.0f64).sqrt() * size;
        let [stress, slope] = self.equivalent(equivalent);
        let bulk = self.elastic.bulk_modulus();
        let twice = match equivalent > 0.0 {
            true => 2.0 / 3.0 * stress / equivalent,
            false => 2.0 / 3.0 * slope,
        };
        let even = bulk * volume;
        let own = std::array::from_fn(|k| twice * shape[k] + if k < 3 { even } else { 0.0 });
        let mut moduli = [[0.0; 6]; 6];
        add_unit(&mut moduli, twice);
        (0..3).for_each(|i| (0..3).for_each(|j| moduli[i][j] += bulk - twice / 3.0));
        if size > 0.0 {
            let way = shape.map(|e| e / size);
            add_dyad(&mut moduli, 2.0 / 3.0 * slope - twice, &way);
        }
        let kept = stress * stress / (6.0 * self.elastic.shear_modulus());
        let power = self.exponent / (self.exponent + 1.0);
        let bent = power * self.offset_at(stress) * stress * stress;
        let energy = 0.5 * even * volume + kept + bent;
        Answer { stress: own, moduli, energy, dissipation: 0.0 }
    }

    /// Answer to a deformation: the law of small strain in logarithmic strain.
    pub fn large(&self, gradient: &Matrix) -> Answer {
        logarithmic::answer(gradient, |strain| self.small(strain))
    }
}
