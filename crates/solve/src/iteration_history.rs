//! What the iterations of an attempt showed, point by point.
//!
//! ```text
//!   iteration        1  2  3  4  5  6  7  8
//!   closed           #  .  #  .  #  .  #  .     changes 1111111: it chatters
//!   slides           >  >  <  >  <  <  >  <     flips    110101: it wavers
//! ```
//!
//! A diagnosis rests on this, not on the last iteration alone.

use crate::observe::results::Status;
use crate::state::PointState;
use slideline_mech::contact::tangential::Tangential;

/// Iterations that are looked back upon.
const WINDOW: u32 = 8;
/// How often a point must change in them to count as chattering.
const RESTLESS: u32 = 4;

/// A contact point in the iterations of an attempt.
#[derive(Clone, Copy, Debug, Default)]
pub struct PointHistory {
    closed: bool,
    status: Status,
    traction: Tangential,
    /// One bit an iteration, the latest lowest: it opened or closed.
    changes: u32,
    /// Likewise: it began or ceased to slide, or slid the other way.
    flips: u32,
    /// Overclosure in the last iteration and in the one before [L].
    pub overclosure: (f64, f64),
    /// Largest shear traction, and pressure with it, of the attempt [F/L2].
    pub dragged: (f64, f64),
}

impl PointHistory {
    fn note(&mut self, now: &PointState) {
        let both = self.closed && now.closed;
        let turned = self.traction.dot(now.traction) < 0.0;
        let wavers = both && (self.status != now.status || turned);
        self.changes = self.changes << 1 | u32::from(self.closed != now.closed);
        self.flips = self.flips << 1 | u32::from(wavers);
        (self.closed, self.status, self.traction) = (now.closed, now.status, now.traction);
        self.overclosure = (-now.opening, self.overclosure.0);
        if now.traction.size() > self.dragged.0 {
            self.dragged = (now.traction.size(), now.pressure);
        }
    }

    /// In how many of the last iterations it opened or closed.
    pub fn changes(&self) -> u32 {
        latest(self.changes)
    }

    /// In how many of them it changed between stick and slip, or its way.
    pub fn flips(&self) -> u32 {
        latest(self.flips)
    }
}

fn latest(bits: u32) -> u32 {
    (bits & ((1 << WINDOW) - 1)).count_ones()
}

/// All contact points in the iterations of an attempt.
#[derive(Clone, Debug, Default)]
pub struct IterationHistory {
    /// In the order of the plan.
    pub points: Vec<PointHistory>,
    iterations: u32,
}

impl IterationHistory {
    /// Room for `points` points.
    pub fn new(points: usize) -> Self {
        let mut new = Self::default();
        new.fit(points);
        new
    }

    /// Forgets all, with room for `points` points.
    pub fn fit(&mut self, points: usize) {
        self.points.clear();
        self.points.resize(points, PointHistory::default());
        self.iterations = 0;
    }

    /// Begins an attempt at its first guess.
    pub fn begin(&mut self, guess: &[PointState]) {
        self.iterations = 0;
        for (point, now) in self.points.iter_mut().zip(guess) {
            *point = PointHistory::default();
            point.note(now);
            (point.changes, point.flips) = (0, 0);
        }
    }

    /// Takes an iteration in.
    pub fn note(&mut self, now: &[PointState]) {
        self.iterations += 1;
        for (point, now) in self.points.iter_mut().zip(now) {
            if point.closed || now.closed || point.changes != 0 {
                point.note(now);
            }
        }
    }

    /// Iterations that counts refer to.
    pub fn window(&self) -> u32 {
        self.iterations.min(WINDOW)
    }

    /// Points that opened and closed again and again, those that changed most first.
    pub fn chattering(&self) -> Vec<usize> {
        self.changing_most(PointHistory::changes)
    }

    /// Closed points that went on changing between stick and slip, or their
    /// way, those that changed most first.
    pub fn stick_slip_cycling(&self) -> Vec<usize> {
        self.changing_most(PointHistory::flips)
    }

    fn changing_most(&self, count: fn(&PointHistory) -> u32) -> Vec<usize> {
        let mut places: Vec<usize> =
            (0..self.points.len()).filter(|&k| count(&self.points[k]) >= RESTLESS).collect();
        places.sort_by_key(|&k| std::cmp::Reverse(count(&self.points[k])));
        places
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(closed: bool, status: Status, traction: f64) -> PointState {
        PointState {
            closed,
            status,
            traction: Tangential::along(traction),
            ..PointState::default()
        }
    }

    /// Requirement: a point that opens and closes in every iteration chatters;
    /// one that changes twice does not; one that stays closed and turns its
    /// slip round wavers.
    #[test]
    fn restless_points_are_told_apart() {
        let at = |k: u32| {
            let swing = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            [
                point(k.is_multiple_of(2), Status::Slip, 0.0),
                point(k > 3, Status::Stick, 1.0),
                point(true, Status::Slip, swing),
            ]
        };
        let mut iteration_history = IterationHistory::new(3);
        iteration_history.begin(&at(0));
        for k in 1..10 {
            iteration_history.note(&at(k));
        }
        assert_eq!((iteration_history.window(), iteration_history.chattering()), (8, vec![0]));
        assert_eq!(iteration_history.stick_slip_cycling(), [2]);
        assert_eq!(
            (iteration_history.points[0].changes(), iteration_history.points[2].flips()),
            (8, 8)
        );
        iteration_history.begin(&at(0));
        assert!(
            iteration_history.chattering().is_empty()
                && iteration_history.stick_slip_cycling().is_empty()
        );
    }
}
