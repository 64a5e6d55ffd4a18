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
//! Points that are closed already lend K a moderate stiffness s (it enters K
//! and leaves the multipliers again: lambda = q + s (e - e0)), so that a body
//! held by contact alone has a regular K. The laws of friction, and with them
//! the coupling of traction and pressure, stand in the small system; K itself
//! is unsymmetric only by the turning of the tractions with the surface.

mod jam;
mod settle;

use settle::{eliminate, settle};
use slideline_linalg::{SolveError, Solver};
use slideline_mech::contact::enforcement::Demand;
use slideline_mech::contact::pair::{Laws, UserMemory};

/// The most dofs one contact point couples.
pub const MOST_DOFS: usize = 16;

/// Friction at a point whose friction is called.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sliding {
    /// Change of the slip coordinate since the last commit [L].
    pub slip: f64,
    /// Committed elastic slip [L].
    pub elastic_slip: f64,
    /// Shear traction: estimate in, solution out [F/L2].
    pub traction: f64,
    /// Stiffness lent to K [F/L3].
    pub stiffness: f64,
    /// Where the point's state values of a user law begin, and how many.
    pub memory: (usize, usize),
}

/// What is common to all points of an increment.
#[derive(Debug)]
pub struct Circumstances<'a> {
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
}

/// A contact point, linearised.
#[derive(Clone, Copy, Debug)]
pub struct LinearPoint {
    /// Place of the point in the plan.
    pub place: usize,
    /// Place of its pair among the laws.
    pub pair: usize,
    /// Area [L2].
    pub area: f64,
    /// Whether it is one of the many stations of integrated contact.
    pub integrated: bool,
    /// Number of equations it acts on.
    pub width: usize,
    /// Those equations.
    pub equations: [usize; MOST_DOFS],
    /// dh/du of each [1].
    pub normal: [f64; MOST_DOFS],
    /// d slip/du of each [1].
    pub tangential: [f64; MOST_DOFS],
    /// Direction of the tangential force on each [1].
    pub drag: [f64; MOST_DOFS],
    /// Overclosure [L].
    pub overclosure: f64,
    /// Pressure: estimate in, solution out [F/L2].
    pub pressure: f64,
    /// Stiffness lent to K [F/L3].
    pub stiffness: f64,
    /// Friction, where it would be called for a closed point.
    pub sliding: Option<Sliding>,
}

impl LinearPoint {
    fn dot(&self, of: Kind, vector: &[f64]) -> f64 {
        let gradient = self.gradient(of);
        self.equations[..self.width].iter().zip(gradient).map(|(&e, g)| g * vector[e]).sum()
    }

    fn gradient(&self, of: Kind) -> &[f64] {
        match of {
            Kind::Normal => &self.normal[..self.width],
            Kind::Tangential => &self.tangential[..self.width],
        }
    }

    /// Direction of the force of a multiplier.
    fn force(&self, of: Kind) -> &[f64] {
        match of {
            Kind::Normal => &self.normal[..self.width],
            Kind::Tangential => &self.drag[..self.width],
        }
    }

    fn moves(&self, of: Kind) -> bool {
        self.gradient(of).iter().any(|&g| g != 0.0)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Normal,
    Tangential,
}

/// What a row of the small system stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unknown {
    /// A pressure or a traction of a point.
    Multiplier {
        point: usize,
        kind: Kind,
        /// Row of the same point's pressure (its own, for a pressure).
        pressure_row: usize,
    },
    /// The contact force of all stations on an equation.
    Interface { equation: usize },
}

/// One row of the small system.
#[derive(Clone, Copy, Debug)]
struct Row {
    unknown: Unknown,
    /// Overclosure, slip or displacement without any multiplier beyond the
    /// lent stiffness [L].
    free: f64,
    /// The same at the point of linearisation [L].
    start: f64,
    /// Lent stiffness [F/L3].
    lent: f64,
    /// Stiffness of the structure as the row feels it [F/L3].
    kappa: f64,
    /// Weight of its square in the norm, so that squares add up to an energy.
    weight: f64,
}

impl Row {
    /// The point of a pressure or traction.
    fn point(&self) -> Option<(usize, Kind)> {
        match self.unknown {
            Unknown::Multiplier { point, kind, .. } => Some((point, kind)),
            Unknown::Interface { .. } => None,
        }
    }
}

/// A station that takes part, with the rows of its equations.
#[derive(Clone, Copy, Debug)]
struct Station {
    point: usize,
    rows: [usize; MOST_DOFS],
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
    jacobian: Vec<f64>,
    /// dF/dd of the interface rows, row-major over all rows.
    stiffness: Vec<f64>,
    in_rows: Vec<bool>,
    /// du by the present estimate.
    moved: Vec<f64>,
    /// Displacements of the interface rows.
    values: Vec<f64>,
    stations: Vec<Station>,
}

/// The most rounds in which further points may join.
const ROUNDS: usize = 12;
/// The most iterations of the small system.
const ITERATIONS: usize = 40;
/// How often it is started again from settled pressures.
const RESTARTS: usize = 3;
/// Residual of the small system, relative to its multipliers, at which a step
/// that gains nothing means rounding, not a wrong set.
const ROUNDED: f64 = 1e-9;
/// Shortest fraction of a step that is tried.
const SHORTEST: f64 = 1e-3;

impl LinearisedContact {
    /// Makes room for `points` points of a system of `equations`, so that
    /// later iterations allocate nothing.
    pub fn reserve(&mut self, points: usize, equations: usize) {
        let rows = (2 * points).min(32);
        self.rows.reserve(rows);
        self.response.reserve(rows * equations);
        self.compliance.reserve(rows * rows);
        self.jacobian.reserve(rows * rows);
        for vector in [&mut self.unknown, &mut self.residual, &mut self.step, &mut self.trial] {
            vector.reserve(rows);
        }
        self.in_rows.reserve(points);
        self.moved.reserve(equations);
        self.values.reserve(rows);
    }

    /// Solves the linearised contact problem. `correction` holds -r on entry
    /// and du on return; `points` get their pressures and tractions.
    ///
    /// Errors: the solver's.
    pub fn solve(
        &mut self,
        points: &mut [LinearPoint],
        circumstances: &Circumstances<'_>,
        solver: &mut Solver,
        correction: &mut [f64],
    ) -> Result<(), SolveError> {
        solver.solve(correction)?;
        self.rows.clear();
        self.unknown.clear();
        self.response.clear();
        self.in_rows.clear();
        self.in_rows.resize(points.len(), false);
        self.stations.clear();
        // First those that touch already: without their pressures the
        // structure would spring back and seem to touch everywhere.
        let mut touching = true;
        for _ in 0..ROUNDS {
            let joined = self.admit(points, circumstances, touching, solver, correction)?;
            if joined {
                if touching {
                    self.press(points);
                }
                self.couple(points, correction);
                self.iterate(points, circumstances);
            } else if !touching {
                break;
            }
            touching = false;
        }
        self.hand_out(points, circumstances, correction);
        Ok(())
    }

    /// Lets points join that touch already (`touching`), or that would touch
    /// by the present estimate; says whether any did.
    fn admit(
        &mut self,
        points: &[LinearPoint],
        circumstances: &Circumstances<'_>,
        touching: bool,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<bool, SolveError> {
        if !touching {
            self.move_by_rows(base);
        }
        let mut joined = false;
        for (place, point) in points.iter().enumerate() {
            if self.in_rows[place] || !point.moves(Kind::Normal) {
                continue;
            }
            let joins = if touching {
                point.pressure > 0.0 || point.stiffness > 0.0
            } else {
                let begins = circumstances.laws[point.pair].normal.contact_begins();
                point.overclosure + point.dot(Kind::Normal, &self.moved) > begins
            };
            if !joins {
                continue;
            }
            self.in_rows[place] = true;
            joined = true;
            if point.integrated {
                self.add_station(point, place, solver, base)?;
                continue;
            }
            self.add_row(point, place, Kind::Normal, solver, base)?;
            if point.sliding.is_some() && point.moves(Kind::Tangential) {
                self.add_row(point, place, Kind::Tangential, solver, base)?;
            }
        }
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

    fn add_row(
        &mut self,
        point: &LinearPoint,
        place: usize,
        kind: Kind,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<(), SolveError> {
        let n = base.len();
        let begin = self.response.len();
        self.response.resize(begin + n, 0.0);
        let response = &mut self.response[begin..];
        for (&equation, g) in point.equations[..point.width].iter().zip(point.force(kind)) {
            response[equation] += point.area * g;
        }
        solver.solve(response)?;
        let (start, lent) = match (kind, &point.sliding) {
            (Kind::Tangential, Some(sliding)) => (sliding.slip, sliding.stiffness),
            _ => (point.overclosure, point.stiffness),
        };
        let pressure_row = match kind {
            Kind::Normal => self.rows.len(),
            Kind::Tangential => self.rows.len() - 1,
        };
        self.rows.push(Row {
            unknown: Unknown::Multiplier { point: place, kind, pressure_row },
            free: start + point.dot(kind, base),
            start,
            lent,
            kappa: 0.0,
            weight: 0.0,
        });
        let guess = match (kind, &point.sliding) {
            (Kind::Tangential, Some(sliding)) => sliding.traction,
            _ => point.pressure,
        };
        self.unknown.truncate(self.rows.len() - 1);
        self.unknown.push(guess);
        Ok(())
    }

    /// Lets a station join; its equations that no station has touched yet
    /// become rows.
    fn add_station(
        &mut self,
        point: &LinearPoint,
        place: usize,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<(), SolveError> {
        let mut station = Station { point: place, rows: [0; MOST_DOFS] };
        for (row, &equation) in station.rows.iter_mut().zip(&point.equations[..point.width]) {
            let known = Unknown::Interface { equation };
            let found = self.rows.iter().position(|row| row.unknown == known);
            *row = match found {
                Some(found) => found,
                None => self.add_interface(equation, solver, base)?,
            };
        }
        self.stations.push(station);
        Ok(())
    }

    fn add_interface(
        &mut self,
        equation: usize,
        solver: &mut Solver,
        base: &[f64],
    ) -> Result<usize, SolveError> {
        let n = base.len();
        let begin = self.response.len();
        self.response.resize(begin + n, 0.0);
        self.response[begin + equation] = 1.0;
        solver.solve(&mut self.response[begin..])?;
        self.rows.push(Row {
            unknown: Unknown::Interface { equation },
            free: base[equation],
            start: 0.0,
            lent: 0.0,
            kappa: 0.0,
            weight: 0.0,
        });
        self.unknown.truncate(self.rows.len() - 1);
        self.unknown.push(0.0);
        Ok(self.rows.len() - 1)
    }

    /// Starts the forces of the interface rows from the pressures and
    /// tractions that the iteration estimates.
    fn press(&mut self, points: &[LinearPoint]) {
        for station in &self.stations {
            let point = &points[station.point];
            let traction = point.sliding.map_or(0.0, |sliding| sliding.traction);
            for a in 0..point.width {
                let force = point.pressure * point.normal[a] + traction * point.drag[a];
                self.unknown[station.rows[a]] += point.area * force;
            }
        }
    }

    /// Fills C and the stiffness that each row feels.
    fn couple(&mut self, points: &[LinearPoint], base: &[f64]) {
        let (m, n) = (self.rows.len(), base.len());
        self.compliance.clear();
        self.compliance.resize(m * m, 0.0);
        for i in 0..m {
            for j in 0..m {
                let response = &self.response[j * n..][..n];
                self.compliance[i * m + j] = match self.rows[i].unknown {
                    Unknown::Multiplier { point, kind, .. } => points[point].dot(kind, response),
                    Unknown::Interface { equation } => response[equation],
                };
            }
        }
        for i in 0..m {
            let own = self.compliance[i * m + i];
            let row = &mut self.rows[i];
            row.kappa = if own > 0.0 { 1.0 / own } else { f64::INFINITY };
            let area = row.point().map_or(1.0, |(point, _)| points[point].area);
            row.weight = area * own.abs();
        }
    }

    /// Solves the small system: by Newton, and where Newton is lost among the
    /// active sets of a hard law, from the set that a pivoting method finds.
    fn iterate(&mut self, points: &[LinearPoint], circumstances: &Circumstances<'_>) {
        if self.newton(points, circumstances) {
            return;
        }
        for _ in 0..RESTARTS {
            if !self.settle_pressures(points, circumstances) || self.newton(points, circumstances) {
                return;
            }
        }
    }

    /// Semismooth Newton with backtracking; says whether it converged.
    fn newton(&mut self, points: &[LinearPoint], circumstances: &Circumstances<'_>) -> bool {
        let m = self.rows.len();
        for vector in [&mut self.residual, &mut self.step, &mut self.trial] {
            vector.clear();
            vector.resize(m, 0.0);
        }
        self.jacobian.clear();
        self.jacobian.resize(m * m, 0.0);
        self.stiffness.clear();
        self.stiffness.resize(if self.stations.is_empty() { 0 } else { m * m }, 0.0);
        self.values.resize(m, 0.0);
        let (stiffness, values) = (&mut self.stiffness, &mut self.values);
        let system =
            System { rows: &self.rows, compliance: &self.compliance, stations: &self.stations };
        let (residual, jacobian) = (&mut self.residual, &mut self.jacobian);
        let unknown = &mut self.unknown;
        let mut size = system.residual(
            (unknown, points),
            circumstances,
            residual,
            (jacobian, stiffness, values),
        );
        for _ in 0..ITERATIONS {
            if size == 0.0 || !size.is_finite() {
                return size == 0.0;
            }
            let rounded = size <= ROUNDED * ROUNDED * system.largest_multiplier(unknown);
            self.step.copy_from_slice(residual);
            eliminate(jacobian, &mut self.step);
            let mut length = 1.0;
            loop {
                for ((trial, q), step) in self.trial.iter_mut().zip(&*unknown).zip(&self.step) {
                    *trial = q - length * step;
                }
                let new = system.residual(
                    (&self.trial, points),
                    circumstances,
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
    /// p h = 0. Soft points keep their pressures. False: nothing to settle.
    fn settle_pressures(
        &mut self,
        points: &[LinearPoint],
        circumstances: &Circumstances<'_>,
    ) -> bool {
        let hard = |row: &Row| {
            let Some((point, kind)) = row.point() else { return false };
            let law = &circumstances.laws[points[point].pair].normal;
            kind == Kind::Normal && law.pressure(0.0).is_none()
        };
        let candidates: Vec<usize> =
            (0..self.rows.len()).filter(|&i| hard(&self.rows[i])).collect();
        if candidates.is_empty() {
            return false;
        }
        let system = System { rows: &self.rows, compliance: &self.compliance, stations: &[] };
        settle(&system, &candidates, &mut self.unknown);
        true
    }

    /// du from the multipliers, and the multipliers to their points.
    fn hand_out(
        &mut self,
        points: &mut [LinearPoint],
        circumstances: &Circumstances<'_>,
        correction: &mut [f64],
    ) {
        let n = correction.len();
        let system = System { rows: &self.rows, compliance: &self.compliance, stations: &[] };
        for (place, point) in points.iter_mut().enumerate() {
            if self.in_rows[place] {
                continue;
            }
            let fixed = !point.moves(Kind::Normal);
            let laws = &circumstances.laws[point.pair];
            point.pressure = if fixed { laws.pressure(point.overclosure, 0.0) } else { 0.0 };
            if let Some(sliding) = &mut point.sliding {
                sliding.traction = 0.0;
            }
        }
        for (i, row) in self.rows.iter().enumerate() {
            let Some((place, kind)) = row.point() else { continue };
            let (multiplier, value) = system.multiplier_and_value(i, &self.unknown);
            let point = &mut points[place];
            match (kind, &mut point.sliding) {
                (Kind::Tangential, Some(sliding)) => sliding.traction = multiplier,
                _ => {
                    let laws = &circumstances.laws[point.pair];
                    point.pressure = laws.demand_pressure(multiplier, value, row.kappa).value;
                }
            }
        }
        if !self.stations.is_empty() {
            self.values.clear();
            let values =
                (0..self.rows.len()).map(|i| system.multiplier_and_value(i, &self.unknown).1);
            self.values.extend(values);
        }
        for point in points.iter_mut() {
            circumstances.slide_as_prescribed(point);
        }
        for station in &self.stations {
            let point = &mut points[station.point];
            let answer = circumstances.station(station, point, &self.values);
            point.pressure = answer.pressure;
            if let Some(sliding) = &mut point.sliding {
                sliding.traction = answer.traction;
            }
        }
        for (i, &q) in self.unknown.iter().take(self.rows.len()).enumerate() {
            for (du, w) in correction.iter_mut().zip(&self.response[i * n..][..n]) {
                *du -= q * w;
            }
        }
    }
}

/// The small system: e = free - C q, lambda = q + s (e - start).
#[derive(Clone, Copy)]
struct System<'a> {
    rows: &'a [Row],
    compliance: &'a [f64],
    stations: &'a [Station],
}

impl System<'_> {
    fn multiplier_and_value(&self, i: usize, unknown: &[f64]) -> (f64, f64) {
        let m = self.rows.len();
        let row = &self.rows[i];
        let yielded: f64 =
            self.compliance[i * m..][..m].iter().zip(unknown).map(|(c, q)| c * q).sum();
        let value = row.free - yielded;
        (unknown[i] + row.lent * (value - row.start), value)
    }

    /// Largest multiplier in the squared norm of the residual.
    fn largest_multiplier(&self, unknown: &[f64]) -> f64 {
        (0..self.rows.len())
            .map(|i| {
                let multiplier = self.multiplier_and_value(i, unknown).0.abs();
                multiplier.max(unknown[i].abs()).powi(2) * self.rows[i].weight
            })
            .fold(f64::MIN_POSITIVE, f64::max)
    }

    /// F = lambda - law, its squared norm, and dF/dq.
    fn residual(
        &self,
        (unknown, points): (&[f64], &[LinearPoint]),
        circumstances: &Circumstances<'_>,
        residual: &mut [f64],
        (jacobian, stiffness, values): (&mut [f64], &mut [f64], &mut [f64]),
    ) -> f64 {
        if !self.stations.is_empty() {
            for (i, value) in values.iter_mut().enumerate() {
                *value = self.multiplier_and_value(i, unknown).1;
            }
            let known = (unknown, &*values, points);
            self.interface(known, circumstances, residual, (jacobian, stiffness));
        }
        for (i, row) in self.rows.iter().enumerate() {
            let Unknown::Multiplier { point, kind, pressure_row } = row.unknown else { continue };
            let (multiplier, value) = self.multiplier_and_value(i, unknown);
            let pressure = self.multiplier_and_value(pressure_row, unknown).0;
            let values = [multiplier, value, pressure];
            let demand = circumstances.demand(row, kind, &points[point], values);
            residual[i] = multiplier - demand.value;
            self.differentiate(i, pressure_row, &demand, jacobian);
        }
        residual.iter().zip(self.rows).map(|(f, row)| f * f * row.weight).sum()
    }

    /// dF/dq of a pressure or traction.
    fn differentiate(&self, i: usize, k: usize, demand: &Demand, jacobian: &mut [f64]) {
        let m = self.rows.len();
        for j in 0..m {
            // d value/dq_j = -C_ij, d lambda_i/dq_j = delta_ij - s C_ij
            let by_value = -self.compliance[i * m + j];
            let own = if i == j { 1.0 } else { 0.0 };
            let by_multiplier = own + self.rows[i].lent * by_value;
            let of_pressure =
                if j == k { 1.0 } else { 0.0 } - self.rows[k].lent * self.compliance[k * m + j];
            jacobian[i * m + j] = by_multiplier
                - demand.by_multiplier * by_multiplier
                - demand.by_value * by_value
                - demand.by_pressure * of_pressure;
        }
    }

    /// The rows of equations that stations press on: F = q - f(d), with f the
    /// force of all stations at the displacements d = free - C q.
    fn interface(
        &self,
        (unknown, values, points): (&[f64], &[f64], &[LinearPoint]),
        circumstances: &Circumstances<'_>,
        residual: &mut [f64],
        (jacobian, stiffness): (&mut [f64], &mut [f64]),
    ) {
        let m = self.rows.len();
        stiffness.fill(0.0);
        let is_interface = |i: &usize| self.rows[*i].point().is_none();
        for i in (0..m).filter(is_interface) {
            residual[i] = unknown[i];
        }
        for station in self.stations {
            let point = &points[station.point];
            let answer = circumstances.station(station, point, values);
            for a in 0..point.width {
                let i = station.rows[a];
                let (n, t) = (point.area * point.normal[a], point.area * point.drag[a]);
                residual[i] -= n * answer.force[0] + t * answer.force[1];
                for b in 0..point.width {
                    let (g, s) = (point.normal[b], point.tangential[b]);
                    let [[nn, nt], [tn, tt]] = answer.slope;
                    stiffness[i * m + station.rows[b]] +=
                        n * (nn * g + nt * s) + t * (tn * g + tt * s);
                }
            }
        }
        for i in (0..m).filter(is_interface) {
            let row = &mut jacobian[i * m..(i + 1) * m];
            row.fill(0.0);
            row[i] = 1.0;
            for k in 0..m {
                let by = stiffness[i * m + k];
                if by != 0.0 {
                    let compliance = &self.compliance[k * m..(k + 1) * m];
                    row.iter_mut().zip(compliance).for_each(|(sum, c)| *sum += by * c);
                }
            }
        }
    }
}

/// A station at the displacements of the small system.
struct StationAnswer {
    pressure: f64,
    traction: f64,
    /// Pressure and traction less what the lent stiffness carries [F/L2].
    force: [f64; 2],
    /// Their derivatives by overclosure and slip [F/L3].
    slope: [[f64; 2]; 2],
}

impl Circumstances<'_> {
    /// What the law of a row demands of its multiplier.
    fn demand(
        &self,
        row: &Row,
        kind: Kind,
        point: &LinearPoint,
        [multiplier, value, pressure]: [f64; 3],
    ) -> Demand {
        let laws = &self.laws[point.pair];
        match (kind, &point.sliding) {
            (Kind::Tangential, Some(sliding)) => {
                let pressure = if self.symmetrised { point.pressure } else { pressure };
                let values = [multiplier, value, pressure];
                let demand = self.demand_traction(laws, values, sliding, row.kappa);
                if self.symmetrised { Demand { by_pressure: 0.0, ..demand } } else { demand }
            }
            _ => laws.demand_pressure(multiplier, value, row.kappa),
        }
    }

    /// A slip that is prescribed leaves exact stick no choice: there is no
    /// row that would carry it to the limit.
    fn slide_as_prescribed(&self, point: &mut LinearPoint) {
        if point.integrated || point.moves(Kind::Tangential) {
            return;
        }
        let (friction, pressure) = (&self.laws[point.pair].friction, point.pressure);
        if let Some(sliding) = &mut point.sliding
            && friction.needs_multiplier()
            && sliding.slip.abs() > self.rounding
        {
            let limit = friction.limit_traction(pressure, sliding.slip, self.dt);
            if limit.is_finite() {
                sliding.traction = limit * sliding.slip.signum();
            }
        }
    }

    /// A station with its laws inserted: among many stations of one element
    /// none has a multiplier of its own.
    fn station(&self, station: &Station, point: &LinearPoint, values: &[f64]) -> StationAnswer {
        let (mut normal, mut tangential) = (0.0, 0.0);
        for a in 0..point.width {
            let d = values[station.rows[a]];
            normal += point.normal[a] * d;
            tangential += point.tangential[a] * d;
        }
        let laws = &self.laws[point.pair];
        let demand = laws.demand_pressure(0.0, point.overclosure + normal, f64::INFINITY);
        let mut answer = StationAnswer {
            pressure: demand.value,
            traction: 0.0,
            force: [demand.value - point.stiffness * normal, 0.0],
            slope: [[demand.by_value - point.stiffness, 0.0], [0.0, 0.0]],
        };
        if let Some(sliding) = &point.sliding {
            let limit = if self.symmetrised { point.pressure } else { demand.value };
            let values = [sliding.traction, sliding.slip + tangential, limit];
            let drag = self.demand_traction(laws, values, sliding, f64::INFINITY);
            let by_pressure = if self.symmetrised { 0.0 } else { drag.by_pressure };
            answer.traction = drag.value;
            answer.force[1] = drag.value - sliding.stiffness * tangential;
            answer.slope[1] = [by_pressure * demand.by_value, drag.by_value - sliding.stiffness];
        }
        answer
    }

    fn demand_traction(
        &self,
        laws: &Laws,
        values: [f64; 3],
        sliding: &Sliding,
        kappa: f64,
    ) -> Demand {
        let (begin, size) = sliding.memory;
        let committed = self.committed.get(begin..begin + size).unwrap_or(&[]);
        // Only a user law has a memory, and only then does this allocate.
        let mut state = committed.to_vec();
        let mut memory =
            UserMemory { time: self.time, committed, state: &mut state, fault: &mut None };
        laws.demand_traction(values, sliding.elastic_slip, (kappa, self.dt), &mut memory)
    }
}
