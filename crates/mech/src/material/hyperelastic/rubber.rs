//! Rubbers and what they answer.

use crate::differentiate::{Real, Second, taylor};
use crate::material::answer::Answer;
use crate::material::elastic::{Elastic, add_turned};
use crate::material::principal::Axes;
use crate::material::tensor::{
    Matrix, Moduli, Symmetric, UNIT, add, add_dyad, add_pair, add_unit, deviator, dilation, left,
    square, trace,
};

/// The most terms of a form.
pub const MOST_TERMS: usize = 6;

/// Energy of the change of volume, sum over (J - 1)^(2 i) / D_i, as 1/D_i [F/L2].
pub type Volume = [f64; MOST_TERMS];

/// A rubber.
#[derive(Debug, Clone, PartialEq)]
pub enum Rubber {
    /// C_ij (I1 - 3)^i (I2 - 3)^j: powers and coefficient of every term [F/L2].
    Polynomial {
        /// (i, j, C_ij).
        terms: Vec<(u8, u8, f64)>,
        /// Change of volume.
        volume: Volume,
    },
    /// Arruda and Boyce, five terms.
    ArrudaBoyce {
        /// mu [F/L2].
        shear: f64,
        /// Locking stretch lambda_m [1].
        locking: f64,
        /// 1/D [F/L2].
        volume: f64,
    },
    /// Ogden.
    Ogden {
        /// (mu_i [F/L2], alpha_i [1]).
        terms: Vec<[f64; 2]>,
        /// Change of volume.
        volume: Volume,
    },
}

/// Coefficients of the five terms of the law of [arruda1993].
pub(super) const CHAIN: [f64; 5] =
    [0.5, 1.0 / 20.0, 11.0 / 1050.0, 19.0 / 7000.0, 519.0 / 673_750.0];

impl Rubber {
    /// Elasticity of small strains.
    pub fn small(&self) -> Elastic {
        Elastic::of_moduli(self.shear_modulus(), self.bulk_modulus())
    }

    /// Shear modulus of small strains [F/L2].
    pub fn shear_modulus(&self) -> f64 {
        match self {
            Self::Polynomial { terms, .. } => {
                2.0 * terms.iter().filter(|t| t.0 + t.1 == 1).map(|t| t.2).sum::<f64>()
            }
            Self::ArrudaBoyce { shear, locking, .. } => {
                let by = |k: usize| {
                    let power = i32::try_from(k).unwrap_or(0);
                    2.0 * CHAIN[k] * (power + 1) as f64 * 3f64.powi(power) / locking.powi(2 * power)
                };
                shear * (0..5).map(by).sum::<f64>()
            }
            Self::Ogden { terms, .. } => terms.iter().map(|[shear, _]| shear).sum(),
        }
    }

    /// Bulk modulus of small strains [F/L2].
    pub fn bulk_modulus(&self) -> f64 {
        match self {
            Self::Polynomial { volume, .. } | Self::Ogden { volume, .. } => 2.0 * volume[0],
            Self::ArrudaBoyce { volume, .. } => 2.0 * volume,
        }
    }

    /// Energy per undeformed volume of I1 - 3, I2 - 3 and J - 1; not that of Ogden's stretches.
    pub(super) fn energy<R: Real>(&self, x: R, y: R, j: R) -> R {
        let number = R::from_f64;
        match self {
            Self::Polynomial { terms, volume } => {
                let mut sum = of_volume(volume, j);
                for &(i, k, coefficient) in terms {
                    sum = sum + number(coefficient) * x.powi(i.into()) * y.powi(k.into());
                }
                sum
            }
            Self::ArrudaBoyce { shear, locking, volume } => {
                // (J^2 - 1)/2 - ln J, whose slope J - 1/J differences of rounded numbers would spoil
                let (at, grown) = (j.value(), 1.0 + j.value());
                let twice = at * (2.0 + at);
                let of_volume =
                    [0.5 * twice - at.ln_1p(), twice / grown, 1.0 + 1.0 / (grown * grown)];
                let mut sum = number(*volume) * taylor(j, of_volume);
                for (k, chain) in CHAIN.iter().enumerate() {
                    let power = i32::try_from(k).unwrap_or(0);
                    let scale = shear * chain / locking.powi(2 * power);
                    let first = (x + number(3.0)).powi(power + 1);
                    sum = sum + number(scale) * (first - number(3f64.powi(power + 1)));
                }
                sum
            }
            Self::Ogden { volume, .. } => of_volume(volume, j),
        }
    }

    /// Mean stress, a pull, of a change of volume J - 1, and its derivative by it [F/L2].
    pub fn volume_stress(&self, dilation: f64) -> [f64; 2] {
        let none = Second::constant(0.0);
        let w: Second<1> = self.energy(none, none, Second::variable(dilation, 0));
        [w.gradient[0], w.hessian[0][0]]
    }

    /// The same with all its stresses against changes of shape and of volume multiplied by factors.
    #[must_use]
    pub fn scaled(&self, [shape, bulk]: [f64; 2]) -> Self {
        let volumes = |volume: &Volume| volume.map(|inverse| bulk * inverse);
        match self {
            Self::Polynomial { terms, volume } => Self::Polynomial {
                terms: terms.iter().map(|&(i, j, own)| (i, j, shape * own)).collect(),
                volume: volumes(volume),
            },
            Self::ArrudaBoyce { shear, locking, volume } => {
                Self::ArrudaBoyce { shear: shape * shear, locking: *locking, volume: bulk * volume }
            }
            Self::Ogden { terms, volume } => Self::Ogden {
                terms: terms.iter().map(|&[shear, power]| [shape * shear, power]).collect(),
                volume: volumes(volume),
            },
        }
    }

    /// Answer to a deformation.
    pub fn large(&self, gradient: &Matrix) -> Answer {
        let small = left(gradient);
        let j = dilation(gradient);
        match self {
            Self::Ogden { terms, volume } => ogden(terms, volume, &small, j),
            _ => self.by_invariants(&small, j),
        }
    }

    /// docs/theory.md eq. (3.42).
    fn by_invariants(&self, small: &Symmetric, j: f64) -> Answer {
        let q = (-2.0 / 3.0 * j.ln_1p()).exp();
        let t = trace(small);
        let squared = square(small);
        let first = q * (3.0 + t);
        // I2 of b = 1 + e: 3 + 2 t + (t^2 - tr e^2)/2
        let second = q * q * (3.0 + 2.0 * t + 0.5 * (t * t - trace(&squared)));
        let [x, y, dilation] = Second::variables(&[first - 3.0, second - 3.0, j]);
        let w: Second<3> = self.energy(x, y, dilation);
        let by_second = add(&small.map(|e| (1.0 + t) * e), -1.0, &squared);
        let rows: [Symmetric; 3] = [
            deviator(small).map(|e| 2.0 * q * e),
            deviator(&by_second).map(|e| 2.0 * q * q * e),
            UNIT.map(|e| (1.0 + j) * e),
        ];
        let g = &w.gradient;
        let stress =
            std::array::from_fn(|k| g[0] * rows[0][k] + g[1] * rows[1][k] + g[2] * rows[2][k]);
        let mut moduli: Moduli = [[0.0; 6]; 6];
        let b = add(&UNIT, 1.0, small).map(|e| q * e);
        add_pair(&mut moduli, -4.0 / 3.0 * g[0], &b, &UNIT);
        add_dyad(
            &mut moduli,
            4.0 / 9.0 * (g[0] * first + 4.0 * g[1] * second) + g[2] * (1.0 + j),
            &UNIT,
        );
        let shape = 4.0 / 3.0 * (g[0] * first + 2.0 * g[1] * second);
        add_unit(&mut moduli, shape - 2.0 * g[2] * (1.0 + j));
        if g[1] != 0.0 {
            let both = add(&b.map(|e| first * e), -1.0, &square(&b));
            add_dyad(&mut moduli, 4.0 * g[1], &b);
            add_turned(&mut moduli, -4.0 * g[1], &b);
            add_pair(&mut moduli, -8.0 / 3.0 * g[1], &both, &UNIT);
        }
        for i in 0..3 {
            add_dyad(&mut moduli, w.hessian[i][i], &rows[i]);
            for k in 0..i {
                if w.hessian[i][k] != 0.0 {
                    add_pair(&mut moduli, w.hessian[i][k], &rows[i], &rows[k]);
                }
            }
        }
        Answer { stress, moduli, energy: w.value, dissipation: 0.0 }
    }
}

fn of_volume<R: Real>(volume: &Volume, j: R) -> R {
    let squared = j * j;
    let mut sum = R::from_f64(0.0);
    for coefficient in volume.iter().rev() {
        sum = (sum + R::from_f64(*coefficient)) * squared;
    }
    sum
}

/// docs/theory.md eq. (3.43).
fn ogden(terms: &[[f64; 2]], volume: &Volume, small: &Symmetric, j: f64) -> Answer {
    let axes = Axes::of(small);
    let even = j.ln_1p() / 3.0;
    let shape = axes.logs.map(|log| log - even);
    let u: Second<1> = of_volume(volume, Second::variable(j, 0));
    let pressure = (1.0 + j) * u.gradient[0];
    let mut stresses = [pressure; 3];
    let mut slopes = [[pressure + (1.0 + j) * (1.0 + j) * u.hessian[0][0]; 3]; 3];
    let mut energy = u.value;
    for &[shear, power] in terms {
        // l^alpha - 1, so that small strains keep their digits
        let grown = shape.map(|log| (power * log).exp_m1());
        let sum = grown[0] + grown[1] + grown[2];
        energy += 2.0 * shear / (power * power) * sum;
        for a in 0..3 {
            stresses[a] += 2.0 * shear / power * (grown[a] - sum / 3.0);
            slopes[a][a] += 2.0 * shear * (1.0 + grown[a]);
            for b in 0..3 {
                slopes[a][b] +=
                    2.0 * shear * ((sum + 3.0) / 9.0 - (2.0 + grown[a] + grown[b]) / 3.0);
            }
        }
    }
    axes.answer(&stresses, &slopes, energy)
}
