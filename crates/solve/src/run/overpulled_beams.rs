//! When it is told that beams are pulled beyond what their shear stiffness is good for.

use super::analysis::{Analysis, Left};
use crate::increments::Verdict;
use crate::newton::Outcome;
use crate::observe::Event;
use crate::overpulled::{Moment, Overpulled};
use crate::problem::Problem;
use crate::target::Target;
use slideline_diag::{Code, Diagnostic};

impl Analysis<'_> {
    /// Takes note of the worst element of a committed increment, whose results stand in the rows.
    pub(super) fn watch_overpulled(&mut self, plan: &Problem<'_>, target: &Target) {
        let found = match plan.step.nlgeom {
            true => Overpulled::worst(plan, &self.rows.elements),
            false => None,
        };
        self.overpulled.take(found, Moment::of(target, self.committed.total_time));
    }

    /// Says what was found since it last was asked.
    pub(super) fn judge_overpulled(&mut self, plan: &Problem<'_>) -> Result<(), Left> {
        match self.overpulled.take_warning(plan.model) {
            Some(said) => self.tell(Event::Diagnosed(&said)),
            None => Ok(()),
        }
    }

    /// Says why a run stops, and what was found until then.
    pub(super) fn tell_cause(
        &mut self,
        plan: &Problem<'_>,
        outcome: &Outcome,
        found: Diagnostic,
    ) -> Result<Left, Left> {
        let cause = Box::new(self.blame_overpulled(plan, outcome, found));
        self.judge_overpulled(plan)?;
        self.tell(Event::Diagnosed(&cause))?;
        Ok(Left::Failed(cause))
    }

    /// The diagnosis of a run that stops, with the element that is its likely cause, where there is one in the last
    /// state or in that in which the attempt was given up.
    fn blame_overpulled(
        &self,
        plan: &Problem<'_>,
        outcome: &Outcome,
        said: Diagnostic,
    ) -> Diagnostic {
        let failed =
            !matches!(outcome.verdict, Verdict::Converged { .. } | Verdict::TooCoarse { .. });
        if !failed || !plan.step.nlgeom || said.code == Code("SL0505") {
            return said;
        }
        let tried = Overpulled::worst(plan, &self.rows.elements);
        let mut found = [self.overpulled.now, tried].into_iter().flatten();
        match found.find(Overpulled::is_wrong) {
            Some(found) => found.blamed_in(plan.model, said),
            None => said,
        }
    }
}
