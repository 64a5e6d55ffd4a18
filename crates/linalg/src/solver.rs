//! An analysed system, and the checks around every factorisation.

mod near;
mod solving;

use crate::error::{FactorReport, SolveError};
use crate::followed::{EXACT, single_pays};
use crate::near::{Near, Use};
use crate::pattern::{Matrix, Pattern};
use crate::refused::Refused;
use crate::system::{Analyse, Description, Interface, Kind, LinearSystem};

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
