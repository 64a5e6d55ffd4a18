//! What lines of cards give before and in steps: temperatures of nodes, stresses and plastic strains of
//! elements.

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
    /// Where one along axis 1 of the section was given, which beams in space have.
    pub other_slope: Option<Span>,
    /// Where more values were given.
    pub further: Option<Span>,
    pub amplitude: Option<(String, Span)>,
    pub origin: Span,
}

/// A line of `*INITIAL CONDITIONS, TYPE=STRESS`, or of CalculiX' PLASTIC STRAIN.
#[derive(Clone, Debug)]
pub(crate) struct StressLine {
    pub target: Target,
    pub target_span: Span,
    /// The integration point, from 0; `None`: all.
    pub point: Option<usize>,
    /// Whether the values are strains that the law does not see.
    pub strains: bool,
    pub values: Vec<f64>,
    pub origin: Span,
}

/// A line of `*INITIAL CONDITIONS, TYPE=HARDENING`.
#[derive(Clone, Debug)]
pub(crate) struct HardeningLine {
    pub target: Target,
    pub target_span: Span,
    pub plastic_strain: f64,
    /// Components of the first back stress.
    pub values: Vec<f64>,
    pub origin: Span,
}
