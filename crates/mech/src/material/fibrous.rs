//! Soft tissue: rubber with families of fibres that bear tension alone.
//!
//! ```text
//!   W = C10 (I1 - 3) + ((J^2 - 1)/2 - ln J)/D + k1/(2 k2) sum (exp(k2 <E>^2) - 1)
//!   E = kappa (I1 - 3) + (1 - 3 kappa)(I4 - 1)       I1 = J^(-2/3) tr C,  I4 = J^(-2/3) a C a
//! ```
//!
//! This is the law of [holzapfel2000] and [gasser2006]: kappa is 0 where all fibres of a family run along a, and 1/3
//! where they run all ways. docs/theory.md eqs. (3.113) to (3.115).

use super::answer::Answer;
use super::elastic::Elastic;
use super::tensor::{
    COUNTS, Matrix, Symmetric, add_dyad, carried, contract, deformation, deviator, pushed, right,
};
use crate::differentiate::{Real, Second, ln_1p, taylor};

/// A matrix with families of fibres.
#[derive(Debug, Clone, PartialEq)]
pub struct Fibrous {
    /// C10 of the matrix [F/L2].
    pub matrix: f64,
    /// D: two over the bulk modulus [L2/F].
    pub softness: f64,
    /// k1 of the fibres [F/L2].
    pub stiffness: f64,
    /// k2, their exponent [1].
    pub exponent: f64,
    /// kappa, how far they disperse: 0 to 1/3 [1].
    pub dispersion: f64,
    /// Mean directions of the families, unit vectors along the axes of the material.
    pub directions: Vec<[f64; 3]>,
}

impl Fibrous {
    /// Elasticity of small strains without the fibres.
    pub fn small_matrix(&self) -> Elastic {
        Elastic::of_moduli(2.0 * self.matrix, 2.0 / self.softness)
    }

    /// A stiffness that bounds that of a stretch at small strain [F/L2].
    pub fn stiffest(&self) -> f64 {
        let families = self.directions.len() as f64;
        2.0 / self.softness + 8.0 / 3.0 * self.matrix + 4.0 * families * self.stiffness
    }

    /// Energy of C - 1, measured from one so that small strains keep their digits.
    fn energy<R: Real>(&self, c: &[R; 6]) -> R {
        let number = R::from_f64;
        let [xx, yy, zz, xy, xz, yz] = *c;
        let trace = xx + yy + zz;
        let minors = xx * yy + xx * zz + yy * zz - xy * xy - xz * xz - yz * yz;
        let determinant =
            xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        let growth = trace + minors + determinant; // J^2 - 1
        let shrunk = (number(-1.0 / 3.0) * ln_1p(growth)).exp_m1(); // J^(-2/3) - 1
        let shape = number(3.0) * shrunk + trace + shrunk * trace; // I1 - 3
        let at = growth.value();
        let volume = [0.5 * (at - at.ln_1p()), 0.5 * at / (1.0 + at), 0.5 / (1.0 + at).powi(2)];
        let mut energy =
            number(self.matrix) * shape + number(1.0 / self.softness) * taylor(growth, volume);
        for [a, b, d] in &self.directions {
            let twice = |x: f64, y: f64| number(2.0 * x * y);
            let along = number(a * a) * xx
                + number(b * b) * yy
                + number(d * d) * zz
                + twice(*a, *b) * xy
                + twice(*a, *d) * xz
                + twice(*b, *d) * yz;
            let stretch = shrunk + along + shrunk * along; // I4 - 1
            let strain =
                number(self.dispersion) * shape + number(1.0 - 3.0 * self.dispersion) * stretch;
            if strain.value() > 0.0 {
                let power = (number(self.exponent) * strain * strain).exp_m1();
                energy = energy + number(0.5 * self.stiffness / self.exponent) * power;
            }
        }
        energy
    }

    /// Answer to a small strain.
    pub fn small(&self, strain: &Symmetric) -> Answer {
        let mut answer = self.small_matrix().small(strain);
        for [a, b, c] in &self.directions {
            let across = [a * a, b * b, c * c, a * b, a * c, b * c];
            let way = deviator(&across).map(|x| 2.0 * (1.0 - 3.0 * self.dispersion) * x);
            let stretch = contract(&way, strain);
            if stretch > 0.0 {
                (0..6).for_each(|k| answer.stress[k] += self.stiffness * stretch * way[k]);
                add_dyad(&mut answer.moduli, self.stiffness, &way);
                answer.energy += 0.5 * self.stiffness * stretch * stretch;
            }
        }
        answer
    }

    /// Answer to a deformation.
    pub fn large(&self, gradient: &Matrix) -> Answer {
        let c = right(gradient);
        let energy = self.energy(&Second::variables(&c));
        // by Green's strain: S = 2 dW/dC, a component off the diagonal stands twice in C
        let second = std::array::from_fn(|k| 2.0 * energy.gradient[k] / COUNTS[k]);
        let moduli = std::array::from_fn(|k| {
            std::array::from_fn(|l| 4.0 * energy.hessian[k][l] / (COUNTS[k] * COUNTS[l]))
        });
        let f = deformation(gradient);
        Answer {
            stress: carried(&f, &second),
            moduli: pushed(&f, &moduli),
            energy: energy.value,
            dissipation: 0.0,
        }
    }
}
