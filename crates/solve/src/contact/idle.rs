//! Points that no motion so far can have brought into contact.
//!
//! ```text
//!      x  opening when it was last looked at
//!      |  > way of the point + way of its master since: it is open still
//!   ---------  master
//! ```
//!
//! An iteration leaves them alone. Before a state is taken as converged they are
//! looked at again; one that touches after all, as where a part comes to face it
//! that did not before, sends the iteration on.

use super::facade::Facade;
use super::meeting::Meeting;
use super::{Carrier, Contact};

/// Room for rounding and for the turning of what is near, as a part of the ways [1].
const ROOM: f64 = 0.1;

/// What was seen when all points were last looked at.
#[derive(Clone, Debug, Default)]
pub struct Look {
    /// Displacements then; empty: never.
    at: Vec<f64>,
    /// Largest way of each pair's master since [L].
    ways: Vec<f64>,
    /// Whether each point is left alone.
    pub idle: Vec<bool>,
}

impl Look {
    /// Forgets what was seen: all points are looked at next.
    pub fn forget(&mut self) {
        self.at.clear();
        self.idle.fill(false);
    }

    /// Notes that all points were looked at, at displacements `u`.
    pub fn note(&mut self, u: &[f64]) {
        self.at.clear();
        self.at.extend_from_slice(u);
    }
}

impl Contact {
    /// Finds the points that the way to `u` leaves open for certain, of those that
    /// carry no pressure by the estimates.
    pub fn find_idle(
        &self,
        meetings: &[Meeting],
        (u, pressures): (&[f64], &[f64]),
        look: &mut Look,
    ) {
        look.idle.resize(self.points.len(), false);
        if look.at.is_empty() {
            look.idle.fill(false);
            return;
        }
        self.ways(u, look);
        for place in 0..self.points.len() {
            look.idle[place] =
                pressures[place] == 0.0 && self.stays_open(place, &meetings[place], u, look);
        }
    }

    /// Whether the way to `u` would leave all idle points open.
    pub fn stay_idle(&self, meetings: &[Meeting], u: &[f64], look: &mut Look) -> bool {
        if !look.idle.contains(&true) {
            return true;
        }
        self.ways(u, look);
        let idle = |place: &usize| look.idle[*place];
        (0..self.points.len())
            .filter(idle)
            .all(|place| self.stays_open(place, &meetings[place], u, look))
    }

    fn stays_open(&self, place: usize, meeting: &Meeting, u: &[f64], look: &Look) -> bool {
        let point = &self.points[place];
        let Carrier::Node { slots, .. } = &point.carrier else { return false };
        let way = slots.map(|slot| u[slot] - look.at[slot]);
        let way = way[0].hypot(way[1]) + look.ways[point.pair];
        let begins = self.laws[point.pair].normal.contact_begins();
        meeting.faces && begins - meeting.overclosure > (1.0 + ROOM) * way
    }

    /// Largest way of each master from the last look to `u`.
    fn ways(&self, u: &[f64], look: &mut Look) {
        look.ways.clear();
        for facade in &self.facades {
            let moved = |slot: usize| u[slot] - look.at[slot];
            look.ways.push(match facade {
                Facade::Nothing => 0.0,
                Facade::Body { slots, reference, surface } => {
                    let (centre, radius) = surface.bounds();
                    let arm = (centre[0] - reference[0]).hypot(centre[1] - reference[1]);
                    let turn = moved(slots[2]).abs() * (arm + radius);
                    moved(slots[0]).hypot(moved(slots[1])) + turn
                }
                Facade::Line { chain, nodes, .. } => {
                    let ways = nodes
                        .iter()
                        .map(|(_, slots)| moved(slots[0]).powi(2) + moved(slots[1]).powi(2));
                    let largest = ways.fold(0.0_f64, |a, b| if b > a { b } else { a });
                    (1.0 + 2.0 * chain.extension) * largest.sqrt()
                }
            });
        }
    }
}
