//! The semismooth Newton method of the condensed contact problem.

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::pivoting::pivoting;
use super::points::{Kind, LinearPoints};
use super::rows::{IntegrationPoints, Row};
use super::step_room::StepRoom;
use super::system::{System, eliminate_in_units, go};

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
    /// their augmentations, without, and with next to none, where signs of multipliers alone decide: of a
    /// body that nothing but open contact holds no row may stay open; where Newton is lost between the limits of
    /// friction from the least energy for fixed limits, or among the
    /// active sets of a hard law from the set that a pivoting method finds.
    /// Says whether the laws of all rows are met.
    pub(super) fn iterate(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        if self.newton(points, context) {
            return true;
        }
        self.begun.clone_from(&self.unknown);
        self.felt.clear();
        self.felt.extend(self.rows.iter().map(|row| row.kappa));
        let own = |row: &Row| row.own.max(LEAST_OWN * row.kappa);
        if self.newton_by(own, points, context) {
            return true;
        }
        self.unknown.clone_from(&self.begun);
        let is_least = |row: &Row| row.own <= LEAST_OWN * row.kappa;
        if !self.rows.iter().all(is_least)
            && self.newton_by(|row| LEAST_OWN * row.kappa, points, context)
        {
            return true;
        }
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

    /// Newton by other stiffnesses than those that rows feel; says whether the laws are met by those that they feel.
    fn newton_by(
        &mut self,
        stiffness: impl Fn(&Row) -> f64,
        points: &LinearPoints,
        context: &LawContext<'_>,
    ) -> bool {
        self.rows.iter_mut().for_each(|row| row.kappa = stiffness(row));
        let is_found = self.newton(points, context);
        self.rows.iter_mut().zip(&self.felt).for_each(|(row, &felt)| row.kappa = felt);
        // next to no stiffness makes an overclosure that nothing presses out look like rounding
        is_found && self.meets_laws(points, context)
    }

    /// Semismooth Newton with backtracking; says whether it converged.
    fn newton(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        self.room.resize(self.rows.len(), self.integration_points.len());
        let unknown = &mut self.unknown;
        let StepRoom { residual, step, yielded, values, laws, jacobian, stiffness, factors, trial } =
            &mut self.room;
        let [trial, trial_values] = trial;
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        system.values(unknown, values);
        let mut size = system.residual((unknown, values, points), context, residual, laws);
        for _ in 0..ITERATIONS {
            if size == 0.0 || !size.is_finite() {
                return size == 0.0;
            }
            let largest = system.largest_multiplier(unknown, values);
            let rounded = size <= ROUNDED * ROUNDED * largest;
            system.jacobian(points, laws, jacobian, stiffness);
            step.copy_from_slice(residual);
            eliminate_in_units(&self.rows, jacobian, factors, step);
            system.product(step, yielded);
            let mut length = 1.0;
            loop {
                go((unknown, -length, step), trial);
                go((values, length, yielded), trial_values);
                let at = (&trial[..], &trial_values[..], points);
                let new = system.residual(at, context, residual, laws);
                if new < size {
                    unknown.copy_from_slice(trial);
                    values.copy_from_slice(trial_values);
                    size = new;
                    break;
                }
                length *= 0.5;
                // Nothing is gained from steps below rounding.
                if rounded || length < SHORTEST {
                    return rounded && self.meets_laws(points, context);
                }
            }
        }
        false
    }

    /// Whether the laws are met to rounding.
    fn meets_laws(&mut self, points: &LinearPoints, context: &LawContext<'_>) -> bool {
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        system.values(&self.unknown, &mut self.room.values);
        let at = (&self.unknown[..], &self.room.values[..], points);
        let size = system.residual(at, context, &mut self.room.residual, &mut self.room.laws);
        size <= ROUNDED * ROUNDED * system.largest_multiplier(&self.unknown, &self.room.values)
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
