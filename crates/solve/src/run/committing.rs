//! A converged increment committed and shown, its tangent checked.

use super::analysis::{Analysis, Left};
use super::shown::{Numbers, Rows, frame};
use crate::balance::pair_rows;
use crate::commit::commit;
use crate::diagnose;
use crate::heaviest::take_approaches;
use crate::increments::Decision;
use crate::joined_forces::joined_forces;
use crate::newton::{Outcome, Scratch};
use crate::observe::Event;
use crate::observe::results::{FrictionCall, Status};
use crate::problem::Problem;
use crate::section_forces::section_rows;
use crate::tangent;
use crate::target::Target;
use std::ops::ControlFlow;

impl Analysis<'_> {
    /// Makes the trial the committed state and shows it.
    pub(super) fn commit(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        outcome: &Outcome,
        decision: &Decision,
        work: &mut Scratch,
    ) -> Result<(), Left> {
        if self.check_tangent.is_due(target.increment) {
            self.check(plan, target, work)?;
        }
        commit(plan, self.committed, target, work, self.trial);
        let left = diagnose::slid_off(plan, self.committed, self.trial);
        std::mem::swap(self.committed, self.trial);
        if outcome.leapt {
            self.committed.increment_time = (0.0, 0.0);
        }
        self.totals.increments += 1;
        let Rows { contact, closed, .. } = &mut *self.rows;
        closed.clear();
        closed.extend(contact.iter().map(|row| row.status != Status::Open));
        let dropped = |point: &&crate::state::PointState| point.friction == FrictionCall::Dropped;
        self.totals.dropped_points += self.committed.points.iter().filter(dropped).count();
        self.rows.fill(plan, (self.committed, Some(&work.evaluation.kinematics)));
        self.watch_overpulled(plan, target);
        let last = *decision == Decision::StepDone;
        let numbers = Numbers { last, ..Numbers::of(target, outcome) };
        let Rows { contact, closed, pairs, sums, .. } = &mut *self.rows;
        pair_rows(plan, self.committed, work, (contact, closed), (pairs, sums));
        section_rows(plan, self.committed, work, &mut self.rows.sections);
        joined_forces(plan, self.committed, work, &mut self.rows.joined);
        // where points stand is asked before the search for a jump moves them
        let strayed = self.strayed(plan, work);
        let jumped = self.balance_books(plan, target, work);
        let Rows { pairs, heaviest, .. } = &mut *self.rows;
        heaviest.take(plan, (self.committed, work), last, pairs);
        take_approaches(self.committed, &mut self.rows.pairs);
        let frame = frame(plan, self.committed, &numbers, self.rows);
        // A wish to stop does not keep back what belongs to the increment.
        let mut told = match self.observer.event(Event::Committed(&frame)) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        };
        if told.is_ok() {
            told = self.differentiate((plan, target), &numbers, work);
        }
        if *decision == Decision::StepDone {
            told = told.and(self.judge_stabilisation(plan)).and(self.judge_balance(plan, target));
            told = told.and(self.judge_overpulled(plan));
        }
        told = told.and(self.judge_room(plan)).and(self.judge_edges(plan, work));
        told = told.and(strayed.iter().try_for_each(|said| self.tell(Event::Diagnosed(said))));
        told = told.and(self.judge_means(plan));
        if let Some(jumped) = &jumped {
            told = told.and(self.tell(Event::Diagnosed(jumped)));
        }
        let is_last = *decision == Decision::StepDone;
        told = told.and(self.judge_ends(plan, target, (left, is_last)));
        let kept = self.keep(plan, target, decision, told.is_err());
        told.and(kept)
    }

    /// Holds the tangent of the converged trial against differences.
    fn check(&mut self, plan: &Problem<'_>, target: &Target, work: &Scratch) -> Result<(), Left> {
        let trial = work.trial(self.committed, target.dt);
        let place =
            tangent::Place { plan, committed: self.committed, trial, evaluation: &work.evaluation };
        let report = tangent::check(&place, (target.step, target.increment));
        let fault = tangent::fault(plan, &report).filter(|_| !self.tangent_is_wrong);
        self.tell(Event::Tangent(&report))?;
        self.tangent_is_wrong |= fault.is_some();
        fault.iter().try_for_each(|said| self.tell(Event::Diagnosed(said)))
    }
}
