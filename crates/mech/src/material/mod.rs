//! Materials: pure functions of a strain measure, differentiated by whoever asks.

mod plane;

pub(crate) use plane::invariants;
pub use plane::{Hencky, PlaneInvariants, PlaneStrainLaw, SaintVenant, SmallStrain};

/// Isotropic linear elasticity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus E [F/L2].
    pub modulus: f64,
    /// Poisson's ratio nu [1].
    pub poisson: f64,
}

impl Elastic {
    /// Shear modulus G = E / 2(1 + nu) [F/L2]. [semantics: keywords, `*ELASTIC`]
    pub fn shear_modulus(&self) -> f64 {
        self.modulus / (2.0 * (1.0 + self.poisson))
    }

    /// Bulk modulus K = E / 3(1 - 2 nu) [F/L2].
    pub fn bulk_modulus(&self) -> f64 {
        self.modulus / (3.0 * (1.0 - 2.0 * self.poisson))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moduli_of_the_1995_beam() {
        let material = Elastic { modulus: 6.9e9, poisson: 0.3 };
        assert!((material.shear_modulus() - 6.9e9 / 2.6).abs() < 1e-3);
        assert!((material.bulk_modulus() - 6.9e9 / 1.2).abs() < 1e-3);
    }
}
