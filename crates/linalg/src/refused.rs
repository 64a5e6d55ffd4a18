//! A system whose analysis failed: every factorisation says so.

use crate::error::{FactorReport, SolveError};
use crate::pattern::Matrix;
use crate::system::{Description, Kind, LinearSystem};

/// A system whose analysis failed.
pub(crate) struct Refused {
    pub fault: SolveError,
    pub kind: Kind,
    pub equations: usize,
}

impl LinearSystem for Refused {
    fn description(&self) -> Description {
        Description::external("analysis failed", self.kind, self.equations)
    }
    fn scatter(&mut self, _matrix: Matrix<'_>) {}
    fn factor(&mut self, _: Matrix<'_>, _: &[f64]) -> Result<FactorReport, SolveError> {
        Err(self.fault)
    }
    fn solve(&mut self, _block: &mut [f64], _columns: usize) -> Result<(), SolveError> {
        Err(self.fault)
    }
    fn solve_transpose(&mut self, _: &mut [f64], _: usize) -> Result<(), SolveError> {
        Err(self.fault)
    }
}
