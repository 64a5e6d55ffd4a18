//! A step towards the least energy for fixed limits of friction: the laws inserted, their slopes.

use super::context::LawContext;
use super::points::{Kind, LinearPoint, LinearPoints};
use super::rows::{Row, RowSlopes, Unknown};
use super::step_room::StepRoom;
use super::system::{System, eliminate_in_units, go};
use slideline_mech::contact::enforcement::{Complementarity, TangentialComplementarity};
use slideline_mech::contact::tangential::{Tangential, TangentialMap};

/// Stiffness that stands for a hard law or exact stick, in those that the
/// structure has at the point [1].
const STIFF: f64 = 1e5;
/// Halvings that find the end of a step.
const HALVINGS: usize = 40;
/// Part of the slope at its beginning that may be left at its end [1].
const ENDED: f64 = 0.1;
/// Part of it that counts as rounding [1].
const ROUNDING: f64 = 1e-9;

/// Scratch of a descent, kept.
#[derive(Clone, Debug, Default)]
pub(super) struct Descent {
    /// Points with the pressures that limit friction.
    pub(super) held: LinearPoints,
    /// That of Newton's steps while it goes on.
    pub(super) room: StepRoom,
    /// Whether slopes are those of stick, sliding or not.
    pub(super) steepest: bool,
    /// Steps of the last descent, over all rounds.
    pub(super) steps: usize,
}

impl Descent {
    /// F = lambda - law with the laws inserted at the values that are there; its weighted square.
    pub(super) fn evaluate(
        &mut self,
        system: &System<'_>,
        unknown: &[f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) -> f64 {
        let at = (unknown, &self.room.values[..], points);
        let laws = &mut self.room.laws;
        system.residual_of_inserted(at, (fixed, self.steepest), &mut self.room.residual, laws)
    }

    /// The step, J step = F, and what the energy says of it.
    pub(super) fn find_step(&mut self, system: &System<'_>, points: &LinearPoints) {
        let StepRoom { residual, step, yielded: push, jacobian, factors, stiffness, laws, .. } =
            &mut self.room;
        system.jacobian(points, laws, jacobian, stiffness);
        step.copy_from_slice(residual);
        eliminate_in_units(system.rows, jacobian, factors, step);
        system.product(step, push);
        push.iter_mut().zip(system.rows).for_each(|(push, row)| *push /= measure(row));
    }

    /// Goes along the step to a little before where the energy is least, or all of it where that lies
    /// beyond.
    pub(super) fn descend_along_step(
        &mut self,
        system: &System<'_>,
        unknown: &mut [f64],
        points: &LinearPoints,
        fixed: &LawContext<'_>,
    ) {
        let begun = self.slope();
        self.begin(unknown);
        let (mut low, mut high) = (0.0, 1.0);
        let mut at = 1.0;
        for _ in 0..HALVINGS {
            self.go(system, at, unknown);
            self.evaluate(system, unknown, points, fixed);
            let slope = self.slope();
            if at == 1.0 && slope >= -ROUNDING * begun {
                return; // still downhill at its end
            }
            if (0.0..=ENDED * begun).contains(&slope) {
                return; // all but there, and never beyond: downhill all the way
            }
            if slope >= 0.0 {
                low = at
            } else {
                high = at
            }
            if high - low <= 1e-9 * high {
                return;
            }
            at = 0.5 * (low + high);
        }
    }

    /// Begins steps from the unknowns and the values that are there.
    fn begin(&mut self, unknown: &[f64]) {
        let [from, values_from] = &mut self.room.trial;
        from.copy_from_slice(unknown);
        values_from.copy_from_slice(&self.room.values);
    }

    /// Goes so much of the step.
    fn go(&mut self, system: &System<'_>, at: f64, unknown: &mut [f64]) {
        let StepRoom { step, yielded: push, trial: [from, values_from], values, .. } =
            &mut self.room;
        go((from, -at, step), unknown);
        let from = values_from.iter().zip(push).zip(system.rows);
        for (value, ((from, push), row)) in values.iter_mut().zip(from) {
            *value = *from + at * *push * measure(row);
        }
    }

    /// Energy that the step gains per length of it; below zero beyond the place
    /// where the energy is least [F L].
    pub(super) fn slope(&self) -> f64 {
        self.room.yielded.iter().zip(&self.room.residual).map(|(push, f)| push * f).sum()
    }
}

/// What a row's part of the energy is measured in: the area that makes a force of its pressure or traction [L2].
fn measure(row: &Row) -> f64 {
    match row.unknown {
        Unknown::Multiplier { .. } => row.unit,
        Unknown::Interface { .. } => 1.0,
    }
}

impl LawContext<'_> {
    /// What the laws say at the `values` of all rows, at the limit of the pressure that the
    /// point has: of the pressure in row `i`, or of all tractions that begin there; `steepest`:
    /// with the slopes of stick, sliding or not.
    pub(super) fn insert(
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
