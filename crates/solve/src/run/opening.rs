//! The beginning of a step: what it starts from, what it changes.

use super::analysis::{Analysis, Left};
use crate::convergence::FluxAverage;
use crate::start::Start;

impl Analysis<'_> {
    /// Opens a step: the state becomes that of its beginning, and `start` what it begins from.
    pub(super) fn open_step(
        &mut self,
        number: usize,
        start: &mut Start<'static>,
    ) -> Result<(), Left> {
        self.committed.step_time = 0.0;
        self.committed.increment_time = (0.0, 0.0);
        self.committed.flux.iter_mut().for_each(FluxAverage::begin_step);
        self.committed.damping.clear();
        self.committed.stabilised = false;
        let own = self.plan.of_step[number - 1];
        start.take(self.committed, &self.plan.steps[own].constraints);
        self.let_go_of_moments(number, start.released.to_mut());
        if number == 1 {
            self.begin_stressed(start);
        }
        self.change_model(number, start)
    }
}
