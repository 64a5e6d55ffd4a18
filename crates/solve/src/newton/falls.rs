//! Loose bodies that a load takes along, with nothing in its way yet.
//!
//! ```text
//!       | F            the springs that hold the block in the iteration would carry F: nothing else
//!      _v_             does, until contact closes
//!     |___|
//!   =========
//! ```
//!
//! docs/theory.md section 8.18. (derived)

use super::hold::{HOLD, springs_on_loose};
use super::scratch::Scratch;
use crate::problem::Problem;
use crate::state::State;
use slideline_linalg::SolveError;

/// Part of the work on loose bodies that their springs must do at least to be all that holds one [1]. (choice)
const SHARE: f64 = 0.5;

/// Work on loose bodies [F L].
struct Work {
    /// Of forces that are not balanced but by contact.
    work: f64,
    /// Of the springs that hold them.
    held: f64,
}

impl Scratch {
    /// What is said of the tangent where the springs on loose bodies do the work against what is unbalanced: nothing but contact
    /// that is still open would hold one.
    pub(super) fn falls(&mut self, plan: &Problem<'_>, committed: &State) -> Option<SolveError> {
        let has_failed = self.outside() || self.evaluation.failed.is_some();
        if !self.holds_loose(plan) || has_failed {
            return None;
        }
        let Work { work, held } = self.work_on_loose(plan);
        let unknown = || plan.loose.iter().flat_map(|body| body.unknowns());
        let (moved, forces) = (&self.correction_dofs, &self.evaluation.structure);
        // what else opposes it is less than the springs are at their weakest
        let weakest = held * HOLD[0] / self.hold;
        let is_unopposed = work > SHARE * held && work - held < weakest;
        let falls = is_unopposed || work > 0.0 && self.is_thrown_round(plan);
        if !falls {
            return None;
        }
        let most = unknown().map(|dof| forces[dof].abs()).fold(0.0, f64::max);
        let way = |dof: usize| moved[dof].abs();
        let dof = unknown().max_by(|a, b| way(*a).total_cmp(&way(*b)))?;
        let equation = plan.constraints.equation(dof)?;
        let loaded = most > self.floors(plan, committed)[0];
        loaded.then(|| SolveError::Singular { equation, ratio: plan.reach / way(dof) })
    }

    /// Work of what is unbalanced and of the springs along the correction.
    fn work_on_loose(&mut self, plan: &Problem<'_>) -> Work {
        self.expand_correction(plan);
        let (moved, forces) = (&self.correction_dofs, &self.evaluation.structure);
        let springs = springs_on_loose(plan, self.hold);
        let unknown = plan.loose.iter().flat_map(|body| body.unknowns());
        Work {
            work: unknown.map(|dof| -forces[dof] * moved[dof]).sum(),
            held: springs.map(|(dof, stiffness)| stiffness * moved[dof] * moved[dof]).sum(),
        }
    }

    /// Whether a body that nothing presses on swings far about the support that it hangs on, until contact would stop it.
    pub(super) fn is_thrown_round(&self, plan: &Problem<'_>) -> bool {
        let pair = |place: usize| plan.contact.parent(plan.contact.points[place].pair);
        let presses = |body: usize| {
            let own = |place: &usize| plan.loose.of_pair(pair(*place)).contains(&body);
            (0..self.pressures.len()).filter(own).any(|place| self.pressures[place] != 0.0)
        };
        let mut bodies = plan.loose.iter().enumerate();
        let way = |dof: usize| self.correction_dofs[dof];
        bodies.any(|(k, own)| own.hangs() && own.goes_far(way, plan.dofs) && !presses(k))
    }
}
