//! Stiffnesses of the beam that bends.

use crate::cantilever::Cantilever;
use crate::error::TheoryError;

/// Stiffnesses, length and width of a beam.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Section {
    /// EI [F L2].
    pub bending: f64,
    /// 1/EA [1/F]; zero for the elastica.
    pub stretch: f64,
    /// 1/kGA [1/F]; zero for the elastica.
    pub shear: f64,
    /// Length L [L].
    pub length: f64,
    /// Width b [L].
    pub width: f64,
}

impl Section {
    /// Section of an extensible, shear-flexible beam.
    pub fn reissner(beam: &Cantilever) -> Self {
        Self {
            bending: beam.bending_stiffness(),
            stretch: 1.0 / beam.axial_stiffness(),
            shear: 1.0 / beam.shear_stiffness(),
            length: beam.length(),
            width: beam.width,
        }
    }

    /// Section of the inextensible, unshearable beam of the same bending stiffness.
    pub fn elastica(beam: &Cantilever) -> Self {
        Self { stretch: 0.0, shear: 0.0, ..Self::reissner(beam) }
    }

    /// Refuses a contact beyond the free end.
    pub fn check_inside(&self, contact_length: f64) -> Result<(), TheoryError> {
        if contact_length <= self.length {
            Ok(())
        } else {
            Err(TheoryError::BeyondTip { contact_length, length: self.length })
        }
    }
}
