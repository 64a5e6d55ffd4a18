//! Why a reference does not exist.

use std::fmt;

/// A reason for which no number is given. A reference never answers with a
/// number outside the range in which its definition has a meaning.
#[derive(Debug, Clone, PartialEq)]
pub enum TheoryError {
    /// A dimension, coefficient or count is outside its range; the text names it.
    InvalidInput(&'static str),
    /// The circle does not reach the beam; `gap` is the clearance [L].
    NoContact {
        /// Clearance left between circle and beam [L].
        gap: f64,
    },
    /// The circle is clear of the beam at every increment of the stroke.
    NeverTouches,
    /// The circle lies over the clamped end, or no contact length above zero
    /// fulfils the equations.
    PastClamp,
    /// The contact would lie beyond the free end of the beam.
    BeyondTip {
        /// Contact length the equations ask for [L].
        contact_length: f64,
        /// Length of the beam [L].
        length: f64,
    },
    /// Friction balances the component of the pressure that bends the beam
    /// (mu tan(slope) reaches one): the force grows without bound.
    Jamming {
        /// What is left of the transverse force per unit normal force [-]; <= 0.
        transverse: f64,
    },
    /// The bending moment changes sign between clamp and contact; the
    /// references describe arcs without inflection only.
    Inflection,
    /// The equations were not solved to the accuracy promised.
    NotConverged {
        /// Size of the last scaled correction [-].
        correction: f64,
    },
    /// The reason, at one increment of a stroke.
    AtIncrement {
        /// Number of the increment, from 0.
        increment: usize,
        /// The reason itself.
        reason: Box<TheoryError>,
    },
}

impl fmt::Display for TheoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InvalidInput(what) => write!(f, "invalid input: {what}"),
            Self::NoContact { gap } => {
                write!(f, "no contact: the circle clears the beam by {gap:e}")
            }
            Self::NeverTouches => {
                write!(f, "no contact: the circle clears the beam at every increment")
            }
            Self::PastClamp => write!(f, "the circle lies over the clamped end of the beam"),
            Self::BeyondTip { contact_length, length } => {
                write!(
                    f,
                    "contact at {contact_length:e} would lie beyond the free end at {length:e}"
                )
            }
            Self::Jamming { transverse } => write!(
                f,
                "jamming: friction takes up the whole transverse force ({transverse:e} of the normal force is left)"
            ),
            Self::Inflection => {
                write!(f, "the bending moment changes sign between clamp and contact")
            }
            Self::NotConverged { correction } => {
                write!(f, "the equations were not solved: last correction {correction:e}")
            }
            Self::AtIncrement { increment, reason } => write!(f, "increment {increment}: {reason}"),
        }
    }
}

impl std::error::Error for TheoryError {}

/// Refuses the first value that is not positive and finite, with its message.
pub(crate) fn check_positive(values: &[(f64, &'static str)]) -> Result<(), TheoryError> {
    match values.iter().find(|(value, _)| !(value.is_finite() && *value > 0.0)) {
        Some((_, message)) => Err(TheoryError::InvalidInput(message)),
        None => Ok(()),
    }
}
