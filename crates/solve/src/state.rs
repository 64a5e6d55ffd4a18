//! What history needs, as a value: commit is a swap, a cutback drops a value.

use crate::account::Books;
use crate::convergence::FluxAverage;
use crate::observe::{Energies, FrictionCall, Status};
use serde::{Deserialize, Serialize};
use slideline_mech::contact::pair::History;
use slideline_mech::contact::tangential::Tangential;

/// A committed (or trial) state of the whole model.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct State {
    /// Total time [T].
    pub total_time: f64,
    /// Time in the step [T].
    pub step_time: f64,
    /// Displacements and rotations, a dof each [L or 1].
    pub displacement: Vec<f64>,
    /// The last increment of each, for the first guess of the next.
    pub increment: Vec<f64>,
    /// The increment before it.
    pub increment_before: Vec<f64>,
    /// Length of the last increment and of the one before [T]; zero: none.
    pub increment_time: (f64, f64),
    /// Forces of supports on the model [F or F L].
    pub reaction: Vec<f64>,
    /// Applied loads [F or F L].
    pub load: Vec<f64>,
    /// Contact points, in the order of the plan.
    pub points: Vec<PointState>,
    /// State values of user friction laws.
    pub state_variables: Vec<f64>,
    /// State variables of the elements and their materials, block by block.
    pub elements: Vec<f64>,
    /// Average flux of forces and moments over the step.
    pub flux: [Flow; 2],
    /// Nodal forces of contact stabilisation, a dof each; empty without it.
    pub damping: Vec<f64>,
    /// Whether contact of this step is stabilised without the deck's asking.
    pub stabilised: bool,
    /// Energies.
    pub energy: Energies,
    /// Sum of the energies that `balance` counts from [F L]; set by the first
    /// converged increment.
    pub balance_origin: Option<f64>,
    /// What the increments turned over and left unbalanced.
    pub books: Books,
}

/// Average flux of one field.
pub type Flow = FluxAverage;

/// History of a contact point.
#[derive(Clone, Copy, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct PointState {
    /// Whether it carries pressure.
    pub closed: bool,
    /// Whether it ever did.
    pub ever_closed: bool,
    /// Open, stick or slip.
    pub status: Status,
    /// Whether friction was called.
    pub friction: FrictionCall,
    /// Pressure [F/L2].
    pub pressure: f64,
    /// Shear traction [F/L2].
    pub traction: Tangential,
    /// Gap, open positive [L].
    pub opening: f64,
    /// Coordinates along the master [L]; `None` where it faces none.
    pub along: Option<Tangential>,
    /// Elastic slip [L].
    pub elastic_slip: Tangential,
    /// Slip accumulated while closed [L].
    pub slip: Tangential,
    /// Magnitude of the slip dissipated in the last increment [L].
    pub dissipated: f64,
    /// Friction work dropped by the onset in the last increment [F L].
    pub dropped_work: f64,
    /// Current position [L].
    pub position: [f64; 3],
    /// Outward normal of the master [1].
    pub normal: [f64; 3],
    /// Area it stands for [L2].
    pub area: f64,
    /// Where an integration point stands on its element, 0 to 1.
    pub xi: f64,
}

impl PointState {
    /// Whether this is what [`PointState::open_from`] makes of an integration point that
    /// was never closed.
    pub fn is_untouched(&self) -> bool {
        self.opening == f64::INFINITY && self.area == 0.0 && !self.ever_closed
    }

    /// A integration_point that faces nothing: open, what it has done before kept.
    pub fn open_from(&mut self, before: &Self) {
        let (ever_closed, slip) = (before.ever_closed, before.slip);
        let opening = f64::INFINITY;
        *self = Self { ever_closed, slip, opening, ..Self::default() };
    }

    /// What the contact laws want to know of it.
    pub fn history(&self) -> History {
        History { closed: self.closed, along: self.along, elastic_slip: self.elastic_slip }
    }
}

impl State {
    /// The undeformed model: everything zero, every point open. `states` counts the state
    /// values of user friction laws and those of elements.
    pub fn undeformed(dofs: usize, points: usize, states: (usize, usize)) -> Self {
        Self {
            displacement: vec![0.0; dofs],
            increment: vec![0.0; dofs],
            increment_before: vec![0.0; dofs],
            reaction: vec![0.0; dofs],
            load: vec![0.0; dofs],
            points: vec![PointState::default(); points],
            state_variables: vec![0.0; states.0],
            elements: vec![0.0; states.1],
            ..Self::default()
        }
    }
}
