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

use super::Answer;
use super::tensor::{Matrix, Moduli, PAIRS, Symmetric, add_dyad, eigen};

/// Principal logarithmic strains and directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axes {
    /// ln of the principal stretches [1].
    pub logs: [f64; 3],
    /// Unit vectors, a row each.
    pub directions: Matrix,
}

impl Axes {
    /// Those of b - 1.
    pub fn of(left: &Symmetric) -> Self {
        let (values, directions) = eigen(left);
        Self { logs: values.map(|value| 0.5 * value.ln_1p()), directions }
    }

    /// The tensor with those principal values.
    pub fn tensor(&self, values: &[f64; 3]) -> Symmetric {
        let n = &self.directions;
        PAIRS.map(|[i, j]| {
            values[0] * n[0][i] * n[0][j]
                + values[1] * n[1][i] * n[1][j]
                + values[2] * n[2][i] * n[2][j]
        })
    }

    /// Stress and moduli from principal stresses [F/L2] and their derivatives by the logarithmic
    /// strains.
    pub fn answer(&self, stresses: &[f64; 3], slopes: &Matrix, energy: f64) -> Answer {
        let n = &self.directions;
        let dyads: [Symmetric; 3] = std::array::from_fn(|a| PAIRS.map(|[i, j]| n[a][i] * n[a][j]));
        let mut moduli: Moduli = [[0.0; 6]; 6];
        for a in 0..3 {
            let mut row = slopes[a];
            row[a] -= 2.0 * stresses[a];
            let by: Symmetric = std::array::from_fn(|k| {
                row[0] * dyads[0][k] + row[1] * dyads[1][k] + row[2] * dyads[2][k]
            });
            for (line, dyad) in moduli.iter_mut().zip(&dyads[a]) {
                line.iter_mut().zip(&by).for_each(|(entry, by)| *entry += dyad * by);
            }
        }
        for [a, b] in [[0, 1], [0, 2], [1, 2]] {
            let both = PAIRS.map(|[i, j]| n[a][i] * n[b][j] + n[b][i] * n[a][j]);
            add_dyad(&mut moduli, across(&self.logs, stresses, slopes, [a, b]), &both);
        }
        Answer { stress: self.tensor(stresses), moduli, energy, dissipation: 0.0 }
    }
}

/// Difference of logarithmic strains below which the stresses' difference is taken from slopes [1].
const NEAR: f64 = 1e-5;

/// The modulus of a pair of axes: docs/theory.md eq. (3.41).
fn across(logs: &[f64; 3], stresses: &[f64; 3], slopes: &Matrix, [a, b]: [usize; 2]) -> f64 {
    let d = logs[a] - logs[b];
    let mean = 0.5 * (stresses[a] + stresses[b]);
    let (ratio, growth) = if d.abs() < NEAR {
        let ratio = 0.5 * (slopes[a][a] - slopes[a][b] - slopes[b][a] + slopes[b][b]);
        (ratio, 1.0 + d * d / 3.0)
    } else {
        ((stresses[a] - stresses[b]) / d, d / d.tanh())
    };
    0.5 * ratio * growth - mean
}
