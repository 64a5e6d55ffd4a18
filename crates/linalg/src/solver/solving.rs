//! Solutions with factors that are there: entered in units, checked, refined.
//!
//! ```text
//!   b --> in units, raised --> by factors, or by iteration near them --> residual --> refined once --> x
//! ```

use super::{Side, Solver};
use crate::error::{FactorReport, SolveError};
use crate::followed::{EXACT, Followed, NEAR};
use crate::krylov::{Stop, gmres};
use crate::pattern::Matrix;
use crate::residual::worst_of;

/// Backward error above which one step of iterative refinement is done.
const REFINE_ABOVE: f64 = 1e-10;
/// Backward error above which a refined solution is refused.
const REFUSE_ABOVE: f64 = 1e-6;
/// Right-hand sides below this lose digits in products, the format having no smaller exponents.
const SMALLEST: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON * f64::EPSILON);
/// What they are raised by, a power of two.
const RAISE: f64 = 1.0 / SMALLEST;

impl Solver {
    /// Solves in place with the last factorisation, any number of times. The residual is checked
    /// and the solution refined once where rounding was worse than usual.
    ///
    /// Errors: [`SolveError::Size`], [`SolveError::NotFactored`], [`SolveError::NotFinite`] for the
    /// right-hand side, [`SolveError::Singular`] when the solution is useless all the same, those
    /// of the system.
    pub fn solve(&mut self, rhs: &mut [f64]) -> Result<(), SolveError> {
        self.solve_side(rhs, Side::Plain)
    }

    /// Solves A' x = b in place with the last factorisation, checked like [`Solver::solve`].
    ///
    /// Errors: those of [`Solver::solve`].
    pub fn solve_transpose(&mut self, rhs: &mut [f64]) -> Result<(), SolveError> {
        self.solve_side(rhs, Side::Transposed)
    }

    /// Whether there are factors, and a right-hand side for them.
    pub(super) fn check(&self, rhs: &[f64]) -> Result<(), SolveError> {
        if rhs.len() != self.rhs.len() {
            return Err(SolveError::Size { expected: self.rhs.len(), found: rhs.len() });
        }
        self.report.map(|_| ()).ok_or(SolveError::NotFactored)
    }

    pub(super) fn solve_side(&mut self, rhs: &mut [f64], side: Side) -> Result<(), SolveError> {
        self.check(rhs)?;
        let infinite = self.system.owned_rows().find(|&i| !rhs[i].is_finite());
        if let [Some(equation)] = self.first_of_all([infinite]) {
            return Err(SolveError::NotFinite { equation });
        }
        self.enter(rhs);
        let raised = self.raised.first().copied().unwrap_or(1.0);
        if side == Side::Plain && self.solve_nearly(rhs)? {
            self.leave(rhs, raised);
            return Ok(());
        }
        if self.near.stop.is_some() {
            self.factor_exactly()?;
        }
        self.rhs.copy_from_slice(rhs);
        self.substitute(rhs, side)?;
        let mut error = self.backward_error(rhs, side);
        let accurate = error <= REFINE_ABOVE;
        if side == Side::Plain {
            self.accurate = accurate;
        }
        if !accurate {
            self.refine(rhs, side)?;
            error = self.backward_error(rhs, side);
        }
        if error <= REFUSE_ABOVE {
            self.leave(rhs, raised);
            return Ok(());
        }
        let report = self.report.unwrap_or(FactorReport::EMPTY);
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
        self.solve_many(rhs, 1)
    }

    /// As [`Solver::respond`] for many right-hand sides at once, stored column after column. The
    /// result does not depend on how they are divided into blocks.
    ///
    /// Errors: those of [`Solver::solve`].
    pub fn solve_many(&mut self, block: &mut [f64], columns: usize) -> Result<(), SolveError> {
        let n = self.rhs.len();
        if block.len() != n * columns {
            return Err(SolveError::Size { expected: n * columns, found: block.len() });
        }
        if n == 0 || columns == 0 {
            return Ok(());
        }
        let mut checked = 0;
        while !self.accurate && checked < columns {
            self.solve(&mut block[checked * n..(checked + 1) * n])?;
            checked += 1;
        }
        let rest = &mut block[checked * n..];
        if rest.is_empty() {
            return Ok(());
        }
        self.enter(rest);
        let solved = self.system.solve(rest, columns - checked);
        for (column, &raised) in rest.chunks_exact_mut(n).zip(&self.raised) {
            self.leave(column, raised);
        }
        solved
    }

    /// Right-hand sides in the units of their equations, raised by a power of two where they are so
    /// small that products with them would lose digits below the smallest normal number; by which is
    /// noted in `raised`.
    pub(super) fn enter(&mut self, block: &mut [f64]) {
        let n = self.rhs.len().max(1);
        self.raised.clear();
        for rhs in block.chunks_exact_mut(n) {
            rhs.iter_mut().zip(&self.unit).for_each(|(b, u)| *b *= u);
            let own = &rhs[self.system.owned_rows()];
            self.raised.push(own.iter().fold(0.0_f64, |largest, b| largest.max(b.abs())));
        }
        self.system.reduce_max(&mut self.raised);
        for (rhs, raised) in block.chunks_exact_mut(n).zip(&mut self.raised) {
            let tiny = *raised > 0.0 && *raised < SMALLEST;
            *raised = if tiny { RAISE } else { 1.0 };
            if tiny {
                rhs.iter_mut().for_each(|b| *b *= RAISE);
            }
        }
    }

    /// The unknowns of a solution.
    pub(super) fn leave(&self, solution: &mut [f64], raised: f64) {
        if raised != 1.0 {
            solution.iter_mut().for_each(|x| *x /= raised);
        }
        solution.iter_mut().zip(&self.unit).for_each(|(x, u)| *x *= u);
    }

    /// Solves with factors that are near; where these are of another matrix and fail, with those of
    /// this one. False where that fails too, or where exact factors are at hand.
    pub(super) fn solve_nearly(&mut self, x: &mut [f64]) -> Result<bool, SolveError> {
        if self.near.stop == Some(NEAR) {
            if self.iterate(x, NEAR) {
                return Ok(true);
            }
            self.factor_taken()?;
        }
        if self.near.stop != Some(EXACT) {
            return Ok(false);
        }
        self.rhs.copy_from_slice(x);
        let solved = self.iterate(x, EXACT) && self.backward_error(x, Side::Plain) <= REFINE_ABOVE;
        if !solved {
            x.copy_from_slice(&self.rhs);
        }
        Ok(solved)
    }

    /// Conjugate gradients with the factors at hand, GMRES where the matrix is not symmetric; false,
    /// and the right-hand side as it was, where they fail.
    pub(super) fn iterate(&mut self, x: &mut [f64], stop: Stop) -> bool {
        let matrix = Matrix::new(&self.pattern, &self.values);
        let (near, system) = (&mut self.near, &mut *self.system);
        if near.skew.is_empty() {
            let mut followed = Followed { matrix, factors: system };
            return near.conjugate.solve(x, stop, &mut followed);
        }
        let b = &mut self.correction[..];
        b.copy_from_slice(x);
        x.fill(0.0);
        let (skew, krylov, mut failed) = (&near.skew, &mut near.krylov, false);
        let product = |v: &[f64], into: &mut [f64]| {
            matrix.multiply(v, into);
            skew.add_product(1.0, v, into);
        };
        let nearly = |v: &[f64], into: &mut [f64]| {
            into.copy_from_slice(v);
            failed |= system.solve(into, 1).is_err();
        };
        let solved = gmres(product, nearly, b, x, stop, krylov).converged() && !failed;
        if !solved {
            x.copy_from_slice(b);
        }
        solved
    }

    pub(super) fn substitute(&mut self, x: &mut [f64], side: Side) -> Result<(), SolveError> {
        match side {
            Side::Plain => self.system.solve(x, 1),
            Side::Transposed => self.system.solve_transpose(x, 1),
        }
    }

    /// Backward error of a solution for the right-hand side kept, over the rows of all processes.
    pub(super) fn backward_error(&mut self, x: &[f64], side: Side) -> f64 {
        if side == Side::Transposed {
            self.residual_transposed(x);
            let size = |j: usize| self.column_size[j];
            return worst_of((0..x.len()).map(|j| (self.correction[j], size(j), self.rhs[j])), x);
        }
        self.residual(x);
        let owned = self.system.owned_rows();
        let rows = owned.map(|i| (self.correction[i], self.row_size[i], self.rhs[i]));
        let mut worst = [worst_of(rows, x)];
        self.system.reduce_max(&mut worst);
        worst[0]
    }

    /// b - A x of the owned rows.
    pub(super) fn residual(&mut self, x: &[f64]) {
        let matrix = Matrix::new(&self.pattern, &self.values);
        for i in self.system.owned_rows() {
            self.correction[i] = self.rhs[i] - matrix.row_times(i, x);
        }
        self.near.skew.add_product(-1.0, x, &mut self.correction);
    }

    /// b - A' x, and the sums of magnitudes of the columns.
    pub(super) fn residual_transposed(&mut self, x: &[f64]) {
        let matrix = Matrix::new(&self.pattern, &self.values);
        self.correction.fill(0.0);
        self.column_size.clear();
        self.column_size.resize(x.len(), 0.0);
        for i in self.system.owned_rows() {
            let (columns, values) = matrix.row(i);
            for (&j, &a) in columns.iter().zip(values) {
                self.correction[j] -= a * x[i];
                self.column_size[j] += a.abs();
            }
        }
        self.system.reduce_sum(&mut self.correction);
        self.system.reduce_sum(&mut self.column_size);
        self.correction.iter_mut().zip(&self.rhs).for_each(|(c, b)| *c += b);
    }

    pub(super) fn refine(&mut self, x: &mut [f64], side: Side) -> Result<(), SolveError> {
        match side {
            Side::Plain => self.residual(x),
            Side::Transposed => self.residual_transposed(x),
        }
        let mut correction = std::mem::take(&mut self.correction);
        let solved = self.substitute(&mut correction, side);
        x.iter_mut().zip(&correction).for_each(|(x_i, c)| *x_i += c);
        self.correction = correction;
        solved
    }
}
