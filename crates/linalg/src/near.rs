//! What a solver keeps of factors that are near: of another matrix, in single precision, or of the
//! symmetric part alone.

use crate::conjugate::Conjugate;
use crate::krylov::{self, Stop};
use crate::skew::Skew;

/// What solutions of a matrix are wanted for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Use {
    /// Many, each of them to rounding: factors in double.
    #[default]
    Many,
    /// Few. Large definite matrices are then factored in single precision, which takes half the
    /// memory and time, and solved by conjugate gradients with these factors to a residual of 1e-12
    /// of the right-hand side.
    Few,
    /// Many on the interface, where those of a matrix nearby do, and few on all equations that make
    /// them good: [`Solver::respond_on_interface`] and [`Solver::correction`].
    Interface,
}

/// What brings solutions with near factors to those of the matrix.
#[derive(Default)]
pub(crate) struct Near {
    pub wanted: Use,
    /// Equations of the interface, marked; empty: there is none.
    pub is_on_interface: Vec<bool>,
    /// Whether the symmetric part of the matrix is factored.
    pub halves: bool,
    /// What is left of the matrix beside it.
    pub skew: Skew,
    /// How far iterations go where the factors are those of the matrix taken last no more than
    /// nearly.
    pub stop: Option<Stop>,
    pub conjugate: Conjugate,
    pub krylov: krylov::Workspace,
}
