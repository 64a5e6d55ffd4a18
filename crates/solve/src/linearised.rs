//! The contact problem of one Newton iteration, solved exactly.
//!
//! ```text
//!        structure + geometry: linear          laws: as they are
//!     K du + r + sum A (p a + tau b) = 0       p = p(h),  tau = tau(slip, p)
//!                 \                             /
//!                  h = h0 + a.du ,  slip = s0 + b.du
//! ```
//!
//! A Newton iteration linearises the structure and the geometry of contact,
//! but not the contact laws: a softened law climbs by decades within one
//! clearance, a hard one has no slope at all, and a linearised law therefore
//! overshoots from iteration to iteration. Here the laws are kept. With the
//! responses W = K^-1 A (a, b) of the few points that may touch, overclosures
//! and slips are linear in the multipliers, and a small dense system remains,
//! one row a pressure or a traction, which a semismooth Newton method solves
//! to round-off. See docs/theory.md, "The contact step".
//!
//! Points that are closed already augment K a moderate stiffness s (it enters K
//! and leaves the multipliers again: lambda = q + s (e - e0)), so that a body
//! held by contact alone has a regular K. The laws of friction, and with them
//! the coupling of traction and pressure, stand in the small system; K itself
//! is unsymmetric only by the turning of the tractions with the surface.

mod augmentation;
mod contradiction;
mod convex;
mod integration_points;
mod iterate;
mod jam;
mod laws;
mod matrix_free;
mod pivoting;
mod points;
mod slopes;
mod system;

pub use augmentation::Stiffness;
pub use contradiction::Contradiction;
use convex::Descent;
use matrix_free::MatrixFree;
use points::Kind;
pub use points::{Augmentation, LinearPoint, LinearPoints, LinearRows, Sliding};
use slideline_linalg::{DenseLu, SolveError, Solver};
use slideline_mech::contact::enforcement::Enforcement;
use slideline_mech::contact::pair::Laws;
use slideline_mech::contact::tangential::Tangential;
use std::collections::HashMap;
use system::{IntegrationPoints, Row, System, Unknown};

/// What is common to all points of an increment.
#[derive(Debug)]
pub struct LawContext<'a> {
    /// Laws, a pair each.
    pub laws: &'a [Laws],
    /// Total time at the end of the increment [T].
    pub time: f64,
    /// The increment [T].
    pub dt: f64,
    /// Committed state values of user friction laws.
    pub committed: &'a [f64],
    /// `UNSYMM=NO`: tractions take their limit from the pressure of the last
    /// iteration, which is what a symmetrised tangent amounts to.
    pub symmetrised: bool,
    /// What rounding leaves of a slip [L].
    pub rounding: f64,
    /// Natural unit of each equation's displacement, as in the plan.
    pub units: &'a [f64],
}

/// Scratch of the small system, kept from iteration to iteration.
#[derive(Clone, Debug, Default)]
pub struct LinearisedContact {
    rows: Vec<Row>,
    /// K^-1 A v of each row, one after the other.
    response: Vec<f64>,
    /// C = V W, row-major.
    compliance: Vec<f64>,
    unknown: Vec<f64>,
    residual: Vec<f64>,
    step: Vec<f64>,
    trial: Vec<f64>,
    /// Unknowns where the first way left them.
    begun: Vec<f64>,
    jacobian: Vec<f64>,
    /// Its factors.
    factors: DenseLu,
    /// dF/dd of the interface rows, row-major over all rows.
    stiffness: Vec<f64>,
    in_rows: Vec<bool>,
    /// du by the present estimate.
    moved: Vec<f64>,
    /// Displacements of the interface rows.
    values: Vec<f64>,
    integration_points: IntegrationPoints,
    /// Rows of equations that integration_points press on.
    interface: HashMap<usize, usize>,
    matrix_free: MatrixFree,
    descent: Descent,
    /// Whether the laws of all rows were met in the last solution.
    solved: bool,
}

/// The most rounds in which further points may join.
const ROUNDS: usize = 12;
impl LinearisedContact {
    /// Makes room for `points` points of a system of `equations`, so that
    /// later iterations allocate nothing.
    pub fn reserve(&mut self, points: usize, equations: usize) {
        let rows = (2 * points).min(32);
        if self.rows.capacity() >= rows.max(1) && self.moved.capacity() >= equations {
            return;
        }
        self.rows.reserve(rows);
        self.response.reserve(rows * equations);
        self.compliance.reserve(rows * rows);
        self.jacobian.reserve(rows * rows);
        // factored once, so that what it needs is there
        self.factors.matrix_mut(rows);
        self.factors.factor();
        self.descent.reserve(rows, points);
        let vectors = [&mut self.unknown, &mut self.residual, &mut self.step, &mut self.trial];
        vectors.into_iter().chain([&mut self.begun]).for_each(|vector| vector.reserve(rows));
        self.in_rows.reserve(points);
        self.moved.reserve(equations);
        self.values.reserve(rows);
    }

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

    /// Solutions with the factored stiffness that the last contact step took, of
    /// the matrix-free way.
    pub fn solutions(&self) -> usize {
        self.matrix_free.solves
    }

    /// Whether the last solution meets the laws of all its rows.
    pub fn is_solved(&self) -> bool {
        self.solved
    }

    /// Lets points join that touch already (`touching`), or that would touch
    /// by the present estimate; says whether any did.
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
        for (place, point) in points.with_rows().enumerate() {
            if self.in_rows[place] || !self.joins(&point, context, touching) {
                continue;
            }
            self.in_rows[place] = true;
            joined = true;
            if point.integrated {
                self.add_integration_point((&point, place), context, solver, base)?;
                continue;
            }
            self.add_row(&point, place, Kind::Normal, solver, base)?;
            if point.sliding.is_some() && point.slides() {
                for direction in 0..points.directions() {
                    self.add_row(&point, place, Kind::Tangential(direction), solver, base)?;
                }
            }
        }
        Ok(joined)
    }

    /// Whether a point touches already (`touching`), or would by the present
    /// estimate of du.
    fn joins(&self, point: &LinearRows<'_>, context: &LawContext<'_>, touching: bool) -> bool {
        if !point.moves(Kind::Normal) {
            return false;
        }
        if touching {
            return point.pressure > 0.0 || point.stiffness > 0.0;
        }
        let begins = context.laws[point.pair].normal.contact_begins();
        point.overclosure + point.dot(Kind::Normal, &self.moved) > begins
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

    fn add_row(
        &mut self,
        point: &LinearRows<'_>,
        place: usize,
        kind: Kind,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<(), SolveError> {
        let n = base.len();
        let begin = self.response.len();
        self.response.resize(begin + n, 0.0);
        let response = &mut self.response[begin..];
        point.push(kind, 1.0, response);
        solver.respond(response)?;
        self.push_row(point, place, kind);
        if let Some(row) = self.rows.last_mut() {
            row.free = row.start + point.dot(kind, base);
        }
        Ok(())
    }

    /// A row for the pressure or the traction of a point, with its first guess.
    fn push_row(&mut self, point: &LinearPoint, place: usize, kind: Kind) {
        let (start, augmentation, guess) = match (kind, &point.sliding) {
            (Kind::Tangential(direction), Some(sliding)) => {
                let Sliding { slip, stiffness, traction, .. } = sliding;
                (slip[direction], *stiffness, traction[direction])
            }
            _ => (point.overclosure, point.stiffness, point.pressure),
        };
        let pressure_row = match kind {
            Kind::Normal => self.rows.len(),
            Kind::Tangential(direction) => self.rows.len() - 1 - direction,
        };
        let unknown = Unknown::Multiplier { point: place, kind, pressure_row };
        self.rows.push(Row { start, augmentation, unit: 1.0 / point.area, ..Row::new(unknown) });
        self.unknown.truncate(self.rows.len() - 1);
        self.unknown.push(guess);
    }

    /// A row for the force of all integration_points on an equation.
    fn push_interface(&mut self, equation: usize, unit: f64) -> usize {
        let place = self.rows.len();
        self.rows.push(Row { unit: 1.0 / unit, ..Row::new(Unknown::Interface { equation }) });
        self.interface.insert(equation, place);
        self.unknown.truncate(place);
        self.unknown.push(0.0);
        place
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
        system::share_among_directions(&mut self.rows);
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
        self.values.clear();
        for (i, row) in self.rows.iter().enumerate() {
            let (multiplier, value) = system.multiplier_and_value(i, &self.unknown);
            self.values.push(value);
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

    /// Points without rows press as their law says where nothing moves them,
    /// and not at all elsewhere.
    fn release_others(&self, points: &mut LinearPoints, context: &LawContext<'_>) {
        for place in (0..points.len()).filter(|&place| !self.in_rows[place]) {
            let fixed = !points.at(place).moves(Kind::Normal);
            let point = &mut points[place];
            let laws = &context.laws[point.pair];
            point.pressure = if fixed { laws.pressure(point.overclosure, 0.0) } else { 0.0 };
            point.set_traction(Tangential::ZERO);
        }
    }

    /// Gives the integration points what their laws say at the displacements found.
    fn give_integration_points(&self, points: &mut LinearPoints, context: &LawContext<'_>) {
        for place in 0..points.len() {
            if let Some(traction) = context.prescribed_sliding(&points.at(place)) {
                points[place].set_traction(traction);
            }
        }
        for integration_point in self.integration_points.iter() {
            let place = integration_point.point;
            let answer =
                context.integration_point(integration_point, &points.at(place), &self.values);
            points[place].pressure = answer.pressure;
            points[place].set_traction(answer.traction);
        }
    }
}

/// Gives a point its multiplier, of the overclosure or slip found and the
/// stiffness that the law was asked through.
fn give_multiplier(
    point: &mut LinearPoint,
    context: &LawContext<'_>,
    kind: Kind,
    [multiplier, value, kappa]: [f64; 3],
) {
    match (kind, &mut point.sliding) {
        (Kind::Tangential(direction), Some(sliding)) => sliding.traction.0[direction] = multiplier,
        _ => {
            let laws = &context.laws[point.pair];
            point.pressure = laws.complementarity_of_pressure(multiplier, value, kappa).value;
        }
    }
}

#[cfg(test)]
mod tests;
