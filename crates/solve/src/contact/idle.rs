//! Points that no motion so far will have brought into contact.
//!
//! ```text
//!      x - - > x   opening, as its derivatives carry it along the way since it was
//!      |       |   last looked at: far more than what may turn meanwhile
//!   -------------  master
//! ```
//!
//! An iteration leaves them alone. Before a state is taken as converged they are
//! looked at again; one that touches after all, as where a part comes to face it
//! that did not before, sends the iteration on.

use super::kinematics::{ContactKinematics, PointRows};
use super::master::MasterSurface;
use super::pairs::{Carrier, Contact};
use super::positions::{distance, square};

/// Room for the turning of what a point faces along its way, as a part of that [1].
const ROOM: f64 = 1.0;

/// What was seen when all points were last looked at.
#[derive(Clone, Debug, Default)]
pub struct Look {
    /// Displacements then; empty: never.
    at: Vec<f64>,
    /// Whether no evaluation has followed: the kinematics of all points are those
    /// of then. Later this holds for the ones that were left alone ever since.
    is_fresh: bool,
    /// Whether each point is left alone.
    pub idle: Vec<bool>,
    /// Whether that was said from outside.
    is_told: bool,
}

impl Look {
    /// Forgets what was seen: all points are looked at next.
    pub fn forget(&mut self) {
        self.at.clear();
        self.idle.fill(false);
        self.is_told = false;
    }

    /// Leaves these points alone in the next evaluation, whatever was seen.
    pub fn leave(&mut self, alone: &[bool]) {
        self.idle.clear();
        self.idle.extend_from_slice(alone);
        self.is_told = true;
    }

    /// Whether all points were last looked at at displacements `u`.
    pub fn is_at(&self, u: &[f64]) -> bool {
        self.at == u
    }

    /// Notes that all points were looked at, at displacements `u`.
    pub fn note(&mut self, u: &[f64]) {
        self.at.clear();
        self.at.extend_from_slice(u);
        self.is_fresh = true;
    }
}

impl Contact {
    /// Finds the points that the way to `u` leaves open by what was seen, of those
    /// that carry no pressure by the estimates. One that was looked at since stays
    /// looked at until all are.
    pub fn find_idle(
        &self,
        kinematics: &ContactKinematics,
        (u, pressures): (&[f64], &[f64]),
        look: &mut Look,
    ) {
        if std::mem::take(&mut look.is_told) {
            return;
        }
        look.idle.resize(self.points.len(), false);
        if look.at.is_empty() {
            look.idle.fill(false);
            return;
        }
        for (place, &pressure) in pressures.iter().enumerate() {
            look.idle[place] = (look.is_fresh || look.idle[place])
                && pressure == 0.0
                && self.stays_open(place, &kinematics.at(place), u, look);
        }
        look.is_fresh = false;
    }

    /// Wakes the idle points that the way to `u` may close, which the next evaluation looks at too;
    /// says whether there are any.
    pub fn wake(&self, kinematics: &ContactKinematics, u: &[f64], look: &mut Look) -> bool {
        let mut woken = false;
        for place in 0..look.idle.len() {
            if look.idle[place] && !self.stays_open(place, &kinematics.at(place), u, look) {
                look.idle[place] = false;
                woken = true;
            }
        }
        look.is_told |= woken;
        woken
    }

    /// Whether a point bears on nothing but itself while it is open.
    pub fn may_be_left(&self, place: usize) -> bool {
        let point = &self.points[place];
        // what may not separate is held wherever it goes, what is allowed changes with time
        let is_bound = self.keeps[point.pair] || !self.allowed.is_empty();
        !is_bound && point.is_node() && point.mortar.is_none()
    }

    fn stays_open(&self, place: usize, kinematics: &PointRows<'_>, u: &[f64], look: &Look) -> bool {
        let point = &self.points[place];
        let Carrier::Node { position, dofs, section } = &point.carrier else { return false };
        if !kinematics.faces || !self.may_be_left(place) {
            return false;
        }
        let master = &self.masters[point.pair];
        let way = match master {
            MasterSurface::Nothing => return false,
            MasterSurface::Body { .. } => {
                let seen = |u: &[f64]| master.placed_body(u).to_body(dofs.displace(*position, u));
                distance(seen(u), seen(&look.at))
            }
            MasterSurface::Line { .. } | MasterSurface::Faces { .. } => {
                let own = dofs.as_slice();
                let moved = |own: &[usize]| {
                    let mut way = [0.0; 3];
                    way.iter_mut().zip(own).for_each(|(w, &dof)| *w = u[dof] - look.at[dof]);
                    way
                };
                let way = moved(own);
                let of_slave = own.len() + usize::from(section[0].1 != 0.0);
                let facing = kinematics.rows.unknowns[of_slave..].chunks_exact(own.len());
                facing.map(|own| square(way, moved(own))).fold(0.0, f64::max).sqrt()
            }
        };
        let own = kinematics.rows.unknowns.iter().zip(kinematics.rows.normal());
        let closing: f64 = own.map(|(&dof, g)| g * (u[dof] - look.at[dof])).sum();
        let begins = self.laws[point.pair].normal.contact_begins();
        // what an edge is allowed may be less by now
        let overclosure = kinematics.overclosure + kinematics.allowed;
        begins - (overclosure + closing) > ROOM * way
    }
}
