//! Equilibria of a circle on a cantilever, from linear theory to pressure
//! spread along a shear-flexible beam.

mod continuum;
pub mod linear;
mod point;

use crate::TheoryError;
use crate::frame::{Circle, Frame};
use crate::problem::Cantilever;
use crate::softened_law::ExponentialLaw;

/// Which theory an answer comes from [verification: definition of each reference model].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reference {
    /// The paper's linear theory, eqs. (1) to (12), with its slope used as an angle.
    Linear,
    /// Inextensible, unshearable elastica with hard contact at one point.
    Elastica,
    /// Extensible, shear-flexible (Reissner) beam with hard contact at one point,
    /// normal to the mean of the two slopes there.
    Reissner,
    /// As [`Reference::Reissner`], with one softened contact point of the given area.
    Softened {
        /// Tributary area A of the contact point [L2].
        area: f64,
    },
    /// Reissner beam with the softened pressure spread along the beam.
    Continuum,
}

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

/// What linear theory says about one position of the circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearContact {
    /// Contact length xi_L [L].
    pub contact_length: f64,
    /// Deflection u of the beam at the contact, negative away from the circle [L].
    pub deflection: f64,
    /// Slope theta at the contact, negative [-].
    pub slope: f64,
    /// Contact force F [F].
    pub force: f64,
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
    fn reissner(beam: &Cantilever) -> Self {
        Self {
            bending: beam.bending_stiffness(),
            stretch: 1.0 / beam.axial_stiffness(),
            shear: 1.0 / beam.shear_stiffness(),
            length: beam.length(),
            width: beam.width,
        }
    }
    fn elastica(beam: &Cantilever) -> Self {
        Self { stretch: 0.0, shear: 0.0, ..Self::reissner(beam) }
    }
}

/// Equilibrium of one position by one theory; `None` where the circle is clear
/// of the beam. `drag` is the coefficient of friction, negative where the circle
/// drags the beam towards its clamp.
pub(crate) fn solve(
    beam: &Cantilever,
    law: &ExponentialLaw,
    circle: Circle,
    drag: f64,
    reference: Reference,
) -> Result<Option<Local>, TheoryError> {
    let section = Section::reissner(beam);
    let found = match reference {
        Reference::Linear => linear::solve(&section, circle, drag),
        Reference::Elastica => point::hard(&Section::elastica(beam), circle, drag),
        Reference::Reissner => point::hard(&section, circle, drag),
        Reference::Softened { area } => point::softened(&section, circle, drag, law, area),
        Reference::Continuum => continuum::solve(&section, circle, drag, law),
    };
    match found {
        Ok(equilibrium) => Ok(Some(equilibrium)),
        Err(TheoryError::NoContact { .. }) => Ok(None),
        Err(reason) => Err(reason),
    }
}

fn check_inside(contact_length: f64, length: f64) -> Result<(), TheoryError> {
    if contact_length <= length {
        Ok(())
    } else {
        Err(TheoryError::BeyondTip { contact_length, length })
    }
}
