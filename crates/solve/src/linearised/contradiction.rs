//! Whether hard points contradict one another.
//!
//! ```text
//!     \  o   /      a body that may only move sideways between two walls that
//!      \ /\ /       both close: what opens one point closes the other
//! ```
//!
//! The pivoting method of [`super::pivoting`] finds pressures that close every
//! hard point wherever any do. What then still penetrates cannot be helped:
//! some points that press depend on one another. (derived)

use super::condensed::LinearisedContact;
use super::context::LawContext;
use super::pivoting::pivoting;
use super::points::{Kind, LinearPoint, LinearPoints};
use super::rows::IntegrationPoints;
use super::system::System;

/// Hard points that cannot all close.
#[derive(Clone, Debug, PartialEq)]
pub struct Contradiction {
    /// Places of the points in the plan.
    pub places: Vec<usize>,
    /// Overclosure that is left whatever the pressures [L].
    pub left: f64,
}

impl LinearisedContact {
    /// What hard points contradict one another by more than `tolerance` [L],
    /// by the system that was solved last.
    pub fn contradiction(
        &self,
        points: &LinearPoints,
        context: &LawContext<'_>,
        tolerance: f64,
    ) -> Option<Contradiction> {
        let hard: Vec<usize> = (0..self.rows.len())
            .filter(|&i| match self.rows[i].point() {
                Some((point, Kind::Normal)) => context.is_hard(&points[point]),
                _ => false,
            })
            .collect();
        if hard.is_empty() || self.compliance.len() < self.rows.len() * self.rows.len() {
            return None;
        }
        let system = System {
            rows: &self.rows,
            compliance: &self.compliance,
            integration_points: IntegrationPoints::NONE,
        };
        let mut unknown = self.unknown.clone();
        pivoting(&system, &hard, &mut unknown);
        let at = |i: usize| system.multiplier_and_value(i, &unknown);
        let left = hard.iter().map(|&i| at(i).1).fold(f64::NEG_INFINITY, f64::max);
        let presses = |&i: &usize| unknown[i] > 0.0 || at(i).1 > tolerance;
        let pressing: Vec<usize> = hard.into_iter().filter(presses).collect();
        if left <= tolerance || !self.depend(&pressing) {
            return None;
        }
        let place = |&i: &usize| self.rows[i].point().map(|(point, _)| points[point].place);
        Some(Contradiction { places: pressing.iter().filter_map(place).collect(), left })
    }

    /// Whether the structure cannot move so many points independently.
    fn depend(&self, rows: &[usize]) -> bool {
        let (m, n) = (rows.len(), self.rows.len());
        let scale: Vec<f64> = rows.iter().map(|&i| self.compliance[i * n + i].sqrt()).collect();
        let mut matrix: Vec<f64> = Vec::with_capacity(m * m);
        for (a, &i) in rows.iter().enumerate() {
            for (b, &j) in rows.iter().enumerate() {
                matrix.push(self.compliance[i * n + j] / (scale[a] * scale[b]));
            }
        }
        for k in 0..m {
            let pivot = (k..m).max_by(|&a, &b| matrix[a * m + a].total_cmp(&matrix[b * m + b]));
            let Some(pivot) = pivot.filter(|&p| matrix[p * m + p] > DEPENDENT) else { return true };
            for j in 0..m {
                matrix.swap(k * m + j, pivot * m + j);
            }
            for i in 0..m {
                matrix.swap(i * m + k, i * m + pivot);
            }
            for i in k + 1..m {
                let factor = matrix[i * m + k] / matrix[k * m + k];
                for j in k..m {
                    matrix[i * m + j] -= factor * matrix[k * m + j];
                }
            }
        }
        false
    }
}

/// Pivot of a compliance with ones on its diagonal below which a point moves
/// as the others say [1]: what the conditioning of K leaves of zero.
const DEPENDENT: f64 = 1e-6;

impl LawContext<'_> {
    /// Whether no overclosure is allowed at the point.
    pub fn is_hard(&self, point: &LinearPoint) -> bool {
        !point.integrated && self.laws[point.law].normal.pressure(0.0).is_none()
    }
}
