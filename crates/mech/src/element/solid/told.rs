//! Strains as results tell them.

use crate::material::tensor::{Matrix, Symmetric, left, right, symmetric};
use crate::material::{Axes, Material};

/// Strains as results tell them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Told {
    /// ln V where displacements are large, shear strains as angles (Abaqus).
    #[default]
    Logarithmic,
    /// Green's strain where displacements are large, shear strains as components (CalculiX).
    Green,
}

impl Told {
    /// The strain of a displacement gradient, 11, 22, 33, 12, 13, 23 [1].
    pub fn strain(self, gradient: &Matrix, large: bool) -> Symmetric {
        let mut strain = match (self, large) {
            (_, false) => symmetric(gradient),
            (Self::Logarithmic, true) => {
                let axes = Axes::of(&left(gradient));
                axes.tensor(&axes.logs)
            }
            (Self::Green, true) => right(gradient).map(|entry| 0.5 * entry),
        };
        if self == Self::Logarithmic {
            (3..6).for_each(|k| strain[k] *= 2.0);
        }
        strain
    }

    /// Equivalent plastic strain and equivalent creep strain of a state [1]; CalculiX does not tell
    /// one from the other.
    pub fn flowed(self, material: &Material, state: &[f64]) -> [f64; 2] {
        let plastic = material.plastic_strain(state).unwrap_or(0.0);
        let creep = material.creep_strain(state).unwrap_or(0.0);
        match self {
            Self::Logarithmic => [plastic, creep],
            Self::Green => [plastic + creep; 2],
        }
    }
}
