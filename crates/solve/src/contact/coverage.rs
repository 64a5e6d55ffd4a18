//! Slave nodes of which the master covers next to nothing: let go step by step, not at once.
//!
//! ```text
//!       master  |
//!   ------------'          the function of b is small on what is covered. Where a has it too, nothing holds
//!   a==========.---b       the corner any more: it goes down, covers more, is held again, goes up ...
//!       slave
//! ```
//!
//! docs/theory.md section 5.10

use super::pairs::Contact;
use crate::state::{PointState, State};

/// Part of the area of the node of a face that has most of it, which a node must have to carry
/// contact of its own there [1].
pub(super) const LEAST_AREA: f64 = 0.05;

/// The same from which on a node is held whole, and of one that has less when it is covered as that other one is: then [1].
const HELD_AREA: f64 = 0.25;

/// How deep a node may stand unheld half-way between both, by the size of its faces [1].
const FREE: f64 = 0.01;

/// How deep at most [1].
const DEEPEST: f64 = 0.1;

/// How far a node is on the way from one that carries nothing of its own (0) to one that is held whole (1), by what is
/// covered of it and by its whole area, and by those of the node beside it that has most [L2]: docs/theory.md eq. (5.50).
pub(super) fn held_part((own, whole): (f64, f64), (most, whole_most): (f64, f64)) -> f64 {
    let [part, all] =
        [(own, most), (whole, whole_most)].map(|(a, b)| if b > 0.0 { a / b } else { 0.0 });
    let held = HELD_AREA.min(all);
    if part >= held { 1.0 } else { ((part - LEAST_AREA) / (held - LEAST_AREA)).max(0.0) }
}

/// How deep a node may stand in the master unheld, by the size of its faces [1]: docs/theory.md eq. (5.51).
pub(super) fn free_depth(held: f64) -> f64 {
    if held <= 0.0 { DEEPEST } else { (FREE * ((1.0 - held) / held).powi(2)).min(DEEPEST) }
}

impl Contact {
    /// Work of edges and of nodes that are hardly covered as more or less of their depth is allowed, by the
    /// trapezoidal rule [F L]; what steps allow is left out.
    pub(super) fn work_of_free_depths(&self, committed: &State, trial: &State) -> f64 {
        let free = |state: &PointState, by_step: &[f64], place: usize| {
            state.allowed - by_step.get(place).copied().unwrap_or(0.0)
        };
        let states = committed.points.iter().zip(&trial.points).enumerate();
        let work = |(place, (then, now)): (usize, (&PointState, &PointState))| {
            let mean = 0.5 * (then.area * then.pressure + now.area * now.pressure);
            // what faced nothing was allowed nothing that could do work
            if mean == 0.0 || !then.opening.is_finite() {
                return 0.0;
            }
            let taken = free(then, &self.allowed_before, place) - free(now, &self.allowed, place);
            mean * taken
        };
        let is_let_go = |place: usize| self.is_edge(place) || self.points[place].is_spread();
        states.filter(|(place, _)| is_let_go(*place)).map(work).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: what is covered as its neighbours are is held; less and less is held as it comes out from under
    /// the master, without a leap.
    #[test]
    fn nodes_are_let_go_step_by_step() {
        let at = |part: f64| free_depth(held_part((part, 1.0), (1.0, 1.0)));
        assert_eq!([at(1.0), at(HELD_AREA), at(LEAST_AREA)], [0.0, 0.0, DEEPEST]);
        assert!((at(0.5 * (HELD_AREA + LEAST_AREA)) - FREE).abs() < 1e-15);
        let depths: Vec<f64> = (0..=1000).map(|k| at(1e-3 * f64::from(k))).collect();
        assert!(depths.windows(2).all(|own| own[1] <= own[0] && own[0] - own[1] < 0.2 * DEEPEST));
    }

    /// Requirement: a node with small faces that are covered whole is held.
    #[test]
    fn coverage_counts_and_not_size() {
        for whole in [1e-3, 0.06, 0.2, 0.5] {
            assert_eq!(held_part((2.0 * whole, 2.0 * whole), (2.0, 2.0)), 1.0);
        }
        assert!(held_part((0.1, 0.2), (1.0, 1.0)) < 1.0);
        assert_eq!(held_part((0.0, 1.0), (0.0, 1.0)), 0.0);
    }
}
