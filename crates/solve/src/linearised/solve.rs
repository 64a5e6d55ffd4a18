//! The contact problem of an iteration solved: points join, their rows are formed and solved, their
//! multipliers move everything.

use super::augmentation::Stiffness;
use super::condensed::{LinearisedContact, ROUNDS, give_multiplier};
use super::context::LawContext;
use super::points::{Kind, LinearPoints, LinearRows};
use super::rows::{IntegrationPoints, Unknown, share_among_directions};
use super::system::System;
use slideline_linalg::{SolveError, Solver};
use slideline_mech::contact::enforcement::Enforcement;

impl LinearisedContact {
    /// Solves the linearised contact problem. `correction` holds -r on entry
    /// and du on return; `points` get their pressures and tractions. The stiffness
    /// is factored with the augmentation of the points.
    ///
    /// Errors: the solver's.
    pub fn solve(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        (enforcement, stiffness): (Enforcement, &mut Stiffness<'_>),
        correction: &mut [f64],
    ) -> Result<(), SolveError> {
        self.rows.clear();
        self.unknown.clear();
        self.response.clear();
        self.in_rows.clear();
        self.in_rows.resize(points.len(), false);
        self.integration_points.clear();
        self.interface.clear();
        // of the solution before nothing is left: neither its end nor its matrix
        self.compliance.clear();
        self.solved = true;
        if enforcement.inserts_laws() {
            return self.solve_inserted(points, stiffness, correction);
        }
        self.rub_held(points, context, correction);
        if enforcement == Enforcement::MatrixFree {
            return self.solve_matrix_free(points, context, stiffness, correction);
        }
        let solver = &mut *stiffness.solver;
        solver.solve(correction)?;
        // First those that touch already: without their pressures the
        // structure would spring back and seem to touch everywhere.
        let mut touching = true;
        for _ in 0..ROUNDS {
            let joined = self.activate(points, context, touching, solver, correction)?;
            if joined {
                if touching {
                    self.press(points);
                }
                self.couple(points, correction);
                self.solved = self.iterate(points, context);
            } else if !touching {
                break;
            }
            touching = false;
        }
        self.back_substitute(points, context, correction);
        Ok(())
    }

    /// Takes the tractions of slips that are prescribed from what `correction` answers: there is no row to
    /// bring them in.
    fn rub_held(&self, points: &LinearPoints, context: &LawContext<'_>, correction: &mut [f64]) {
        for point in points.with_rows() {
            let Some(traction) = context.prescribed_sliding(&point) else { continue };
            for direction in 0..points.directions() {
                point.push(Kind::Tangential(direction), -traction[direction], correction);
            }
        }
    }

    /// Lets points join that touch already (`touching`), or that would touch
    /// by the present estimate; says whether any did. The responses to all of them are found at once.
    fn activate(
        &mut self,
        points: &LinearPoints,
        context: &LawContext<'_>,
        touching: bool,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<bool, SolveError> {
        if !touching {
            self.move_by_rows(base);
        }
        let mut joined = false;
        let before = self.rows.len();
        for (place, point) in points.with_rows().enumerate() {
            if self.in_rows[place] || !self.joins(&point, context, touching) {
                continue;
            }
            self.in_rows[place] = true;
            joined = true;
            if point.integrated {
                self.add_integration_point((&point, place), context, base);
                continue;
            }
            self.add_row(&point, place, Kind::Normal, base);
            if point.sliding.is_some() && point.slides() {
                for direction in 0..points.directions() {
                    self.add_row(&point, place, Kind::Tangential(direction), base);
                }
            }
        }
        let n = base.len();
        solver.solve_many(&mut self.response[before * n..], self.rows.len() - before)?;
        Ok(joined)
    }

    /// du under the multipliers of the rows that are solved already.
    fn move_by_rows(&mut self, base: &[f64]) {
        self.moved.clear();
        self.moved.extend_from_slice(base);
        let n = base.len();
        for (row, q) in self.unknown.iter().enumerate() {
            for (du, w) in self.moved.iter_mut().zip(&self.response[row * n..][..n]) {
                *du -= q * w;
            }
        }
    }

    /// A row of a point, its column of loads where its response is to stand.
    fn add_row(&mut self, point: &LinearRows<'_>, place: usize, kind: Kind, base: &[f64]) {
        let begin = self.response.len();
        self.response.resize(begin + base.len(), 0.0);
        point.push(kind, 1.0, &mut self.response[begin..]);
        self.push_row(point, place, kind);
        if let Some(row) = self.rows.last_mut() {
            row.free = row.start + point.dot(kind, base);
        }
    }

    /// Fills C and the stiffness that each row feels.
    fn couple(&mut self, points: &LinearPoints, base: &[f64]) {
        let (m, n) = (self.rows.len(), base.len());
        self.compliance.clear();
        self.compliance.resize(m * m, 0.0);
        for i in 0..m {
            for j in 0..m {
                let response = &self.response[j * n..][..n];
                self.compliance[i * m + j] = match self.rows[i].unknown {
                    Unknown::Multiplier { point, kind, .. } => points.at(point).dot(kind, response),
                    Unknown::Interface { equation } => response[equation],
                };
            }
        }
        for i in 0..m {
            let own = self.compliance[i * m + i];
            let row = &mut self.rows[i];
            row.kappa = if own > 0.0 { 1.0 / own } else { f64::INFINITY };
            row.own = row.kappa - row.augmentation;
            row.felt = if own > 0.0 { 1.0 / own } else { 0.0 };
            let area = row.point().map_or(1.0, |(point, _)| points[point].area);
            row.weight = area * own.abs();
        }
        share_among_directions(&mut self.rows);
    }

    /// du from the multipliers, and the multipliers to their points.
    fn back_substitute(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        correction: &mut [f64],
    ) {
        let n = correction.len();
        self.release_others(points, context);
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: IntegrationPoints::NONE,
        };
        self.room.values.clear();
        for (i, row) in self.rows.iter().enumerate() {
            let (multiplier, value) = system.multiplier_and_value(i, &self.unknown);
            self.room.values.push(value);
            if let Some((place, kind)) = row.point() {
                let found = [multiplier, value, row.kappa];
                give_multiplier(&mut points[place], context, kind, found);
            }
        }
        self.give_integration_points(points, context);
        for (i, &q) in self.unknown.iter().take(self.rows.len()).enumerate() {
            for (du, w) in correction.iter_mut().zip(&self.response[i * n..][..n]) {
                *du -= q * w;
            }
        }
    }
}
