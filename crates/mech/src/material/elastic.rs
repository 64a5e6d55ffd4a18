//! Linear elasticity: at small strain, and the two readings of it at large strain.
//!
//! ```text
//!   stress |   / Hencky: Kirchhoff stress to ln V      (*ELASTIC of Abaqus)
//!          |  /
//!          | /  ___ Saint Venant, Kirchhoff: second Piola-Kirchhoff stress to Green's strain
//!          |/__/____ stretch                            (*ELASTIC of CalculiX)
//! ```

use super::principal::Axes;
use super::tensor::{
    Matrix, Moduli, PAIRS, Symmetric, add, add_dyad, add_unit, contract, deformation, left, right,
    square, trace,
};
use super::{Answer, Elastic};

/// Which strain and stress an elastic law joins where displacements are large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LargeStrain {
    /// ln V and Kirchhoff stress.
    #[default]
    Logarithmic,
    /// Green's strain and second Piola-Kirchhoff stress.
    Green,
}

impl Elastic {
    /// Lame's first constant [F/L2].
    pub fn lame(&self) -> f64 {
        self.bulk_modulus() - 2.0 / 3.0 * self.shear_modulus()
    }

    /// Moduli of small strains.
    pub fn moduli(&self) -> Moduli {
        let mut moduli = [[0.0; 6]; 6];
        add_unit(&mut moduli, 2.0 * self.shear_modulus());
        (0..3).for_each(|i| (0..3).for_each(|j| moduli[i][j] += self.lame()));
        moduli
    }

    /// Stress of small strains: sigma = 2 G eps + L tr eps, docs/theory.md eq. (3.34).
    pub fn stress(&self, strain: &Symmetric) -> Symmetric {
        let even = self.lame() * trace(strain);
        let twice = 2.0 * self.shear_modulus();
        std::array::from_fn(|k| twice * strain[k] + if k < 3 { even } else { 0.0 })
    }

    /// Answer to a small strain.
    pub fn small(&self, strain: &Symmetric) -> Answer {
        let stress = self.stress(strain);
        let energy = 0.5 * contract(&stress, strain);
        Answer { stress, moduli: self.moduli(), energy, dissipation: 0.0 }
    }

    /// W = G sum eps_a^2 + L/2 (sum eps_a)^2 in logarithmic strains: docs/theory.md eq. (3.35).
    pub fn hencky(&self, gradient: &Matrix) -> Answer {
        let axes = Axes::of(&left(gradient));
        let (stresses, slopes, energy) = self.principal(&axes.logs);
        axes.answer(&stresses, &slopes, energy)
    }

    /// Principal stresses of principal logarithmic strains, their slopes and the energy.
    pub(super) fn principal(&self, logs: &[f64; 3]) -> ([f64; 3], Matrix, f64) {
        let (lame, twice) = (self.lame(), 2.0 * self.shear_modulus());
        let sum = logs[0] + logs[1] + logs[2];
        let stresses = logs.map(|log| twice * log + lame * sum);
        let mut slopes = [[lame; 3]; 3];
        (0..3).for_each(|a| slopes[a][a] += twice);
        let energy = 0.5 * (0..3).map(|a| stresses[a] * logs[a]).sum::<f64>();
        (stresses, slopes, energy)
    }

    /// W = L/2 (tr E)^2 + G E:E in Green's strain: docs/theory.md eq. (3.36).
    pub fn green(&self, gradient: &Matrix) -> Answer {
        let strain = right(gradient).map(|entry| 0.5 * entry);
        let (lame, shear) = (self.lame(), self.shear_modulus());
        let small = left(gradient);
        // b = 1 + small; F E F' = (b^2 - b)/2 = b small / 2
        let mut b = small;
        (0..3).for_each(|k| b[k] += 1.0);
        let carried = add(&small, 1.0, &square(&small)).map(|entry| 0.5 * entry);
        let even = lame * trace(&strain);
        let stress = std::array::from_fn(|k| even * b[k] + 2.0 * shear * carried[k]);
        let mut moduli = [[0.0; 6]; 6];
        add_dyad(&mut moduli, lame, &b);
        add_turned(&mut moduli, 2.0 * shear, &b);
        let energy = 0.5 * even * trace(&strain) + shear * contract(&strain, &strain);
        Answer { stress, moduli, energy, dissipation: 0.0 }
    }
}

/// Adds `factor` (b_ik b_jl + b_il b_jk)/2.
pub(super) fn add_turned(moduli: &mut Moduli, factor: f64, b: &Symmetric) {
    let b = super::tensor::full(b);
    for (row, [i, j]) in moduli.iter_mut().zip(PAIRS) {
        for (entry, [k, l]) in row.iter_mut().zip(PAIRS) {
            *entry += 0.5 * factor * (b[i][k] * b[j][l] + b[i][l] * b[j][k]);
        }
    }
}

/// Elastic moduli without isotropy, in the axes of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anisotropic {
    /// Stress of a strain, components 11, 22, 33, 12, 13, 23 both [F/L2].
    pub moduli: Moduli,
}

impl Anisotropic {
    /// From engineering constants: E1, E2, E3, nu12, nu13, nu23, G12, G13, G23; `None` where they
    /// make no positive energy.
    pub fn engineering(constants: &[f64; 9]) -> Option<Self> {
        let [e1, e2, e3, nu12, nu13, nu23, g12, g13, g23] = *constants;
        let compliance = [
            [1.0 / e1, -nu12 / e1, -nu13 / e1],
            [-nu12 / e1, 1.0 / e2, -nu23 / e2],
            [-nu13 / e1, -nu23 / e2, 1.0 / e3],
        ];
        let (block, _) = super::tensor::inverse(&compliance);
        let [shear12, shear13, shear23] = [g12, g13, g23];
        Self::orthotropic(&block, &[shear12, shear13, shear23])
    }

    /// From the moduli along the axes and the shear moduli of 12, 13, 23; `None` where they make
    /// no positive energy.
    pub fn orthotropic(block: &Matrix, shear: &[f64; 3]) -> Option<Self> {
        let mut moduli = [[0.0; 6]; 6];
        for i in 0..3 {
            moduli[i][..3].copy_from_slice(&block[i]);
            // a component of the strain is half the angle
            moduli[3 + i][3 + i] = shear[i];
        }
        let minor = block[0][0] * block[1][1] - block[0][1] * block[1][0];
        let positive = block[0][0] > 0.0
            && minor > 0.0
            && super::tensor::determinant(block) > 0.0
            && shear.iter().all(|shear| *shear > 0.0);
        positive.then_some(Self { moduli })
    }

    fn stress(&self, strain: &Symmetric) -> Symmetric {
        use super::tensor::COUNTS;
        self.moduli.map(|row| (0..6).map(|k| row[k] * COUNTS[k] * strain[k]).sum())
    }

    /// Answer to a small strain.
    pub fn small(&self, strain: &Symmetric) -> Answer {
        let stress = self.stress(strain);
        let energy = 0.5 * contract(&stress, strain);
        Answer { stress, moduli: self.moduli, energy, dissipation: 0.0 }
    }

    /// Answer in Green's strain, carried to the deformed body.
    pub fn green(&self, gradient: &Matrix) -> Answer {
        let strain = right(gradient).map(|entry| 0.5 * entry);
        let second = self.stress(&strain);
        let f = deformation(gradient);
        let energy = 0.5 * contract(&second, &strain);
        let stress = super::tensor::carried(&f, &second);
        Answer { stress, moduli: pushed(&f, &self.moduli), energy, dissipation: 0.0 }
    }

    /// A stiffness that bounds that of a stretch [F/L2].
    pub fn stiffest(&self) -> f64 {
        (0..3).map(|k| self.moduli[k][k]).fold(0.0, f64::max)
    }
}

/// F F F F C.
fn pushed(f: &Matrix, moduli: &Moduli) -> Moduli {
    // T[ij][IJ]: a symmetric tensor's component IJ goes to ij
    let carry: Moduli =
        PAIRS.map(|[i, j]| {
            PAIRS.map(|[a, b]| {
                if a == b { f[i][a] * f[j][a] } else { f[i][a] * f[j][b] + f[i][b] * f[j][a] }
            })
        });
    let half: Moduli = carry
        .map(|row| std::array::from_fn(|k| (0..6).map(|m| row[m] * moduli[m][k]).sum::<f64>()));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..6).map(|m| half[i][m] * carry[j][m]).sum::<f64>())
    })
}
