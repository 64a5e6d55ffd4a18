//! What a linear system must offer, whoever implements it.
//!
//! ```text
//!   pattern --analyse--> system --scatter(values)--> --factor--> --solve(block)--> ...
//!   (owned)  once        (owned by the Solver)       as often     as often as needed
//!                                                    as values
//!                                                    change
//!
//!   process 0 owns rows |x x x x . . .|      every process holds the whole pattern, right-hand
//!                       |x x x x x . .|      sides and solutions; it assembles the rows it owns,
//!   process 1           |. x x x x x .|      and what is summed or compared over rows goes through
//!                       |. . . x x x x|      a reduction
//! ```

use std::fmt;
use std::ops::Range;

use crate::error::{FactorReport, SolveError};
use crate::pattern::{Matrix, Pattern};

/// Symmetry of the values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Symmetric values, definite or not. The whole matrix is given, not one triangle.
    Symmetric,
    /// Unsymmetric values (friction, follower loads).
    Unsymmetric,
}

/// How systems are factored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BackEnd {
    /// Contiguous band with dense border: L D L' with fall-back to LU with partial pivoting.
    Banded,
    /// Sparse factorisation in a fill-reducing order.
    Sparse,
    /// Conjugate gradients with a multigrid cycle; the sparse factorisation where they fail.
    Multigrid,
    /// An implementation from elsewhere, by its name.
    External(&'static str),
}

/// What the analysis decided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Description {
    /// How systems are factored.
    pub back_end: BackEnd,
    /// Symmetry asked for.
    pub kind: Kind,
    /// Number of equations.
    pub equations: usize,
    /// Half-bandwidth without the border; zero for other back ends than the banded one.
    pub half_bandwidth: usize,
    /// Number of dense rows set apart; zero for other back ends than the banded one.
    pub border: usize,
    /// Predicted number of stored factor entries.
    pub predicted_entries: f64,
    /// Predicted number of multiplications and additions of a factorisation.
    pub predicted_operations: f64,
    /// Memory that a factorisation takes, what it works in included [bytes].
    pub bytes: f64,
}

impl Description {
    /// Of an implementation from elsewhere that predicts nothing.
    pub fn external(name: &'static str, kind: Kind, equations: usize) -> Self {
        Self {
            back_end: BackEnd::External(name),
            kind,
            equations,
            half_bandwidth: 0,
            border: 0,
            predicted_entries: 0.0,
            predicted_operations: 0.0,
            bytes: 0.0,
        }
    }
}

impl fmt::Display for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.kind {
            Kind::Symmetric => "symmetric",
            Kind::Unsymmetric => "unsymmetric",
        };
        match self.back_end {
            BackEnd::Banded => write!(
                f,
                "banded {kind}, {} equations, half-bandwidth {}, border {}",
                self.equations, self.half_bandwidth, self.border
            )?,
            BackEnd::Sparse => write!(f, "sparse {kind}, {} equations", self.equations)?,
            BackEnd::Multigrid => {
                return write!(f, "multigrid {kind}, {} equations", self.equations);
            }
            BackEnd::External(name) => {
                return write!(f, "{name}, {kind}, {} equations", self.equations);
            }
        }
        write!(
            f,
            ", {:.3e} entries, {:.3e} operations predicted",
            self.predicted_entries, self.predicted_operations
        )
    }
}

/// Makes linear systems: the symbolic analysis, once for every pattern.
pub trait Analyse: Send + Sync {
    /// Orders the equations of a pattern, predicts, and sets memory apart.
    ///
    /// Errors: [`SolveError::OutOfMemory`], [`SolveError::External`].
    fn analyse(&self, pattern: &Pattern, kind: Kind) -> Result<Box<dyn LinearSystem>, SolveError>;

    /// The same for systems most solutions of which are wanted on an interface alone.
    ///
    /// Errors: those of [`Analyse::analyse`].
    fn analyse_for(
        &self,
        pattern: &Pattern,
        kind: Kind,
        _: &Interface<'_>,
    ) -> Result<Box<dyn LinearSystem>, SolveError> {
        self.analyse(pattern, kind)
    }
}

/// Equations on which a problem of its own is solved, that of contact: many right-hand sides have
/// entries there alone, and nothing else of their solutions is wanted.
#[derive(Clone, Copy, Debug, Default)]
pub struct Interface<'a> {
    /// The equations, ascending.
    pub equations: &'a [usize],
    /// Whether an unsymmetric matrix is symmetric but for a little. It may be analysed as a
    /// symmetric one then; [`crate::Solver`] gives it the symmetric part.
    pub nearly_symmetric: bool,
}

/// An analysed linear system. It is used through [`crate::Solver`], which gives it matrices of the
/// analysed pattern only, all their values finite and no row empty, and checks its solutions.
///
/// Blocks of right-hand sides are stored column after column. On one process the defaults of
/// [`LinearSystem::owned_rows`] and the reductions are right; on many, every process makes the same
/// calls in the same order.
pub trait LinearSystem: Send {
    /// What the analysis decided.
    fn description(&self) -> Description;

    /// Takes the values of the rows it owns to where the factorisation wants them, by positions
    /// computed in the analysis. What was factored before is lost.
    fn scatter(&mut self, matrix: Matrix<'_>);

    /// Factors what was scattered last. `matrix` is the same once more, for those that go over to
    /// another factorisation, and `row_size[i]` the sum of magnitudes of row i, for owned rows. The
    /// result is a function of the values alone, whatever was factored before.
    ///
    /// Errors: [`SolveError::Singular`] with the equation that has no usable pivot, in the caller's
    /// numbering; [`SolveError::OutOfMemory`], [`SolveError::External`].
    fn factor(&mut self, matrix: Matrix<'_>, row_size: &[f64]) -> Result<FactorReport, SolveError>;

    /// Factors a symmetric matrix in single precision, where that is sound: it has no pivot near
    /// zero. [`LinearSystem::solve`] then gives solutions with the error of that precision, which
    /// are near enough for an iteration. `None`: [`LinearSystem::factor`] is to be asked.
    fn factor_single(&mut self, _matrix: Matrix<'_>) -> Option<FactorReport> {
        None
    }

    /// Solves A X = B in place for a block of `columns` right-hand sides, of which the owned rows
    /// are read; all rows of X are returned on every process.
    ///
    /// Errors: [`SolveError::NotFactored`], [`SolveError::External`].
    fn solve(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError>;

    /// Solves A x = b in place where b is zero but on the interface that the analysis was told of, and
    /// x is wanted there alone: elsewhere nothing need be left.
    ///
    /// Errors: those of [`LinearSystem::solve`].
    fn solve_on_interface(&mut self, b: &mut [f64]) -> Result<(), SolveError> {
        self.solve(b, 1)
    }

    /// Factors an unsymmetric matrix that was analysed as nearly symmetric.
    ///
    /// Errors: those of [`LinearSystem::factor`].
    fn factor_unsymmetric(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError> {
        self.scatter(matrix);
        self.factor(matrix, row_size)
    }

    /// Solves A' X = B likewise.
    ///
    /// Errors: [`SolveError::NotFactored`], [`SolveError::External`].
    fn solve_transpose(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError>;

    /// Takes the rigid motions of the body whose stiffness the matrix is, column after column: what
    /// costs next to no energy where nothing holds it. Iterations may use them.
    fn take_motions(&mut self, _motions: &[f64]) {}

    /// Rows that this process assembles and judges.
    fn owned_rows(&self) -> Range<usize> {
        0..self.description().equations
    }

    /// Replaces every value by its sum over the processes.
    fn reduce_sum(&self, _values: &mut [f64]) {}

    /// Replaces every value by its largest over the processes.
    fn reduce_max(&self, _values: &mut [f64]) {}
}
