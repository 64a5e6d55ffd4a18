//! Linear elasticity: at small strain, and the two readings of it at large strain.
//!
//! ```text
//!   stress |   / Hencky: Kirchhoff stress to ln V      (*ELASTIC of Abaqus)
//!          |  /
//!          | /  ___ Saint Venant, Kirchhoff: second Piola-Kirchhoff stress to Green's strain
//!          |/__/____ stretch                            (*ELASTIC of CalculiX)
//! ```

use super::answer::Answer;
use super::tensor::{
    Matrix, Moduli, PAIRS, Symmetric, add, add_dyad, add_unit, contract, deformation, left, pushed,
    right, square, trace,
};

/// Isotropic linear elasticity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus E [F/L2].
    pub modulus: f64,
    /// Poisson's ratio nu [1].
    pub poisson: f64,
}

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
    /// Shear modulus G = E / 2(1 + nu) [F/L2]. [semantics: keywords, `*ELASTIC`]
    pub fn shear_modulus(&self) -> f64 {
        self.modulus / (2.0 * (1.0 + self.poisson))
    }

    /// Part of the way to another one, E and nu each.
    pub fn towards(&self, other: &Self, part: f64) -> Self {
        let number = |low: f64, high: f64| low + part * (high - low);
        Self {
            modulus: number(self.modulus, other.modulus),
            poisson: number(self.poisson, other.poisson),
        }
    }

    /// That of a shear modulus and a bulk modulus [F/L2].
    pub fn of_moduli(shear: f64, bulk: f64) -> Self {
        let modulus = 9.0 * bulk * shear / (3.0 * bulk + shear);
        Self { modulus, poisson: modulus / (2.0 * shear) - 1.0 }
    }

    /// Bulk modulus K = E / 3(1 - 2 nu) [F/L2].
    pub fn bulk_modulus(&self) -> f64 {
        self.modulus / (3.0 * (1.0 - 2.0 * self.poisson))
    }

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

    /// H33 that leaves a sheet in the plane of axes 1 and 2 without stress across, exact: the
    /// strain across is -L/(L + 2 G) times the others' sum, docs/theory.md eqs. (3.34) to (3.36).
    /// Not a number where no thickness does.
    pub fn across(&self, gradient: &Matrix, large: Option<LargeStrain>) -> f64 {
        let lame = self.lame();
        let part = -lame / (lame + 2.0 * self.shear_modulus());
        let [[a, b, _], [c, d, _], _] = gradient;
        match large {
            None => part * (a + d),
            Some(LargeStrain::Logarithmic) => (part * (a + d + a * d - b * c).ln_1p()).exp_m1(),
            Some(LargeStrain::Green) => {
                let twice = part * (2.0 * (a + d) + a * a + b * b + c * c + d * d);
                twice / ((1.0 + twice).sqrt() + 1.0)
            }
        }
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
    #[inline(always)]
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
#[inline(always)]
pub(super) fn add_turned(moduli: &mut Moduli, factor: f64, b: &Symmetric) {
    let b = super::tensor::full(b);
    for (row, [i, j]) in moduli.iter_mut().zip(PAIRS) {
        for (entry, [k, l]) in row.iter_mut().zip(PAIRS) {
            *entry += 0.5 * factor * (b[i][k] * b[j][l] + b[i][l] * b[j][k]);
        }
    }
}

/// Why constants are not those of an elastic material: it would release energy under some load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unsound {
    /// A modulus is not positive.
    NotPositive(&'static str),
    /// A Poisson's ratio is not below sqrt(Ei/Ej) in size [1].
    Ratio {
        /// Its name.
        name: &'static str,
        /// What its size must stay below [1].
        most: f64,
    },
    /// 1 - nu12 nu21 - nu23 nu32 - nu31 nu13 - 2 nu21 nu32 nu13 is not positive [1].
    Determinant(f64),
    /// The energy is not positive; so many of the leading components, 11, 22, 33, 12, 13, 23,
    /// suffice to show it.
    Energy(usize),
}

/// Size of the first leading block that is not positive definite, by elimination; what is left of
/// an entry by rounding alone counts as none.
fn first_soft(moduli: &Moduli) -> Option<usize> {
    let mut left = *moduli;
    for k in 0..6 {
        let pivot = left[k][k];
        let sound = pivot > 16.0 * f64::EPSILON * moduli[k][k].abs();
        if !sound || !pivot.is_finite() {
            return Some(k + 1);
        }
        for i in k + 1..6 {
            let factor = left[i][k] / pivot;
            let row = left[k];
            left[i].iter_mut().zip(row).for_each(|(entry, own)| *entry -= factor * own);
        }
    }
    None
}

/// Elastic moduli without isotropy, along the axes of the material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anisotropic {
    /// Stress of a strain, components 11, 22, 33, 12, 13, 23 both [F/L2].
    pub moduli: Moduli,
}

impl Anisotropic {
    /// From engineering constants: E1, E2, E3, nu12, nu13, nu23, G12, G13, G23; `Err`: the bound
    /// that they break.
    pub fn engineering(constants: &[f64; 9]) -> Result<Self, Unsound> {
        let [e1, e2, e3, nu12, nu13, nu23, g12, g13, g23] = *constants;
        let names = ["E1", "E2", "E3", "G12", "G13", "G23"];
        for (value, name) in [e1, e2, e3, g12, g13, g23].into_iter().zip(names) {
            if value <= 0.0 || !value.is_finite() {
                return Err(Unsound::NotPositive(name));
            }
        }
        let pairs = [("nu12", nu12, e1 / e2), ("nu13", nu13, e1 / e3), ("nu23", nu23, e2 / e3)];
        for (name, nu, ratio) in pairs {
            // NaN breaks the bound too
            if nu * nu < ratio {
                continue;
            }
            return Err(Unsound::Ratio { name, most: ratio.sqrt() });
        }
        let [nu21, nu31, nu32] = [nu12 * e2 / e1, nu13 * e3 / e1, nu23 * e3 / e2];
        let left = 1.0 - nu12 * nu21 - nu23 * nu32 - nu31 * nu13 - 2.0 * nu21 * nu32 * nu13;
        if left <= f64::EPSILON {
            return Err(Unsound::Determinant(left));
        }
        let compliance = [
            [1.0 / e1, -nu12 / e1, -nu13 / e1],
            [-nu12 / e1, 1.0 / e2, -nu23 / e2],
            [-nu13 / e1, -nu23 / e2, 1.0 / e3],
        ];
        let (block, _) = super::tensor::inverse(&compliance);
        Self::orthotropic(&block, &[g12, g13, g23])
    }

    /// From E1, E2, nu12, G12, G13, G23 of a ply in plane stress: nothing across couples with
    /// what is in the plane.
    pub fn lamina(constants: &[f64; 6]) -> Result<Self, Unsound> {
        let [e1, e2, nu12, g12, g13, g23] = *constants;
        Self::engineering(&[e1, e2, e2, nu12, 0.0, 0.0, g12, g13, g23])
    }

    /// From the moduli along the axes and the shear moduli of 12, 13, 23.
    pub fn orthotropic(block: &Matrix, shear: &[f64; 3]) -> Result<Self, Unsound> {
        let mut moduli = [[0.0; 6]; 6];
        for i in 0..3 {
            moduli[i][..3].copy_from_slice(&block[i]);
            // a component of the strain is half the angle
            moduli[3 + i][3 + i] = shear[i];
        }
        Self::general(&moduli)
    }

    /// From all moduli, a symmetric matrix of 11, 22, 33, 12, 13, 23.
    pub fn general(moduli: &Moduli) -> Result<Self, Unsound> {
        match first_soft(moduli) {
            Some(leading) => Err(Unsound::Energy(leading)),
            None => Ok(Self { moduli: *moduli }),
        }
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

    /// Answer in the logarithmic strain of the undeformed body, whose axes the material turns with:
    /// docs/theory.md, below (3.36).
    pub fn hencky(&self, gradient: &Matrix) -> Answer {
        super::logarithmic::answer(gradient, |strain| self.small(strain))
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
