//! Solutions on the interface, and corrections on all equations, with factors that may be near.

use super::{Side, Solver};
use crate::error::SolveError;
use crate::followed::{NEAR, pays};
use crate::near::Use;
use crate::pattern::Pattern;
use crate::system::BackEnd;

impl Solver {
    /// Tells what solutions of the matrices that follow are wanted for.
    pub fn set_use(&mut self, wanted: Use) {
        self.near.wanted = wanted;
    }

    /// Takes a matrix near the one factored last without factoring it: solutions come from
    /// conjugate gradients with the factors at hand, to a residual of 1e-8 of the right-hand side,
    /// and where these fail from a factorisation after all. False where the matrix is to be
    /// factored: where that is as cheap, or the factors are not those of a definite matrix.
    ///
    /// Errors: those of [`Solver::refactor`] but for singular matrices.
    pub fn follow(&mut self, pattern: &Pattern, values: &[f64]) -> Result<bool, SolveError> {
        let definite = self.report.is_some_and(|report| report.is_definite());
        if !(definite && pays(&self.system.description())) {
            return Ok(false);
        }
        self.take_matrix(pattern, values)?;
        self.near.stop = Some(NEAR);
        Ok(true)
    }

    /// Whether solutions on the interface that the analysis was told of read less than all factors.
    pub fn answers_on_interface(&self) -> bool {
        let is_sparse = self.system.description().back_end == BackEnd::Sparse;
        is_sparse && !self.near.is_on_interface.is_empty()
    }

    /// Whether all these equations are on the interface that the analysis was told of.
    pub fn is_on_interface(&self, equations: &[usize]) -> bool {
        let is_on = &self.near.is_on_interface;
        equations.iter().all(|&equation| is_on.get(equation) == Some(&true))
    }

    /// Solves in place with the factors at hand, near as they are and without a check. With
    /// `on_interface` the right-hand side is zero but there, and the solution is left there alone.
    ///
    /// Errors: [`SolveError::Size`], [`SolveError::NotFactored`], those of the system.
    pub fn respond_on_interface(
        &mut self,
        rhs: &mut [f64],
        on_interface: bool,
    ) -> Result<(), SolveError> {
        self.check(rhs)?;
        self.enter(rhs);
        let raised = self.raised.first().copied().unwrap_or(1.0);
        let solved = match on_interface {
            true => self.system.solve_on_interface(rhs),
            false => self.system.solve(rhs, 1),
        };
        self.leave(rhs, raised);
        solved
    }

    /// What the factors at hand make of the residual b - A x, if the backward error of x is more than
    /// `enough`; x may be zero. Returns that error.
    ///
    /// Errors: [`SolveError::Size`], [`SolveError::NotFactored`], those of the system.
    pub fn correction(
        &mut self,
        (b, x): (&[f64], &[f64]),
        enough: f64,
        into: &mut [f64],
    ) -> Result<f64, SolveError> {
        self.check(b)?;
        into.copy_from_slice(b);
        self.enter(into);
        let raised = self.raised.first().copied().unwrap_or(1.0);
        self.rhs.copy_from_slice(into);
        into.iter_mut().zip(x).for_each(|(into, x)| *into = x * raised);
        into.iter_mut().zip(&self.unit).for_each(|(into, unit)| *into /= unit);
        let error = self.backward_error(into, Side::Plain);
        if error <= enough {
            return Ok(error);
        }
        into.copy_from_slice(&self.correction);
        self.system.solve(into, 1)?;
        self.leave(into, raised);
        Ok(error)
    }

    /// Whether the factors at hand are those of the matrix to rounding.
    pub fn is_exact(&self) -> bool {
        self.near.stop.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::choice::BuiltIn;
    use crate::pattern::Matrix;
    use crate::system::{Interface, Kind};

    /// Blocks of a grid in space, whose middle layer is an interface with an unsymmetric part of
    /// `turned` times the couplings.
    fn turned_block(turned: f64) -> (Pattern, Vec<f64>, Vec<usize>) {
        let side = 14;
        let n = side * side * side;
        let ways = [1, side, side * side, side + 1, side * side + side];
        let pattern =
            Pattern::from_pairs(n, (0..n).flat_map(move |i| ways.map(|way| (i, i + way))));
        let layer = 7 * side * side..8 * side * side;
        let mut values = Vec::with_capacity(pattern.entries());
        for i in 0..n {
            values.extend(pattern.row(i).iter().map(|&j| match i == j {
                true => 10.5,
                false if layer.contains(&i) && layer.contains(&j) && i < j => -1.0 + turned,
                false if layer.contains(&i) && layer.contains(&j) => -1.0 - turned,
                false => -1.0,
            }));
        }
        (pattern, values, layer.collect())
    }

    /// Requirement: a nearly symmetric matrix is factored as a symmetric one and solved all the same;
    /// one that is not so near is factored as it is, in the end. Corrections of solutions on the
    /// interface lessen the error by decades where it is near. Tolerance: 1e-10 of the right side.
    #[test]
    fn what_is_nearly_symmetric_is_solved() {
        for (turned, stays) in [(0.01, true), (60.0, false)] {
            let (pattern, values, layer) = turned_block(turned);
            let interface = Interface { equations: &layer, nearly_symmetric: true };
            let of = (&pattern, Kind::Unsymmetric);
            let mut solver = Solver::analyse_for(of, &BuiltIn::default(), &interface);
            assert_eq!(solver.description().kind, Kind::Symmetric);
            assert!(solver.answers_on_interface() && solver.is_on_interface(&layer));
            assert!(!solver.is_on_interface(&[0]));
            solver.set_use(Use::Interface);
            solver.refactor(&pattern, &values).unwrap();
            assert!(!solver.is_exact());
            let b: Vec<f64> = (0..pattern.size()).map(|i| ((i * 31) % 17) as f64 - 8.0).collect();
            let mut x = b.clone();
            solver.respond_on_interface(&mut x, false).unwrap();
            let mut step = vec![0.0; b.len()];
            let mut errors = [0.0; 3];
            for error in &mut errors {
                *error = solver.correction((&b, &x), 0.0, &mut step).unwrap();
                x.iter_mut().zip(&step).for_each(|(x, step)| *x += step);
            }
            assert_eq!(errors[2] < 1e-2 * errors[1] && errors[1] < 1e-2 * errors[0], stays);
            let mut x = b.clone();
            solver.solve(&mut x).unwrap();
            assert_eq!(!solver.is_exact(), stays, "{turned}");
            let mut product = vec![0.0; b.len()];
            Matrix::new(&pattern, &values).multiply(&x, &mut product);
            let worst = product.iter().zip(&b).map(|(p, b)| (p - b).abs()).fold(0.0, f64::max);
            assert!(worst < 8e-10, "{turned}: {worst:e}");
            // exact factors answer on the interface as on all equations
            solver.set_use(Use::Many);
            solver.refactor(&pattern, &values).unwrap();
            assert!(solver.is_exact());
            let mut all = vec![0.0; b.len()];
            layer.iter().for_each(|&i| all[i] = b[i]);
            let mut few = all.clone();
            solver.solve(&mut all).unwrap();
            solver.respond_on_interface(&mut few, true).unwrap();
            assert!(layer.iter().all(|&i| (all[i] - few[i]).abs() < 1e-10 * all[i].abs().max(0.1)));
        }
    }
}
