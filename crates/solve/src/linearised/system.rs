//! The small system of one Newton iteration: its rows, residual and slope.

use super::{Kind, LawContext, LinearPoint, MOST_DOFS};
use slideline_mech::contact::enforcement::Complementarity;

/// What a row of the small system stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unknown {
    /// A pressure or a traction of a point.
    Multiplier {
        point: usize,
        kind: Kind,
        /// Row of the same point's pressure (its own, for a pressure).
        pressure_row: usize,
    },
    /// The contact force of all integration_points on an equation.
    Interface { equation: usize },
}

/// One row of the small system.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub unknown: Unknown,
    /// Overclosure, slip or displacement without any multiplier beyond the
    /// augmentation stiffness [L].
    pub free: f64,
    /// The same at the point of linearisation [L].
    pub start: f64,
    /// Lent stiffness [F/L3].
    pub augmentation: f64,
    /// Stiffness of the structure as the row feels it [F/L3].
    pub kappa: f64,
    /// What is left of it without the augmentation [F/L3].
    pub own: f64,
    /// Stiffness of the structure as the row feels it, with its augmentation [F/L3].
    pub felt: f64,
    /// Natural unit of its unknown: that of one force.
    pub unit: f64,
    /// Weight of its square in the norm, so that squares add up to an energy.
    pub weight: f64,
}

impl Row {
    /// A row of which nothing else is known.
    pub(super) fn new(unknown: Unknown) -> Self {
        Self {
            unknown,
            free: 0.0,
            start: 0.0,
            augmentation: 0.0,
            kappa: 0.0,
            own: 0.0,
            felt: 0.0,
            unit: 1.0,
            weight: 0.0,
        }
    }

    /// The point of a pressure or traction.
    pub(super) fn point(&self) -> Option<(usize, Kind)> {
        match self.unknown {
            Unknown::Multiplier { point, kind, .. } => Some((point, kind)),
            Unknown::Interface { .. } => None,
        }
    }
}

/// A integration_point that takes part, with the rows of its equations.
#[derive(Clone, Copy, Debug)]
pub(super) struct IntegrationPoint {
    pub point: usize,
    pub rows: [usize; MOST_DOFS],
}

/// The small system: e = free - C q, lambda = q + s (e - start).
#[derive(Clone, Copy)]
pub(super) struct System<'a> {
    pub rows: &'a [Row],
    pub compliance: &'a [f64],
    pub integration_points: &'a [IntegrationPoint],
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
        (unknown, points): (&[f64], &[LinearPoint]),
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
        for (i, row) in self.rows.iter().enumerate() {
            let Unknown::Multiplier { point, kind, pressure_row } = row.unknown else { continue };
            let (multiplier, value) = self.multiplier_and_value(i, unknown);
            let pressure = self.multiplier_and_value(pressure_row, unknown).0;
            let values = [multiplier, value, pressure];
            let complementarity = context.complementarity(row, kind, &points[point], values);
            residual[i] = multiplier - complementarity.value;
            self.differentiate(i, pressure_row, &complementarity, jacobian);
        }
        residual.iter().zip(self.rows).map(|(f, row)| f * f * row.weight).sum()
    }

    /// dF/dq of a pressure or traction.
    pub(super) fn differentiate(
        &self,
        i: usize,
        k: usize,
        complementarity: &Complementarity,
        jacobian: &mut [f64],
    ) {
        let m = self.rows.len();
        for j in 0..m {
            // d value/dq_j = -C_ij, d lambda_i/dq_j = delta_ij - s C_ij
            let by_value = -self.compliance[i * m + j];
            let own = if i == j { 1.0 } else { 0.0 };
            let by_multiplier = own + self.rows[i].augmentation * by_value;
            let of_pressure = if j == k { 1.0 } else { 0.0 }
                - self.rows[k].augmentation * self.compliance[k * m + j];
            jacobian[i * m + j] = by_multiplier
                - complementarity.by_multiplier * by_multiplier
                - complementarity.by_value * by_value
                - complementarity.by_pressure * of_pressure;
        }
    }

    /// The rows of equations that integration_points press on: F = q - f(d), with f the
    /// force of all integration_points at the displacements d = free - C q.
    pub(super) fn interface(
        &self,
        (unknown, values, points): (&[f64], &[f64], &[LinearPoint]),
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
        for integration_point in self.integration_points {
            let point = &points[integration_point.point];
            let answer = context.integration_point(integration_point, point, values);
            if answer.is_idle() {
                continue;
            }
            let rows = &integration_point.rows[..point.width];
            for (a, &i) in rows.iter().enumerate() {
                residual[i] -= point.area
                    * (point.normal[a] * answer.force[0] + point.direction[a] * answer.force[1]);
            }
            answer.add_slope(point, rows, m, stiffness);
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
