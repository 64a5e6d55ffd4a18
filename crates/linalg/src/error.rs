//! What a factorisation reports and how a solution can fail.

use std::fmt;

/// What a factorisation found out about the matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorReport {
    /// Number of negative pivots of a symmetric factorisation, equal to the number of negative
    /// eigenvalues (Sylvester). `None` when an unsymmetric factorisation was used.
    pub negative_pivots: Option<usize>,
    /// Smallest pivot relative to the size of what it was left over from, dimensionless: 1 means no
    /// cancellation, 1e-16 that nothing but rounding is left. The size is the sum of magnitudes of
    /// the diagonal's terms (banded symmetric), the diagonal (single precision) or the sum of
    /// magnitudes of the equation's row (all others); the sparse unsymmetric factorisation estimates
    /// it from one solution.
    pub smallest_pivot_ratio: f64,
    /// Equation of that pivot, in the caller's numbering.
    pub smallest_pivot: usize,
}

/// Pivot ratio from which on positive pivots alone say that L D L' is good: the factorisation of a
/// definite matrix is stable in every order.
const DEFINITE: f64 = 1e-6;

impl FactorReport {
    /// Whether it is that of a definite matrix, far from a singular one.
    pub(crate) fn is_definite(&self) -> bool {
        self.negative_pivots == Some(0) && self.smallest_pivot_ratio >= DEFINITE
    }

    /// Report of a factorisation without equations.
    pub(crate) const EMPTY: Self =
        Self { negative_pivots: Some(0), smallest_pivot_ratio: 1.0, smallest_pivot: 0 };
}

/// Why a system could not be solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolveError {
    /// The matrix is singular to working precision.
    Singular {
        /// Equation without a usable pivot, in the caller's numbering.
        equation: usize,
        /// Its pivot relative to the size of the equation, dimensionless.
        ratio: f64,
    },
    /// A value of the matrix or of the right-hand side is infinite or not a number.
    NotFinite {
        /// Equation that holds the value, in the caller's numbering.
        equation: usize,
    },
    /// An array does not have the length the pattern asks for.
    Size {
        /// Length needed.
        expected: usize,
        /// Length given.
        found: usize,
    },
    /// The pattern is not the one that was analysed.
    PatternChanged,
    /// `solve` was called without a valid factorisation.
    NotFactored,
    /// The sparse library could not analyse or factor the system for want of memory, and the banded
    /// factorisation would need more still.
    OutOfMemory,
    /// An implementation from elsewhere failed for a reason of its own.
    External {
        /// The reason, as a clause.
        reason: &'static str,
    },
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Singular { equation, ratio } => write!(
                f,
                "the system is singular: equation {equation} has no usable pivot \
                 (pivot / equation size = {ratio:.1e})"
            ),
            Self::NotFinite { equation } => {
                write!(f, "equation {equation} holds a value that is infinite or not a number")
            }
            Self::Size { expected, found } => {
                write!(
                    f,
                    "an array of length {expected} is needed, one of length {found} was given"
                )
            }
            Self::PatternChanged => write!(f, "the pattern is not the one that was analysed"),
            Self::NotFactored => write!(f, "the system has not been factored"),
            Self::External { reason } => write!(f, "the linear system failed: {reason}"),
            Self::OutOfMemory => write!(f, "the factorisation needs more memory than there is"),
        }
    }
}

impl std::error::Error for SolveError {}
