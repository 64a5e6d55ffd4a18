//! The trial state of an attempt, evaluated.

use super::scratch::Scratch;
use crate::evaluate::{Evaluation, Trial, complete, evaluate, evaluate_forces, evaluate_tangent};
use crate::problem::Problem;
use crate::state::State;
use crate::structure::Ambient;

impl Scratch {
    /// The trial state that was evaluated last.
    pub fn trial(&self, committed: &State, dt: f64) -> Trial<'_> {
        Trial {
            u: &self.u,
            load: &self.load,
            faces: &self.faces,
            stresses: &self.stresses,
            pressures: &self.pressures,
            tractions: &self.tractions,
            standing: &self.standing,
            held: &self.held.of,
            dashpots: &self.dashpots,
            ambient: Ambient {
                temperatures: &self.temperatures,
                turns: &self.turns,
                clock: self.clock,
            },
            time: committed.total_time + dt,
            dt,
        }
    }

    /// Evaluates the trial state.
    pub(super) fn evaluate(&mut self, plan: &Problem<'_>, committed: &State, dt: f64) {
        if self.line_search {
            self.follow_law(plan);
        }
        self.evaluate_by(plan, committed, dt, evaluate);
        self.tangent_is_behind = false;
    }

    /// Makes the tangents of the elements of a trial state whose forces are known.
    pub(super) fn evaluate_tangents(&mut self, plan: &Problem<'_>, committed: &State, dt: f64) {
        self.evaluate_by(plan, committed, dt, evaluate_tangent);
        self.tangent_is_behind = false;
    }

    /// Evaluates the trial state but for the tangents of the elements, which the next iteration
    /// makes if there is one.
    pub(super) fn evaluate_without_tangent(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
    ) {
        self.evaluate_by(plan, committed, dt, evaluate_forces);
    }

    /// Evaluates the trial state as it is, or a part of it; the tangents count as those of another state.
    pub(super) fn evaluate_by(
        &mut self,
        plan: &Problem<'_>,
        committed: &State,
        dt: f64,
        evaluate: fn(&Problem<'_>, &State, &Trial<'_>, &mut Evaluation),
    ) {
        self.give_back();
        self.tangent_is_behind = true;
        self.write_evaluation(|work, into| {
            evaluate(plan, committed, &work.trial(committed, dt), into)
        });
        if plan.inserts_laws() {
            self.follow_inserted_laws();
        }
    }

    /// Looks at the points that iterations have left alone; says whether none of
    /// them touches.
    pub(super) fn complete(&mut self, plan: &Problem<'_>, committed: &State) -> bool {
        let dt = self.dt;
        self.write_evaluation(|work, into| {
            complete(plan, committed, &work.trial(committed, dt), into)
        })
    }

    /// Lends the evaluation out to be written while the trial is read.
    fn write_evaluation<R>(&mut self, write: impl FnOnce(&Self, &mut Evaluation) -> R) -> R {
        let mut evaluation = std::mem::take(&mut self.evaluation);
        let written = write(self, &mut evaluation);
        self.evaluation = evaluation;
        written
    }
}
