//! Where a metal hardens no more.
//!
//! ```text
//!   s_y |     o--------   behind the last line of its table the yield stress stays:
//!       |   /             a structure of it has a limit load
//!       | o
//!       +------------ plastic strain
//! ```

use super::law::Material;

/// The end of the hardening of a metal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HardeningEnd {
    /// Plastic strain from which on the yield stress stays [1].
    pub plastic_strain: f64,
    /// Elastic strain at that yield stress, pulled along one axis [1].
    pub elastic_strain: f64,
}

impl Material {
    /// Where its hardening ends; `None`: it does not yield, or its yield surface moves.
    pub fn hardening_end(&self) -> Option<HardeningEnd> {
        match self {
            Self::Plastic(plastic) if plastic.back_stresses.is_empty() => {
                let [stress, plastic_strain] = *plastic.table.last()?;
                let elastic_strain = stress / plastic.elastic.modulus;
                Some(HardeningEnd { plastic_strain, elastic_strain })
            }
            Self::Graded(graded) => graded.rows().next()?.hardening_end(),
            Self::Expanding(own) => own.law.hardening_end(),
            Self::Prestressed(own) => own.law.hardening_end(),
            Self::Creeping(own) => own.metal.hardening_end(),
            _ => None,
        }
    }
}
