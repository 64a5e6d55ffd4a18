//! A step towards the least energy for fixed limits of friction: the laws inserted, their slopes.

use super::context::LawContext;
use super::points::{Kind, LinearPoint, LinearPoints};
use super::rows::{Row, RowSlopes, Unknown};
use super::system::{System, eliminate_in_units};
use slideline_linalg::DenseLu;
use slideline_mech::contact::enforcement::{Complementarity, TangentialComplementarity};
use slideline_mech::contact::tangential::{Tangential, TangentialMap};

/// Stiffness that stands for a hard law or exact stick, in those that the
/// structure has at the point [1].
const STIFF: f64 = 1e5;
/// Equations of a point that room is kept for.
const ROWS: usize = 18;

/// Scratch of a descent, kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Descent {
    /// Points with the pressures that limit friction.
    pub(super) held: LinearPoints,
    /// Unknowns at the beginning of a step.
    pub(super) from: Vec<f64>,
    pub(super) step: Vec<f64>,
    /// A C step: how the energy falls with the residual of each row.
    pub(super) push: Vec<f64>,
    pub(super) residual: Vec<f64>,
    pub(super) jacobian: Vec<f64>,
    pub(super) factors: DenseLu,
    pub(super) stiffness: Vec<f64>,
    pub(super) values: Vec<f64>,
    /// Whether slopes are those of stick, sliding or not.
    pub(super) steepest: bool,
    /// Steps of the last descent, over all rounds.
    pub(super) steps: usize,
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
    pub(super) fn make_room(&mut self, m: usize) {
        let Self { from, step, push, residual, jacobian, stiffness, values, .. } = self;
        [from, step, push, residual, values].into_iter().for_each(|list| list.resize(m, 0.0));
        [jacobian, stiffness].into_iter().for_each(|square| square.resize(m * m, 0.0));
        self.steepest = false;
    }

    /// F = lambda - law with the laws inserted, and dF/dq; its weighted square.
    pub(super) fn evaluate(
        &mut self,
        system: &System<'_>,
        unknown: &[f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) -> f64 {
        self.residual_at(system, (unknown, true), points, fixed);
        let squares = self.residual.iter().zip(system.rows).map(|(f, row)| f * f * row.weight);
        squares.sum()
    }

    /// F alone, which is all that the slope along a known step asks for.
    pub(super) fn settle(
        &mut self,
        system: &System<'_>,
        unknown: &[f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) {
        self.residual_at(system, (unknown, false), points, fixed);
    }

    /// F, and its derivatives where they are `wanted`.
    fn residual_at(
        &mut self,
        system: &System<'_>,
        (unknown, wanted): (&[f64], bool),
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) {
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
                if wanted {
                    system.differentiate(i, &slopes, &mut self.jacobian);
                }
            });
        }
    }

    /// The step, J step = F, and what the energy says of it.
    pub(super) fn find_step(&mut self, system: &System<'_>) {
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
    pub(super) fn slope(&self) -> f64 {
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
    pub(super) fn inserted_pressure(
        &self,
        row: &Row,
        point: &LinearPoint,
        value: f64,
    ) -> Complementarity {
        let laws = &self.laws[point.law];
        let stiff = STIFF * row.felt;
        match laws.normal.pressure(0.0) {
            None if value > 0.0 || laws.normal.is_bonded() => {
                Complementarity::inserted(stiff * value, stiff)
            }
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
        let laws = &self.laws[point.law];
        let Some(sliding) = &point.sliding else { return TangentialComplementarity::default() };
        if !laws.friction.needs_multiplier() {
            let values = (sliding.traction, slip, point.pressure);
            let answer = self.complementarity_of_traction(laws, values, sliding, f64::INFINITY);
            return TangentialComplementarity { by_pressure: Tangential::ZERO, ..answer };
        }
        let stiff = STIFF * row.felt;
        let limit = laws.limit_traction(point.pressure, sliding.slip, self.dt);
        let ellipse = laws.friction.ellipse();
        let tau = stiff * ellipse.slip_on_circle(slip);
        let (value, by_value) = match tau.size() <= limit {
            true => (tau, TangentialMap::isotropic(stiff)),
            false => {
                let way = tau.direction();
                (limit * way, TangentialMap::across(way, stiff * limit / tau.size()))
            }
        };
        TangentialComplementarity {
            value: ellipse.traction(value),
            by_value: ellipse.stiffness(by_value),
            ..TangentialComplementarity::default()
        }
    }
}
