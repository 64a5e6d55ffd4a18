//! The first guess of an attempt.

use super::hold::{HOLD, OF_INSERTED, hold_loose};
use super::scratch::{Scratch, solver};
use crate::evaluate::{Evaluation, look_at};
use crate::predict;
use crate::problem::Problem;
use crate::stabilise;
use crate::state::State;
use crate::structure::{Ambient, Configuration, Gather, Product};
use crate::target::Target;
use slideline_mech::material::Clock;

impl Scratch {
    /// Sets what the time prescribes, then the dofs that follow others.
    pub(super) fn follow_time(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.set_time(plan, committed, target);
        plan.constraints.enforce(&self.turns, &mut self.u);
    }

    /// Sets what the time prescribes: motions, loads, pressures on faces, temperatures.
    pub(super) fn set_time(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        plan.prescribe(target.step_time, &mut self.u);
        plan.load(target.step_time, &mut self.load);
        self.faces.clear();
        self.faces.extend(plan.pressures(target.step_time));
        plan.temperatures(target.step_time, &mut self.temperatures);
        self.turns.clone_from(&committed.turns);
        self.clock = Clock {
            passed: plan.step.procedure.passage.of(target.dt),
            total: committed.total_time + target.dt,
        };
    }

    /// The first guess, evaluated.
    pub(super) fn begin(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.augment_all = false;
        self.only_dense = false;
        if self.changes.capacity() == 0 {
            // the last attempt's list went with its outcome
            self.changes = self.spare_changes.pop().unwrap_or_default();
        }
        self.changes.reserve(plan.contact.points.len());
        self.dt = target.dt;
        self.negative_pivots = 0;
        (self.factored, self.nearly_there) = (false, false);
        let firm = target.attempt.clamp(1, HOLD.len()) - 1;
        let part = if plan.inserts_laws() { OF_INSERTED } else { 1.0 };
        let hold = part * HOLD[firm];
        (self.least_hold, self.hold) = (hold, hold);
        self.thrown = false;
        self.secants.begin(target.attempt == 1, committed.by_secants);
        let times = (target.step_time, target.dt);
        stabilise::fill(plan, committed, times, &mut self.dashpots);
        self.u.copy_from_slice(&committed.displacement);
        predict::extrapolate(plan, committed, target.dt, &mut self.u);
        self.follow_time(plan, committed, target);
        for (place, point) in committed.points.iter().enumerate() {
            self.pressures[place] = point.pressure;
            self.tractions[place] = point.traction;
            self.pressed[place] = point.closed.then_some(point.area * point.pressure);
            self.standing[place] = point.stands_on();
        }
        self.hold_multipliers(plan);
        if committed.increment_time.0 == 0.0 {
            self.spread_prescribed(plan, committed, target);
        }
        self.first_stresses(plan, committed, target.dt);
        look_at(plan, committed, &mut self.evaluation);
        self.evaluate(plan, committed, target.dt);
        if committed.increment_time.0 > 0.0 && self.lets_go(plan, committed) {
            self.evaluate(plan, committed, target.dt);
        }
        if self.evaluation.failed.is_some() && committed.increment_time.0 > 0.0 {
            self.begin_at_rest(plan, committed, target);
        }
        self.iteration_history.begin(&self.evaluation.points);
    }

    /// Leaves bodies where they are that the first guess takes out of contact, and that nothing else holds.
    fn lets_go(&mut self, plan: &Problem<'_>, committed: &State) -> bool {
        let guess = (committed, Some(&self.evaluation.points[..]));
        let some = predict::let_go(plan, guess, &mut self.u);
        if some {
            plan.constraints.enforce(&self.turns, &mut self.u);
        }
        some
    }

    /// Where the last increment cannot be repeated, for an element would fail: a first guess
    /// as if there had been none.
    fn begin_at_rest(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.u.copy_from_slice(&committed.displacement);
        plan.prescribe(target.step_time, &mut self.u);
        plan.constraints.enforce(&self.turns, &mut self.u);
        self.spread_prescribed(plan, committed, target);
        self.first_stresses(plan, committed, target.dt);
        self.evaluate(plan, committed, target.dt);
    }

    /// Without a last increment to repeat, what is prescribed on the
    /// structure is spread over it linearly, lest one element takes it all.
    fn spread_prescribed(&mut self, plan: &Problem<'_>, committed: &State, target: &Target) {
        self.give_back();
        let change = &mut self.correction_dofs;
        for (dof, value) in change.iter_mut().enumerate() {
            *value = self.u[dof] - committed.displacement[dof];
        }
        let from = &committed.displacement;
        let ambient =
            Ambient { temperatures: &self.temperatures, turns: &self.turns, clock: self.clock };
        let state = &committed.elements;
        let at = Configuration { u: from, stresses: None, state, ambient };
        plan.constraints.linearise((from, &self.turns), &mut self.evaluation.rows);
        self.residual.fill(0.0);
        let product = Product { vector: change, into: &mut self.residual };
        let Evaluation { rows, tangent, contributions, .. } = &mut self.evaluation;
        let gather = Gather { product: Some(product), ..plan.gather(rows, tangent) };
        plan.structure.evaluate(&at, contributions, gather, plan.means.pool);
        plan.constraints.carry(&self.evaluation.rows, &mut self.residual);
        for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
            self.correction[equation] = -self.residual[dof];
        }
        if self.correction.iter().all(|&value| value == 0.0) {
            return;
        }
        let Evaluation { rows, tangent, .. } = &mut self.evaluation;
        hold_loose(plan, (rows, self.least_hold), tangent);
        let solver = solver(&mut self.systems);
        let factored = solver.refactor(plan.pattern, &self.evaluation.tangent);
        if factored.is_ok() && solver.solve(&mut self.correction).is_ok() {
            for (equation, &dof) in plan.constraints.dof_of_equation.iter().enumerate() {
                self.u[dof] += self.correction[equation];
            }
            plan.constraints.enforce(&self.turns, &mut self.u);
            plan.prescribe(target.step_time, &mut self.u);
        }
    }
}
