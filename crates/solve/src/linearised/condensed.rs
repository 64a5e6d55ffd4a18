//! The condensed contact problem: rows of the points that take part, what they feel, and what the
//! points are given of the solution.

use super::compliance::MatrixFree;
use super::context::LawContext;
use super::descent::Descent;
use super::laws::PointAnswer;
use super::points::{Kind, LinearPoint, LinearPoints, LinearRows, Sliding};
use super::rows::{IntegrationPoints, Row, Unknown};
use super::step_room::StepRoom;
use slideline_mech::contact::tangential::Tangential;
use std::collections::HashMap;

/// Scratch of the condensed contact problem, kept from iteration to iteration.
#[derive(Clone, Debug, Default)]
pub struct LinearisedContact {
    pub(super) rows: Vec<Row>,
    /// K^-1 A v of each row, one after the other.
    pub(super) response: Vec<f64>,
    /// C = V W, row-major.
    pub(super) compliance: Vec<f64>,
    pub(super) unknown: Vec<f64>,
    /// Multipliers at which the base of the matrix-free way stands.
    pub(super) anchor: Vec<f64>,
    pub(super) room: StepRoom,
    /// Stiffnesses that the rows feel, while others are tried.
    pub(super) felt: Vec<f64>,
    /// Unknowns where the first way left them.
    pub(super) begun: Vec<f64>,
    pub(super) in_rows: Vec<bool>,
    /// du by the present estimate.
    pub(super) moved: Vec<f64>,
    pub(super) integration_points: IntegrationPoints,
    /// Rows of equations that integration_points press on.
    pub(super) interface: HashMap<usize, usize>,
    pub(super) matrix_free: MatrixFree,
    /// What inserted laws say, a point each.
    pub(super) inserted: Vec<PointAnswer>,
    pub(super) descent: Descent,
    /// Whether the laws of all rows were met in the last solution.
    pub(super) solved: bool,
}

/// The most rounds in which further points may join.
pub(super) const ROUNDS: usize = 12;

/// Equations of a point that room is kept for.
const ROWS: usize = 18;

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
        [&mut self.unknown, &mut self.begun, &mut self.felt]
            .into_iter()
            .for_each(|vector| vector.reserve(rows));
        self.room.reserve(rows, points);
        self.descent.held.reserve(points, ROWS);
        self.in_rows.reserve(points);
        self.inserted.reserve(points);
        self.moved.reserve(equations);
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

    /// Whether a point touches already (`touching`), or would by the present
    /// estimate of du.
    pub(super) fn joins(
        &self,
        point: &LinearRows<'_>,
        context: &LawContext<'_>,
        touching: bool,
    ) -> bool {
        if !point.takes_part(&context.laws[point.law]) {
            return false;
        }
        if touching {
            return point.pressure > 0.0 || point.stiffness > 0.0;
        }
        let begins = context.laws[point.law].normal.contact_begins();
        point.overclosure + point.dot(Kind::Normal, &self.moved) > begins
    }

    /// A row for the pressure or the traction of a point, with its first guess.
    pub(super) fn push_row(&mut self, point: &LinearPoint, place: usize, kind: Kind) {
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
    pub(super) fn push_interface(&mut self, equation: usize, unit: f64) -> usize {
        let place = self.rows.len();
        self.rows.push(Row { unit: 1.0 / unit, ..Row::new(Unknown::Interface { equation }) });
        self.interface.insert(equation, place);
        self.unknown.truncate(place);
        self.unknown.push(0.0);
        place
    }

    /// Points without rows press as their law says where nothing moves them,
    /// and not at all elsewhere.
    pub(super) fn release_others(&self, points: &mut LinearPoints, context: &LawContext<'_>) {
        for place in (0..points.len()).filter(|&place| !self.in_rows[place]) {
            let fixed = !points.at(place).moves(Kind::Normal);
            let point = &mut points[place];
            let laws = &context.laws[point.law];
            point.pressure = if fixed { laws.pressure(point.overclosure, 0.0) } else { 0.0 };
            point.set_traction(Tangential::ZERO);
        }
    }

    /// Gives the integration points what their laws say at the displacements found.
    pub(super) fn give_integration_points(
        &self,
        points: &mut LinearPoints,
        context: &LawContext<'_>,
    ) {
        for place in 0..points.len() {
            if let Some(traction) = context.prescribed_sliding(&points.at(place)) {
                points[place].set_traction(traction);
            }
        }
        for integration_point in self.integration_points.iter() {
            let place = integration_point.point;
            let answer =
                context.integration_point(integration_point, &points.at(place), &self.room.values);
            points[place].pressure = answer.pressure;
            points[place].set_traction(answer.traction);
        }
    }
}

/// Gives a point its multiplier, of the overclosure or slip found and the
/// stiffness that the law was asked through.
pub(super) fn give_multiplier(
    point: &mut LinearPoint,
    context: &LawContext<'_>,
    kind: Kind,
    [multiplier, value, kappa]: [f64; 3],
) {
    match (kind, &mut point.sliding) {
        (Kind::Tangential(direction), Some(sliding)) => sliding.traction.0[direction] = multiplier,
        _ => {
            let laws = &context.laws[point.law];
            point.pressure = laws.complementarity_of_pressure(multiplier, value, kappa).value;
        }
    }
}
