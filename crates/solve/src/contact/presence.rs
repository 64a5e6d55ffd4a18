//! The contact of a step: pairs that are absent have nothing to slide on.

use super::kinematics::ContactKinematics;
use super::master::MasterSurface;
use super::pairs::Contact;
use super::positions::MasterPositions;
use crate::state::{PointState, State};
use slideline_model::Presence;
use std::borrow::Cow;

/// Energy of contact that is let go [F L].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Released {
    /// That of the normal laws.
    pub laws: f64,
    /// That of elastic slip.
    pub slip: f64,
}

impl Contact {
    /// The contact of a step.
    pub fn of_step(&self, presence: &Presence) -> Cow<'_, Self> {
        if presence.absent_pairs.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut own = self.clone();
        for &pair in &presence.absent_pairs {
            if let Some(master) = own.masters.get_mut(pair) {
                *master = MasterSurface::Nothing;
            }
        }
        own.opposed.retain(|pairs| pairs.iter().all(|&pair| presence.has_pair(pair)));
        own.chain_nodes = 0;
        for master in &mut own.masters {
            if let MasterSurface::Line { offset, .. } | MasterSurface::Faces { offset, .. } = master
            {
                *offset = own.chain_nodes;
            }
            own.chain_nodes += master.nodes().len();
        }
        Cow::Owned(own)
    }

    /// Adds `factor` times the forces of the points of some pairs in a committed state [F], and
    /// lets these points forget what they did; the energy that they held.
    pub fn release(
        &self,
        pairs: &[usize],
        (state, factor): (&mut State, f64),
        force: &mut [f64],
    ) -> Released {
        let mut held = Released::default();
        if pairs.is_empty() {
            return held;
        }
        let (mut positions, mut kinematics) = (MasterPositions::default(), self.nowhere());
        let at = (&state.displacement[..], &state.points[..]);
        self.meet(at, &[], &mut positions, &mut kinematics);
        for (place, point) in self.points.iter().enumerate() {
            if pairs.contains(&point.pair) {
                let own = self.push_out(place, (state, factor), &kinematics, force);
                held.laws += own.laws;
                held.slip += own.slip;
                let own = point.state_variables..point.state_variables + point.state_size;
                state.state_variables[own].fill(0.0);
                state.points[place] = PointState::default();
            }
        }
        held
    }

    fn push_out(
        &self,
        place: usize,
        (state, factor): (&State, f64),
        kinematics: &ContactKinematics,
        force: &mut [f64],
    ) -> Released {
        let now = &state.points[place];
        if !now.closed {
            return Released::default();
        }
        let tangential = now.area * now.traction;
        let normal = now.area * now.pressure;
        kinematics.at(place).push(factor * normal, factor * tangential, force);
        let law = &self.laws[self.points[place].pair].normal;
        let laws = now.area * law.energy(-now.opening);
        Released { laws, slip: 0.5 * tangential.dot(now.elastic_slip) }
    }
}
