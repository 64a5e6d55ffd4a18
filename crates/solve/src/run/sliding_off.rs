//! Nodes that slide off the ends of their masters: said once of a pair, counted, and said again at
//! the end of the run where there were more.

use super::analysis::{Analysis, Left, SlidOff};
use crate::observe::Event;
use crate::problem::Problem;
use crate::target::Target;
use slideline_diag::Diagnostic;

impl Analysis<'_> {
    /// Says of every pair once that a node slid off, and behind the last increment how many did.
    pub(super) fn judge_ends(
        &mut self,
        plan: &Problem<'_>,
        target: &Target,
        (left, is_last): (Vec<(usize, Diagnostic)>, bool),
    ) -> Result<(), Left> {
        for (pair, said) in left {
            if let Some(known) = self.slid_off.iter_mut().find(|known| known.pair == pair) {
                known.times += 1;
                known.last = said;
                continue;
            }
            self.tell(Event::Diagnosed(&said))?;
            self.slid_off.push(SlidOff { pair, times: 1, last: said });
        }
        if !is_last || target.step < plan.model.steps.len() {
            return Ok(());
        }
        for SlidOff { pair, times, last } in std::mem::take(&mut self.slid_off) {
            if times > 1 {
                let name = &plan.model.contact_pairs[pair].name;
                let message = format!(
                    "nodes of {name} slid off an end of their master {times} times in all, the last \
                     time: {}",
                    last.message
                );
                self.tell(Event::Diagnosed(&Diagnostic { message, ..last }))?;
            }
        }
        Ok(())
    }
}
