//! The semismooth Newton method of the condensed contact problem.

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::convex::HOLDING;
use super::pivoting::pivoting;
use super::points::{Kind, LinearPoints};
use super::rows::{IntegrationPoints, Row};
use super::system::{Derivatives, System, eliminate_in_units};

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
    /// their augmentations and without; where Newton is lost along motions that only
    /// contact holds with rows held in each step; between the limits of
    /// friction from the least energy for fixed limits, or among the
    /// active sets of a hard law from the set that a pivoting method finds.
    /// Says whether the laws of all rows are met.
    pub(super) fn iterate(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        if self.newton(points, context, 0.0) {
            return true;
        }
        self.begun.clone_from(&self.unknown);
        for row in &mut self.rows {
            (row.kappa, row.own) = (row.own.max(LEAST_OWN * row.kappa), row.kappa);
        }
        if self.newton(points, context, 0.0) {
            return true;
        }
        self.rows.iter_mut().for_each(|row| row.kappa = row.own);
        self.unknown.clone_from(&self.begun);
        if self.newton(points, context, HOLDING) {
            return true;
        }
        self.unknown.clone_from(&self.begun);
        self.minimise(points, context);
        self.begun.clone_from(&self.unknown);
        if self.newton(points, context, 0.0) {
            return true;
        }
        std::mem::swap(&mut self.unknown, &mut self.begun);
        if self.newton(points, context, HOLDING) {
            return true;
        }
        std::mem::swap(&mut self.unknown, &mut self.begun);
        self.restart(points, context)
    }

    /// Newton from settled pressures, some times over; says whether it converged.
    fn restart(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        for restart in 0..RESTARTS {
            if !self.pivot_pressures(points, context) {
                return false;
            }
            if restart > 0 && self.unknown == self.begun {
                return false; // from there Newton was lost before
            }
            self.begun.clone_from(&self.unknown);
            if self.newton(points, context, 0.0) {
                return true;
            }
        }
        false
    }

    /// Semismooth Newton with backtracking, rows held by so much in a step,
    /// [`Derivatives::holding`]; says whether it converged.
    fn newton(&mut self, points: &LinearPoints, context: &LawContext<'_>, holding: f64) -> bool {
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
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        let Self { unknown, residual, jacobian, stiffness, values, step, trial, .. } = self;
        for _ in 0..ITERATIONS {
            let wanted = Derivatives { jacobian, stiffness, holding };
            let at = (&unknown[..], points);
            let size = system.residual(at, context, (residual, values), Some(wanted));
            if size == 0.0 || !size.is_finite() {
                return size == 0.0;
            }
            let rounded = size <= ROUNDED * ROUNDED * system.largest_multiplier(unknown);
            step.copy_from_slice(residual);
            eliminate_in_units(&self.rows, jacobian, &mut self.factors, step);
            let mut length = 1.0;
            loop {
                for ((trial, q), step) in trial.iter_mut().zip(&*unknown).zip(&*step) {
                    *trial = q - length * step;
                }
                let at = (&trial[..], points);
                let new = system.residual(at, context, (residual, values), None);
                if new < size {
                    unknown.copy_from_slice(trial);
                    // held, it comes nearer by the same part with every step
                    if holding > 0.0 && rounded && new > 0.25 * size {
                        return true;
                    }
                    break;
                }
                length *= 0.5;
                // Nothing is gained from steps below rounding.
                if rounded {
                    return true;
                }
                if length < SHORTEST {
                    return size <= system.rounding(unknown, (context.rounding, ROUNDED));
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
