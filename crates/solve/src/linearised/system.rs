//! The condensed contact problem of one Newton iteration: its residual and slope.

use super::context::LawContext;
use super::points::LinearPoints;
use super::rows::{IntegrationPoints, Row, RowSlopes};
use slideline_linalg::DenseLu;

/// The condensed contact problem: e = free - C q, lambda = q + s (e - start).
#[derive(Clone, Copy)]
pub(super) struct System<'a> {
    pub rows: &'a [Row],
    pub compliance: &'a [f64],
    pub integration_points: &'a IntegrationPoints,
}

impl System<'_> {
    pub(super) fn multiplier_and_value(&self, i: usize, unknown: &[f64]) -> (f64, f64) {
        let m = self.rows.len();
        let row = &self.rows[i];
        let yielded: f64 =
            self.compliance[i * m..][..m].iter().zip(unknown).map(|(c, q)| c * q).sum();
        let value = row.free - yielded;
        (unknown[i] + row.augmentation * (value - row.start), value)
    }

    /// Largest multiplier in the squared norm of the residual.
    pub(super) fn largest_multiplier(&self, unknown: &[f64]) -> f64 {
        (0..self.rows.len())
            .map(|i| {
                let multiplier = self.multiplier_and_value(i, unknown).0.abs();
                multiplier.max(unknown[i].abs()).powi(2) * self.rows[i].weight
            })
            .fold(f64::MIN_POSITIVE, f64::max)
    }

    /// F = lambda - law, its squared norm, and dF/dq.
    pub(super) fn residual(
        &self,
        (unknown, points): (&[f64], &LinearPoints),
        context: &LawContext<'_>,
        residual: &mut [f64],
        (jacobian, stiffness, values): (&mut [f64], &mut [f64], &mut [f64]),
    ) -> f64 {
        if !self.integration_points.is_empty() {
            for (i, value) in values.iter_mut().enumerate() {
                *value = self.multiplier_and_value(i, unknown).1;
            }
            let known = (unknown, &*values, points);
            self.interface(known, context, residual, (jacobian, stiffness));
        }
        let asked = |i: usize| self.multiplier_and_value(i, unknown);
        for i in 0..self.rows.len() {
            context.ask(self.rows, i, points, asked, |i, multiplier, slopes| {
                residual[i] = multiplier - slopes.value;
                self.differentiate(i, &slopes, jacobian);
            });
        }
        residual.iter().zip(self.rows).map(|(f, row)| f * f * row.weight).sum()
    }

    /// dF/dq of a pressure or traction.
    pub(super) fn differentiate(&self, i: usize, slopes: &RowSlopes, jacobian: &mut [f64]) {
        let m = self.rows.len();
        let k = self.rows[i].pressure_row().unwrap_or(i);
        for j in 0..m {
            // d value/dq_j = -C_ij, d lambda_i/dq_j = delta_ij - s C_ij
            let by_value = |i: usize| -self.compliance[i * m + j];
            let by_multiplier = |i: usize| {
                let own = if i == j { 1.0 } else { 0.0 };
                own + self.rows[i].augmentation * by_value(i)
            };
            let mut entry = by_multiplier(i);
            for (row, multiplier, value) in slopes.each() {
                entry = entry - multiplier * by_multiplier(row) - value * by_value(row);
            }
            if slopes.by_pressure != 0.0 {
                entry -= slopes.by_pressure * by_multiplier(k);
            }
            jacobian[i * m + j] = entry;
        }
    }

    /// The rows of equations that integration_points press on: F = q - f(d), with f the
    /// force of all integration_points at the displacements d = free - C q.
    pub(super) fn interface(
        &self,
        (unknown, values, points): (&[f64], &[f64], &LinearPoints),
        context: &LawContext<'_>,
        residual: &mut [f64],
        (jacobian, stiffness): (&mut [f64], &mut [f64]),
    ) {
        let m = self.rows.len();
        stiffness.fill(0.0);
        let is_interface = |i: &usize| self.rows[*i].point().is_none();
        for i in (0..m).filter(is_interface) {
            residual[i] = unknown[i];
        }
        for integration_point in self.integration_points.iter() {
            let point = points.at(integration_point.point);
            let answer = context.integration_point(integration_point, &point, values);
            if answer.is_idle() {
                continue;
            }
            for (a, &i) in integration_point.rows.iter().enumerate() {
                residual[i] -= point.area * point.force_at(a, answer.normal, answer.tangential);
            }
            let rows = integration_point.rows;
            answer.add_slope(&point, |a, b, slope| stiffness[rows[a] * m + rows[b]] += slope);
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
