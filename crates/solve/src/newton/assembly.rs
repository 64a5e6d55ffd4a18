//! The tangent of an iteration: elements, geometry of contact, lent stiffness.

use super::Workspace;
use crate::contact::{Meeting, STRIP_POINTS, SlavePoint};
use crate::evaluate::Evaluation;
use crate::linearised::{Circumstances, LinearPoint, MOST_DOFS, Sliding, Stiffness};
use crate::plan::Plan;
use crate::state::State;
use slideline_linalg::SolveError;
use slideline_mech::contact::enforcement::Enforcement;

/// How far apart, in sizes of the model, points still count as touching.
pub const TOUCH: f64 = 1e-9;
/// Rows from which on the condensed contact problem is solved without its matrix.
const DENSE_ROWS: f64 = 100.0;
/// Rows that a touching station adds to it: those of its element are shared.
const INTEGRATED_ROWS: f64 = 6.0 / STRIP_POINTS as f64;
/// Stiffness lent to a closed point, as a fraction of the stiffest element.
pub(super) const LENT: f64 = 0.1;

impl Workspace {
    /// Assembles and factors. Where nothing but contact that is still open
    /// would hold the model, stiffness is lent to every point that faces its
    /// master, and the contact step closes the gap.
    pub(super) fn factor(&mut self, plan: &Plan<'_>, committed: &State) -> Result<(), SolveError> {
        loop {
            self.linearise_points(plan, committed);
            let counts = |point: &&LinearPoint| point.stiffness > 0.0 || point.pressure > 0.0;
            self.outside = !self.points.iter().filter(counts).all(|point| plan.holds(point));
            if self.outside {
                return Ok(());
            }
            self.assemble(plan);
            self.choose_enforcement(plan, committed);
            let Self { values, augmented, solver, points, .. } = self;
            let symmetrised = plan.symmetrised();
            let pattern = &plan.pattern;
            match (Stiffness { pattern, values, augmented, solver, symmetrised }).factor(points) {
                Ok(report) => {
                    let negative = report.negative_pivots.unwrap_or(0);
                    self.negative_pivots = self.negative_pivots.max(negative);
                    return Ok(());
                }
                Err(SolveError::Singular { .. }) if !self.lend_to_all => self.lend_to_all = true,
                Err(fault) => return Err(fault),
            }
        }
    }

    /// Contact points as the small system wants them.
    pub(super) fn linearise_points(&mut self, plan: &Plan<'_>, committed: &State) {
        self.points.clear();
        for (place, point) in plan.contact.points.iter().enumerate() {
            if self.evaluation.look.idle[place] {
                continue;
            }
            let meeting = &self.evaluation.meetings[place];
            if point.is_station() && !meeting.faces {
                self.pressures[place] = 0.0;
                self.tractions[place] = 0.0;
                continue;
            }
            let before = &committed.points[place];
            let laws = &plan.contact.laws[point.pair];
            let touching = meeting.faces
                && (self.lend_to_all
                    || self.pressures[place] > 0.0
                    || meeting.overclosure > laws.normal.contact_begins() - TOUCH * plan.reach);
            let lent = if touching { lent_stiffness(plan, point) } else { 0.0 };
            let called = laws.has_friction() && laws.onset.called(before.closed, true);
            let sliding = (called && meeting.faces).then(|| Sliding {
                slip: plan.contact.slip(place, &before.history(), meeting, &committed.displacement),
                elastic_slip: before.elastic_slip,
                traction: self.tractions[place],
                stiffness: lent,
                memory: (point.memory, point.memory_size),
            });
            let mut linear = LinearPoint {
                place,
                pair: point.pair,
                area: meeting.area,
                integrated: point.is_station(),
                width: 0,
                equations: [0; MOST_DOFS],
                normal: [0.0; MOST_DOFS],
                tangential: [0.0; MOST_DOFS],
                drag: [0.0; MOST_DOFS],
                overclosure: meeting.overclosure,
                pressure: if meeting.faces { self.pressures[place] } else { 0.0 },
                stiffness: lent,
                sliding,
            };
            for k in 0..meeting.width {
                let own = [meeting.gradient[k], meeting.slip_gradient[k], meeting.drag[k]];
                let add = &mut |equation, a: f64| linear.add(equation, own.map(|g| a * g));
                plan.constraints.for_each_equation(&self.evaluation.rows, meeting.slots[k], add);
            }
            self.points.push(linear);
        }
    }

    /// Elements and geometry of contact: the tangent without the stiffness that
    /// closed points are augmented with.
    pub(super) fn assemble(&mut self, plan: &Plan<'_>) {
        self.values.fill(0.0);
        let Evaluation { contributions, rows, .. } = &self.evaluation;
        plan.gather_tangent(contributions, rows, &mut self.values);
        self.stiffen(plan);
        for dashpot in &self.dashpots {
            dashpot.stiffen(plan, &self.evaluation.rows, &mut self.values);
        }
        self.turn(plan);
        plan.contact.fill_scratch(&self.u, &mut self.geometry);
        for k in 0..self.points.len() {
            if self.points[k].pressure == 0.0 && self.points[k].stiffness == 0.0 {
                continue;
            }
            self.add_geometry(plan, self.points[k].place);
        }
    }

    /// Many rows are solved without their matrix, and augmented by their laws.
    fn choose_enforcement(&mut self, plan: &Plan<'_>, committed: &State) {
        let rows = |point: &LinearPoint| match point.stiffness > 0.0 {
            true if point.integrated => INTEGRATED_ROWS,
            true => 1.0 + f64::from(u8::from(point.sliding.is_some())),
            false => 0.0,
        };
        let rows: f64 = self.points.iter().map(rows).sum();
        let by_size = match rows < DENSE_ROWS {
            true => Enforcement::Dense,
            false => Enforcement::MatrixFree,
        };
        self.enforcement = plan.enforcement.unwrap_or(by_size);
        if self.enforcement == Enforcement::MatrixFree {
            let context = circumstances(plan, committed, self.dt);
            let Self { values, augmented, solver, points, .. } = self;
            let (pattern, symmetrised) = (&plan.pattern, plan.symmetrised());
            let stiffness = Stiffness { pattern, values, augmented, solver, symmetrised };
            context.augment(points, &stiffness);
        }
    }

    pub(super) fn add_geometry(&mut self, plan: &Plan<'_>, place: usize) {
        let meeting: &Meeting = &self.evaluation.meetings[place];
        let width = meeting.width;
        let forces = (meeting.area * self.pressures[place], meeting.area * self.tractions[place]);
        let geometry = &mut self.geometry;
        plan.contact.geometric_tangent(place, &self.u, meeting, forces, geometry);
        let at = |i: usize, j: usize| geometry.tangent[width * i + j];
        plan.scatter(&self.evaluation.rows, &meeting.slots[..width], at, &mut self.values);
    }

    /// Adds what the turning of rigid links makes of the forces that the
    /// tangent is taken at: of estimated stresses, pressures and tractions.
    fn turn(&mut self, plan: &Plan<'_>) {
        if !plan.constraints.turns() {
            return;
        }
        let (evaluation, turning) = (&self.evaluation, &mut self.turning);
        turning.iter_mut().zip(&self.load).for_each(|(force, load)| *force = -load);
        let stresses = Some(&self.stresses[..]);
        plan.structure.turning_forces(&self.u, stresses, &evaluation.contributions, turning);
        for linear in &self.points {
            let meeting = &evaluation.meetings[linear.place];
            let [p, tau] = [self.pressures[linear.place], self.tractions[linear.place]];
            for k in 0..meeting.width {
                turning[meeting.slots[k]] +=
                    meeting.area * (p * meeting.gradient[k] + tau * meeting.drag[k]);
            }
        }
        plan.stiffen_by_turning(&self.u, turning, &mut self.values);
    }
}

pub(super) fn circumstances<'a>(
    plan: &'a Plan<'_>,
    committed: &'a State,
    dt: f64,
) -> Circumstances<'a> {
    Circumstances {
        laws: &plan.contact.laws,
        time: committed.total_time + dt,
        dt,
        committed: &committed.memory,
        symmetrised: plan.symmetrised(),
        rounding: 8.0 * f64::EPSILON * plan.reach,
        units: &plan.units,
    }
}

/// Stiffness per area lent to a point [F/L3]: a part of that of the stiffest
/// element. Without elements, of one that the largest load would shorten by the
/// size of the model; where nothing has a size, any.
pub(super) fn lent_stiffness(plan: &Plan<'_>, point: &SlavePoint) -> f64 {
    let load = plan.largest_load;
    let scale = match plan.structure.stiffest > 0.0 {
        true => LENT * plan.structure.stiffest,
        false if plan.reach > 0.0 => load / plan.reach,
        false => load,
    };
    if scale > 0.0 && point.area > 0.0 {
        let points = if point.is_station() { STRIP_POINTS as f64 } else { 1.0 };
        scale / (points * point.area)
    } else {
        1.0
    }
}
