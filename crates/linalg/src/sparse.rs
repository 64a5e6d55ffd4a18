//! Sparse back end: multifrontal factorisations in the order with the fewest predicted operations.
//!
//! ```text
//!   L D L'  --trial fails-->  L U, pivots among  --trial fails-->  banded L U with partial
//!   (symmetric values)        a front's columns                    pivoting, where affordable
//! ```
//!
//! Equations with a zero diagonal are moved behind their neighbours. Each factorisation is tried on
//! one right-hand side, unless it is that of a definite matrix; if it fails that, or if a pivot is
//! no more than rounding, the next takes its place, and the last one decides whether the system is
//! singular, and where.

use crate::banded::Banded;
use crate::dense_fronts::Pivots;
use crate::error::{FactorReport, SolveError};
use crate::fronts::Tree;
use crate::multifrontal::Multifrontal;
use crate::ordering::{Layout, behind_neighbours};
use crate::orders::best_tree_for;
use crate::pattern::{Matrix, Pattern};
use crate::residual::worst_residual;
use crate::single::Single;
use crate::system::{BackEnd, Description, Kind, LinearSystem};
use rayon::ThreadPool;
use std::sync::Arc;

/// Backward error of the trial solution above which the factors are not trusted.
const LARGEST_TRIAL_ERROR: f64 = 1e-8;
/// Pivot ratio below which partial pivoting decides whether the system is singular.
const SUSPICIOUS: f64 = 1e-13;
/// And below which it is taken as singular where partial pivoting is beyond reach.
const SINGULAR: f64 = 1e-14;
/// Largest number of entries the banded stand-in may have (8 bytes each).
pub(crate) const LARGEST_BAND: f64 = 4e8;
/// Operations that a banded stand-in may always cost, and how many times those of the sparse one.
const AFFORDABLE: (f64, f64) = (1e9, 5.0);

/// Which factorisation is solved with.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Held {
    Nothing,
    Factors,
    Single,
    Pivoted,
    Banded,
}

/// Sparse back end.
pub(crate) struct Sparse {
    kind: Kind,
    entries: f64,
    operations: f64,
    /// Fill-reducing order found without knowledge of the values.
    order: Vec<usize>,
    /// Where the diagonal's values are among the entries.
    diagonal: Vec<usize>,
    zero_diagonal: Vec<bool>,
    /// None when an order that zero diagonals asked for could not be analysed.
    factors: Option<Box<Multifrontal>>,
    /// The same in single precision, where it was asked for.
    single: Option<Box<Single>>,
    /// L U of symmetric values that L D L' is not fit for.
    pivoted: Option<Box<Multifrontal>>,
    banded: Option<Box<Banded>>,
    trial: Vec<f64>,
    held: Held,
    /// Equations that most solutions are wanted on; none: all.
    interface: Vec<usize>,
    pool: Option<Arc<ThreadPool>>,
}

impl Sparse {
    /// Symbolic analysis; `None` when the libraries cannot do it.
    pub fn new(
        pattern: &Pattern,
        kind: Kind,
        interface: &[usize],
        pool: Option<Arc<ThreadPool>>,
    ) -> Option<Self> {
        let n = pattern.size();
        let tree = best_tree_for(pattern, interface)?;
        let (entries, operations) = tree.predicted();
        let factor = if kind == Kind::Symmetric { 1.0 } else { 2.0 };
        let factors = Multifrontal::new(pattern, kind, &tree, pool.clone())?.with_path(interface);
        Some(Self {
            kind,
            entries: factor * entries,
            operations: factor * operations,
            order: tree.order,
            diagonal: (0..n).filter_map(|i| pattern.position(i, i)).collect(),
            zero_diagonal: vec![false; n],
            factors: Some(Box::new(factors)),
            single: None,
            pivoted: None,
            banded: None,
            trial: vec![0.0; n],
            held: Held::Nothing,
            interface: interface.to_vec(),
            pool,
        })
    }

    /// Predicted multiplications and additions.
    pub fn operations(&self) -> f64 {
        self.operations
    }

    /// Predicted entries of the factors.
    pub fn entries(&self) -> f64 {
        self.entries
    }

    /// Orders anew when the set of zero diagonals is another than last time, so that the order is a
    /// function of the values alone.
    fn follow_zero_diagonals(&mut self, matrix: Matrix<'_>) {
        let flags = || self.diagonal.iter().map(|&at| matrix.values[at] == 0.0);
        if self.factors.is_some() && flags().eq(self.zero_diagonal.iter().copied()) {
            return;
        }
        self.zero_diagonal = flags().collect();
        (self.single, self.pivoted) = (None, None);
        self.factors = self.analyse(matrix.pattern, self.kind);
    }

    /// Factors in the order that the zero diagonals ask for.
    fn analyse(&self, pattern: &Pattern, kind: Kind) -> Option<Box<Multifrontal>> {
        let order = behind_neighbours(pattern, &self.order, &self.zero_diagonal);
        let tree = Tree::new(pattern, &order);
        let factors = Multifrontal::new(pattern, kind, &tree, self.pool.clone())?;
        Some(Box::new(factors.with_path(&self.interface)))
    }

    /// Factors with pivoting among the columns of a front, in the order of the symmetric factors.
    fn factor_pivoted(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError> {
        if self.pivoted.is_none() {
            let pivoted = self.analyse(matrix.pattern, Kind::Unsymmetric);
            self.pivoted = Some(pivoted.ok_or(SolveError::OutOfMemory)?);
        }
        let Some(pivoted) = &mut self.pivoted else { return Err(SolveError::OutOfMemory) };
        pivoted.scatter(matrix.values.iter().copied())?;
        let pivots = pivoted.factor(|i| row_size[i]);
        self.held = Held::Pivoted;
        Ok(report(pivoted, pivots, None))
    }

    /// Solves one system with right-hand sides as large as their equations and judges the result,
    /// whose size also tells how near to singular the system is.
    fn trial(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
        report: FactorReport,
    ) -> (bool, FactorReport) {
        let sign = |i: usize| if (i * 7 + i / 3) % 5 < 2 { -1.0 } else { 1.0 };
        let mut x = std::mem::take(&mut self.trial);
        for (i, (x_i, size)) in x.iter_mut().zip(row_size).enumerate() {
            *x_i = sign(i) * size;
        }
        let solved = self.solve_block(&mut x, 1, false);
        let error = worst_residual(matrix, row_size, &x, |i| sign(i) * row_size[i]);
        let (mut at, mut largest) = (0, 1.0);
        for (i, x_i) in x.iter().enumerate() {
            if x_i.abs() > largest {
                (at, largest) = (i, x_i.abs());
            }
        }
        self.trial = x;
        let judged = match 1.0 / largest < report.smallest_pivot_ratio {
            true => {
                FactorReport { smallest_pivot_ratio: 1.0 / largest, smallest_pivot: at, ..report }
            }
            false => report,
        };
        (solved.is_ok() && error <= LARGEST_TRIAL_ERROR, judged)
    }

    /// Factors with partial pivoting, where that does not cost much more; otherwise the verdict is
    /// that of the sparse factors.
    fn factor_banded(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
        (good, sparse): (bool, FactorReport),
    ) -> Result<FactorReport, SolveError> {
        if self.banded.is_none() {
            let layout = Layout::cheapest(matrix.pattern, Kind::Unsymmetric);
            let affordable = AFFORDABLE.0.max(AFFORDABLE.1 * self.operations);
            if layout.operations(Kind::Unsymmetric) <= affordable
                && layout.entries(Kind::Unsymmetric) <= LARGEST_BAND
            {
                let banded = Banded::new(matrix.pattern, Kind::Unsymmetric, layout);
                self.banded = Some(Box::new(banded));
            }
        }
        let Some(banded) = &mut self.banded else {
            let (equation, ratio) = (sparse.smallest_pivot, sparse.smallest_pivot_ratio);
            if good && ratio >= SINGULAR {
                return Ok(sparse);
            }
            self.held = Held::Nothing;
            return Err(SolveError::Singular { equation, ratio });
        };
        self.held = Held::Nothing;
        banded.scatter(matrix);
        let report = banded.factor(matrix, row_size)?;
        self.held = Held::Banded;
        Ok(report)
    }

    fn solve_block(
        &mut self,
        block: &mut [f64],
        columns: usize,
        transposed: bool,
    ) -> Result<(), SolveError> {
        let factors = match self.held {
            Held::Single => {
                let Some(single) = &mut self.single else { return Err(SolveError::NotFactored) };
                block.chunks_exact_mut(block.len() / columns).for_each(|b| single.solve(b, false));
                return Ok(());
            }
            Held::Factors => &mut self.factors,
            Held::Pivoted => &mut self.pivoted,
            Held::Banded => {
                let Some(banded) = &mut self.banded else { return Err(SolveError::NotFactored) };
                return match transposed {
                    true => banded.solve_transpose(block, columns),
                    false => banded.solve(block, columns),
                };
            }
            Held::Nothing => return Err(SolveError::NotFactored),
        };
        let Some(factors) = factors else { return Err(SolveError::NotFactored) };
        factors.solve(block, columns, transposed);
        Ok(())
    }
}

impl LinearSystem for Sparse {
    fn scatter(&mut self, matrix: Matrix<'_>) {
        self.held = Held::Nothing;
        self.follow_zero_diagonals(matrix);
        if let Some(single) = &mut self.single {
            single.release();
        }
        let values = matrix.values.iter().copied();
        let scattered = self.factors.as_mut().map(|factors| factors.scatter(values));
        if let Some(Err(_)) = scattered {
            self.factors = None; // there is no memory for them
        }
    }

    fn factor(&mut self, matrix: Matrix<'_>, row_size: &[f64]) -> Result<FactorReport, SolveError> {
        let Some(factors) = &mut self.factors else { return Err(SolveError::OutOfMemory) };
        let pivots = factors.factor(|i| row_size[i]);
        let symmetric = self.kind == Kind::Symmetric;
        let found = report(factors, pivots, symmetric.then_some(pivots.negative));
        self.held = Held::Factors;
        if found.is_definite() {
            return Ok(found);
        }
        let mut judged = self.trial(matrix, row_size, found);
        if is_safe(judged) {
            return Ok(judged.1);
        }
        if symmetric {
            let found = self.factor_pivoted(matrix, row_size)?;
            judged = self.trial(matrix, row_size, found);
            if is_safe(judged) {
                return Ok(judged.1);
            }
        }
        self.factor_banded(matrix, row_size, judged)
    }

    fn factor_single(&mut self, matrix: Matrix<'_>) -> Option<FactorReport> {
        self.held = Held::Nothing;
        let definite = self.diagonal.iter().all(|&at| matrix.values[at] > 0.0);
        if self.kind != Kind::Symmetric || !definite {
            return None;
        }
        self.follow_zero_diagonals(matrix);
        let factors = self.factors.as_mut()?;
        factors.release();
        let single = self.single.get_or_insert_with(|| Box::new(Single::new(factors)));
        let report = single.factor(matrix, &self.diagonal)?;
        self.held = Held::Single;
        Some(report)
    }

    fn solve(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve_block(block, columns, false)
    }

    fn solve_transpose(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        self.solve_block(block, columns, true)
    }

    fn solve_on_interface(&mut self, b: &mut [f64]) -> Result<(), SolveError> {
        let factors = match self.held {
            Held::Single => {
                let Some(single) = &mut self.single else { return Err(SolveError::NotFactored) };
                single.solve(b, true);
                return Ok(());
            }
            Held::Factors => &mut self.factors,
            Held::Pivoted => &mut self.pivoted,
            Held::Banded | Held::Nothing => return self.solve_block(b, 1, false),
        };
        let Some(factors) = factors else { return Err(SolveError::NotFactored) };
        factors.solve_on_path(b, |_, b| b, |_, x| x);
        Ok(())
    }

    fn factor_unsymmetric(
        &mut self,
        matrix: Matrix<'_>,
        row_size: &[f64],
    ) -> Result<FactorReport, SolveError> {
        self.held = Held::Nothing;
        self.follow_zero_diagonals(matrix);
        self.factors.iter_mut().for_each(|factors| factors.release());
        self.single.iter_mut().for_each(|single| single.release());
        let found = self.factor_pivoted(matrix, row_size)?;
        let judged = self.trial(matrix, row_size, found);
        if is_safe(judged) {
            return Ok(judged.1);
        }
        self.factor_banded(matrix, row_size, judged)
    }

    fn description(&self) -> Description {
        Description {
            back_end: BackEnd::Sparse,
            kind: self.kind,
            equations: self.diagonal.len(),
            half_bandwidth: 0,
            border: 0,
            predicted_entries: self.entries,
            predicted_operations: self.operations,
            bytes: self.factors.as_ref().map_or(0.0, |factors| factors.bytes()),
        }
    }
}

/// Whether a trial was passed and no pivot is suspicious.
fn is_safe((good, report): (bool, FactorReport)) -> bool {
    good && report.smallest_pivot_ratio >= SUSPICIOUS
}

fn report(factors: &Multifrontal, pivots: Pivots, negative: Option<usize>) -> FactorReport {
    FactorReport {
        negative_pivots: negative,
        smallest_pivot_ratio: pivots.smallest_ratio,
        smallest_pivot: factors.equation(pivots.smallest),
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
            let mut sparse = Sparse::new(&pattern, kind, &[], None).unwrap();
            refactor(&mut sparse, Matrix::new(&pattern, &values), &row_size).unwrap();
            assert!(sparse.held == Held::Factors, "{kind:?}");
            for (at, &j) in pattern.columns().iter().enumerate() {
                values[at] = if j == 5 { 0.0 } else { values[at] };
            }
            let result = refactor(&mut sparse, Matrix::new(&pattern, &values), &row_size);
            assert!(matches!(result, Err(SolveError::Singular { equation: 5, .. })), "{result:?}");
            assert!(sparse.banded.is_some());
        }
    }
}
