//! Temperatures of nodes as lines of cards give them.

use slideline_diag::Span;
use slideline_model::Temperature;

use crate::log::Target;

/// A line of `*TEMPERATURE` or `*INITIAL CONDITIONS, TYPE=TEMPERATURE`.
#[derive(Clone, Debug)]
pub(crate) struct Heat {
    pub target: Target,
    pub target_span: Span,
    pub temperature: Temperature,
    /// Where a slope through a beam was given.
    pub slope: Option<Span>,
    pub amplitude: Option<(String, Span)>,
    pub origin: Span,
}
