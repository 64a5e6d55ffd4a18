//! What the laws of a contact point make of its trial.

use crate::contact::PointKinematics;
use crate::observe::results::{FrictionCall, Status};
use crate::problem::Problem;
use crate::state::PointState;
use slideline_mech::contact::enforcement::HeldMultiplier;
use slideline_mech::contact::friction;
use slideline_mech::contact::pair::{Laws, PointTrial, UserState};
use slideline_mech::contact::tangential::Tangential;

/// A point between its committed and its trial state.
pub(super) struct Encounter<'a> {
    pub plan: &'a Problem<'a>,
    pub laws: &'a Laws,
    pub before: &'a PointState,
    pub kinematics: &'a PointKinematics,
    /// What a law without a function takes as it is [F/L2].
    pub estimate: (f64, Tangential),
    pub slip: Tangential,
    pub dt: f64,
}

impl Encounter<'_> {
    /// Pressure and traction of laws that are inserted about held multipliers [F/L2].
    pub(super) fn inserted(
        &self,
        held: &HeldMultiplier,
        state_variables: &mut UserState<'_>,
    ) -> (f64, Tangential) {
        let (laws, kappa) = (self.laws, held.tangential_stiffness);
        if !self.kinematics.faces {
            return (0.0, Tangential::ZERO);
        }
        if held.normal_stiffness == 0.0 {
            return self.estimate; // before the first tangent
        }
        let overclosure = self.kinematics.overclosure;
        let normal =
            laws.complementarity_of_pressure(held.pressure, overclosure, held.normal_stiffness);
        if !laws.has_friction() || !laws.onset.called(self.before.closed, true) {
            return (normal.value, Tangential::ZERO);
        }
        if kappa.is_infinite() && laws.friction.needs_multiplier() {
            return (normal.value, self.estimate.1); // a slip that is prescribed
        }
        let values = (held.traction, self.slip, normal.value);
        let stiffness = (kappa, self.dt);
        let committed = self.before.elastic_slip;
        let tangential =
            laws.complementarity_of_traction(values, committed, stiffness, state_variables);
        (normal.value, tangential.value)
    }

    /// The laws of the point, and its history, were the trial committed.
    pub(super) fn follow(&self, state_variables: &mut UserState<'_>) -> PointState {
        let (kinematics, before, slip) = (self.kinematics, self.before, self.slip);
        let trial = PointTrial {
            overclosure: kinematics.overclosure,
            slip,
            pressure: self.estimate.0,
            traction: self.estimate.1,
            stiffness: self.plan.structure.stiffest / kinematics.area,
            dt: self.dt,
        };
        let response = self.laws.respond(&before.history(), &trial, state_variables);
        if !response.called {
            state_variables.state.copy_from_slice(state_variables.committed);
        }
        let (closed, traction) = (response.closed, response.traction);
        let status = match (closed, traction.status) {
            (false, _) => Status::Open,
            (true, friction::Status::Stick) => Status::Stick,
            (true, friction::Status::Slip) => Status::Slip,
        };
        let friction = match (closed && self.laws.has_friction(), response.called) {
            (false, _) => FrictionCall::None,
            (true, true) => FrictionCall::Called,
            (true, false) => FrictionCall::Dropped,
        };
        let mut now = PointState {
            closed,
            ever_closed: before.ever_closed || closed,
            status,
            friction,
            pressure: response.pressure,
            traction: traction.tau,
            opening: -kinematics.overclosure,
            allowed: kinematics.allowed,
            along: kinematics.faces.then_some(kinematics.along),
            elastic_slip: traction.elastic_slip,
            slip: if closed { before.slip + slip } else { before.slip },
            dissipated: traction.dissipated_slip,
            dropped_work: 0.0,
            position: kinematics.position,
            normal: kinematics.normal,
            area: kinematics.area,
            xi: kinematics.xi,
            footing: kinematics.footing,
            segment: kinematics.segment(),
            stands_alone: false,
        };
        if friction == FrictionCall::Dropped {
            let limit = self.laws.friction.limit_traction(response.pressure, slip, self.dt);
            let ellipse = self.laws.friction.ellipse();
            now.dropped_work = now.area * limit * ellipse.slip_on_circle(slip).size();
        }
        now
    }
}
