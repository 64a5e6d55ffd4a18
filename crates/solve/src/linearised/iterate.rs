//! The semismooth Newton method of the condensed contact problem.

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::pivoting::pivoting;
use super::points::{Kind, LinearPoints};
use super::rows::{IntegrationPoints, Row};
use super::system::{System, eliminate_in_units};

/// The most iterations of the condensed contact problem.
const ITERATIONS: usize = 40;
/// How often it is started again from settled pressures.
const RESTARTS: usize = 3;
/// Residual of the condensed contact problem, relative to its multipliers, at which a step
/// that gains nothing means rounding, not a wrong set.
const ROUNDED: f64 = 1e-9;
/// Least part of the stiffness with its augmentation that a row is taken to feel
/// without it: what rounding leaves of the difference [1].
const LEAST_OWN: f64 = 1e-6;
/// Shortest fraction of a step that is tried.
const SHORTEST: f64 = 1e-3;

impl LinearisedContact {
    /// Solves the condensed contact problem: by Newton with the stiffness that rows feel, with
    /// their augmentations and without; where Newton is lost between the limits of
    /// friction from the least energy for fixed limits, or among the
    /// active sets of a hard law from the set that a pivoting method finds.
    /// Says whether the laws of all rows are met.
    pub(super) fn iterate(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        if self.newton(points, context) {
            return true;
        }
        self.begun.clone_from(&self.unknown);
        for row in &mut self.rows {
            (row.kappa, row.own) = (row.own.max(LEAST_OWN * row.kappa), row.kappa);
        }
        if self.newton(points, context) {
            return true;
        }
        self.rows.iter_mut().for_each(|row| row.kappa = row.own);
        self.unknown.clone_from(&self.begun);
        self.minimise(points, context);
        if self.newton(points, context) {
            return true;
        }
        for _ in 0..RESTARTS {
            if !self.pivot_pressures(points, context) {
                return false;
            }
            if self.newton(points, context) {
                return true;
            }
        }
        false
    }

    /// Semismooth Newton with backtracking; says whether it converged.
    fn newton(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        let m = self.rows.len();
        for vector in [&mut self.residual, &mut self.step, &mut self.trial] {
            vector.clear();
            vector.resize(m, 0.0);
        }
        self.jacobian.clear();
        self.jacobian.resize(m * m, 0.0);
        self.stiffness.clear();
        self.stiffness.resize(if self.integration_points.is_empty() { 0 } else { m * m }, 0.0);
        self.values.resize(m, 0.0);
        let (stiffness, values) = (&mut self.stiffness, &mut self.values);
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        let (residual, jacobian) = (&mut self.residual, &mut self.jacobian);
        let unknown = &mut self.unknown;
        let mut size =
            system.residual((unknown, points), context, residual, (jacobian, stiffness, values));
        for _ in 0..ITERATIONS {
            if size == 0.0 || !size.is_finite() {
                return size == 0.0;
            }
            let rounded = size <= ROUNDED * ROUNDED * system.largest_multiplier(unknown);
            self.step.copy_from_slice(residual);
            eliminate_in_units(&self.rows, jacobian, &mut self.factors, &mut self.step);
            let mut length = 1.0;
            loop {
                for ((trial, q), step) in self.trial.iter_mut().zip(&*unknown).zip(&self.step) {
                    *trial = q - length * step;
                }
                let new = system.residual(
                    (&self.trial, points),
                    context,
                    residual,
                    (jacobian, stiffness, values),
                );
                if new < size {
                    unknown.copy_from_slice(&self.trial);
                    size = new;
                    break;
                }
                length *= 0.5;
                // Nothing is gained from steps below rounding.
                if rounded || length < SHORTEST {
                    return rounded;
                }
            }
        }
        false
    }

    /// Finds the pressures of hard points for the present tractions by a
    /// pivoting method that ends for any compliance: Lawson and Hanson's
    /// non-negative least squares, written for h = b - C p <= 0, p >= 0,
    /// p h = 0. Soft points keep their pressures. False: nothing to pivoting.
    fn pivot_pressures(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        let hard = |row: &Row| {
            let Some((point, kind)) = row.point() else { return false };
            let law = &context.laws[points[point].law].normal;
            kind == Kind::Normal && law.pressure(0.0).is_none() && !law.is_bonded()
        };
        let candidates: Vec<usize> =
            (0..self.rows.len()).filter(|&i| hard(&self.rows[i])).collect();
        if candidates.is_empty() {
            return false;
        }
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: IntegrationPoints::NONE,
        };
        pivoting(&system, &candidates, &mut self.unknown);
        true
    }
}
