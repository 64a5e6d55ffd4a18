//! The slopes of the laws about an estimate: the operator of GMRES, and what preconditions it.
//!
//! ```text
//!   J v = (1 - dL/dlambda)(v - c C v) + dL/de C v         C v: one solution
//!   J with C as the diagonal of the point's own equations: a small block a point
//! ```
//!
//! docs/theory.md eq. (8.27).

use super::laws::LawAnswers;
use super::points::LinearPoints;
use super::rows::{IntegrationPoints, Row, Unknown};
use slideline_mech::contact::tangential::MOST_DIRECTIONS;

/// The slopes of the laws about an estimate.
pub(super) struct Slopes<'a> {
    pub rows: &'a [Row],
    pub integration_points: &'a IntegrationPoints,
    pub points: &'a LinearPoints,
    pub laws: &'a LawAnswers,
}

impl Slopes<'_> {
    /// J v, with w = C v known.
    pub(super) fn product(&self, v: &[f64], w: &[f64], into: &mut [f64]) {
        let multiplier = |i: usize| v[i] - self.rows[i].augmentation * w[i];
        for (i, (row, slopes)) in self.rows.iter().zip(&self.laws.rows).enumerate() {
            into[i] = match row.unknown {
                Unknown::Multiplier { pressure_row, .. } => {
                    let mut sum = multiplier(i);
                    for (other, by_multiplier, by_value) in slopes.each() {
                        sum += by_value * w[other] - by_multiplier * multiplier(other);
                    }
                    sum - slopes.by_pressure * multiplier(pressure_row)
                }
                Unknown::Interface { .. } => v[i],
            };
        }
        for (integration_point, answer) in self.integration_points.iter().zip(&self.laws.points) {
            if answer.is_idle() {
                continue;
            }
            let point = self.points.at(integration_point.point);
            let (normal, slip) = point.values(|k| w[integration_point.rows[k]]);
            let (normal, tangential) = answer.change(normal, slip);
            let (normal, tangential) = (point.area * normal, point.area * tangential);
            for (a, &i) in integration_point.rows.iter().enumerate() {
                into[i] += point.force_at(a, normal, tangential);
            }
        }
    }

    /// The inverse of J with C taken as its diagonal would be of the point's own
    /// equations; in the norm of the energy.
    pub(super) fn precondition(&self, x: &[f64], into: &mut [f64]) {
        let mut i = 0;
        while i < self.rows.len() {
            let slopes = &self.laws.rows[i];
            match self.rows[i].unknown {
                Unknown::Interface { .. } => {
                    into[i] = x[i];
                    i += 1;
                }
                Unknown::Multiplier { pressure_row, .. } => {
                    self.precondition_point((i, slopes.count.max(1)), pressure_row, x, into);
                    i += slopes.count.max(1);
                }
            }
        }
    }

    /// The rows `first` and on of one kind at a point.
    fn precondition_point(
        &self,
        (first, count): (usize, usize),
        pressure_row: usize,
        x: &[f64],
        into: &mut [f64],
    ) {
        let own = |row: &Row| {
            let compliance = if row.felt > 0.0 { 1.0 / (row.felt + row.augmentation) } else { 0.0 };
            (1.0 - row.augmentation * compliance, compliance)
        };
        let mut right = [0.0; MOST_DIRECTIONS];
        let mut block = [[0.0; MOST_DIRECTIONS]; MOST_DIRECTIONS];
        let (multiplier, compliance) = own(&self.rows[first]);
        for k in 0..count {
            let (row, slopes) = (&self.rows[first + k], &self.laws.rows[first + k]);
            right[k] = x[first + k];
            if pressure_row != first && slopes.by_pressure != 0.0 {
                let pressure = &self.rows[pressure_row];
                let scale = (row.weight / pressure.weight).sqrt();
                right[k] += slopes.by_pressure * own(pressure).0 * into[pressure_row] * scale;
            }
            for (l, entry) in block[k].iter_mut().enumerate().take(count) {
                let unit = if k == l { 1.0 } else { 0.0 };
                *entry =
                    multiplier * (unit - slopes.by_multiplier[l]) + slopes.by_value[l] * compliance;
            }
        }
        solve_block(&block, &mut right, count);
        into[first..first + count].copy_from_slice(&right[..count]);
    }
}

/// Solves one or two equations; those that say nothing leave the right side as it is.
fn solve_block(
    block: &[[f64; MOST_DIRECTIONS]; MOST_DIRECTIONS],
    right: &mut [f64; MOST_DIRECTIONS],
    count: usize,
) {
    let [[a, b], [c, d]] = *block;
    if count == 1 {
        right[0] /= if a.abs() > f64::EPSILON { a } else { 1.0 };
        return;
    }
    let determinant = a * d - b * c;
    if determinant.abs() > f64::EPSILON * (a * a + b * b + c * c + d * d) {
        let [x, y] = *right;
        *right = [(d * x - b * y) / determinant, (a * y - c * x) / determinant];
    }
}
