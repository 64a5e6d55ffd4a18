//! What history needs, as a value: commit is a swap, a cutback drops a value.

use crate::books::Books;
use crate::convergence::FluxAverage;
use crate::observe::results::{Energies, FrictionCall, Status};
use serde::{Deserialize, Serialize};
use slideline_mech::contact::pair::{Footing, History};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::element::Temperature;
use slideline_mech::turn::Turn;

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
    /// Temperatures, a node each; empty: those before the first step [theta].
    pub temperatures: Vec<Temperature>,
    /// What rotations in space count from, a node each; empty: all from rest.
    pub turns: Vec<Turn>,
    /// Average flux of forces and moments over the step.
    pub flux: [Flow; 2],
    /// Nodal forces of contact stabilisation, a dof each; empty without it.
    pub damping: Vec<f64>,
    /// Whether contact of this step is stabilised without the deck's asking.
    pub stabilised: bool,
    /// Whether the last increment ended by steps along secants.
    pub by_secants: bool,
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
    /// Overclosure that is allowed, from which the gap counts [L].
    pub allowed: f64,
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
    /// Where it stands on faces in space.
    pub footing: Option<Footing>,
    /// On which segment of a line of nodes, or of a rigid surface.
    pub segment: Option<usize>,
    /// Of a sharp edge that does not separate: whether it stands by itself, where its pair does not hold it.
    pub stands_alone: bool,
}

impl PointState {
    /// Whether this is what [`PointState::open_from`] makes of an integration point that
    /// was never closed.
    pub fn is_untouched(&self) -> bool {
        self.opening == f64::INFINITY && self.area == 0.0 && !self.ever_closed
    }

    /// An integration point that faces nothing: open, what it has done before kept.
    pub fn open_from(&mut self, before: &Self) {
        let (ever_closed, slip) = (before.ever_closed, before.slip);
        let opening = f64::INFINITY;
        *self = Self { ever_closed, slip, opening, ..Self::default() };
    }

    /// Directions in the tangent plane of the master [1]; in the plane the first one is its
    /// direction of travel, the second one stands across the plane.
    pub fn directions(&self) -> [[f64; 3]; 2] {
        let [x, y, _] = self.normal;
        match &self.footing {
            Some(footing) => footing.directions(),
            None => [[y, -x, 0.0], [0.0, 0.0, 1.0]],
        }
    }

    /// The face of its master, or the segment of a line of nodes or a rigid surface, on which it stands.
    pub fn stands_on(&self) -> Option<usize> {
        self.footing.map(|footing| footing.place.face).or(self.segment)
    }

    /// Its gap before anything is allowed; infinite where it faces nothing [L].
    pub fn raw_gap(&self) -> f64 {
        self.opening - self.allowed
    }

    /// What the contact laws want to know of it.
    pub fn history(&self) -> History {
        History { closed: self.closed, along: self.along, elastic_slip: self.elastic_slip }
    }
}

impl State {
    /// Whether its lists are as long as those of another state.
    pub fn has_room_of(&self, other: &Self) -> bool {
        let lengths = |own: &Self| {
            let dofs = (own.displacement.len(), own.increment.len(), own.reaction.len());
            let of_laws = (own.state_variables.len(), own.elements.len());
            (dofs, own.increment_before.len(), own.load.len(), own.points.len(), of_laws)
        };
        lengths(self) == lengths(other)
    }

    /// Becomes a copy of another state, in the room it has.
    pub fn copy_from(&mut self, from: &Self) {
        let Self { total_time, step_time, increment_time, .. } = *from;
        let Self { flux, stabilised, by_secants, energy, balance_origin, books, .. } = *from;
        let Self { displacement, increment, increment_before, reaction, load, .. } = from;
        let Self { points, state_variables, elements, damping, temperatures, turns, .. } = from;
        let lists = [
            (&mut self.displacement, displacement),
            (&mut self.increment, increment),
            (&mut self.increment_before, increment_before),
            (&mut self.reaction, reaction),
            (&mut self.load, load),
            (&mut self.state_variables, state_variables),
            (&mut self.elements, elements),
            (&mut self.damping, damping),
        ];
        lists.into_iter().for_each(|(own, from)| own.clone_from(from));
        self.points.clone_from(points);
        self.temperatures.clone_from(temperatures);
        self.turns.clone_from(turns);
        *self = Self {
            total_time,
            step_time,
            displacement: std::mem::take(&mut self.displacement),
            increment: std::mem::take(&mut self.increment),
            increment_before: std::mem::take(&mut self.increment_before),
            increment_time,
            reaction: std::mem::take(&mut self.reaction),
            load: std::mem::take(&mut self.load),
            points: std::mem::take(&mut self.points),
            state_variables: std::mem::take(&mut self.state_variables),
            elements: std::mem::take(&mut self.elements),
            temperatures: std::mem::take(&mut self.temperatures),
            turns: std::mem::take(&mut self.turns),
            flux,
            damping: std::mem::take(&mut self.damping),
            stabilised,
            by_secants,
            energy,
            balance_origin,
            books,
        };
    }

    /// Becomes the undeformed model: everything zero, every point open. `states` counts the
    /// state values of user friction laws and those of elements.
    pub fn begin(&mut self, dofs: usize, points: usize, states: (usize, usize)) {
        let mut own = Self {
            points: std::mem::take(&mut self.points),
            damping: std::mem::take(&mut self.damping),
            temperatures: std::mem::take(&mut self.temperatures),
            turns: std::mem::take(&mut self.turns),
            ..Self::default()
        };
        let lists = [
            (&mut self.displacement, &mut own.displacement, dofs),
            (&mut self.increment, &mut own.increment, dofs),
            (&mut self.increment_before, &mut own.increment_before, dofs),
            (&mut self.reaction, &mut own.reaction, dofs),
            (&mut self.load, &mut own.load, dofs),
            (&mut self.state_variables, &mut own.state_variables, states.0),
            (&mut self.elements, &mut own.elements, states.1),
        ];
        for (room, list, count) in lists {
            *list = std::mem::take(room);
            list.clear();
            list.resize(count, 0.0);
        }
        own.damping.clear();
        own.temperatures.clear();
        own.turns.clear();
        own.points.clear();
        own.points.resize(points, PointState::default());
        *self = own;
    }

    /// The undeformed model.
    pub fn undeformed(dofs: usize, points: usize, states: (usize, usize)) -> Self {
        let mut state = Self::default();
        state.begin(dofs, points, states);
        state
    }
}
