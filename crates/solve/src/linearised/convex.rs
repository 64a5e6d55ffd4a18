//! The contact problem with the limits of friction held fixed: a convex one.
//!
//! ```text
//!   energy |\         /      K0/2 du.du - beta.du + sum A W(e):   W convex,
//!          | \___   _/       so the slope along a Newton direction only grows
//!          |     \_/         and has one zero: there the step ends
//!          +--------> step
//! ```
//!
//! Newton by the norm of the residual can be caught between the limits of
//! friction, or among the active sets of a hard law, where a body is held by
//! little else than contact. With limits mu p of fixed p (Tresca friction) the
//! same equations are the gradient of a convex energy, and a step that ends where
//! that energy is least never leaves the way to the solution. From there the laws
//! are taken as they are again. docs/theory.md eq. (8.25). (derived)

use super::iterate::eliminate_in_units;
use super::points::Kind;
use super::system::{Row, RowSlopes, System, Unknown};
use super::{LawContext, LinearPoint, LinearPoints, LinearisedContact};
use slideline_linalg::DenseLu;
use slideline_mech::contact::enforcement::{Complementarity, TangentialComplementarity};
use slideline_mech::contact::tangential::{Tangential, TangentialMap};

/// Rounds in which the limits of friction follow the pressures.
const ROUNDS: usize = 8;
/// The most Newton steps of a round.
const STEPS: usize = 60;
/// Halvings that find the end of a step.
const HALVINGS: usize = 40;
/// Stiffness that stands for a hard law or exact stick, in those that the
/// structure has at the point [1].
const STIFF: f64 = 1e5;
/// Change of all pressures, relative to the largest, that ends the rounds [1].
const STEADY: f64 = 1e-6;
/// Equations of a point that room is kept for.
const ROWS: usize = 18;

impl LinearisedContact {
    /// Moves the unknowns to where the energy is least, rounds of fixed limits
    /// after one another.
    pub(super) fn minimise(&mut self, points: &LinearPoints, context: &LawContext<'_>) {
        let mut work = std::mem::take(&mut self.descent);
        let mut held = std::mem::take(&mut work.held);
        held.copy_from(points);
        let fixed = LawContext { symmetrised: true, ..*context };
        for _ in 0..ROUNDS {
            self.descend(&held, &fixed, &mut work);
            if self.follow_pressures(&mut held, &fixed, &mut work.values) {
                break;
            }
        }
        work.held = held;
        self.descent = work;
    }

    /// Newton with steps that end where the energy is least.
    fn descend(&mut self, points: &LinearPoints, fixed: &LawContext<'_>, work: &mut Descent) {
        work.make_room(self.rows.len());
        let mut unknown = std::mem::take(&mut self.unknown);
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        for _ in 0..STEPS {
            let size = work.evaluate(&system, &unknown, points, fixed);
            if !size.is_finite() || size <= 1e-24 * system.largest_multiplier(&unknown) {
                break;
            }
            work.find_step(&system);
            work.from.clone_from(&unknown);
            if work.slope() <= 0.0 {
                // Sliding, the structure gives way; sticking it may not: the
                // steepest the laws can be lies above them all the way.
                work.steepest = true;
                work.evaluate(&system, &unknown, points, fixed);
                work.steepest = false;
                work.find_step(&system);
                if work.slope() <= 0.0 {
                    break; // no way down: rows that depend on one another
                }
            }
            let (mut low, mut high) = (0.0, 1.0);
            let mut at = 1.0;
            for _ in 0..HALVINGS {
                for ((q, start), step) in unknown.iter_mut().zip(&work.from).zip(&work.step) {
                    *q = start - at * step;
                }
                work.evaluate(&system, &unknown, points, fixed);
                let slope = work.slope();
                if slope >= 0.0 && at == 1.0 {
                    break; // still downhill at its end
                }
                if slope >= 0.0 {
                    low = at
                } else {
                    high = at
                }
                if high - low <= 1e-9 * high {
                    break;
                }
                at = 0.5 * (low + high);
            }
        }
        self.unknown = unknown;
    }

    /// Gives the points the pressures of the present unknowns; says whether
    /// they are what they were.
    fn follow_pressures(
        &mut self,
        points: &mut LinearPoints,
        fixed: &LawContext<'_>,
        values: &mut Vec<f64>,
    ) -> bool {
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: &self.integration_points,
        };
        values.clear();
        let rows = 0..self.rows.len();
        values.extend(rows.map(|i| system.multiplier_and_value(i, &self.unknown).1));
        let (mut change, mut largest) = (0.0_f64, 0.0_f64);
        let mut follow = |point: &mut LinearPoint, pressure: f64| {
            change = change.max((pressure - point.pressure).abs());
            largest = largest.max(pressure.abs());
            point.pressure = pressure;
        };
        for (i, row) in self.rows.iter().enumerate() {
            if let Some((place, Kind::Normal)) = row.point() {
                let pressure = fixed.inserted_pressure(row, &points[place], values[i]).value;
                follow(&mut points[place], pressure);
            }
        }
        for integration_point in self.integration_points.iter() {
            let place = integration_point.point;
            let answer = fixed.integration_point(integration_point, &points.at(place), values);
            follow(&mut points[place], answer.pressure);
        }
        change <= STEADY * largest
    }
}

/// Scratch of a descent, kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Descent {
    /// Points with the pressures that limit friction.
    held: LinearPoints,
    /// Unknowns at the beginning of a step.
    from: Vec<f64>,
    step: Vec<f64>,
    /// A C step: how the energy falls with the residual of each row.
    push: Vec<f64>,
    residual: Vec<f64>,
    jacobian: Vec<f64>,
    factors: DenseLu,
    stiffness: Vec<f64>,
    values: Vec<f64>,
    /// Whether slopes are those of stick, sliding or not.
    steepest: bool,
}

impl Descent {
    /// Room for `m` rows and so many points, so that later steps allocate nothing.
    pub fn reserve(&mut self, m: usize, points: usize) {
        self.make_room(m);
        self.held.reserve(points, ROWS);
        // factored once, so that what it needs is there
        self.factors.matrix_mut(m);
        self.factors.factor();
    }

    /// Room for `m` rows.
    fn make_room(&mut self, m: usize) {
        let Self { from, step, push, residual, jacobian, stiffness, values, .. } = self;
        [from, step, push, residual, values].into_iter().for_each(|list| list.resize(m, 0.0));
        [jacobian, stiffness].into_iter().for_each(|square| square.resize(m * m, 0.0));
        self.steepest = false;
    }

    /// F = lambda - law with the laws inserted, and dF/dq; its weighted square.
    fn evaluate(
        &mut self,
        system: &System<'_>,
        unknown: &[f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) -> f64 {
        for (i, value) in self.values.iter_mut().enumerate() {
            *value = system.multiplier_and_value(i, unknown).1;
        }
        if !system.integration_points.is_empty() {
            let known = (unknown, &self.values[..], points);
            let slope = (&mut self.jacobian[..], &mut self.stiffness[..]);
            system.interface(known, fixed, &mut self.residual, slope);
        }
        for i in 0..system.rows.len() {
            fixed.insert(system.rows, i, points, (&self.values, self.steepest), |i, slopes| {
                self.residual[i] = system.multiplier_and_value(i, unknown).0 - slopes.value;
                system.differentiate(i, &slopes, &mut self.jacobian);
            });
        }
        let squares = self.residual.iter().zip(system.rows).map(|(f, row)| f * f * row.weight);
        squares.sum()
    }

    /// The step, J step = F, and what the energy says of it.
    fn find_step(&mut self, system: &System<'_>) {
        self.step.copy_from_slice(&self.residual);
        eliminate_in_units(system.rows, &self.jacobian, &mut self.factors, &mut self.step);
        let rows = system.compliance.chunks_exact(system.rows.len());
        for ((push, row), compliance) in self.push.iter_mut().zip(system.rows).zip(rows) {
            let moved: f64 = compliance.iter().zip(&self.step).map(|(c, d)| c * d).sum();
            *push = match row.unknown {
                Unknown::Multiplier { .. } => moved / row.unit,
                Unknown::Interface { .. } => moved,
            };
        }
    }

    /// Energy that the step gains per length of it; below zero beyond the place
    /// where the energy is least [F L].
    fn slope(&self) -> f64 {
        self.push.iter().zip(&self.residual).map(|(push, f)| push * f).sum()
    }
}

impl LawContext<'_> {
    /// What the laws say at the `values` of all rows, at the limit of the pressure that the
    /// point has: of the pressure in row `i`, or of all tractions that begin there; `steepest`:
    /// with the slopes of stick, sliding or not.
    fn insert(
        &self,
        rows: &[Row],
        i: usize,
        points: &LinearPoints,
        (values, steepest): (&[f64], bool),
        mut slopes: impl FnMut(usize, RowSlopes),
    ) {
        let Some((place, kind)) = rows[i].point() else { return };
        let (row, point) = (&rows[i], &points[place]);
        match kind {
            Kind::Normal => {
                let answer = self.inserted_pressure(row, point, values[i]);
                slopes(i, RowSlopes::of_pressure(i, &answer));
            }
            Kind::Tangential(0) => {
                let mut slip = Tangential::ZERO;
                let directions = points.directions();
                slip.0[..directions].copy_from_slice(&values[i..i + directions]);
                let mut answer = self.inserted_traction(row, point, slip);
                if steepest {
                    let rest = point.sliding.map_or(slip, |sliding| -sliding.elastic_slip);
                    answer.by_value = self.inserted_traction(row, point, rest).by_value;
                }
                for direction in 0..directions {
                    let own = RowSlopes::of_traction((i, directions), direction, &answer);
                    slopes(i + direction, own);
                }
            }
            Kind::Tangential(_) => {}
        }
    }

    /// The pressure at an overclosure; a hard law as a stiff spring.
    fn inserted_pressure(&self, row: &Row, point: &LinearPoint, value: f64) -> Complementarity {
        let laws = &self.laws[point.pair];
        let stiff = STIFF * row.felt;
        match laws.normal.pressure(0.0) {
            None if value > 0.0 => Complementarity::inserted(stiff * value, stiff),
            None => Complementarity::inserted(0.0, 0.0),
            Some(_) => laws.complementarity_of_pressure(0.0, value, f64::INFINITY),
        }
    }

    /// The traction at a slip and the limit of the pressure that the point has; exact stick as a
    /// stiff spring.
    fn inserted_traction(
        &self,
        row: &Row,
        point: &LinearPoint,
        slip: Tangential,
    ) -> TangentialComplementarity {
        let laws = &self.laws[point.pair];
        let Some(sliding) = &point.sliding else { return TangentialComplementarity::default() };
        if !laws.friction.needs_multiplier() {
            let values = (sliding.traction, slip, point.pressure);
            let answer = self.complementarity_of_traction(laws, values, sliding, f64::INFINITY);
            return TangentialComplementarity { by_pressure: Tangential::ZERO, ..answer };
        }
        let stiff = STIFF * row.felt;
        let limit = laws.friction.limit_traction(point.pressure, sliding.slip, self.dt);
        let tau = stiff * slip;
        let (value, by_value) = match tau.size() <= limit {
            true => (tau, TangentialMap::isotropic(stiff)),
            false => {
                let way = tau.direction();
                (limit * way, TangentialMap::across(way, stiff * limit / tau.size()))
            }
        };
        TangentialComplementarity { value, by_value, ..TangentialComplementarity::default() }
    }
}
