//! What planes of symmetry leave of the balance of a pair.
//!
//! ```text
//!     M |   what the image of a master bears acts on the master as its image: moments about axes in the
//!   --->|   plane turn round, forces along it and moments about its normal do not
//! ```
//!
//! docs/theory.md section 5.9.

use super::master::MasterSurface;
use super::pairs::Contact;
use slideline_mech::vector::{dot, scale};

impl Contact {
    /// What of the moment of a pair is balanced within it [F L].
    pub fn balanced(&self, pair: usize, moment: [f64; 3]) -> [f64; 3] {
        match self.masters[pair].planes()[..] {
            [] => moment,
            [normal] => scale(normal, dot(normal, moment)),
            _ => [0.0; 3],
        }
    }
}

impl MasterSurface {
    /// Normals of the planes of symmetry beyond which it goes on as its image [1].
    fn planes(&self) -> Vec<[f64; 3]> {
        match self {
            Self::Faces { mesh, .. } => mesh.planes().to_vec(),
            Self::Line { beyond, .. } => beyond.normals().collect(),
            Self::Body { .. } | Self::Nothing => Vec::new(),
        }
    }
}
