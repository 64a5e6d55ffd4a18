//! What a reference answers for one position of the circle.

use crate::frame::Frame;

/// Direction of sliding: friction acts with the stroke or against it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// The circle moves as the problem says.
    Push,
    /// The circle comes back through the same positions; friction is reversed.
    Return,
}

impl Stroke {
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Push => 1.0,
            Self::Return => -1.0,
        }
    }
}

/// An equilibrium of circle and beam, in the axes of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium {
    /// Contact length: xi_L for the linear theory, undeformed arc length from the
    /// clamp for the others (that of the resultant where pressure is spread) [L].
    pub contact_length: f64,
    /// Normal contact force [F].
    pub force: f64,
    /// Force of the support on the circle, equal to that of the circle on the beam [F].
    pub reaction: [f64; 2],
    /// Point through which the reaction acts [L].
    pub point: [f64; 2],
    /// Angle of the section at the contact, against the undeformed beam, negative
    /// away from the circle [rad]; the slope for the linear theory.
    pub angle: f64,
    /// Largest overclosure; zero for hard contact [L].
    pub overclosure: f64,
    /// Strain energy of the beam [F L].
    pub strain_energy: f64,
    /// Energy held by softened contact [F L].
    pub contact_energy: f64,
}

/// As [`Equilibrium`], in beam axes.
pub(crate) type Local = Equilibrium;

impl Equilibrium {
    pub(crate) fn in_global(self, frame: &Frame) -> Self {
        Self { reaction: frame.vector(self.reaction), point: frame.point(self.point), ..self }
    }
}
