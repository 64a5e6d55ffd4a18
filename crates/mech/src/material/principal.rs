//! Isotropic laws in principal logarithmic strains.
//!
//! ```text
//!        ^ n2                 tau = sum_a beta_a n_a n_a,  beta_a = dW/d eps_a
//!     ___|___                 moduli: along the axes  d beta_a/d eps_b - 2 beta_a delta_ab
//!    |   |   |--> n1                  across a pair   (delta/2) coth d - mean
//!    |_______|
//! ```
//!
//! n_a: principal directions in the deformed body, d: difference of two strains, delta: that of
//! their stresses. docs/theory.md eqs. (3.40) and (3.41).

use super::answer::Answer;
use super::tensor::{Matrix, Moduli, Symmetric, eigen};

/// Principal logarithmic strains and directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// ln of the principal stretches [1].
    pub logs: [f64; 3],
    /// The squares of the principal stretches less one [1].
    squares: [f64; 3],
    /// Unit vectors, a row each.
    pub directions: Matrix,
}

impl Axes {
    /// Those of b - 1.
    pub fn of(left: &Symmetric) -> Self {
        let (values, directions) = eigen(left);
        Self { logs: values.map(|value| 0.5 * value.ln_1p()), squares: values, directions }
    }

    /// The tensor with those principal values.
    pub fn tensor(&self, values: &[f64; 3]) -> Symmetric {
        let [x, y, z] = self.directions.map(|direction| square(&direction));
        std::array::from_fn(|k| values[0] * x[k] + values[1] * y[k] + values[2] * z[k])
    }

    /// Stress and moduli from principal stresses [F/L2] and their derivatives by the logarithmic
    /// strains.
    pub fn answer(&self, stresses: &[f64; 3], slopes: &Matrix, energy: f64) -> Answer {
        let n = &self.directions;
        let (x, y, z) = (&n[0], &n[1], &n[2]);
        let dyads: [Symmetric; 6] =
            [square(x), square(y), square(z), both(x, y), both(x, z), both(y, z)];
        let mut by = [[0.0; 6]; 6];
        for (a, by) in by.iter_mut().enumerate().take(3) {
            for (b, dyad) in dyads.iter().enumerate().take(3) {
                let slope = slopes[a][b] - if a == b { 2.0 * stresses[a] } else { 0.0 };
                by.iter_mut().zip(dyad).for_each(|(sum, d)| *sum += slope * d);
            }
        }
        for (k, pair) in [[0, 1], [0, 2], [1, 2]].into_iter().enumerate() {
            let modulus = self.across(stresses, slopes, pair);
            by[3 + k].iter_mut().zip(&dyads[3 + k]).for_each(|(own, d)| *own = modulus * d);
        }
        let mut moduli: Moduli = [[0.0; 6]; 6];
        for (dyad, by) in dyads.iter().zip(&by) {
            for (row, d) in moduli.iter_mut().zip(dyad) {
                row.iter_mut().zip(by).for_each(|(entry, by)| *entry += d * by);
            }
        }
        Answer { stress: self.tensor(stresses), moduli, energy, dissipation: 0.0 }
    }

    /// The modulus of a pair of axes, docs/theory.md eq. (3.41): coth of the difference of two
    /// logarithms is the sum of the squares over their difference.
    fn across(&self, stresses: &[f64; 3], slopes: &Matrix, [a, b]: [usize; 2]) -> f64 {
        let d = self.logs[a] - self.logs[b];
        let mean = 0.5 * (stresses[a] + stresses[b]);
        if d.abs() < NEAR {
            let ratio = 0.5 * (slopes[a][a] - slopes[a][b] - slopes[b][a] + slopes[b][b]);
            return 0.5 * ratio * (1.0 + d * d / 3.0) - mean;
        }
        let [x, y] = [self.squares[a], self.squares[b]];
        0.5 * (stresses[a] - stresses[b]) * ((2.0 + x + y) / (x - y)) - mean
    }
}

/// a a.
#[inline]
fn square(a: &[f64; 3]) -> Symmetric {
    [a[0] * a[0], a[1] * a[1], a[2] * a[2], a[0] * a[1], a[0] * a[2], a[1] * a[2]]
}

/// a b + b a.
#[inline]
fn both(a: &[f64; 3], b: &[f64; 3]) -> Symmetric {
    [
        2.0 * a[0] * b[0],
        2.0 * a[1] * b[1],
        2.0 * a[2] * b[2],
        a[0] * b[1] + b[0] * a[1],
        a[0] * b[2] + b[0] * a[2],
        a[1] * b[2] + b[1] * a[2],
    ]
}

/// Difference of logarithmic strains below which the stresses' difference is taken from slopes [1].
const NEAR: f64 = 1e-5;
