//! Foam of rubber: its energy is of the principal stretches and changes volume with its shape.
//!
//! ```text
//!   W = sum 2 mu_i/alpha_i^2 (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3
//!                             + (J^(-alpha_i beta_i) - 1)/beta_i),   beta_i = nu_i/(1 - 2 nu_i)
//! ```
//!
//! The law of [storakers1986]: a bar of one term keeps the ratio nu of its logarithmic strains at any
//! strain. docs/theory.md eqs. (3.99) and (3.100).

use super::answer::Answer;
use super::elastic::Elastic;
use super::principal::Axes;
use super::tensor::{Matrix, left};

/// One term of the energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// mu [F/L2].
    pub shear: f64,
    /// alpha, not zero [1].
    pub power: f64,
    /// Poisson's ratio of the term, above -1 and below 1/2 [1].
    pub poisson: f64,
}

/// A foam.
#[derive(Debug, Clone, PartialEq)]
pub struct Foam {
    /// Its terms.
    pub terms: Vec<Term>,
}

impl Term {
    /// beta [1].
    fn volume_power(&self) -> f64 {
        self.poisson / (1.0 - 2.0 * self.poisson)
    }
}

impl Foam {
    /// Shear modulus of small strains [F/L2].
    pub fn shear_modulus(&self) -> f64 {
        self.terms.iter().map(|term| term.shear).sum()
    }

    /// Bulk modulus of small strains [F/L2].
    pub fn bulk_modulus(&self) -> f64 {
        let of = |term: &Term| 2.0 * term.shear * (1.0 / 3.0 + term.volume_power());
        self.terms.iter().map(of).sum()
    }

    /// Elasticity of small strains.
    pub fn small(&self) -> Elastic {
        Elastic::of_moduli(self.shear_modulus(), self.bulk_modulus())
    }

    /// Answer to a deformation: docs/theory.md eqs. (3.99) and (3.100).
    pub fn large(&self, gradient: &Matrix) -> Answer {
        let axes = Axes::of(&left(gradient));
        let volume = axes.logs[0] + axes.logs[1] + axes.logs[2];
        let (mut stresses, mut slopes, mut energy) = ([0.0; 3], [[0.0; 3]; 3], 0.0);
        for term in &self.terms {
            let (power, beta) = (term.power, term.volume_power());
            // less one each, so that small strains keep their digits
            let grown = axes.logs.map(|log| (power * log).exp_m1());
            let shrunk = (-power * beta * volume).exp_m1();
            let of_volume = if beta == 0.0 { -power * volume } else { shrunk / beta };
            let sum = grown[0] + grown[1] + grown[2] + of_volume;
            energy += 2.0 * term.shear / (power * power) * sum;
            for a in 0..3 {
                stresses[a] += 2.0 * term.shear / power * (grown[a] - shrunk);
                slopes[a].iter_mut().for_each(|s| *s += 2.0 * term.shear * beta * (1.0 + shrunk));
                slopes[a][a] += 2.0 * term.shear * (1.0 + grown[a]);
            }
        }
        axes.answer(&stresses, &slopes, energy)
    }
}
