//! Sparse back end on faer's factorisations, always on one thread.
//!
//! Symmetric: L D L' in approximate minimum degree order, equations with a zero diagonal moved
//! behind their neighbours. Unsymmetric: sparse LU of the transpose, because compressed rows are the
//! transpose's compressed columns. Each factorisation is tried on one right-hand side; if it fails
//! that, the banded factorisation with partial pivoting takes its place.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::linalg::lu::{
    LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

use crate::banded::Banded;
use crate::error::{FactorReport, SolveError};
use crate::ordering::{Layout, behind_neighbours, positions};
use crate::pattern::{Matrix, Pattern};
use crate::residual::worst_residual;
use crate::system::{BackEnd, Description, Kind, LinearSystem};

/// Backward error of the trial solution above which the factors are not trusted.
const LARGEST_TRIAL_ERROR: f64 = 1e-8;
/// Pivot ratio below which partial pivoting decides whether the system is singular.
const SUSPICIOUS: f64 = 1e-13;
/// Largest number of entries the banded stand-in may have (8 bytes each).
pub(crate) const LARGEST_BAND: f64 = 4e8;

enum Factors {
    Symmetric { symbolic: Box<SymbolicCholesky<usize>>, values: Vec<f64> },
    Unsymmetric { symbolic: Box<SymbolicLu<usize>>, numeric: Box<NumericLu<usize, f64>> },
}

/// Sparse back end.
pub(crate) struct Sparse {
    n: usize,
    entries: f64,
    operations: f64,
    /// Fill-reducing order found without knowledge of the values.
    order: Vec<usize>,
    zero_diagonal: Vec<bool>,
    factors: Factors,
    memory: MemBuffer,
    trial: Vec<f64>,
    banded: Option<Box<Banded>>,
    use_banded: bool,
    ready: bool,
}

impl Sparse {
    /// Symbolic analysis; `None` when the library cannot do it.
    pub fn new(pattern: &Pattern, kind: Kind) -> Option<Self> {
        let n = pattern.size();
        let symbolic = analyse_symmetric(pattern, None)?;
        let (entries, operations) = predicted(&symbolic);
        let order = symbolic.perm().map_or((0..n).collect(), |p| p.arrays().0.to_vec());
        let mut factors = match kind {
            Kind::Symmetric => {
                Factors::Symmetric { symbolic: Box::new(symbolic), values: Vec::new() }
            }
            Kind::Unsymmetric => Factors::Unsymmetric {
                symbolic: Box::new(
                    factorize_symbolic_lu(structure(pattern), LuSymbolicParams::default()).ok()?,
                ),
                numeric: Box::new(NumericLu::new()),
            },
        };
        let memory = prepare(&mut factors)?;
        let (zero_diagonal, trial) = (vec![false; n], vec![0.0; n]);
        let factor = if kind == Kind::Symmetric { 1.0 } else { 2.0 };
        Some(Self {
            n,
            entries: factor * entries,
            operations: factor * operations,
            order,
            zero_diagonal,
            factors,
            memory,
            trial,
            banded: None,
            use_banded: false,
            ready: false,
        })
    }

    /// Predicted multiplications and additions, as of a symmetric (times two: unsymmetric) pattern.
    pub fn operations(&self) -> f64 {
        self.operations
    }

    /// Predicted entries of the factors.
    pub fn entries(&self) -> f64 {
        self.entries
    }

    /// Orders anew when the set of zero diagonals is another than last time, so that the order is a
    /// function of the values alone.
    fn follow_zero_diagonals(&mut self, matrix: Matrix<'_>) -> Result<(), SolveError> {
        let Factors::Symmetric { symbolic, values } = &mut self.factors else {
            return Ok(());
        };
        let zero =
            |i: usize| matrix.pattern.position(i, i).is_none_or(|at| matrix.values[at] == 0.0);
        if (0..self.n).all(|i| zero(i) == self.zero_diagonal[i]) {
            return Ok(());
        }
        self.zero_diagonal.iter_mut().enumerate().for_each(|(i, flag)| *flag = zero(i));
        let order = behind_neighbours(matrix.pattern, &self.order, &self.zero_diagonal);
        **symbolic =
            analyse_symmetric(matrix.pattern, Some(&order)).ok_or(SolveError::OutOfMemory)?;
        values.clear();
        self.memory = prepare(&mut self.factors).ok_or(SolveError::OutOfMemory)?;
        Ok(())
    }

    /// Factors; `None` when the factors are of no use.
    fn factor_sparse(&mut self, matrix: Matrix<'_>, row_size: &[f64]) -> Option<FactorReport> {
        let system = SparseColMatRef::new(structure(matrix.pattern), matrix.values);
        let stack = MemStack::new(&mut self.memory);
        match &mut self.factors {
            Factors::Symmetric { symbolic, values } => {
                let (set, side) = (Default::default(), Side::Upper);
                symbolic
                    .factorize_numeric_ldlt(
                        values,
                        system,
                        side,
                        set,
                        Par::Seq,
                        stack,
                        Default::default(),
                    )
                    .ok()?;
                Some(pivots(symbolic, values, row_size))
            }
            Factors::Unsymmetric { symbolic, numeric } => {
                symbolic
                    .factorize_numeric_lu(numeric, system, Par::Seq, stack, Default::default())
                    .ok()?;
                Some(FactorReport { negative_pivots: None, ..FactorReport::EMPTY })
            }
        }
    }

    fn solve_sparse(&mut self, rhs: &mut [f64], transposed: bool) {
        let stack = MemStack::new(&mut self.memory);
        let rhs = MatMut::from_column_major_slice_mut(rhs, self.n, 1);
        match &self.factors {
            Factors::Symmetric { symbolic, values } => LdltRef::new(symbolic, values)
                .solve_in_place_with_conj(Conj::No, rhs, Par::Seq, stack),
            Factors::Unsymmetric { symbolic, numeric } => {
                let factors = LuRef::new_unchecked(symbolic, numeric);
                match transposed {
                    true => factors.solve_in_place_with_conj(Conj::No, rhs, Par::Seq, stack),
                    false => {
                        factors.solve_transpose_in_place_with_conj(Conj::No, rhs, Par::Seq, stack);
                    }
                }
            }
        }
    }

    /// Solves one system with right-hand sides as large as their equations and judges the result;
    /// for the unsymmetric factorisation its size also tells how near to singular the system is.
    fn trial(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
        report: FactorReport,
    ) -> Option<FactorReport> {
        let sign = |i: usize| if (i * 7 + i / 3) % 5 < 2 { -1.0 } else { 1.0 };
        let mut x = std::mem::take(&mut self.trial);
        for (i, (x_i, size)) in x.iter_mut().zip(row_size).enumerate() {
            *x_i = sign(i) * size;
        }
        self.solve_sparse(&mut x, false);
        let error = worst_residual(matrix, row_size, &x, |i| sign(i) * row_size[i]);
        let (mut at, mut largest) = (0, 0.0);
        for (i, x_i) in x.iter().enumerate() {
            if x_i.abs() > largest {
                (at, largest) = (i, x_i.abs());
            }
        }
        let finite = x.iter().all(|x_i| x_i.is_finite());
        self.trial = x;
        if !finite || error.is_nan() || error > LARGEST_TRIAL_ERROR {
            return None;
        }
        let judged = match self.factors {
            Factors::Symmetric { .. } => report,
            Factors::Unsymmetric { .. } => FactorReport {
                negative_pivots: None,
                smallest_pivot_ratio: 1.0 / largest.max(1.0),
                smallest_pivot: at,
            },
        };
        (judged.smallest_pivot_ratio >= SUSPICIOUS).then_some(judged)
    }

    fn factor_banded(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError> {
        if self.banded.is_none() {
            let layout = Layout::cheapest(matrix.pattern, Kind::Unsymmetric);
            if layout.entries(Kind::Unsymmetric) > LARGEST_BAND {
                return Err(SolveError::OutOfMemory);
            }
            let banded = Banded::new(matrix.pattern, Kind::Unsymmetric, layout);
            self.banded = Some(Box::new(banded));
        }
        let Some(banded) = &mut self.banded else { return Err(SolveError::NotFactored) };
        banded.scatter(matrix);
        let report = banded.factor(matrix, row_size)?;
        (self.use_banded, self.ready) = (true, true);
        Ok(report)
    }
}

impl Sparse {
    fn solve_block(
        &mut self,
        block: &mut [f64],
        columns: usize,
        transposed: bool,
    ) -> Result<(), SolveError> {
        if !self.ready {
            return Err(SolveError::NotFactored);
        }
        match (&mut self.banded, self.use_banded, transposed) {
            (Some(banded), true, false) => banded.solve(block, columns),
            (Some(banded), true, true) => banded.solve_transpose(block, columns),
            _ => {
                for column in block.chunks_exact_mut(self.n.max(1)) {
                    self.solve_sparse(column, transposed);
                }
                Ok(())
            }
        }
    }
}

impl LinearSystem for Sparse {
    fn scatter(&mut self, _matrix: Matrix<'_>) {
        (self.use_banded, self.ready) = (false, false);
    }

    fn factor(&mut self, matrix: Matrix<'_>, row_size: &[f64]) -> Result<FactorReport, SolveError> {
        self.follow_zero_diagonals(matrix)?;
        let report = self.factor_sparse(matrix, row_size);
        match report.and_then(|report| self.trial(matrix, row_size, report)) {
            Some(report) => {
                self.ready = true;
                Ok(report)
            }
            None => self.factor_banded(matrix, row_size),
        }
    }

    fn solve(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve_block(block, columns, false)
    }

    fn solve_transpose(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve_block(block, columns, true)
    }

    fn description(&self) -> Description {
        let kind = match self.factors {
            Factors::Symmetric { .. } => Kind::Symmetric,
            Factors::Unsymmetric { .. } => Kind::Unsymmetric,
        };
        Description {
            back_end: BackEnd::Sparse,
            kind,
            equations: self.n,
            half_bandwidth: 0,
            border: 0,
            predicted_entries: self.entries,
            predicted_operations: self.operations,
        }
    }
}

fn structure(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, usize> {
    let n = pattern.size();
    SymbolicSparseColMatRef::new_checked(n, n, pattern.row_start(), None, pattern.columns())
}

fn analyse_symmetric(
    pattern: &Pattern,
    order: Option<&[usize]>,
) -> Option<SymbolicCholesky<usize>> {
    let settings = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::AUTO,
        ..Default::default()
    };
    let structure = structure(pattern);
    let symbolic = match order {
        None => {
            factorize_symbolic_cholesky(structure, Side::Upper, SymmetricOrdering::Amd, settings)
        }
        Some(order) => {
            let place = positions(pattern.size(), order);
            let custom = PermRef::new_checked(order, &place, pattern.size());
            let ordering = SymmetricOrdering::Custom(custom);
            factorize_symbolic_cholesky(structure, Side::Upper, ordering, settings)
        }
    };
    symbolic.ok()
}

/// Sizes the values and returns working memory for factorisation and solution.
fn prepare(factors: &mut Factors) -> Option<MemBuffer> {
    let need = match factors {
        Factors::Symmetric { symbolic, values } => {
            values.resize(symbolic.len_val(), 0.0);
            StackReq::or(
                symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default()),
                symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
            )
        }
        Factors::Unsymmetric { symbolic, .. } => StackReq::or(
            symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default()),
            StackReq::or(
                symbolic.solve_transpose_in_place_scratch::<f64>(1, Par::Seq),
                symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
            ),
        ),
    };
    MemBuffer::try_new(need).ok()
}

/// Calls back with (place in the order, number of entries from the diagonal down, place of the
/// diagonal's value) for every column of the factor.
fn for_each_column(symbolic: &SymbolicCholesky<usize>, mut call: impl FnMut(usize, usize, usize)) {
    match symbolic.raw() {
        SymbolicCholeskyRaw::Simplicial(factor) => {
            for (j, start) in factor.col_ptr().windows(2).enumerate() {
                call(j, start[1] - start[0], start[0]);
            }
        }
        SymbolicCholeskyRaw::Supernodal(factor) => {
            let blocks = factor.supernode_begin().iter().zip(factor.supernode_end());
            for (s, (&begin, &end)) in blocks.enumerate() {
                let rows = factor.supernode(s).pattern().len() + end - begin;
                let first = factor.col_ptr_for_val()[s];
                for c in 0..end - begin {
                    call(begin + c, rows - c, first + c * (rows + 1));
                }
            }
        }
    }
}

/// Entries and operations of the factorisation.
fn predicted(symbolic: &SymbolicCholesky<usize>) -> (f64, f64) {
    let mut operations = 0.0;
    for_each_column(symbolic, |_, count, _| operations += (count as f64).powi(2));
    (symbolic.len_val() as f64, operations)
}

fn pivots(symbolic: &SymbolicCholesky<usize>, values: &[f64], row_size: &[f64]) -> FactorReport {
    let order = symbolic.perm().map(|p| p.arrays().0);
    let (mut negative, mut smallest, mut equation) = (0, f64::INFINITY, 0);
    for_each_column(symbolic, |j, _, diagonal| {
        let i = order.map_or(j, |order| order[j]);
        let pivot = values[diagonal];
        negative += usize::from(pivot < 0.0);
        let ratio = pivot.abs() / row_size[i];
        if ratio < smallest {
            (smallest, equation) = (ratio, i);
        }
    });
    FactorReport {
        negative_pivots: Some(negative),
        smallest_pivot_ratio: smallest,
        smallest_pivot: equation,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refactor(
        sparse: &mut Sparse,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError> {
        sparse.scatter(matrix);
        LinearSystem::factor(sparse, matrix, row_size)
    }

    /// Requirement: ordinary systems are solved by the sparse factors, not by the banded stand-in;
    /// singular ones are handed to it.
    #[test]
    fn the_stand_in_is_for_trouble_only() {
        let n = 300;
        let pattern = Pattern::from_pairs(n, (0..n).flat_map(|i| [(i, i + 1), (i, (i * 7) % n)]));
        let row_size = vec![1.0; n];
        for kind in [Kind::Symmetric, Kind::Unsymmetric] {
            let mut values = Vec::new();
            for i in 0..n {
                values.extend(pattern.row(i).iter().map(|&j| if i == j { 60.0 } else { -1.0 }));
            }
            let mut sparse = Sparse::new(&pattern, kind).unwrap();
            refactor(&mut sparse, Matrix::new(&pattern, &values), &row_size).unwrap();
            assert!(!sparse.use_banded, "{kind:?}");
            for (at, &j) in pattern.columns().iter().enumerate() {
                values[at] = if j == 5 { 0.0 } else { values[at] };
            }
            let result = refactor(&mut sparse, Matrix::new(&pattern, &values), &row_size);
            assert!(matches!(result, Err(SolveError::Singular { equation: 5, .. })), "{result:?}");
            assert!(sparse.banded.is_some());
        }
    }
}
