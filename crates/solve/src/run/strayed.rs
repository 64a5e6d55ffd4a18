//! What is said of slave nodes that stand in the part of their master, where no force acts on them.

use super::analysis::{Analysis, Left};
use crate::newton::Scratch;
use crate::observe::Event;
use crate::problem::Problem;
use slideline_diag::{Code, Diagnostic};

impl Analysis<'_> {
    /// Says so once where a slave node stands in the part of its master, to which it came where that surface ends.
    pub(super) fn judge_strayed(&mut self, plan: &Problem<'_>, work: &Scratch) -> Result<(), Left> {
        if self.strayed_are_judged {
            return Ok(());
        }
        let committed = &*self.committed;
        let points = work.evaluation.kinematics.points();
        let Some(found) = plan.contact.strayed(plan, committed, points) else { return Ok(()) };
        self.strayed_are_judged = true;
        let pair = &plan.model.contact_pairs[found.pair];
        let message = format!(
            "slave node {} of {} stands {:.3e} behind the master, in element {}, at total time {:.6}: it came in where the \
             surface of the master ends, and no force acts on it",
            plan.model.nodes.name(found.node),
            pair.name,
            found.depth,
            found.element,
            committed.total_time
        );
        let said = Diagnostic::warning(Code("SL0627"), message).at(pair.origin).help(
            "spread the contact over faces with TYPE=SURFACE TO SURFACE, or name the faces at the end of the master in its \
             *SURFACE too: contact forces there are too small or missing",
        );
        self.tell(Event::Diagnosed(&said))
    }
}
