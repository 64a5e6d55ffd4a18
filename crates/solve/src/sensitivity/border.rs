//! The tangent of a converged increment, bordered by what contact holds exactly.
//!
//! ```text
//!   | K + F k G   F | |   du  |   | -R' |      G: gaps of hard contact, slips of exact stick
//!   |     G       0 | | q     | = | -c' |      F: the forces of their multipliers
//!                                              dlambda = q + k G du
//!   an end of a closed part:   F: the forces that it moves,  G du - q = -c',  q its rate
//! ```
//!
//! docs/theory.md eqs (13.3) and (13.4).

use crate::contact::MovingPoints;
use crate::newton::augmentation_stiffness;
use crate::observe::results::{FrictionCall, Status};
use crate::problem::Problem;
use crate::state::{PointState, State};
use crate::tangent::Place;
use slideline_linalg::{DenseLu, SolveError, Solver};
use slideline_mech::contact::tangential::Tangential;

/// What rounding may leave of an overclosure, in sizes of the model [1].
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// What stays as it is along a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Held {
    Gap,
    Slip(usize),
    /// An end of the closed part of a cell, among those that move.
    End,
}

/// A row of the border.
#[derive(Debug)]
struct Row {
    place: usize,
    held: Held,
    /// Stiffness that the row lends to the tangent [F/L3].
    lent: f64,
    /// What its unknown counts in the row itself: that of an end, minus one; others, nothing.
    own: f64,
    /// Derivatives of gap or slip by equations [1].
    gradient: Vec<(usize, f64)>,
    /// Forces of a unit of its multiplier on equations [L2].
    force: Vec<(usize, f64)>,
}

/// All rows, and what the tangent answers them with.
#[derive(Debug, Default)]
pub struct Border {
    rows: Vec<Row>,
    response: Vec<f64>,
    factors: DenseLu,
}

impl Border {
    /// The rows of a converged trial, those of moving ends last.
    pub fn of(place: &Place<'_>, moving: &MovingPoints) -> Self {
        let mut border = Self::default();
        for point in 0..place.plan.contact.points.len() {
            border.add(place, point);
        }
        (0..moving.ends().len()).for_each(|end| border.add_end(place, (moving, end)));
        border
    }

    /// Adds an end of the closed part of a cell, xi' - row u' = what holds of it with the unknowns
    /// held: docs/theory.md section 13, along beams.
    fn add_end(&mut self, at: &Place<'_>, (moving, end): (&MovingPoints, usize)) {
        let mut force = Vec::new();
        for own in moving.of_end(end) {
            let (part, stretch) = own.with_end(end);
            let kinematics = at.evaluation.kinematics.at(own.place);
            let ((pressure, traction), slope) = at.law_with(own.place, &kinematics, own.slip);
            let presses = slope * own.closes;
            let rubs = traction.d_tau_d_slip.at(0, 0) * own.slides
                + traction.d_tau_d_pressure[0] * presses;
            let normal = kinematics.area * (part * presses + stretch * pressure);
            let tangential = kinematics.area * (part * rubs + stretch * traction.tau[0]);
            let rows = kinematics.rows;
            let forces = rows.normal().iter().zip(rows.force(0));
            let forces = forces.map(|(a, b)| normal * a + tangential * b);
            let turned = moving.turned(own).iter().map(|&(dof, force)| (dof, part * force));
            for (dof, force_on) in rows.unknowns.iter().copied().zip(forces).chain(turned) {
                add_to_equations(at, (dof, force_on), &mut force);
            }
        }
        let mut gradient = Vec::new();
        let row = moving.row(end).iter();
        row.for_each(|&(dof, by)| add_to_equations(at, (dof, by), &mut gradient));
        let (held, lent, own) = (Held::End, 0.0, -1.0);
        self.rows.push(Row { place: 0, held, lent, own, gradient, force });
    }

    fn add(&mut self, at: &Place<'_>, place: usize) {
        let (plan, now) = (at.plan, &at.evaluation.points[place]);
        let kinematics = at.evaluation.kinematics.at(place);
        if !now.closed || !kinematics.faces {
            return;
        }
        let point = &plan.contact.points[place];
        let laws = plan.contact.laws_of(point.pair, &at.committed.points[place]);
        let lent = augmentation_stiffness(plan, point);
        let rows = kinematics.rows;
        let over_equations = |of: &dyn Fn(usize) -> f64| {
            let mut list: Vec<(usize, f64)> = Vec::new();
            let each = rows.unknowns.iter().enumerate();
            each.for_each(|(k, &dof)| add_to_equations(at, (dof, of(k)), &mut list));
            list
        };
        let moves = |list: &[(usize, f64)]| list.iter().any(|(_, value)| *value != 0.0);
        let mut push = |held, gradient: Vec<(usize, f64)>, force: Vec<(usize, f64)>| {
            if moves(&gradient) {
                self.rows.push(Row { place, held, lent, own: 0.0, gradient, force });
            }
        };
        if laws.normal.pressure(kinematics.overclosure).is_none() {
            // the traction of a law goes with the pressure
            let (_, traction) = at.law(place, &kinematics).0;
            let with = traction.d_tau_d_pressure;
            let force = |k: usize| {
                let along = (0..rows.directions()).map(|d| with[d] * rows.force(d)[k]);
                now.area * along.fold(rows.normal()[k], |sum, own| sum + own)
            };
            push(Held::Gap, over_equations(&|k| rows.normal()[k]), over_equations(&force));
        }
        let sticks = now.status == Status::Stick && now.friction == FrictionCall::Called;
        if sticks && laws.user.is_none() && laws.friction.needs_multiplier() {
            for d in 0..rows.directions() {
                push(
                    Held::Slip(d),
                    over_equations(&|k| rows.slip(d)[k]),
                    over_equations(&|k| now.area * rows.force(d)[k]),
                );
            }
        }
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Lends the stiffness of the rows to matrix values.
    pub fn lend(&self, plan: &Problem<'_>, values: &mut [f64]) {
        let pattern = plan.pattern;
        for row in self.rows.iter().filter(|row| row.lent != 0.0) {
            for &(i, force) in &row.force {
                for &(j, gradient) in &row.gradient {
                    if let Some(at) = pattern.position(i, j) {
                        values[at] += row.lent * force * gradient;
                    }
                }
            }
        }
    }

    /// Finds what the factored tangent answers the rows with.
    ///
    /// # Errors
    /// Those of the solver.
    pub fn couple(&mut self, equations: usize, solver: &mut Solver) -> Result<(), SolveError> {
        let count = self.rows.len();
        self.response.clear();
        self.response.resize(count * equations, 0.0);
        for (row, column) in self.rows.iter().zip(self.response.chunks_exact_mut(equations.max(1)))
        {
            row.force.iter().for_each(|&(equation, force)| column[equation] += force);
        }
        solver.solve_many(&mut self.response, count)?;
        let matrix = self.factors.matrix_mut(count);
        for (i, row) in self.rows.iter().enumerate() {
            for j in 0..count {
                matrix[i * count + j] = row.along(&self.response[j * equations..]);
            }
            matrix[i * count + i] -= row.own;
        }
        self.factors.factor();
        Ok(())
    }

    /// Solves: `residual` holds R' on entry and du on return, `defects` c' and the change of the
    /// multipliers.
    ///
    /// # Errors
    /// Those of the solver.
    pub fn solve(
        &self,
        solver: &mut Solver,
        (residual, defects): (&mut [f64], &mut [f64]),
    ) -> Result<(), SolveError> {
        residual.iter_mut().for_each(|value| *value = -*value);
        solver.respond(residual)?;
        if self.rows.is_empty() {
            return Ok(());
        }
        let mut q: Vec<f64> =
            self.rows.iter().zip(&*defects).map(|(row, c)| row.along(residual) + c).collect();
        self.factors.solve(&mut q)?;
        let n = residual.len();
        for (q, response) in q.iter().zip(self.response.chunks_exact(n.max(1))) {
            residual.iter_mut().zip(response).for_each(|(du, w)| *du -= q * w);
        }
        for ((row, q), defect) in self.rows.iter().zip(&q).zip(defects) {
            *defect = q - row.lent * *defect;
        }
        Ok(())
    }

    /// Adds `weight` times what the rows should hold, in a trial that began from `committed`.
    pub fn add_defects(
        &self,
        weight: f64,
        (committed, now): (&State, &[PointState]),
        into: &mut [f64],
    ) {
        for (row, sum) in self.rows.iter().zip(into) {
            let point = &now[row.place];
            *sum += weight
                * match row.held {
                    Held::Gap => -point.opening,
                    Held::Slip(d) => (point.slip - committed.points[row.place].slip)[d],
                    // the ends that an evaluation finds are those of its displacements
                    Held::End => 0.0,
                };
        }
    }

    /// Adds changes of the multipliers to pressures and tractions.
    pub fn give(&self, changes: &[f64], pressures: &mut [f64], tractions: &mut [Tangential]) {
        for (row, change) in self.rows.iter().zip(changes) {
            match row.held {
                Held::Gap => pressures[row.place] += change,
                Held::Slip(d) => tractions[row.place].0[d] += change,
                Held::End => {}
            }
        }
    }

    /// The part of a list with a number a row that is of ends.
    pub fn ends<'a>(&self, rows: &'a mut [f64]) -> &'a mut [f64] {
        &mut rows[self.multipliers()..]
    }

    /// How many rows are of multipliers: those before the ends.
    pub fn multipliers(&self) -> usize {
        self.rows.iter().position(|row| row.held == Held::End).unwrap_or(self.rows.len())
    }
}

/// Adds what a number at a dof is at equations.
fn add_to_equations(at: &Place<'_>, (dof, own): (usize, f64), list: &mut Vec<(usize, f64)>) {
    let add = &mut |equation, factor: f64| list.push((equation, factor * own));
    at.plan.constraints.for_each_equation(&at.evaluation.rows, dof, add);
}

impl Row {
    fn along(&self, vector: &[f64]) -> f64 {
        self.gradient.iter().map(|&(equation, g)| g * vector[equation]).sum()
    }
}

/// Whether contact that is hard stands on another branch in a neighbour: closed it would pull, open
/// it would lie beyond its master, and not because both are held there.
pub fn leaves_hard_branch(
    plan: &Problem<'_>,
    committed: &State,
    now: &[PointState],
    stands_held: impl Fn(usize) -> bool,
) -> bool {
    if plan.contact.laws.iter().all(|own| own.normal.pressure(0.0).is_some()) {
        return false;
    }
    let beyond = ROUNDING * plan.reach;
    plan.contact.points.iter().zip(now).enumerate().any(|(place, (point, now))| {
        let law = &plan.contact.laws_of(point.pair, &committed.points[place]).normal;
        if law.is_bonded() || law.pressure(0.0).is_some() || now.along.is_none() {
            return false;
        }
        match now.closed {
            true => now.pressure < 0.0,
            false => -now.opening > beyond && !stands_held(place),
        }
    })
}
