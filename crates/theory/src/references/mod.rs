//! Equilibria of a circle on a cantilever, from linear theory to pressure
//! spread along a shear-flexible beam.

mod continuum;
pub(crate) mod equilibrium;
pub mod linear;
mod point;
mod section;

use crate::cantilever::Cantilever;
use crate::error::TheoryError;
use crate::frame::Circle;
use crate::softened_law::ExponentialLaw;
use equilibrium::Local;
use section::Section;

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
