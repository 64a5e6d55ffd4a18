//! Analysis, choice of the back end, and the checks around every solution.

use std::fmt;

use crate::banded::Banded;
use crate::error::{FactorReport, SolveError};
use crate::ordering::Layout;
use crate::pattern::{Matrix, Pattern};
use crate::residual::worst_residual;
use crate::sparse::{LARGEST_BAND, Sparse};

/// Backward error above which one step of iterative refinement is done.
const REFINE_ABOVE: f64 = 1e-10;
/// Backward error above which a refined solution is refused.
const REFUSE_ABOVE: f64 = 1e-6;
/// Right-hand sides below this lose digits in products, the format having no smaller exponents.
const SMALLEST: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON * f64::EPSILON);
/// What they are raised by, a power of two.
const RAISE: f64 = 1.0 / SMALLEST;
/// Banded factorisations with fewer operations are not worth a second analysis.
const SMALL: f64 = 2e6;

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
    /// Half-bandwidth without the border; zero for the sparse back end.
    pub half_bandwidth: usize,
    /// Number of dense rows set apart; zero for the sparse back end.
    pub border: usize,
    /// Predicted number of stored factor entries.
    pub predicted_entries: f64,
    /// Predicted number of multiplications and additions of a factorisation.
    pub predicted_operations: f64,
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
        }
        write!(
            f,
            ", {:.3e} entries, {:.3e} operations predicted",
            self.predicted_entries, self.predicted_operations
        )
    }
}

/// A way of factoring and solving. An implementation is made by the analysis of a pattern and sees
/// only matrices of that pattern with finite values and no empty row.
pub trait LinearSolver: Send {
    /// Factors; `row_size[i]` is the sum of magnitudes of row i. Errors as [`SolveError`].
    fn refactor(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError>;
    /// Solves in place with the last factorisation.
    fn solve(&mut self, rhs: &mut [f64]) -> Result<(), SolveError>;
    /// What the analysis decided.
    fn description(&self) -> Description;
}

/// An analysed system: refactor as often as the values change, solve as often as needed.
pub struct Solver {
    back_end: Box<dyn LinearSolver>,
    pattern: Pattern,
    values: Vec<f64>,
    row_size: Vec<f64>,
    rhs: Vec<f64>,
    correction: Vec<f64>,
    report: Option<FactorReport>,
    /// Natural unit of each unknown; none: all alike.
    unit: Vec<f64>,
    /// Whether the last checked solution needed no refinement.
    accurate: bool,
}

/// Symbolic analysis, once for every pattern: orders the equations, predicts the work and chooses
/// the back end.
pub fn analyse(pattern: &Pattern, kind: Kind) -> Solver {
    let layout = Layout::cheapest(pattern, kind);
    let banded_time = banded_seconds(&layout, kind);
    if layout.operations(kind) > SMALL
        && let Some(sparse) = Sparse::new(pattern, kind)
        && (sparse_seconds(&sparse, kind) < banded_time || layout.entries(kind) > LARGEST_BAND)
    {
        return Solver::new(pattern, Box::new(sparse));
    }
    Solver::new(pattern, Box::new(Banded::new(pattern, kind, layout)))
}

/// Like [`analyse`] with the back end prescribed, for comparisons and tests. Where the sparse
/// library cannot analyse the pattern the banded back end is used.
pub fn analyse_with(pattern: &Pattern, kind: Kind, back_end: BackEnd) -> Solver {
    if back_end == BackEnd::Sparse
        && let Some(sparse) = Sparse::new(pattern, kind)
    {
        return Solver::new(pattern, Box::new(sparse));
    }
    let layout = Layout::cheapest(pattern, kind);
    Solver::new(pattern, Box::new(Banded::new(pattern, kind, layout)))
}

/// Rough time of a banded factorisation [s]: short contiguous loops.
fn banded_seconds(layout: &Layout, kind: Kind) -> f64 {
    layout.operations(kind) / 8e9
}

/// Rough time of a sparse factorisation [s]: dense blocks are fast, the way there is not. The
/// constants are measured on plane grids.
fn sparse_seconds(sparse: &Sparse, kind: Kind) -> f64 {
    let entry = if kind == Kind::Symmetric { 15e-9 } else { 80e-9 };
    sparse.operations() / 6e9 + sparse.entries() * entry
}

impl Solver {
    fn new(pattern: &Pattern, back_end: Box<dyn LinearSolver>) -> Self {
        let n = pattern.size();
        Self {
            back_end,
            pattern: pattern.clone(),
            values: vec![0.0; pattern.entries()],
            row_size: vec![0.0; n],
            rhs: vec![0.0; n],
            correction: vec![0.0; n],
            report: None,
            unit: Vec::new(),
            accurate: false,
        }
    }

    /// Gives each unknown its natural unit u_i > 0. The system is factored and judged as U A U, in
    /// which all entries have one dimension: neither a pivot nor an accuracy then depends on how
    /// forces and lengths are measured. Units of another number than the equations are left aside.
    pub fn with_units(mut self, unit: Vec<f64>) -> Self {
        if unit.len() == self.rhs.len() && unit.iter().all(|&u| u > 0.0 && u.is_finite()) {
            self.unit = unit;
        }
        self
    }

    /// U A U of the values given.
    fn take(&mut self, values: &[f64]) {
        self.values.copy_from_slice(values);
        if self.unit.is_empty() {
            return;
        }
        let columns = self.pattern.columns();
        for (row, bounds) in self.pattern.row_start().windows(2).enumerate() {
            let own = self.unit[row];
            let entries = self.values[bounds[0]..bounds[1]].iter_mut();
            for (value, &column) in entries.zip(&columns[bounds[0]..bounds[1]]) {
                *value *= own * self.unit[column];
            }
        }
    }

    /// Factors the matrix with these values; `pattern` must be the analysed one. The result is a
    /// function of the values alone, whatever was factored before.
    ///
    /// Errors: [`SolveError::Size`], [`SolveError::PatternChanged`], [`SolveError::NotFinite`],
    /// [`SolveError::Singular`]; after an error there is no factorisation to solve with.
    pub fn refactor(
        &mut self,
        pattern: &Pattern,
        values: &[f64],
    ) -> Result<FactorReport, SolveError> {
        self.report = None;
        self.accurate = false;
        if values.len() != self.values.len() {
            return Err(SolveError::Size { expected: self.values.len(), found: values.len() });
        }
        if *pattern != self.pattern {
            return Err(SolveError::PatternChanged);
        }
        self.take(values);
        let matrix = Matrix::new(&self.pattern, &self.values);
        for (i, size) in self.row_size.iter_mut().enumerate() {
            *size = matrix.row_size(i);
            if !size.is_finite() {
                return Err(SolveError::NotFinite { equation: i });
            }
            if *size == 0.0 {
                return Err(SolveError::Singular { equation: i, ratio: 0.0 });
            }
        }
        let report = self.back_end.refactor(matrix, &self.row_size)?;
        self.report = Some(report);
        Ok(report)
    }

    /// Solves in place with the last factorisation, any number of times. The residual is checked
    /// and the solution refined once where rounding was worse than usual.
    ///
    /// Errors: [`SolveError::Size`], [`SolveError::NotFactored`], [`SolveError::NotFinite`] for the
    /// right-hand side, [`SolveError::Singular`] when the solution is useless all the same.
    pub fn solve(&mut self, rhs: &mut [f64]) -> Result<(), SolveError> {
        if rhs.len() != self.rhs.len() {
            return Err(SolveError::Size { expected: self.rhs.len(), found: rhs.len() });
        }
        let Some(report) = self.report else { return Err(SolveError::NotFactored) };
        if let Some(equation) = rhs.iter().position(|b| !b.is_finite()) {
            return Err(SolveError::NotFinite { equation });
        }
        let raised = self.enter(rhs);
        self.rhs.copy_from_slice(rhs);
        self.back_end.solve(rhs)?;
        self.accurate = self.backward_error(rhs) <= REFINE_ABOVE;
        if !self.accurate {
            self.refine(rhs)?;
        }
        if self.accurate || self.backward_error(rhs) <= REFUSE_ABOVE {
            self.leave(rhs, raised);
            return Ok(());
        }
        Err(SolveError::Singular {
            equation: report.smallest_pivot,
            ratio: report.smallest_pivot_ratio,
        })
    }

    /// As [`Solver::solve`] for a further right-hand side of the same factorisation: where the
    /// solution checked last was accurate, this one is not checked again, which halves its cost.
    ///
    /// Errors: those of [`Solver::solve`].
    pub fn respond(&mut self, rhs: &mut [f64]) -> Result<(), SolveError> {
        if !self.accurate || rhs.len() != self.rhs.len() {
            return self.solve(rhs);
        }
        let raised = self.enter(rhs);
        self.back_end.solve(rhs)?;
        self.leave(rhs, raised);
        Ok(())
    }

    /// A right-hand side in the units of its equations, raised by a power of two where it is so
    /// small that products with it would lose digits below the smallest normal number; says by which.
    fn enter(&self, rhs: &mut [f64]) -> f64 {
        rhs.iter_mut().zip(&self.unit).for_each(|(b, u)| *b *= u);
        let largest = rhs.iter().fold(0.0_f64, |largest, b| largest.max(b.abs()));
        if largest == 0.0 || largest >= SMALLEST {
            return 1.0;
        }
        rhs.iter_mut().for_each(|b| *b *= RAISE);
        RAISE
    }

    /// The unknowns of a solution.
    fn leave(&self, solution: &mut [f64], raised: f64) {
        if raised != 1.0 {
            solution.iter_mut().for_each(|x| *x /= raised);
        }
        solution.iter_mut().zip(&self.unit).for_each(|(x, u)| *x *= u);
    }

    fn backward_error(&self, x: &[f64]) -> f64 {
        let matrix = Matrix::new(&self.pattern, &self.values);
        worst_residual(matrix, &self.row_size, x, |i| self.rhs[i]).0
    }

    fn refine(&mut self, x: &mut [f64]) -> Result<(), SolveError> {
        let matrix = Matrix::new(&self.pattern, &self.values);
        for (i, (c, b)) in self.correction.iter_mut().zip(&self.rhs).enumerate() {
            *c = b - matrix.row_times(i, x);
        }
        self.back_end.solve(&mut self.correction)?;
        x.iter_mut().zip(&self.correction).for_each(|(x_i, c)| *x_i += c);
        Ok(())
    }

    /// The matrix factored last.
    pub fn matrix(&self) -> Matrix<'_> {
        Matrix::new(&self.pattern, &self.values)
    }

    /// What the analysis decided.
    pub fn description(&self) -> Description {
        self.back_end.description()
    }
}
