//! Steps, attempts and checkpoints, told as they come.

use super::analysis::{Analysis, Left};
use super::shown::{Numbers, frame};
use crate::checkpoint::Checkpoint;
use crate::contact::NearContact;
use crate::diagnose;
use crate::increments::{Control, Decision, Verdict};
use crate::newton::{Outcome, Scratch, attempt};
use crate::observe::reports::{AttemptReport, IterationReport};
use crate::observe::{Event, StepReport};
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;
use slideline_linalg::Kind;
use std::borrow::Cow;
use std::ops::ControlFlow;

impl Analysis<'_> {
    /// What follows from an attempt, with what creep says to it.
    pub(super) fn decide(
        &mut self,
        plan: &Problem<'_>,
        (control, target): (&Control, &Target),
        outcome: &mut Outcome,
        work: &Scratch,
    ) -> Decision {
        let part = self.coarseness(plan, (target, outcome), work);
        let (step, limits) = (plan.step, plan.step.controls.effective_time());
        let decision =
            control.after(outcome.verdict, &step.procedure, &limits, step.max_increments);
        match part {
            Some(part) => control.as_creep_allows(decision, part, &step.procedure, &limits),
            None => decision,
        }
    }

    /// By which part of what `CETOL` allows the creep strains of an increment differ, taken by the
    /// conditions at its two ends; one that is too coarse is no longer taken for converged. `None`:
    /// nothing is asked.
    fn coarseness(
        &mut self,
        plan: &Problem<'_>,
        (target, outcome): (&Target, &mut Outcome),
        work: &Scratch,
    ) -> Option<f64> {
        let allowed = plan.step.procedure.creep_tolerance?;
        let converged = matches!(outcome.verdict, Verdict::Converged { .. });
        if !converged || target.dt <= 0.0 {
            return None;
        }
        let trial = &mut self.trial.elements;
        trial.copy_from_slice(&self.committed.elements);
        plan.structure.gather_state(&work.evaluation.contributions, trial);
        let part = plan.structure.creep_difference(trial) / allowed;
        if part > 1.0 && !plan.step.procedure.direct {
            outcome.verdict = Verdict::TooCoarse { percent: (100.0 * part) as u32 };
        }
        Some(part)
    }

    /// An attempt, its iterations counted and shown.
    pub(super) fn attempt(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        work: &mut Scratch,
    ) -> Result<Outcome, Left> {
        self.watched(|committed, watch| attempt(plan, committed, target, work, watch))
    }

    /// Iterations that are counted and shown.
    pub(super) fn watched(
        &mut self,
        iterate: impl FnOnce(&State, &mut dyn FnMut(&IterationReport)) -> Outcome,
    ) -> Result<Outcome, Left> {
        let mut stop = None;
        let (observer, totals) = (&mut *self.observer, &mut self.totals);
        let mut watch = |report: &IterationReport| {
            totals.iterations += 1;
            if let ControlFlow::Break(reason) = observer.event(Event::Iteration(report)) {
                stop = Some(reason);
            }
        };
        let outcome = iterate(self.committed, &mut watch);
        match stop {
            Some(stop) => Err(Left::Stopped(stop)),
            None => Ok(outcome),
        }
    }

    /// Counts an attempt that failed, and shows it.
    pub(super) fn fail(
        &mut self,
        plan: &Problem<'_>,
        (target, outcome): (&Target, &Outcome),
        next: Option<f64>,
    ) -> Result<(), Left> {
        self.totals.cutbacks += 1;
        let report = AttemptReport {
            step: target.step,
            increment: target.increment,
            attempt: target.attempt,
            severe_iterations: outcome.severe,
            equilibrium_iterations: outcome.equilibrium,
            total_time: self.committed.total_time + target.dt,
            step_time: target.step_time,
            time_increment: target.dt,
            reason: diagnose::reason(plan, outcome),
            next,
        };
        self.tell(Event::AttemptFailed(&report))
    }

    /// Announces a step with the state it begins from, or goes on from.
    pub(super) fn begin(
        &mut self,
        plan: &Problem<'_>,
        number: usize,
        from: Option<&Checkpoint<'_>>,
        work: &mut Scratch,
    ) -> Result<(), Left> {
        if let Some(said) = work.objection().or_else(|| diagnose::not_insertable(plan)) {
            self.tell(Event::Diagnosed(&said))?;
            return Err(Left::Failed(Box::new(said)));
        }
        self.rows.fill(plan, (self.committed, None));
        self.rows.pairs.clear();
        self.rows.sections.clear();
        let increment = from.map_or(0, |from| from.increment);
        let numbers = Numbers { step: number, increment, ..Numbers::default() };
        let frame = frame(plan, self.committed, &numbers, self.rows);
        let report = StepReport {
            model: self.model,
            step: number,
            equations: plan.constraints.equations(),
            entries: plan.pattern.entries(),
            linear_solver: work.solver().description(),
            unsymmetric: plan.kind() == Kind::Unsymmetric,
            total_time: self.committed.total_time,
            start: frame,
            resumed: from.is_some() && self.resumes,
        };
        match self.observer.event(Event::StepBegin(&report)) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }

    /// Shows the state that the run could go on from, if it goes on.
    pub(super) fn keep(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        decision: &Decision,
        stopping: bool,
    ) -> Result<(), Left> {
        let control = match decision {
            Decision::Continue(next) => Some(*next),
            Decision::StepDone => None,
            Decision::Cut(_) | Decision::Stop(_) => return Ok(()),
        };
        let checkpoint = Checkpoint {
            step: target.step,
            increment: target.increment,
            stopping,
            totals: self.totals,
            state: Cow::Borrowed(&*self.committed),
            start: plan.start.borrowed(),
            control,
            heaviest: Cow::Borrowed(&self.rows.heaviest.pairs),
            overpulled: self.overpulled,
            near: NearContact { candidates: Cow::Borrowed(plan.near), is_lenient: plan.is_lenient },
        };
        match self.observer.event(Event::Checkpoint(&checkpoint)) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }
}
