//! The condensed contact problem without its matrix.
//!
//! ```text
//!   dense:        C = G K_s^-1 F' A       a solution a row, C formed and eliminated
//!   matrix-free:  C v                     a solution a product, GMRES in the multipliers
//! ```
//!
//! The same problem, the same laws, the same solution to rounding: only the way
//! there differs. With points in the hundreds the dense way costs their cube. Here
//! every Newton step on the multipliers is solved by GMRES, whose operator is one
//! solution with the factored stiffness. Its convergence rests on the augmentation
//! c: with c the slope of the law at the solution, the operator is the identity.
//! Where a step takes more solutions than a factorisation costs, c is taken anew
//! from the laws at the present estimate. docs/theory.md eqs (8.26) to (8.29).
//! [derived]

use super::augmentation::Stiffness;
use super::compliance::{Compliance, MatrixFree};
use super::condensed::{LinearisedContact, ROUNDS, give_multiplier};
use super::context::LawContext;
use super::points::{Kind, LinearPoints, LinearRows};
use super::rows::Unknown;
use super::slopes::Slopes;
use super::system::System;
use slideline_linalg::SolveError;
use slideline_linalg::krylov::{Stop, gmres};

/// The most Newton steps.
const STEPS: usize = 60;
/// The most products of a Newton step.
const PRODUCTS: usize = 80;
/// Residual relative to the multipliers at which the problem counts as solved [1].
const SOLVED: f64 = 1e-11;
/// The same where nothing more is gained [1].
const ROUNDED: f64 = 1e-8;
/// Shortest fraction of a step that is tried.
const SHORTEST: f64 = 1e-3;
/// Products that are always allowed before the augmentation is taken anew.
const FEW: usize = 6;

impl LinearisedContact {
    /// Rounds in which points join, `first` those that touch already; later with the same rows and
    /// others at a base that has moved.
    pub(super) fn rounds_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        (work, first): (&mut MatrixFree, bool),
    ) -> Result<(), SolveError> {
        let (mut touching, mut again) = (first, !first && !self.rows.is_empty());
        for _ in 0..ROUNDS {
            let joined = self.activate_matrix_free(points, context, touching);
            if joined || again {
                if touching {
                    self.guess(points, context);
                }
                self.solved = self.iterate_matrix_free(points, context, stiffness, work)?;
            } else if !touching {
                break;
            }
            (touching, again) = (false, false);
        }
        Ok(())
    }

    /// Rows of points that touch already (`touching`), or that would by the
    /// present estimate; says whether any joined.
    fn activate_matrix_free(
        &mut self,
        points: &LinearPoints,
        context: &LawContext<'_>,
        touching: bool,
    ) -> bool {
        let mut joined = false;
        for (place, point) in points.with_rows().enumerate() {
            if self.in_rows[place] || !self.joins(&point, context, touching) {
                continue;
            }
            self.in_rows[place] = true;
            joined = true;
            if point.integrated {
                self.activate_integration_point((&point, place), context);
                continue;
            }
            self.push_row(&point, place, Kind::Normal);
            if point.sliding.is_some() && point.slides() {
                for direction in 0..points.directions() {
                    self.push_row(&point, place, Kind::Tangential(direction));
                }
            }
        }
        joined
    }

    fn activate_integration_point(
        &mut self,
        (point, place): (&LinearRows<'_>, usize),
        context: &LawContext<'_>,
    ) {
        for &equation in point.rows.unknowns {
            let row = match self.interface.get(&equation) {
                Some(&known) => known,
                None => {
                    let unit = context.units.get(equation).copied().unwrap_or(1.0);
                    self.push_interface(equation, unit)
                }
            };
            self.integration_points.push_row(row);
        }
        self.integration_points.finish(place);
    }

    /// The first guess of all rows: laws linearised about the estimates.
    fn guess(&mut self, points: &LinearPoints, context: &LawContext<'_>) {
        for (row, q) in self.rows.iter().zip(&mut self.unknown) {
            *q = match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    let (pressure, traction) = context.linearised(&points[point]);
                    match kind {
                        Kind::Normal => pressure,
                        Kind::Tangential(direction) => traction[direction],
                    }
                }
                Unknown::Interface { .. } => 0.0,
            };
        }
        for integration_point in self.integration_points.iter() {
            let point = points.at(integration_point.point);
            let (pressure, traction) = context.linearised(&point);
            for (a, &i) in integration_point.rows.iter().enumerate() {
                self.unknown[i] += point.area * point.force_at(a, pressure, traction);
            }
        }
    }

    /// Solves the condensed problem of the rows there are; says whether their
    /// laws are met.
    fn iterate_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
    ) -> Result<bool, SolveError> {
        work.make_room(self.rows.len(), self.integration_points.len());
        self.anchor.resize(self.rows.len(), 0.0);
        self.place_rows(points, stiffness, work);
        let mut q = std::mem::take(&mut self.unknown);
        let result = self.newton_matrix_free(points, context, stiffness, work, &mut q);
        self.unknown = q;
        result
    }

    /// Semismooth Newton in the multipliers `q`.
    fn newton_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        q: &mut [f64],
    ) -> Result<bool, SolveError> {
        self.displace(points, stiffness, work, q)?;
        let mut size = self.measure(points, context, work, q);
        let affordable = (factorisation_in_solves(stiffness) as usize).max(FEW);
        for _ in 0..STEPS {
            let largest = self.without_matrix().largest_multiplier(q, &work.values);
            if size <= SOLVED * SOLVED * largest || !size.is_finite() {
                return Ok(size.is_finite());
            }
            let tolerance = (0.1 * (size / largest).sqrt()).clamp(1e-6, 1e-2);
            let products = self.find_step(points, stiffness, work, tolerance)?;
            let from = (size, products > affordable);
            size = match self.advance(points, context, work, q, size) {
                Some(less) => less,
                None if from.1 => size,
                None => return Ok(size <= ROUNDED * ROUNDED * largest),
            };
            let dear = from.1 && size > SOLVED * SOLVED * largest;
            let changed = dear && self.augment_anew(points, context, stiffness, work, q)?;
            if changed {
                size = self.measure(points, context, work, q);
            } else if size >= from.0 {
                return Ok(size <= ROUNDED * ROUNDED * largest);
            }
        }
        Ok(false)
    }

    /// F = lambda - law at `q` and its values e, with the slopes of the laws;
    /// its weighted square.
    fn measure(
        &self,
        points: &LinearPoints,
        context: &LawContext<'_>,
        work: &mut MatrixFree,
        q: &[f64],
    ) -> f64 {
        let MatrixFree { values, residual, laws, .. } = work;
        self.without_matrix().residual((q, values, points), context, residual, laws)
    }

    /// The condensed problem, its compliance not formed.
    fn without_matrix(&self) -> System<'_> {
        let integration_points = &self.integration_points;
        System { rows: &self.rows, compliance: &[], integration_points }
    }

    /// Solves J step = F by GMRES and fills C step; the number of products.
    fn find_step(
        &self,
        points: &LinearPoints,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        tolerance: f64,
    ) -> Result<usize, SolveError> {
        let MatrixFree { full, residual, step, yielded, scaled, laws, solves, .. } = work;
        let [v, w] = &mut work.trial;
        let rows = &self.rows;
        let on_interface = work.on_interface;
        let mut c = Compliance { rows, points, full, on_interface, solves, fault: None };
        let slopes = Slopes { rows, integration_points: &self.integration_points, points, laws };
        // in the norm of the energy: sqrt(weight) v
        for ((scaled, f), row) in scaled.iter_mut().zip(&*residual).zip(rows) {
            *scaled = f * row.weight.sqrt();
        }
        step.fill(0.0);
        let progress = gmres(
            |x, into| {
                for ((v, x), row) in v.iter_mut().zip(x).zip(rows) {
                    *v = x / row.weight.sqrt();
                }
                c.product(stiffness, v, w);
                slopes.product(v, w, into);
                into.iter_mut().zip(rows).for_each(|(y, row)| *y *= row.weight.sqrt());
            },
            |x, into| slopes.precondition(x, into),
            scaled,
            step,
            Stop { tolerance, iterations: PRODUCTS },
            &mut work.krylov,
        );
        step.iter_mut().zip(rows).for_each(|(step, row)| *step /= row.weight.sqrt());
        c.product(stiffness, step, yielded);
        c.fault.map_or(Ok(progress.iterations), Err)
    }

    /// Takes as much of the step as lessens the residual; its new size, or
    /// `None` where nothing does.
    fn advance(
        &mut self,
        points: &LinearPoints,
        context: &LawContext<'_>,
        work: &mut MatrixFree,
        q: &mut [f64],
        size: f64,
    ) -> Option<f64> {
        let [from, before] = &mut work.trial;
        from.copy_from_slice(q);
        before.copy_from_slice(&work.values);
        let mut length = 1.0;
        while length >= SHORTEST {
            for (i, q) in q.iter_mut().enumerate() {
                *q = work.trial[0][i] - length * work.step[i];
                work.values[i] = work.trial[1][i] + length * work.yielded[i];
            }
            let new = self.measure(points, context, work, q);
            if new < size {
                // the displacements follow: `full` holds K_s^-1 F' A step
                self.moved.iter_mut().zip(&work.full).for_each(|(du, y)| *du += length * y);
                return Some(new);
            }
            length *= 0.5;
        }
        q.copy_from_slice(&work.trial[0]);
        let (values, before) = (&mut work.values, &work.trial[1]);
        values.copy_from_slice(before);
        self.measure(points, context, work, q);
        None
    }

    /// Pressures and tractions of the points from the solution.
    pub(super) fn back_substitute_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        work: &MatrixFree,
    ) {
        self.release_others(points, context);
        for (i, row) in self.rows.iter().enumerate() {
            let Some((place, kind)) = row.point() else { continue };
            let multiplier = self.unknown[i] + row.augmentation * (work.values[i] - row.start);
            give_multiplier(
                &mut points[place],
                context,
                kind,
                [multiplier, work.values[i], row.kappa],
            );
        }
        self.room.values.clone_from(&work.values);
        self.give_integration_points(points, context);
    }
}

/// How many solutions a factorisation costs.
fn factorisation_in_solves(stiffness: &Stiffness<'_>) -> f64 {
    let description = stiffness.solver.description();
    description.predicted_operations / (2.0 * description.predicted_entries.max(1.0))
}
