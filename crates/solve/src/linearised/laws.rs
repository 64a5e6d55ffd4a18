//! What the laws of contact ask of a row or a integration_point.

use super::system::{IntegrationPoint, Row};
use super::{Kind, LawContext, LinearPoint, MOST_DOFS, Sliding};
use slideline_mech::contact::enforcement::Complementarity;
use slideline_mech::contact::pair::{Laws, UserState};

/// A integration_point at the displacements of the small system.
#[derive(Clone, Debug, Default)]
pub(super) struct PointAnswer {
    pub pressure: f64,
    pub traction: f64,
    /// Pressure and traction less what the augmentation stiffness carries [F/L2].
    pub force: [f64; 2],
    /// Their derivatives by overclosure and slip [F/L3].
    pub slope: [[f64; 2]; 2],
}

impl PointAnswer {
    /// Whether it neither presses nor would with a little more closing.
    pub(super) fn is_idle(&self) -> bool {
        self.force == [0.0; 2] && self.slope == [[0.0; 2]; 2]
    }

    /// Adds the derivative of its force by the displacements of its rows,
    /// A (a dp/du + d dtau/du), to a matrix of `m` columns.
    pub(super) fn add_slope(
        &self,
        point: &LinearPoint,
        rows: &[usize],
        m: usize,
        stiffness: &mut [f64],
    ) {
        let [[nn, nt], [tn, tt]] = self.slope;
        let (mut pressure, mut traction) = ([0.0; MOST_DOFS], [0.0; MOST_DOFS]);
        for b in 0..rows.len() {
            let (g, s) = (point.area * point.normal[b], point.area * point.tangential[b]);
            pressure[b] = nn * g + nt * s;
            traction[b] = tn * g + tt * s;
        }
        let drags = [tn, tt] != [0.0; 2];
        for (a, &i) in rows.iter().enumerate() {
            let row = &mut stiffness[i * m..][..m];
            let (n, t) = (point.normal[a], point.direction[a]);
            for (&k, by) in rows.iter().zip(&pressure) {
                row[k] += n * by;
            }
            if drags {
                for (&k, by) in rows.iter().zip(&traction) {
                    row[k] += t * by;
                }
            }
        }
    }
}

impl LawContext<'_> {
    /// What the law of a row complementarities of its multiplier.
    pub(super) fn complementarity(
        &self,
        row: &Row,
        kind: Kind,
        point: &LinearPoint,
        [multiplier, value, pressure]: [f64; 3],
    ) -> Complementarity {
        let laws = &self.laws[point.pair];
        match (kind, &point.sliding) {
            (Kind::Tangential, Some(sliding)) => {
                let pressure = if self.symmetrised { point.pressure } else { pressure };
                let values = [multiplier, value, pressure];
                let complementarity =
                    self.complementarity_of_traction(laws, values, sliding, row.kappa);
                if self.symmetrised {
                    Complementarity { by_pressure: 0.0, ..complementarity }
                } else {
                    complementarity
                }
            }
            _ => laws.complementarity_of_pressure(multiplier, value, row.kappa),
        }
    }

    /// A slip that is prescribed leaves exact stick no choice: there is no
    /// row that would carry it to the limit.
    pub(super) fn slide_as_prescribed(&self, point: &mut LinearPoint) {
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

    /// A integration_point with its laws inserted: among many integration_points of one element
    /// none has a multiplier of its own.
    pub(super) fn integration_point(
        &self,
        integration_point: &IntegrationPoint,
        point: &LinearPoint,
        values: &[f64],
    ) -> PointAnswer {
        let (mut normal, mut tangential) = (0.0, 0.0);
        for a in 0..point.width {
            let d = values[integration_point.rows[a]];
            normal += point.normal[a] * d;
            tangential += point.tangential[a] * d;
        }
        let laws = &self.laws[point.pair];
        let complementarity =
            laws.complementarity_of_pressure(0.0, point.overclosure + normal, f64::INFINITY);
        let mut answer = PointAnswer {
            pressure: complementarity.value,
            traction: 0.0,
            force: [complementarity.value - point.stiffness * normal, 0.0],
            slope: [[complementarity.by_value - point.stiffness, 0.0], [0.0, 0.0]],
        };
        if let Some(sliding) = &point.sliding {
            let limit = if self.symmetrised { point.pressure } else { complementarity.value };
            let values = [sliding.traction, sliding.slip + tangential, limit];
            let direction = self.complementarity_of_traction(laws, values, sliding, f64::INFINITY);
            let by_pressure = if self.symmetrised { 0.0 } else { direction.by_pressure };
            answer.traction = direction.value;
            answer.force[1] = direction.value - sliding.stiffness * tangential;
            answer.slope[1] =
                [by_pressure * complementarity.by_value, direction.by_value - sliding.stiffness];
        }
        answer
    }

    pub(super) fn complementarity_of_traction(
        &self,
        laws: &Laws,
        values: [f64; 3],
        sliding: &Sliding,
        kappa: f64,
    ) -> Complementarity {
        let (begin, size) = sliding.state_variables;
        let committed = self.committed.get(begin..begin + size).unwrap_or(&[]);
        // Only a user law has a state_variables, and only then does this allocate.
        let mut state = committed.to_vec();
        let mut state_variables =
            UserState { time: self.time, committed, state: &mut state, fault: &mut None };
        laws.complementarity_of_traction(
            values,
            sliding.elastic_slip,
            (kappa, self.dt),
            &mut state_variables,
        )
    }
}
