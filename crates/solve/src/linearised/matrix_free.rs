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

use super::augmentation::{Stiffness, within};
use super::laws::PointAnswer;
use super::points::{Augmentation, Kind};
use super::slopes::Slopes;
use super::system::{Row, RowSlopes, Unknown, share_among_directions};
use super::{LawContext, LinearPoints, LinearRows, LinearisedContact};
use slideline_linalg::SolveError;
use slideline_linalg::krylov::{self, Stop, gmres};

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
/// Change of an augmentation that is worth a factorisation [1].
const WORTHWHILE: f64 = 1.5;
/// Products that are always allowed before the augmentation is taken anew.
const FEW: usize = 6;

/// Scratch of the matrix-free way, kept from iteration to iteration.
#[derive(Clone, Debug, Default)]
pub(super) struct MatrixFree {
    /// Right-hand side of the iteration, -r.
    right_side: Vec<f64>,
    /// K_s^-1 of it.
    base: Vec<f64>,
    /// A right-hand side and its solution, an entry an equation.
    full: Vec<f64>,
    /// e = free - C q, a row each.
    values: Vec<f64>,
    residual: Vec<f64>,
    step: Vec<f64>,
    /// C times the step.
    yielded: Vec<f64>,
    trial: [Vec<f64>; 2],
    scaled: Vec<f64>,
    slopes: Vec<RowSlopes>,
    answers: Vec<PointAnswer>,
    krylov: krylov::Workspace,
    /// Solutions with the factored stiffness in this iteration.
    pub solves: usize,
}

/// Products with C of a set of rows.
struct Compliance<'a> {
    rows: &'a [Row],
    points: &'a LinearPoints,
    full: &'a mut Vec<f64>,
    solves: &'a mut usize,
    fault: Option<SolveError>,
}

impl Compliance<'_> {
    /// Forces of the multipliers `q` on the equations: F' A q.
    fn push(&mut self, q: &[f64]) {
        self.full.fill(0.0);
        for (row, &q) in self.rows.iter().zip(q).filter(|(_, q)| **q != 0.0) {
            match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    self.points.at(point).push(kind, q, self.full);
                }
                Unknown::Interface { equation } => self.full[equation] += q,
            }
        }
    }

    /// C q, into a value a row; the displacements are left in `full`.
    fn product(&mut self, stiffness: &mut Stiffness<'_>, q: &[f64], into: &mut [f64]) {
        self.push(q);
        *self.solves += 1;
        if let Err(fault) = stiffness.solver.respond(self.full) {
            self.fault = Some(fault);
        }
        for (value, row) in into.iter_mut().zip(self.rows) {
            *value = match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    self.points.at(point).dot(kind, self.full)
                }
                Unknown::Interface { equation } => self.full[equation],
            };
        }
    }
}

impl LinearisedContact {
    /// As [`LinearisedContact::solve`], without forming C.
    pub(super) fn solve_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        correction: &mut [f64],
    ) -> Result<(), SolveError> {
        let mut work = std::mem::take(&mut self.matrix_free);
        work.solves = 0;
        work.right_side.clear();
        work.right_side.extend_from_slice(correction);
        work.full.resize(correction.len(), 0.0);
        let result = self.rounds_matrix_free(points, context, stiffness, &mut work);
        if result.is_ok() {
            correction.copy_from_slice(&self.moved);
            self.back_substitute_matrix_free(points, context, &work);
        }
        self.matrix_free = work;
        result
    }

    fn rounds_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
    ) -> Result<(), SolveError> {
        work.find_base(stiffness)?;
        self.moved.clone_from(&work.base);
        let mut touching = true;
        for _ in 0..super::ROUNDS {
            let joined = self.activate_matrix_free(points, context, touching);
            if joined {
                if touching {
                    self.guess(points, context);
                }
                self.solved = self.iterate_matrix_free(points, context, stiffness, work)?;
            } else if !touching {
                break;
            }
            touching = false;
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
        self.place_rows(points, stiffness, work);
        let mut q = std::mem::take(&mut self.unknown);
        let result = self.newton_matrix_free(points, context, stiffness, work, &mut q);
        self.unknown = q;
        result
    }

    /// What does not depend on the estimate: starts, local stiffnesses, weights.
    fn place_rows(&mut self, points: &LinearPoints, stiffness: &Stiffness<'_>, work: &MatrixFree) {
        for row in &mut self.rows {
            match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    let point = points.at(point);
                    let (local, lent) = (stiffness.local(&point), point.augmentation());
                    let (own, augmentation) = match kind {
                        Kind::Tangential(_) => (local.tangential, lent.tangential),
                        Kind::Normal => (local.normal, lent.normal),
                    };
                    row.free = row.start + point.dot(kind, &work.base);
                    (row.own, row.augmentation, row.kappa, row.felt) =
                        (own, augmentation, own, own);
                    let felt = own + augmentation;
                    row.weight = if felt > 0.0 { point.area / felt } else { point.area };
                }
                Unknown::Interface { equation } => {
                    let at = stiffness.pattern.position(equation, equation);
                    let own = at.map_or(0.0, |at| stiffness.augmented[at].abs());
                    row.free = work.base[equation];
                    (row.own, row.kappa, row.felt) = (own, own, own);
                    row.weight = if own > 0.0 { 1.0 / own } else { 1.0 };
                }
            }
        }
        share_among_directions(&mut self.rows);
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
            let largest = self.largest(work, q);
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

    /// e = free - C q.
    fn displace(
        &mut self,
        points: &LinearPoints,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        q: &[f64],
    ) -> Result<(), SolveError> {
        let MatrixFree { full, yielded, values, solves, base, .. } = work;
        let mut c = Compliance { rows: &self.rows, points, full, solves, fault: None };
        c.product(stiffness, q, yielded);
        let fault = c.fault;
        for ((value, row), y) in values.iter_mut().zip(&self.rows).zip(yielded) {
            *value = row.free - *y;
        }
        self.moved.clear();
        self.moved.extend(base.iter().zip(&*full).map(|(base, yielded)| base - yielded));
        fault.map_or(Ok(()), Err)
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
        let MatrixFree { values, residual, slopes, answers, .. } = work;
        residual.copy_from_slice(q);
        for (integration_point, answer) in self.integration_points.iter().zip(answers.iter_mut()) {
            let point = points.at(integration_point.point);
            *answer = context.integration_point(integration_point, &point, values);
            if !answer.is_idle() {
                for (a, &i) in integration_point.rows.iter().enumerate() {
                    residual[i] -= point.area * point.force_at(a, answer.normal, answer.tangential);
                }
            }
        }
        let rows = &self.rows;
        let asked =
            |i: usize| (q[i] + rows[i].augmentation * (values[i] - rows[i].start), values[i]);
        for i in 0..rows.len() {
            context.ask(rows, i, points, asked, |i, multiplier, answer| {
                residual[i] = multiplier - answer.value;
                slopes[i] = answer;
            });
        }
        residual.iter().zip(rows).map(|(f, row)| f * f * row.weight).sum()
    }

    /// Largest multiplier in the squared norm of the residual.
    fn largest(&self, work: &MatrixFree, q: &[f64]) -> f64 {
        let of = |(i, row): (usize, &Row)| {
            let multiplier = q[i] + row.augmentation * (work.values[i] - row.start);
            multiplier.abs().max(q[i].abs()).powi(2) * row.weight
        };
        self.rows.iter().enumerate().map(of).fold(f64::MIN_POSITIVE, f64::max)
    }

    /// Solves J step = F by GMRES and fills C step; the number of products.
    fn find_step(
        &self,
        points: &LinearPoints,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        tolerance: f64,
    ) -> Result<usize, SolveError> {
        let MatrixFree { full, residual, step, yielded, scaled, slopes, answers, solves, .. } =
            work;
        let [v, w] = &mut work.trial;
        let rows = &self.rows;
        let mut c = Compliance { rows, points, full, solves, fault: None };
        let slopes =
            Slopes { rows, integration_points: &self.integration_points, points, slopes, answers };
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

    /// Takes the augmentation from the laws at the present estimate and factors
    /// anew; the multipliers and displacements stay. False: nothing to gain.
    fn augment_anew(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        q: &mut [f64],
    ) -> Result<bool, SolveError> {
        let wanted = self.wanted(points, stiffness, work);
        let changes = |now: f64, then: f64| {
            let (low, high) = (now.min(then), now.max(then));
            high > 0.0 && high > WORTHWHILE * low
        };
        let any = wanted.iter().any(|&(place, new)| {
            let old = points[place].augmentation();
            changes(old.normal, new.normal) || changes(old.tangential, new.tangential)
        });
        if !any {
            return Ok(false);
        }
        let multipliers: Vec<f64> = (0..q.len())
            .map(|i| q[i] + self.rows[i].augmentation * (work.values[i] - self.rows[i].start))
            .collect();
        wanted.into_iter().for_each(|(place, new)| points[place].set_augmentation(new));
        stiffness.factor(points)?;
        work.find_base(stiffness)?;
        self.place_rows(points, stiffness, work);
        for (i, row) in self.rows.iter().enumerate() {
            if row.point().is_some() {
                q[i] = multipliers[i] - row.augmentation * (work.values[i] - row.start);
            }
        }
        for integration_point in self.integration_points.iter() {
            integration_point.rows.iter().for_each(|&i| q[i] = 0.0);
        }
        for integration_point in self.integration_points.iter() {
            let point = points.at(integration_point.point);
            let answer = context.integration_point(integration_point, &point, &work.values);
            for (a, &i) in integration_point.rows.iter().enumerate() {
                q[i] += point.area * point.force_at(a, answer.normal, answer.tangential);
            }
        }
        self.displace(points, stiffness, work, q)?;
        Ok(true)
    }

    /// The augmentation of every point with rows that makes the operator of GMRES
    /// diagonal at the present estimate: docs/theory.md eq. (8.28).
    fn wanted(
        &self,
        points: &LinearPoints,
        stiffness: &Stiffness<'_>,
        work: &MatrixFree,
    ) -> Vec<(usize, Augmentation)> {
        let slope =
            |of: &RowSlopes, own: usize| of.by_value[own] / (1.0 - of.by_multiplier[own]).max(0.0);
        let mut wanted = Vec::with_capacity(self.rows.len());
        for (i, row) in self.rows.iter().enumerate() {
            let Some((place, Kind::Normal)) = row.point() else { continue };
            let local = stiffness.local(&points.at(place));
            let next = self.rows.get(i + 1).and_then(Row::point);
            // where it slides in space, nothing stiffens it along its way
            let along = |direction: usize| slope(&work.slopes[i + 1 + direction], direction);
            let sticks = |direction: usize| work.slopes[i + 1 + direction].by_multiplier[direction];
            let tangential = match next == Some((place, Kind::Tangential(0))) {
                true => (0..points.directions())
                    .min_by(|&a, &b| sticks(a).total_cmp(&sticks(b)))
                    .map_or(0.0, |least| within(along(least), local.tangential, 0.0)),
                false => 0.0,
            };
            let normal = within(slope(&work.slopes[i], 0), local.normal, 0.0);
            wanted.push((place, Augmentation { normal, tangential }));
        }
        for (integration_point, answer) in self.integration_points.iter().zip(&work.answers) {
            let point = points.at(integration_point.point);
            let (local, lent) = (stiffness.local(&point), point.augmentation());
            let by_slip = |direction| answer.drag_by_slip.at(direction, direction);
            let least = (0..points.directions()).map(by_slip).fold(f64::INFINITY, f64::min);
            let normal = within(answer.slope + lent.normal, local.normal, 0.0);
            let tangential = within(least + lent.tangential, local.tangential, 0.0);
            wanted.push((integration_point.point, Augmentation { normal, tangential }));
        }
        wanted
    }

    /// Pressures and tractions of the points from the solution.
    fn back_substitute_matrix_free(
        &mut self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
        work: &MatrixFree,
    ) {
        self.release_others(points, context);
        for (i, row) in self.rows.iter().enumerate() {
            let Some((place, kind)) = row.point() else { continue };
            let multiplier = self.unknown[i] + row.augmentation * (work.values[i] - row.start);
            super::give_multiplier(
                &mut points[place],
                context,
                kind,
                [multiplier, work.values[i], row.kappa],
            );
        }
        self.values.clone_from(&work.values);
        self.give_integration_points(points, context);
    }
}

impl MatrixFree {
    fn make_room(&mut self, rows: usize, integration_points: usize) {
        let [a, b] = &mut self.trial;
        let vectors = [
            &mut self.values,
            &mut self.residual,
            &mut self.step,
            &mut self.yielded,
            &mut self.scaled,
            a,
            b,
        ];
        for vector in vectors {
            vector.resize(rows, 0.0);
        }
        self.slopes.resize(rows, RowSlopes::default());
        self.answers.resize(integration_points, PointAnswer::default());
    }

    /// K_s^-1 of the right-hand side.
    fn find_base(&mut self, stiffness: &mut Stiffness<'_>) -> Result<(), SolveError> {
        self.base.clone_from(&self.right_side);
        self.solves += 1;
        stiffness.solver.solve(&mut self.base)
    }
}

/// How many solutions a factorisation costs.
fn factorisation_in_solves(stiffness: &Stiffness<'_>) -> f64 {
    let description = stiffness.solver.description();
    description.predicted_operations / (2.0 * description.predicted_entries.max(1.0))
}
