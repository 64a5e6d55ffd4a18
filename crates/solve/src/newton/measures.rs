//! What an iteration leaves: residuals, corrections, changes of contact, and
//! what rounding and the laws of contact allow of them.

use super::outcome::Progress;
use super::scratch::Scratch;
use crate::convergence::{Measures, judge, largest_nodal};
use crate::observe::reports::{ContactChange, FieldReport, IterationReport};
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;
use slideline_model::Dof;

/// Roundings of the size of a force that a residual is allowed [1].
const ROUNDINGS: f64 = 50.0;

/// How many times what quadratic convergence promises an iteration may leave and still be expected
/// to be the last but one [1]: a guess that decides on work alone.
const LUCKY: f64 = 100.0;

/// Whether a further iteration is expected to leave no more than is allowed: over the forces that act
/// it leaves the square of what there is.
fn is_nearly_there(field: &FieldReport) -> bool {
    field.residual * field.residual <= LUCKY * field.allowed * field.average
}

impl Scratch {
    /// Measures the trial state and judges it.
    pub(super) fn judge(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        target: &Target,
        progress: &mut Progress,
    ) -> IterationReport {
        let [force, moment] = self.measure(plan, committed);
        let mut report = IterationReport {
            step: target.step,
            increment: target.increment,
            attempt: target.attempt,
            iteration: 0,
            severe: false,
            equilibrium: 0,
            contact_changes: self.empty_changes(progress),
            closed: self.evaluation.points.iter().filter(|point| point.closed).count(),
            force,
            moment,
            contact_defect: self.evaluation.penetration.max(self.evaluation.stick_slip),
            step_length: self.step_length,
            enforcement: self.enforcement,
            solutions: self.contact.solutions(),
            moves: self.moves,
            converged: false,
        };
        let controls = &plan.step.controls.field;
        let (flux, averages) = self.fluxes(plan, committed);
        let floors = self.floors(plan, committed);
        let negligible = floors[0].max(controls.r_n * averages[0]);
        let by_places = self.position_rounding(plan) * plan.structure.stiffest;
        self.note_changes(plan, negligible.max(by_places), &mut report);
        self.iteration_history.note(&self.evaluation.points);
        if report.severe {
            progress.severe += 1;
            progress.begin_anew();
        } else {
            progress.equilibrium += 1;
            progress.since_change += 1;
            progress.force.push(report.force.residual);
            progress.moment.push(report.moment.residual);
        }
        report.iteration = (progress.severe + progress.equilibrium) as usize;
        report.equilibrium = progress.equilibrium as usize;
        let late = plan.step.controls.effective_time().i_p;
        for field in [0, 1] {
            let measures = Measures {
                flux: flux[field],
                average: averages[field],
                floor: floors[field],
                iteration: progress.since_change,
                late,
            };
            let (own, history) = match field {
                0 => (&mut report.force, &progress.force),
                _ => (&mut report.moment, &progress.moment),
            };
            judge(own, history, &measures, controls);
        }
        report.converged = !report.severe
            && report.force.converged
            && report.moment.converged
            && self.contact_settled(plan, report.force.allowed);
        let fields = [&report.force, &report.moment];
        self.nearly_there = !report.severe && fields.into_iter().all(is_nearly_there);
        report
    }

    /// Mean forces and moments, now and over the step.
    fn fluxes(&self, plan: &Problem<'_>, committed: &State) -> ([f64; 2], [f64; 2]) {
        let mut flux = [self.evaluation.flux.mean_force(), self.evaluation.flux.mean_moment()];
        let controls = &plan.step.controls.field;
        let mut averages = [0, 1].map(|field| committed.flux[field].with(flux[field], controls));
        if averages[1] == 0.0 {
            // no element has moments: what arrives at dofs that others follow are forces by levers
            let lever = self.largest_shares(plan).1;
            (flux[1], averages[1]) = (lever * flux[0], lever * averages[0]);
        }
        (flux, averages)
    }

    /// The list of the report before, emptied: iterations allocate nothing.
    pub(super) fn empty_changes(&mut self, progress: &mut Progress) -> Vec<ContactChange> {
        if let Some(last) = progress.last.take() {
            self.changes = last.contact_changes;
        }
        self.changes.clear();
        std::mem::take(&mut self.changes)
    }

    /// Residuals, corrections and increments of both fields.
    fn measure(&self, plan: &Problem<'_>, committed: &State) -> [FieldReport; 2] {
        let dofs = plan.dofs;
        let free = |dof: usize| plan.constraints.equation(dof);
        let unbalanced = |dof| free(dof).map(|_| self.evaluation.unbalanced(dof));
        let residual = largest_nodal(dofs, unbalanced);
        let correction = largest_nodal(dofs, |dof| free(dof).map(|_| self.correction_dofs[dof]));
        let increment = largest_nodal(dofs, |dof| Some(self.u[dof] - committed.displacement[dof]));
        [0, 1].map(|field| FieldReport {
            residual: residual[field].0,
            residual_at: residual[field].1.map(|dof| dofs.name(dof)),
            correction: correction[field].0,
            correction_at: correction[field].1.map(|dof| dofs.name(dof)),
            increment: increment[field].0,
            ..FieldReport::default()
        })
    }

    /// What rounding leaves of a residual: 50 eps EA max|u| / l of the
    /// elements, and what the rounding of positions makes of contact.
    /// Moments: the same times their levers. |u| is the largest now and at the
    /// start of the step, and no floor lies below 50 eps of the largest flux of
    /// the analysis: where all forces vanish, as after a springback, nothing
    /// that acts now tells how large a force is small.
    pub(super) fn floors(&self, plan: &Problem<'_>, committed: &State) -> [f64; 2] {
        let mut moved = 0.0_f64;
        let mut reach = plan.reach;
        let start = &plan.start.displacement;
        let in_space = plan.dofs.kinds().contains(&Dof::UR1);
        for (dof, u) in
            self.u.iter().zip(start.iter()).map(|(u, s)| u.abs().max(s.abs())).enumerate()
        {
            if !plan.dofs.name(dof).1.is_rotation() {
                reach = reach.max(u);
                if plan.elastic[dof] {
                    moved = moved.max(u);
                }
            } else if in_space && plan.elastic[dof] {
                // what turns in its place moves nothing, and rounds all the same
                moved = moved.max(u.min(1.0) * plan.structure.stiffest_length);
            }
        }
        // what holds loose bodies in an iteration is forgotten in the next one but for rounding
        for (dof, u) in
            plan.loose.iter().flat_map(|body| body.unknowns()).map(|dof| (dof, self.u[dof]))
        {
            moved = moved.max(if plan.dofs.is_rotation(dof) { 0.0 } else { u.abs() });
        }
        let elastic = ROUNDINGS * f64::EPSILON * plan.structure.stiffest * moved;
        let contact = 4.0 * f64::EPSILON * self.contact_size(plan, reach);
        let flux = [self.evaluation.flux.mean_force(), self.evaluation.flux.mean_moment()];
        let seen = |field: usize| {
            ROUNDINGS * f64::EPSILON * committed.flux[field].largest_with(flux[field])
        };
        // forces that balance round as they act over the length of an element: a beam that heat presses
        // between two clamps moves nothing and has no moment, and rounds all the same
        let length = plan.structure.stiffest_length;
        // and dofs that follow hand on more than one share of a force, or a moment about where they are joined, which
        // may be far from any element
        let (share, lever) = self.largest_shares(plan);
        let moments = elastic.max(seen(0)) * length.max(lever) + contact * reach;
        [(elastic * share.max(1.0) + contact).max(seen(0)), moments.max(seen(1))]
    }

    /// The largest shares that dofs hand on of a force: of it, and as a moment [1, L].
    fn largest_shares(&self, plan: &Problem<'_>) -> (f64, f64) {
        let is_rotation = |dof: usize| plan.dofs.is_rotation(dof);
        plan.constraints.largest_shares(&self.evaluation.rows, is_rotation)
    }

    /// Largest contact force, and largest change of one when positions
    /// change by the size of the model [F].
    pub(super) fn contact_size(&self, plan: &Problem<'_>, reach: f64) -> f64 {
        let mut largest = 0.0_f64;
        for (place, point) in self.evaluation.points.iter().enumerate() {
            if point.closed {
                let laws = plan.contact.laws_of(plan.contact.points[place].pair, point);
                // a hard law that is inserted has the slope of what stands before it
                let held = self.held.of.get(place).map_or(0.0, |held| held.normal_stiffness);
                let slope = laws.normal.pressure(-point.opening).map_or(held, |(_, slope)| slope);
                largest = largest.max(point.area * (point.pressure.abs() + slope * reach));
            }
        }
        largest
    }

    /// Notes points whose contact changed since the last iteration. A change is a discontinuity where
    /// what the point presses with, or has pressed with before it opened, is more than `negligible`
    /// [F]: surfaces that only just touch open and close by rounding alone.
    pub(super) fn note_changes(
        &mut self,
        plan: &Problem<'_>,
        negligible: f64,
        report: &mut IterationReport,
    ) {
        for (place, point) in self.evaluation.points.iter().enumerate() {
            let now = point.closed.then_some(point.area * point.pressure);
            let before = std::mem::replace(&mut self.pressed[place], now);
            if now.is_some() == before.is_some()
                || plan.contact.points[place].is_integration_point()
            {
                continue;
            }
            let own = &plan.contact.points[place];
            report.contact_changes.push(ContactChange {
                pair: own.pair,
                node: own.node,
                closed: point.closed,
            });
            report.severe |= now.or(before).is_some_and(|force| force.abs() > negligible);
        }
    }

    /// Hard contact and exact stick have no stiffness that would turn a
    /// defect into a residual: it is held against the structure's own.
    pub(super) fn contact_settled(&self, plan: &Problem<'_>, allowed: f64) -> bool {
        let tolerance = self.contact_tolerance(plan, allowed);
        self.evaluation.penetration <= tolerance && self.evaluation.stick_slip <= tolerance
    }

    /// Overclosure that the structure would answer with the residual allowed,
    /// or that rounding leaves [L].
    pub(super) fn contact_tolerance(&self, plan: &Problem<'_>, allowed: f64) -> f64 {
        let rounding = self.position_rounding(plan);
        let stiffest = plan.structure.stiffest;
        let by_force = if stiffest > 0.0 { allowed / stiffest } else { 0.0 };
        by_force.max(rounding)
    }

    /// What rounding leaves of an overclosure [L].
    fn position_rounding(&self, plan: &Problem<'_>) -> f64 {
        let moved = self.u.iter().fold(0.0_f64, |largest, u| largest.max(u.abs()));
        8.0 * f64::EPSILON * (plan.reach + moved)
    }
}
