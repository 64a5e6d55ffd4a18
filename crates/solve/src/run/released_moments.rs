//! Moments that a step lets go of at nodes that turn in space.

use super::analysis::Analysis;
use crate::moments::into_moments;

impl Analysis<'_> {
    /// What a step lets go of at the rotations of nodes in space acts as loads do: as moments about
    /// fixed axes, docs/theory.md eq. (4.15).
    pub(super) fn let_go_of_moments(&self, number: usize, forces: &mut [f64]) {
        if self.model.steps[number - 1].nlgeom {
            let axes = self.values.motion.axes();
            let at = (&self.committed.displacement[..], &self.committed.turns[..]);
            into_moments((&self.plan.dofs, axes), at, None, forces);
        }
    }
}
