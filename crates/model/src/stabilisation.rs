//! `*CONTACT CONTROLS, STABILIZE`: dashpots in contact that fade away.

use slideline_diag::Span;

/// Stabilisation of the contact of a step. Its tractions are proportional to
/// the rates of the gap and of the slip, and fall linearly to nothing by the
/// end of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stabilisation {
    /// Factor on the coefficient that the solver chooses [1].
    pub factor: f64,
    /// `TANGENT FRACTION`: damping of slip, as a fraction of that of the gap [1].
    pub tangent_fraction: f64,
    /// Coefficient in place of the solver's: pressure by rate of the gap
    /// [F T/L3].
    pub coefficient: Option<f64>,
    /// Clearance at which it ends; `None`: none [L].
    pub range: Option<f64>,
    /// The card.
    pub origin: Span,
}

impl Stabilisation {
    /// As the solver chooses it.
    pub fn automatic(origin: Span) -> Self {
        Self { factor: 1.0, tangent_fraction: 1.0, coefficient: None, range: None, origin }
    }
}
