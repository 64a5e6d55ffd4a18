//! One attempt at an increment: iterations until a verdict.

use super::multipliers::MOST_MOVES;
use super::outcome::{Outcome, Progress};
use super::scratch::Scratch;
use super::search;
use crate::contact::{Missed, Sweep};
use crate::increments::Verdict;
use crate::observe::reports::IterationReport;
use crate::problem::Problem;
use crate::state::State;
use crate::target::Target;
use slideline_model::{ElementBlock, Section};

/// Walks one increment. `watch` sees every iteration; on success the
/// workspace holds the converged trial.
pub fn attempt(
    plan: &Problem<'_>,
    committed: &State,
    target: &Target,
    work: &mut Scratch,
    watch: &mut dyn FnMut(&IterationReport),
) -> Outcome {
    work.begin(plan, committed, target);
    let limits = match work.line_search {
        false => plan.step.controls.effective_time(),
        true => search::limits(&plan.step.controls.effective_time()),
    };
    let mut progress = Progress::default();
    if work.evaluation.failed.is_some() {
        work.complete(plan, committed);
        return progress.end(Verdict::Collapsed, None);
    }
    loop {
        if let Err(fault) = work.iterate(plan, committed, target.dt) {
            work.complete(plan, committed);
            return progress.end(Verdict::Broken, Some(fault));
        }
        if work.outside() || work.evaluation.fault.is_some() {
            work.complete(plan, committed);
            return progress.end(Verdict::Broken, None);
        }
        if work.evaluation.failed.is_some() {
            work.complete(plan, committed);
            return progress.end(Verdict::Collapsed, None);
        }
        let mut report = work.judge(plan, committed, target, &mut progress);
        if report.converged && !work.complete(plan, committed) {
            // one that was left alone touches after all: its pressure comes next
            work.evaluate(plan, committed, target.dt);
            report.converged = false;
        }
        watch(&report);
        let verdict = progress.verdict(&report, &limits);
        progress.last = Some(report);
        if let Some(verdict) = verdict {
            work.secants.is_wanted |= verdict == Verdict::TooSlow;
            work.complete(plan, committed);
            if flows_away(plan, &progress, verdict) {
                return progress.end(Verdict::FlowsAway, None);
            }
            let missed = match verdict {
                Verdict::Converged { .. } => work.missed(plan, committed),
                _ => None,
            };
            return match missed {
                Some(missed) => progress.end_with(missed),
                None => progress.end(verdict, None),
            };
        }
        if work.move_multipliers(plan, progress.allowed_force()) {
            progress.moves += 1;
            progress.begin_anew();
            work.secants.forget();
            if work.moves > MOST_MOVES {
                work.complete(plan, committed);
                return progress.end(Verdict::TooSlow, None);
            }
        }
    }
}

/// An increment of displacement in sizes of the model that no metal body makes and is whole [1].
const AWAY: f64 = 1e4;

/// Whether an equilibrium lies where metal has flowed away: its stiffness is that of rounding, which
/// the linear system cannot tell from a small one.
fn flows_away(plan: &Problem<'_>, progress: &Progress, verdict: Verdict) -> bool {
    let converged = matches!(verdict, Verdict::Converged { .. });
    let metal = |block: &ElementBlock| match &block.section {
        Section::Solid(section) => section.material.hardening_end().is_some(),
        _ => false,
    };
    let grown = progress.last.as_ref().map_or(0.0, |report| report.force.increment);
    converged && grown > AWAY * plan.reach && plan.model.blocks.iter().any(metal)
}

impl Scratch {
    /// Contact that the way from the last commit to the trial passes through.
    fn missed(&mut self, plan: &Problem<'_>, committed: &State) -> Option<Missed> {
        let sweep = Sweep {
            constraints: plan.constraints,
            rotations: plan.dofs.rotations(),
            turns: &self.turns,
            from: &committed.displacement,
            to: &self.u,
            before: &committed.points,
            now: &self.evaluation.points,
        };
        let through = plan.contact.passed_through(&sweep, &mut self.sweep);
        through.or_else(|| plan.contact.passed_between(&sweep))
    }
}
