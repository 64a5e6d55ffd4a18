//! What the laws of contact ask of a row or an integration point.

use super::context::LawContext;
use super::points::{Kind, LinearPoint, LinearPoints, LinearRows, Sliding};
use super::rows::{IntegrationPoint, Row, RowSlopes};
use slideline_mech::contact::enforcement::{HeldMultiplier, TangentialComplementarity};
use slideline_mech::contact::pair::{Laws, UserState};
use slideline_mech::contact::tangential::{Tangential, TangentialMap};

/// An integration point at the displacements of the condensed contact problem.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct PointAnswer {
    pub pressure: f64,
    pub traction: Tangential,
    /// Pressure and traction less what the augmentation stiffness carries [F/L2].
    pub normal: f64,
    pub tangential: Tangential,
    /// Slope of the normal part by overclosure [F/L3].
    pub slope: f64,
    /// Slopes of the tangential part by overclosure and by slip [F/L3].
    pub tangential_by_overclosure: Tangential,
    pub tangential_by_slip: TangentialMap,
}

/// What the laws say at an estimate: of each row, and of each integration point that takes part.
#[derive(Clone, Debug, Default)]
pub(super) struct LawAnswers {
    pub rows: Vec<RowSlopes>,
    pub points: Vec<PointAnswer>,
}

impl LawAnswers {
    pub(super) fn make_room(&mut self, rows: usize, integration_points: usize) {
        self.rows.resize(rows, RowSlopes::default());
        self.points.resize(integration_points, PointAnswer::default());
    }
}

impl PointAnswer {
    /// Whether it neither presses nor would with a little more closing.
    pub(super) fn is_idle(&self) -> bool {
        let idle = self.normal == 0.0 && self.tangential == Tangential::ZERO;
        idle && self.slope == 0.0 && !self.rubs()
    }

    /// Whether its tangential part follows anything.
    fn rubs(&self) -> bool {
        self.tangential_by_overclosure != Tangential::ZERO
            || self.tangential_by_slip != TangentialMap::ZERO
    }

    /// Change of the normal and the tangential part by one of overclosure and slip.
    pub(super) fn change(&self, normal: f64, slip: Tangential) -> (f64, Tangential) {
        (
            self.slope * normal,
            normal * self.tangential_by_overclosure + self.tangential_by_slip.apply(slip),
        )
    }

    /// Hands over the derivative of its force by the displacements of its equations,
    /// A (a dp/du + d dtau/du), entry by entry, with the places of both among them.
    pub(super) fn add_slope(&self, point: &LinearRows<'_>, mut add: impl FnMut(usize, usize, f64)) {
        let (rubs, directions) = (self.rubs(), point.rows.directions());
        for b in 0..point.rows.width() {
            let g = point.area * point.rows.normal()[b];
            let pressure = self.slope * g;
            let tangential = |direction: usize| {
                let by_slip = (0..directions).map(|slip| {
                    self.tangential_by_slip.at(direction, slip)
                        * (point.area * point.rows.slip(slip)[b])
                });
                by_slip.fold(self.tangential_by_overclosure[direction] * g, |sum, by| sum + by)
            };
            for (a, along) in point.rows.normal().iter().enumerate() {
                add(a, b, along * pressure);
            }
            for direction in (0..directions).filter(|_| rubs) {
                let by = tangential(direction);
                for (a, along) in point.rows.force(direction).iter().enumerate() {
                    add(a, b, along * by);
                }
            }
        }
    }
}

impl LawContext<'_> {
    /// What the laws ask of the row `i`: of a pressure, or of all the tractions of a point
    /// that begin there. `asked` tells multiplier and value of a row; `slopes` takes row,
    /// multiplier and answer.
    pub(super) fn ask(
        &self,
        rows: &[Row],
        i: usize,
        points: &LinearPoints,
        asked: impl Fn(usize) -> (f64, f64),
        mut slopes: impl FnMut(usize, f64, RowSlopes),
    ) {
        let Some((place, kind)) = rows[i].point() else { return };
        let (row, point) = (&rows[i], &points[place]);
        let laws = &self.laws[point.law];
        let sliding = match (kind, &point.sliding) {
            (Kind::Normal, _) | (_, None) => {
                let (multiplier, value) = asked(i);
                let answer = laws.complementarity_of_pressure(multiplier, value, row.kappa);
                slopes(i, multiplier, RowSlopes::of_pressure(i, &answer));
                return;
            }
            (Kind::Tangential(0), Some(sliding)) => sliding,
            _ => return,
        };
        let (mut traction, mut slip) = (Tangential::ZERO, Tangential::ZERO);
        for direction in 0..points.directions() {
            (traction.0[direction], slip.0[direction]) = asked(i + direction);
        }
        let pressure = match self.symmetrised {
            true => point.pressure,
            false => asked(i - 1).0,
        };
        let mut answer =
            self.complementarity_of_traction(laws, (traction, slip, pressure), sliding, row.kappa);
        if self.symmetrised {
            answer.by_pressure = Tangential::ZERO;
        }
        for direction in 0..points.directions() {
            let own = RowSlopes::of_traction((i, points.directions()), direction, &answer);
            slopes(i + direction, traction[direction], own);
        }
    }

    /// The traction of a slip that is prescribed, which leaves exact stick no choice: there
    /// is no row that would carry it to the limit. `None`: the point has its rows.
    pub(super) fn prescribed_sliding(&self, point: &LinearRows<'_>) -> Option<Tangential> {
        let laws = &self.laws[point.law];
        let sliding = point.sliding.as_ref()?;
        let slides = !point.integrated && !point.slides() && laws.friction.needs_multiplier();
        if !slides || sliding.slip.size() <= self.rounding {
            return None;
        }
        let limit = laws.limit_traction(point.pressure, sliding.slip, self.dt);
        let ellipse = laws.friction.ellipse();
        let way = ellipse.slip_on_circle(sliding.slip).direction();
        limit.is_finite().then(|| ellipse.traction(limit * way))
    }

    /// An integration point with its laws inserted, less what the augmentation stiffness carries:
    /// among many integration points of one element none has a multiplier of its own.
    pub(super) fn integration_point(
        &self,
        integration_point: IntegrationPoint<'_>,
        point: &LinearRows<'_>,
        values: &[f64],
    ) -> PointAnswer {
        let (normal, slip) = point.values(|k| values[integration_point.rows[k]]);
        let mut answer = self.inserted(point, (normal, slip), &HeldMultiplier::NONE);
        answer.normal -= point.stiffness * normal;
        answer.slope -= point.stiffness;
        if let Some(sliding) = &point.sliding {
            answer.tangential = answer.tangential - sliding.stiffness * slip;
            answer.tangential_by_slip =
                answer.tangential_by_slip + TangentialMap::isotropic(-sliding.stiffness);
        }
        answer
    }

    /// The laws of a point, inserted about held multipliers, where overclosure and slip have
    /// changed by so much.
    pub(super) fn inserted(
        &self,
        point: &LinearPoint,
        (normal, slip): (f64, Tangential),
        held: &HeldMultiplier,
    ) -> PointAnswer {
        let laws = &self.laws[point.law];
        let overclosure = point.overclosure + normal;
        let asked =
            laws.complementarity_of_pressure(held.pressure, overclosure, held.normal_stiffness);
        let mut answer = PointAnswer {
            pressure: asked.value,
            normal: asked.value,
            slope: asked.by_value,
            ..PointAnswer::default()
        };
        if let Some(sliding) = &point.sliding {
            answer.traction = sliding.traction;
            answer.tangential = sliding.traction;
            if held.tangential_stiffness.is_infinite() && laws.friction.needs_multiplier() {
                return answer; // a slip that is prescribed
            }
            let limit = if self.symmetrised { point.pressure } else { asked.value };
            let values = (held.traction, sliding.slip + slip, limit);
            let kappa = held.tangential_stiffness;
            let asked_along = self.complementarity_of_traction(laws, values, sliding, kappa);
            let by_pressure =
                if self.symmetrised { Tangential::ZERO } else { asked_along.by_pressure };
            answer.traction = asked_along.value;
            answer.tangential = asked_along.value;
            answer.tangential_by_overclosure = asked.by_value * by_pressure;
            answer.tangential_by_slip = asked_along.by_value;
        }
        answer
    }

    pub(super) fn complementarity_of_traction(
        &self,
        laws: &Laws,
        values: (Tangential, Tangential, f64),
        sliding: &Sliding,
        kappa: f64,
    ) -> TangentialComplementarity {
        let (begin, size) = sliding.state_variables;
        let committed = self.committed.get(begin..begin + size).unwrap_or(&[]);
        // Only a user law has state variables, and only then does this allocate.
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
