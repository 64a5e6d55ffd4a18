//! The checks around every factorisation and solution.

mod near;

use crate::error::{FactorReport, SolveError};
use crate::followed::{EXACT, Followed, NEAR, single_pays};
use crate::krylov::{Stop, gmres};
use crate::near::{Near, Use};
use crate::pattern::{Matrix, Pattern};
use crate::refused::Refused;
use crate::residual::worst_of;
use crate::system::{Analyse, Description, Interface, Kind, LinearSystem};

/// Backward error above which one step of iterative refinement is done.
const REFINE_ABOVE: f64 = 1e-10;
/// Backward error above which a refined solution is refused.
const REFUSE_ABOVE: f64 = 1e-6;
/// Right-hand sides below this lose digits in products, the format having no smaller exponents.
const SMALLEST: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON * f64::EPSILON);
/// What they are raised by, a power of two.
const RAISE: f64 = 1.0 / SMALLEST;

/// An analysed system: refactor as often as the values change, solve as often as needed.
pub struct Solver {
    system: Box<dyn LinearSystem>,
    pattern: Pattern,
    values: Vec<f64>,
    row_size: Vec<f64>,
    rhs: Vec<f64>,
    correction: Vec<f64>,
    /// Sums of magnitudes of the columns, for solutions of the transposed system.
    column_size: Vec<f64>,
    /// By what the right-hand sides of a block were raised.
    raised: Vec<f64>,
    report: Option<FactorReport>,
    /// Natural unit of each unknown; none: all alike.
    unit: Vec<f64>,
    /// Product of the units of row and column of each entry, likewise.
    unit_of_entry: Vec<f64>,
    /// Whether the last checked solution needed no refinement.
    accurate: bool,
    near: Near,
}

/// Which of the two systems is solved.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Plain,
    Transposed,
}

impl Solver {
    /// A solver around an analysed system of a pattern, whoever implements it.
    pub fn new(pattern: &Pattern, system: Box<dyn LinearSystem>) -> Self {
        let n = pattern.size();
        Self {
            system,
            pattern: pattern.clone(),
            values: vec![0.0; pattern.entries()],
            row_size: vec![0.0; n],
            rhs: vec![0.0; n],
            correction: vec![0.0; n],
            column_size: Vec::new(),
            raised: Vec::new(),
            report: None,
            unit: Vec::new(),
            unit_of_entry: Vec::new(),
            accurate: false,
            near: Near::default(),
        }
    }

    /// Analyses a pattern with a factory of systems, from this crate or from elsewhere. Where the
    /// analysis fails, every factorisation says so.
    pub fn analyse(pattern: &Pattern, kind: Kind, factory: &dyn Analyse) -> Self {
        Self::analyse_for((pattern, kind), factory, &Interface::default())
    }

    /// The same where most solutions are wanted on an interface. Of a matrix that is nearly symmetric
    /// the symmetric part is factored, where the factory chooses that.
    pub fn analyse_for(
        (pattern, kind): (&Pattern, Kind),
        factory: &dyn Analyse,
        interface: &Interface<'_>,
    ) -> Self {
        let refused = |fault| Box::new(Refused { fault, kind, equations: pattern.size() });
        let mut solver = match factory.analyse_for(pattern, kind, interface) {
            Ok(system) => Self::new(pattern, system),
            Err(fault) => Self::new(pattern, refused(fault)),
        };
        let of_factors = solver.system.description().kind;
        solver.near.halves = (kind, of_factors) == (Kind::Unsymmetric, Kind::Symmetric);
        if !interface.equations.is_empty() {
            solver.near.is_on_interface.resize(pattern.size(), false);
            interface.equations.iter().for_each(|&i| solver.near.is_on_interface[i] = true);
        }
        solver
    }

    /// Gives each unknown its natural unit u_i > 0. The system is factored and judged as U A U, in
    /// which all entries have one dimension: neither a pivot nor an accuracy then depends on how
    /// forces and lengths are measured. Units of another number than the equations are left aside.
    pub fn with_units(mut self, unit: Vec<f64>) -> Self {
        self.set_units(&unit);
        self
    }

    /// The same for a solver that may have had others; a factorisation is lost where they differ.
    pub fn set_units(&mut self, unit: &[f64]) {
        let usable = unit.len() == self.rhs.len() && unit.iter().all(|&u| u > 0.0 && u.is_finite());
        let wanted = if usable && unit.iter().any(|&u| u != 1.0) { unit } else { &[] };
        if self.unit == wanted {
            return;
        }
        self.report = None;
        self.unit.clear();
        self.unit.extend_from_slice(wanted);
        self.unit_of_entry.clear();
        for (i, &unit) in self.unit.iter().enumerate() {
            let row = self.pattern.row(i).iter();
            self.unit_of_entry.extend(row.map(|&column| unit * self.unit[column]));
        }
    }

    /// Tells the system the rigid motions of the unknowns, column after column: it may then solve
    /// by iteration, which pays where few right-hand sides belong to a matrix. To be told after
    /// the units.
    pub fn set_motions(&mut self, motions: &[f64]) {
        let mut own = motions.to_vec();
        for column in own.chunks_exact_mut(self.rhs.len().max(1)) {
            column.iter_mut().zip(&self.unit).for_each(|(motion, unit)| *motion /= unit);
        }
        self.system.take_motions(&own);
    }

    /// U A U of the values given.
    fn take(&mut self, values: &[f64]) {
        if self.unit.is_empty() {
            self.values.copy_from_slice(values);
            return;
        }
        let scaled = values.iter().zip(&self.unit_of_entry).map(|(value, unit)| value * unit);
        self.values.iter_mut().zip(scaled).for_each(|(own, value)| *own = value);
    }

    /// Factors the matrix with these values; `pattern` must be the analysed one. The result is a
    /// function of the values alone, whatever was factored before.
    ///
    /// Errors: [`SolveError::Size`], [`SolveError::PatternChanged`], [`SolveError::NotFinite`],
    /// [`SolveError::Singular`], those of the system; after an error there is no factorisation to
    /// solve with.
    pub fn refactor(
        &mut self,
        pattern: &Pattern,
        values: &[f64],
    ) -> Result<FactorReport, SolveError> {
        self.report = None;
        self.take_matrix(pattern, values)?;
        self.factor_taken()
    }

    /// Negative pivots of the last factorisation; none where it does not count them.
    pub fn negative_pivots(&self) -> usize {
        self.report.and_then(|report| report.negative_pivots).unwrap_or(0)
    }

    /// Takes the values of a matrix of the analysed pattern.
    fn take_matrix(&mut self, pattern: &Pattern, values: &[f64]) -> Result<(), SolveError> {
        (self.accurate, self.near.stop) = (false, None);
        self.near.skew.clear();
        if values.len() != self.values.len() {
            return Err(SolveError::Size { expected: self.values.len(), found: values.len() });
        }
        if *pattern != self.pattern {
            return Err(SolveError::PatternChanged);
        }
        self.take(values);
        if self.near.halves {
            self.near.skew.split(&self.pattern, &mut self.values);
        }
        self.measure_rows()
    }

    /// The first row that any process names.
    fn first_of_all<const M: usize>(&self, own: [Option<usize>; M]) -> [Option<usize>; M] {
        let n = self.rhs.len();
        // The largest distance from the end is that of the first row.
        let mut from_end = own.map(|at| at.map_or(0.0, |i| (n - i) as f64));
        self.system.reduce_max(&mut from_end);
        from_end.map(|distance| (distance > 0.0).then(|| n - distance as usize))
    }

    /// Sizes of the owned rows; refuses what is not finite and what is empty, the first row first.
    fn measure_rows(&mut self) -> Result<(), SolveError> {
        let matrix = Matrix::new(&self.pattern, &self.values);
        let (mut infinite, mut empty) = (None, None);
        for i in self.system.owned_rows() {
            let size = matrix.row_size(i);
            self.row_size[i] = size;
            if size == 0.0 || !size.is_finite() {
                let first = if size == 0.0 { &mut empty } else { &mut infinite };
                first.get_or_insert(i);
            }
        }
        let [infinite, empty] = self.first_of_all([infinite, empty]);
        if let Some(equation) = infinite {
            return Err(SolveError::NotFinite { equation });
        }
        if let Some(equation) = empty {
            return Err(SolveError::Singular { equation, ratio: 0.0 });
        }
        Ok(())
    }

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
    fn check(&self, rhs: &[f64]) -> Result<(), SolveError> {
        if rhs.len() != self.rhs.len() {
            return Err(SolveError::Size { expected: self.rhs.len(), found: rhs.len() });
        }
        self.report.map(|_| ()).ok_or(SolveError::NotFactored)
    }

    fn solve_side(&mut self, rhs: &mut [f64], side: Side) -> Result<(), SolveError> {
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
    fn enter(&mut self, block: &mut [f64]) {
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
    fn leave(&self, solution: &mut [f64], raised: f64) {
        if raised != 1.0 {
            solution.iter_mut().for_each(|x| *x /= raised);
        }
        solution.iter_mut().zip(&self.unit).for_each(|(x, u)| *x *= u);
    }

    /// Factors the matrix taken last, nearly where that does.
    fn factor_taken(&mut self) -> Result<FactorReport, SolveError> {
        if self.near.wanted == Use::Many {
            return self.factor_exactly();
        }
        if single_pays(&self.system.description()) {
            let matrix = Matrix::new(&self.pattern, &self.values);
            self.report = self.system.factor_single(matrix);
            if let Some(report) = self.report {
                self.near.stop = Some(EXACT);
                return Ok(report);
            }
        }
        if !self.near.skew.is_empty()
            && let Ok(report) = self.factor_symmetric()
        {
            self.near.stop = Some(EXACT);
            return Ok(report);
        }
        self.factor_exactly()
    }

    /// Factors the matrix taken last such that a substitution solves it.
    ///
    /// Errors: those of [`Solver::refactor`].
    pub fn factor_exactly(&mut self) -> Result<FactorReport, SolveError> {
        if self.near.skew.is_empty() {
            return self.factor_symmetric();
        }
        (self.report, self.near.stop) = (None, None);
        self.near.skew.join(&self.pattern, &mut self.values);
        self.measure_rows()?;
        let matrix = Matrix::new(&self.pattern, &self.values);
        let report = self.system.factor_unsymmetric(matrix, &self.row_size)?;
        self.report = Some(report);
        Ok(report)
    }

    /// Factors the values taken last in double, without what is left beside the symmetric part.
    fn factor_symmetric(&mut self) -> Result<FactorReport, SolveError> {
        (self.report, self.near.stop) = (None, None);
        let matrix = Matrix::new(&self.pattern, &self.values);
        self.system.scatter(matrix);
        let report = self.system.factor(matrix, &self.row_size)?;
        self.report = Some(report);
        Ok(report)
    }

    /// Solves with factors that are near; where these are of another matrix and fail, with those of
    /// this one. False where that fails too, or where exact factors are at hand.
    fn solve_nearly(&mut self, x: &mut [f64]) -> Result<bool, SolveError> {
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
    fn iterate(&mut self, x: &mut [f64], stop: Stop) -> bool {
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

    fn substitute(&mut self, x: &mut [f64], side: Side) -> Result<(), SolveError> {
        match side {
            Side::Plain => self.system.solve(x, 1),
            Side::Transposed => self.system.solve_transpose(x, 1),
        }
    }

    /// Backward error of a solution for the right-hand side kept, over the rows of all processes.
    fn backward_error(&mut self, x: &[f64], side: Side) -> f64 {
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
    fn residual(&mut self, x: &[f64]) {
        let matrix = Matrix::new(&self.pattern, &self.values);
        for i in self.system.owned_rows() {
            self.correction[i] = self.rhs[i] - matrix.row_times(i, x);
        }
        self.near.skew.add_product(-1.0, x, &mut self.correction);
    }

    /// b - A' x, and the sums of magnitudes of the columns.
    fn residual_transposed(&mut self, x: &[f64]) {
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

    fn refine(&mut self, x: &mut [f64], side: Side) -> Result<(), SolveError> {
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

    /// The matrix factored last.
    pub fn matrix(&self) -> Matrix<'_> {
        Matrix::new(&self.pattern, &self.values)
    }

    /// Rows that this process assembles and judges.
    pub fn owned_rows(&self) -> std::ops::Range<usize> {
        self.system.owned_rows()
    }

    /// What the analysis decided.
    pub fn description(&self) -> Description {
        self.system.description()
    }
}
