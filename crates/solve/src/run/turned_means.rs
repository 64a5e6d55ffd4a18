//! Whether a cloud of nodes has turned too far for a node that follows its mean turn linearly.
//!
//! ```text
//!     o  o            o             what follows linearly sees sin a of the turn a, and its forces act
//!     o  o   -->    o   o  a        along the first shape of the cloud
//!                     o
//! ```
//!
//! docs/theory.md section 4.2. (derived)

use super::analysis::{Analysis, Left};
use crate::observe::Event;
use crate::problem::Problem;
use slideline_diag::{Code, Diagnostic};
use slideline_mech::vector::size;
use slideline_model::{Dof, LinearMeanTurn};

/// Turn from which on it is told [rad]: moments are wrong by half of its square, 0.5 %.
const FAR: f64 = 0.1;

impl Analysis<'_> {
    /// Says so once of every cloud that has turned far.
    pub(super) fn judge_means(&mut self, plan: &Problem<'_>) -> Result<(), Left> {
        if !plan.step.nlgeom {
            return Ok(());
        }
        for (place, mean) in plan.model.linear_mean_turns.iter().enumerate() {
            if self.turned_means.contains(&place) {
                continue;
            }
            // what is seen of a turn is its sine
            let seen = size(turn_of(plan, mean, &self.committed.displacement)).min(1.0);
            let turn = seen.asin();
            if turn <= FAR {
                continue;
            }
            self.turned_means.push(place);
            let message = format!(
                "the nodes of the *DISTRIBUTING coupling of node {} have turned by about {:.0} degrees at total time {:.6}: \
                 the coupling is that of small turns, its moments are wrong by about {:.1} % there",
                plan.model.nodes.name(mean.reference),
                turn.to_degrees(),
                self.committed.total_time,
                100.0 * (1.0 - turn.cos())
            );
            let said = Diagnostic::warning(Code("SL0623"), message).at(mean.origin).help(
                "couple them rigidly with *KINEMATIC, which any turn is exact for, or apply the load to the surface \
                 itself",
            );
            self.tell(Event::Diagnosed(&said))?;
        }
        Ok(())
    }
}

/// The mean turn of a cloud as small ones are [rad]: along the axis, the sine.
fn turn_of(plan: &Problem<'_>, mean: &LinearMeanTurn, u: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (node, by) in &mean.turns {
        let moved = [Dof::U1, Dof::U2, Dof::U3]
            .map(|dof| plan.dofs.find(*node, dof).map_or(0.0, |dof| u[dof]));
        for (part, row) in sum.iter_mut().zip(by) {
            *part += row.iter().zip(moved).map(|(by, moved)| by * moved).sum::<f64>();
        }
    }
    sum
}
