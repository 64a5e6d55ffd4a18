//! What is said of slave nodes that stand in the part of their master, where no force acts on them.

use super::analysis::Analysis;
use crate::newton::Scratch;
use crate::problem::Problem;
use slideline_diag::{Code, Diagnostic};

impl Analysis<'_> {
    /// What is to be said, once, where a slave node stands in the part of its master, to which it came where that surface
    /// ends.
    pub(super) fn strayed(&mut self, plan: &Problem<'_>, work: &Scratch) -> Option<Diagnostic> {
        if self.strayed_are_told {
            return None;
        }
        let points = work.evaluation.kinematics.points();
        let found = plan.contact.strayed(plan, self.committed, points)?;
        self.strayed_are_told = true;
        let pair = &plan.model.contact_pairs[found.pair];
        let message = format!(
            "slave node {} of {} stands {:.3e} behind the master, in element {}, at total time {:.6}: it came in where the \
             surface of the master ends, and no force acts on it",
            plan.model.nodes.name(found.node),
            pair.name,
            found.depth,
            found.element,
            self.committed.total_time
        );
        Some(Diagnostic::warning(Code("SL0627"), message).at(pair.origin).help(
            "spread the contact over faces with TYPE=SURFACE TO SURFACE, or name the faces at the end of the master in its \
             *SURFACE too: contact forces there are too small or missing",
        ))
    }
}
