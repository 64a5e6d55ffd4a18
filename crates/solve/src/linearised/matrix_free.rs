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
use super::laws::PointAnswer;
use super::system::{IntegrationPoint, Row, Unknown};
use super::{Kind, LawContext, LinearPoint, LinearisedContact, MOST_DOFS};
use slideline_linalg::SolveError;
use slideline_linalg::krylov::{self, Stop, gmres};
use slideline_mech::contact::enforcement::Complementarity;

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
/// The most and the least augmentation, in stiffnesses that the point feels [1].
const MOST: f64 = 1e6;
const LEAST: f64 = 1e-3;
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
    complementarities: Vec<Complementarity>,
    answers: Vec<PointAnswer>,
    krylov: krylov::Workspace,
    /// Solutions with the factored stiffness in this iteration.
    pub solves: usize,
}

/// Products with C of a set of rows.
struct Compliance<'a> {
    rows: &'a [Row],
    points: &'a [LinearPoint],
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
                    let point = &self.points[point];
                    for (&equation, f) in point.equations.iter().zip(point.force(kind)) {
                        self.full[equation] += point.area * q * f;
                    }
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
                Unknown::Multiplier { point, kind, .. } => self.points[point].dot(kind, self.full),
                Unknown::Interface { equation } => self.full[equation],
            };
        }
    }
}

impl LinearisedContact {
    /// As [`LinearisedContact::solve`], without forming C.
    pub(super) fn solve_matrix_free(
        &mut self,
        points: &mut [LinearPoint],
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
        points: &mut [LinearPoint],
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
        points: &[LinearPoint],
        context: &LawContext<'_>,
        touching: bool,
    ) -> bool {
        let mut joined = false;
        for (place, point) in points.iter().enumerate() {
            if self.in_rows[place] || !self.joins(point, context, touching) {
                continue;
            }
            self.in_rows[place] = true;
            joined = true;
            if point.integrated {
                self.activate_integration_point((point, place), context);
                continue;
            }
            self.push_row(point, place, Kind::Normal);
            if point.sliding.is_some() && point.moves(Kind::Tangential) {
                self.push_row(point, place, Kind::Tangential);
            }
        }
        joined
    }

    fn activate_integration_point(
        &mut self,
        (point, place): (&LinearPoint, usize),
        context: &LawContext<'_>,
    ) {
        let mut integration_point = IntegrationPoint { point: place, rows: [0; MOST_DOFS] };
        for (row, &equation) in
            integration_point.rows.iter_mut().zip(&point.equations[..point.width])
        {
            *row = match self.interface.get(&equation) {
                Some(&known) => known,
                None => {
                    let unit = context.units.get(equation).copied().unwrap_or(1.0);
                    self.push_interface(equation, unit)
                }
            };
        }
        self.integration_points.push(integration_point);
    }

    /// The first guess of all rows: laws linearised about the estimates.
    fn guess(&mut self, points: &[LinearPoint], context: &LawContext<'_>) {
        for (row, q) in self.rows.iter().zip(&mut self.unknown) {
            *q = match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    let [pressure, traction] = context.linearised(&points[point]);
                    if kind == Kind::Normal { pressure } else { traction }
                }
                Unknown::Interface { .. } => 0.0,
            };
        }
        for integration_point in &self.integration_points {
            let point = &points[integration_point.point];
            let [pressure, traction] = context.linearised(point);
            for (a, &i) in integration_point.rows[..point.width].iter().enumerate() {
                let force = pressure * point.normal[a] + traction * point.direction[a];
                self.unknown[i] += point.area * force;
            }
        }
    }

    /// Solves the condensed problem of the rows there are; says whether their
    /// laws are met.
    fn iterate_matrix_free(
        &mut self,
        points: &mut [LinearPoint],
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
    fn place_rows(&mut self, points: &[LinearPoint], stiffness: &Stiffness<'_>, work: &MatrixFree) {
        for row in &mut self.rows {
            match row.unknown {
                Unknown::Multiplier { point, kind, .. } => {
                    let point = &points[point];
                    let [normal, tangential] = stiffness.local(point);
                    let (own, augmentation) = match (kind, &point.sliding) {
                        (Kind::Tangential, Some(sliding)) => (tangential, sliding.stiffness),
                        _ => (normal, point.stiffness),
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
    }

    /// Semismooth Newton in the multipliers `q`.
    fn newton_matrix_free(
        &mut self,
        points: &mut [LinearPoint],
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
        points: &[LinearPoint],
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
        points: &[LinearPoint],
        context: &LawContext<'_>,
        work: &mut MatrixFree,
        q: &[f64],
    ) -> f64 {
        let MatrixFree { values, residual, complementarities, answers, .. } = work;
        residual.copy_from_slice(q);
        for (integration_point, answer) in self.integration_points.iter().zip(answers.iter_mut()) {
            let point = &points[integration_point.point];
            *answer = context.integration_point(integration_point, point, values);
            if !answer.is_idle() {
                for (a, &i) in integration_point.rows[..point.width].iter().enumerate() {
                    let force =
                        point.normal[a] * answer.force[0] + point.direction[a] * answer.force[1];
                    residual[i] -= point.area * force;
                }
            }
        }
        let multiplier =
            |i: usize| q[i] + self.rows[i].augmentation * (values[i] - self.rows[i].start);
        for (i, row) in self.rows.iter().enumerate() {
            let Unknown::Multiplier { point, kind, pressure_row } = row.unknown else { continue };
            let asked = [multiplier(i), values[i], multiplier(pressure_row)];
            complementarities[i] = context.complementarity(row, kind, &points[point], asked);
            residual[i] = asked[0] - complementarities[i].value;
        }
        residual.iter().zip(&self.rows).map(|(f, row)| f * f * row.weight).sum()
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
        points: &[LinearPoint],
        stiffness: &mut Stiffness<'_>,
        work: &mut MatrixFree,
        tolerance: f64,
    ) -> Result<usize, SolveError> {
        let MatrixFree {
            full,
            residual,
            step,
            yielded,
            scaled,
            complementarities,
            answers,
            solves,
            ..
        } = work;
        let [v, w] = &mut work.trial;
        let rows = &self.rows;
        let mut c = Compliance { rows, points, full, solves, fault: None };
        let slopes = Slopes {
            rows,
            integration_points: &self.integration_points,
            points,
            complementarities,
            answers,
        };
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
        points: &[LinearPoint],
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
        points: &mut [LinearPoint],
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
        let old = |point: &LinearPoint| {
            [point.stiffness, point.sliding.map_or(0.0, |sliding| sliding.stiffness)]
        };
        let any = wanted.iter().any(|&(place, new)| {
            let old = old(&points[place]);
            changes(old[0], new[0]) || changes(old[1], new[1])
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
        for integration_point in &self.integration_points {
            for &i in &integration_point.rows[..points[integration_point.point].width] {
                q[i] = 0.0;
            }
        }
        for integration_point in &self.integration_points {
            let point = &points[integration_point.point];
            let answer = context.integration_point(integration_point, point, &work.values);
            for (a, &i) in integration_point.rows[..point.width].iter().enumerate() {
                let force =
                    point.normal[a] * answer.force[0] + point.direction[a] * answer.force[1];
                q[i] += point.area * force;
            }
        }
        self.displace(points, stiffness, work, q)?;
        Ok(true)
    }

    /// The augmentation of every point with rows that makes the operator of GMRES
    /// diagonal at the present estimate: docs/theory.md eq. (8.28).
    fn wanted(
        &self,
        points: &[LinearPoint],
        stiffness: &Stiffness<'_>,
        work: &MatrixFree,
    ) -> Vec<(usize, [f64; 2])> {
        let slope = |complementarity: &Complementarity| {
            complementarity.by_value / (1.0 - complementarity.by_multiplier).max(0.0)
        };
        let mut wanted = Vec::with_capacity(self.rows.len());
        for (i, row) in self.rows.iter().enumerate() {
            let Some((place, Kind::Normal)) = row.point() else { continue };
            let local = stiffness.local(&points[place]);
            let next = self.rows.get(i + 1).and_then(Row::point);
            let tangential = match next == Some((place, Kind::Tangential)) {
                true => within(slope(&work.complementarities[i + 1]), local[1], 0.0),
                false => 0.0,
            };
            wanted.push((
                place,
                [within(slope(&work.complementarities[i]), local[0], 0.0), tangential],
            ));
        }
        for (integration_point, answer) in self.integration_points.iter().zip(&work.answers) {
            let point = &points[integration_point.point];
            let local = stiffness.local(point);
            let augmentation = point.sliding.map_or(0.0, |sliding| sliding.stiffness);
            let slopes = [answer.slope[0][0] + point.stiffness, answer.slope[1][1] + augmentation];
            let normal = within(slopes[0], local[0], 0.0);
            wanted.push((integration_point.point, [normal, within(slopes[1], local[1], 0.0)]));
        }
        wanted
    }

    /// Pressures and tractions of the points from the solution.
    fn back_substitute_matrix_free(
        &mut self,
        points: &mut [LinearPoint],
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
        self.complementarities.resize(rows, Complementarity::default());
        self.answers.resize(integration_points, PointAnswer::default());
    }

    /// K_s^-1 of the right-hand side.
    fn find_base(&mut self, stiffness: &mut Stiffness<'_>) -> Result<(), SolveError> {
        self.base.clone_from(&self.right_side);
        self.solves += 1;
        stiffness.solver.solve(&mut self.base)
    }
}

/// A slope of a law as an augmentation: none steeper than what the point feels
/// allows, and an infinite one as what it feels [F/L3].
fn within(slope: f64, local: f64, least: f64) -> f64 {
    match slope.is_finite() {
        true => slope.clamp(least * local, MOST * local),
        false => local,
    }
}

/// How many solutions a factorisation costs.
fn factorisation_in_solves(stiffness: &Stiffness<'_>) -> f64 {
    let description = stiffness.solver.description();
    description.predicted_operations / (2.0 * description.predicted_entries.max(1.0))
}

/// The slopes of the laws about an estimate.
struct Slopes<'a> {
    rows: &'a [Row],
    integration_points: &'a [IntegrationPoint],
    points: &'a [LinearPoint],
    complementarities: &'a [Complementarity],
    answers: &'a [PointAnswer],
}

impl Slopes<'_> {
    /// J v, with w = C v known: docs/theory.md eq. (8.27).
    fn product(&self, v: &[f64], w: &[f64], into: &mut [f64]) {
        let multiplier = |i: usize| v[i] - self.rows[i].augmentation * w[i];
        for (i, (row, complementarity)) in self.rows.iter().zip(self.complementarities).enumerate()
        {
            into[i] = match row.unknown {
                Unknown::Multiplier { pressure_row, .. } => {
                    multiplier(i) * (1.0 - complementarity.by_multiplier)
                        + complementarity.by_value * w[i]
                        - complementarity.by_pressure * multiplier(pressure_row)
                }
                Unknown::Interface { .. } => v[i],
            };
        }
        for (integration_point, answer) in self.integration_points.iter().zip(self.answers) {
            if answer.is_idle() {
                continue;
            }
            let point = &self.points[integration_point.point];
            let rows = &integration_point.rows[..point.width];
            let (mut normal, mut tangential) = (0.0, 0.0);
            for (a, &i) in rows.iter().enumerate() {
                normal += point.normal[a] * w[i];
                tangential += point.tangential[a] * w[i];
            }
            let [[nn, nt], [tn, tt]] = answer.slope;
            let force = [nn * normal + nt * tangential, tn * normal + tt * tangential]
                .map(|f| f * point.area);
            for (a, &i) in rows.iter().enumerate() {
                into[i] += point.normal[a] * force[0] + point.direction[a] * force[1];
            }
        }
    }

    /// The inverse of J with C taken as its diagonal would be of the point's own
    /// equations; in the norm of the energy.
    fn precondition(&self, x: &[f64], into: &mut [f64]) {
        for (i, (row, complementarity)) in self.rows.iter().zip(self.complementarities).enumerate()
        {
            let Unknown::Multiplier { pressure_row, .. } = row.unknown else {
                into[i] = x[i];
                continue;
            };
            let own = |row: &Row, complementarity: &Complementarity| {
                let compliance =
                    if row.felt > 0.0 { 1.0 / (row.felt + row.augmentation) } else { 0.0 };
                let multiplier = 1.0 - row.augmentation * compliance;
                let by = multiplier * (1.0 - complementarity.by_multiplier)
                    + complementarity.by_value * compliance;
                (if by.abs() > f64::EPSILON { by } else { 1.0 }, multiplier)
            };
            let mut right = x[i];
            if pressure_row != i && complementarity.by_pressure != 0.0 {
                let pressure = &self.rows[pressure_row];
                let (_, multiplier) = own(pressure, &self.complementarities[pressure_row]);
                let scale = (row.weight / pressure.weight).sqrt();
                right += complementarity.by_pressure * multiplier * into[pressure_row] * scale;
            }
            into[i] = right / own(row, complementarity).0;
        }
    }
}

impl LawContext<'_> {
    /// Augments points that touch by their laws at the first estimate.
    pub fn augment(&self, points: &mut [LinearPoint], stiffness: &Stiffness<'_>) {
        for point in points.iter_mut().filter(|point| point.stiffness > 0.0) {
            let sliding = point.sliding.map(|sliding| (sliding.traction, sliding.slip));
            let wanted = self.augmentation(point, stiffness, (point.pressure, sliding));
            if wanted[0] > 0.0 {
                point.set_augmentation(wanted);
            }
        }
    }

    /// Pressure and traction at the point of linearisation, of laws linearised
    /// about the estimates with the augmentation as their slope [F/L2]:
    /// docs/theory.md eq. (8.29).
    fn linearised(&self, point: &LinearPoint) -> [f64; 2] {
        let laws = &self.laws[point.pair];
        let carries = match laws.normal.overclosure(point.pressure) {
            Some((overclosure, _)) => overclosure,
            None => point.overclosure.min(laws.normal.contact_begins()),
        };
        let pressure = point.pressure + point.stiffness * (point.overclosure - carries);
        let traction = point.sliding.map_or(0.0, |sliding| {
            let exact = laws.friction.needs_multiplier() || sliding.stiffness == 0.0;
            let elastic = if exact { 0.0 } else { sliding.traction / sliding.stiffness };
            let from = if exact { 0.0 } else { elastic - sliding.elastic_slip };
            sliding.traction + sliding.stiffness * (sliding.slip - from)
        });
        [pressure, traction]
    }

    /// Slopes of the laws of a point, no steeper and no softer than what it
    /// feels allows [F/L3]; the state: pressure, traction with slip.
    pub(super) fn augmentation(
        &self,
        point: &LinearPoint,
        stiffness: &Stiffness<'_>,
        (pressure, sliding): (f64, Option<(f64, f64)>),
    ) -> [f64; 2] {
        let laws = &self.laws[point.pair];
        let local = stiffness.local(point);
        let normal = match laws.normal.overclosure(pressure) {
            // a hard law has no slope: the point's own stiffness stands for it
            Some((_, 0.0)) => local[0],
            Some((_, by_pressure)) => within(1.0 / by_pressure, local[0], LEAST),
            None => LEAST * local[0],
        };
        let tangential = match sliding {
            Some((traction, slip)) if pressure > 0.0 => {
                let stick = laws.stick_stiffness(pressure, (traction, slip), self.dt);
                stick.map_or(0.0, |slope| within(slope, local[1], 0.0))
            }
            _ => 0.0,
        };
        [normal, tangential]
    }
}
