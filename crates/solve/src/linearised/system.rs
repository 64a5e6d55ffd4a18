//! The condensed contact problem of one Newton iteration: its residual and slope.

use super::context::LawContext;
use super::laws::{LawAnswers, PointAnswer};
use super::points::LinearPoints;
use super::rows::{IntegrationPoints, Row, RowSlopes};
use slideline_linalg::DenseLu;

/// Unknowns, the values that they give, and the points.
pub(super) type Estimate<'a> = (&'a [f64], &'a [f64], &'a LinearPoints);

/// The condensed contact problem: e = free - C q, lambda = q + s (e - start).
#[derive(Clone, Copy)]
pub(super) struct System<'a> {
    pub rows: &'a [Row],
    pub compliance: &'a [f64],
    pub integration_points: &'a IntegrationPoints,
}

impl System<'_> {
    /// C v.
    pub(super) fn product(&self, v: &[f64], into: &mut [f64]) {
        for (sum, compliance) in into.iter_mut().zip(self.compliance.chunks_exact(v.len())) {
            *sum = compliance.iter().zip(v).map(|(c, v)| c * v).sum();
        }
    }

    /// e of all rows.
    pub(super) fn values(&self, unknown: &[f64], values: &mut [f64]) {
        self.product(unknown, values);
        values.iter_mut().zip(self.rows).for_each(|(value, row)| *value = row.free - *value);
    }

    pub(super) fn multiplier_and_value(&self, i: usize, unknown: &[f64]) -> (f64, f64) {
        let m = self.rows.len();
        let yielded: f64 =
            self.compliance[i * m..][..m].iter().zip(unknown).map(|(c, q)| c * q).sum();
        let value = self.rows[i].free - yielded;
        (self.multiplier(i, unknown[i], value), value)
    }

    fn multiplier(&self, i: usize, unknown: f64, value: f64) -> f64 {
        let row = &self.rows[i];
        unknown + row.augmentation * (value - row.start)
    }

    /// Largest multiplier in the squared norm of the residual.
    pub(super) fn largest_multiplier(&self, unknown: &[f64], values: &[f64]) -> f64 {
        let of = |(i, row): (usize, &Row)| {
            let multiplier = self.multiplier(i, unknown[i], values[i]);
            multiplier.abs().max(unknown[i].abs()).powi(2) * row.weight
        };
        self.rows.iter().enumerate().map(of).fold(f64::MIN_POSITIVE, f64::max)
    }

    /// F = lambda - law at the unknowns and their values, and what the laws say; its weighted
    /// square.
    pub(super) fn residual(
        &self,
        (unknown, values, points): Estimate<'_>,
        context: &LawContext<'_>,
        residual: &mut [f64],
        laws: &mut LawAnswers,
    ) -> f64 {
        self.interface((unknown, values, points), context, residual, &mut laws.points);
        let asked = |i: usize| (self.multiplier(i, unknown[i], values[i]), values[i]);
        for i in 0..self.rows.len() {
            context.ask(self.rows, i, points, asked, |i, multiplier, answer| {
                residual[i] = multiplier - answer.value;
                laws.rows[i] = answer;
            });
        }
        self.size(residual)
    }

    /// The same with the laws inserted and the limits of friction held, `steepest`: with the
    /// slopes of stick.
    pub(super) fn residual_of_inserted(
        &self,
        (unknown, values, points): Estimate<'_>,
        (fixed, steepest): (&LawContext<'_>, bool),
        residual: &mut [f64],
        laws: &mut LawAnswers,
    ) -> f64 {
        self.interface((unknown, values, points), fixed, residual, &mut laws.points);
        for i in 0..self.rows.len() {
            fixed.insert(self.rows, i, points, (values, steepest), |i, answer| {
                residual[i] = self.multiplier(i, unknown[i], values[i]) - answer.value;
                laws.rows[i] = answer;
            });
        }
        self.size(residual)
    }

    fn size(&self, residual: &[f64]) -> f64 {
        residual.iter().zip(self.rows).map(|(f, row)| f * f * row.weight).sum()
    }

    /// The rows of equations that integration points press on: F = q - f(d), with f the
    /// force of all integration points at the displacements d.
    fn interface(
        &self,
        (unknown, values, points): Estimate<'_>,
        context: &LawContext<'_>,
        residual: &mut [f64],
        answers: &mut [PointAnswer],
    ) {
        residual.copy_from_slice(unknown);
        for (integration_point, answer) in self.integration_points.iter().zip(answers) {
            let point = points.at(integration_point.point);
            *answer = context.integration_point(integration_point, &point, values);
            if answer.is_idle() {
                continue;
            }
            for (a, &i) in integration_point.rows.iter().enumerate() {
                residual[i] -= point.area * point.force_at(a, answer.normal, answer.tangential);
            }
        }
    }

    /// dF/dq by what the laws said; `stiffness` is scratch for df/dd of the interface.
    pub(super) fn jacobian(
        &self,
        points: &LinearPoints,
        laws: &LawAnswers,
        jacobian: &mut [f64],
        stiffness: &mut [f64],
    ) {
        let m = self.rows.len();
        stiffness.fill(0.0);
        for (integration_point, answer) in self.integration_points.iter().zip(&laws.points) {
            if !answer.is_idle() {
                let (point, rows) = (points.at(integration_point.point), integration_point.rows);
                answer.add_slope(&point, |a, b, slope| stiffness[rows[a] * m + rows[b]] += slope);
            }
        }
        for (i, derivatives) in jacobian.chunks_exact_mut(m).enumerate() {
            derivatives.fill(0.0);
            derivatives[i] = 1.0;
            match self.rows[i].pressure_row() {
                Some(pressure_row) => {
                    self.differentiate((i, pressure_row), &laws.rows[i], derivatives);
                }
                None => {
                    for (k, &by) in stiffness[i * m..][..m].iter().enumerate() {
                        self.add_compliance(by, k, derivatives);
                    }
                }
            }
        }
    }

    /// dF/dq of a pressure or traction, with d value/dq_j = -C_ij and
    /// d lambda_i/dq_j = delta_ij - s C_ij.
    fn differentiate(
        &self,
        (i, pressure_row): (usize, usize),
        slopes: &RowSlopes,
        derivatives: &mut [f64],
    ) {
        let augmentation = |row: usize| self.rows[row].augmentation;
        // the row's own compliance at once: where law and multiplier say the same, nothing is left
        let mut own = -augmentation(i);
        for (row, by_multiplier, by_value) in slopes.each() {
            derivatives[row] -= by_multiplier;
            let by = by_multiplier * augmentation(row) + by_value;
            match row == i {
                true => own += by,
                false => self.add_compliance(by, row, derivatives),
            }
        }
        if slopes.by_pressure != 0.0 {
            derivatives[pressure_row] -= slopes.by_pressure;
            let by = slopes.by_pressure * augmentation(pressure_row);
            self.add_compliance(by, pressure_row, derivatives);
        }
        self.add_compliance(own, i, derivatives);
    }

    /// Adds so much of row `row` of C.
    fn add_compliance(&self, by: f64, row: usize, derivatives: &mut [f64]) {
        if by != 0.0 {
            let compliance = &self.compliance[row * self.rows.len()..];
            derivatives.iter_mut().zip(compliance).for_each(|(sum, c)| *sum += by * c);
        }
    }
}

/// Where a way of so much along `step` leads from `from`.
pub(super) fn go((from, length, step): (&[f64], f64, &[f64]), to: &mut [f64]) {
    for ((to, from), step) in to.iter_mut().zip(from).zip(step) {
        *to = from + length * step;
    }
}

/// Eliminates with every row and column in the unit of its force, so that no
/// choice of a pivot depends on how forces and lengths are measured.
pub(super) fn eliminate_in_units(
    rows: &[Row],
    jacobian: &[f64],
    factors: &mut DenseLu,
    step: &mut [f64],
) {
    let scaled = factors.matrix_mut(rows.len()).chunks_exact_mut(rows.len());
    for (i, (scaled, row)) in scaled.zip(jacobian.chunks_exact(rows.len())).enumerate() {
        let own = rows[i].unit;
        step[i] /= own;
        for ((scaled, entry), other) in scaled.iter_mut().zip(row).zip(rows) {
            *scaled = entry * (other.unit / own);
        }
    }
    factors.factor();
    // as many equations as were factored: it cannot fail
    let _ = factors.solve(step);
    step.iter_mut().zip(rows).for_each(|(step, row)| *step *= row.unit);
}
