//! Everything a run needs to go on, as a value and as bytes.
//!
//! ```text
//!   committed state + start of the step + increment control + counts
//!        |                                                     ^
//!        +--> Event::Checkpoint --> bytes --> file --> bytes --+--> resume
//! ```
//!
//! A run that goes on from a checkpoint is the same, bit for bit, as one that
//! was never left: an increment depends on nothing but these values and the
//! model. [derived]

use crate::account::Books;
use crate::bytes::{Packed, Unpacking};
use crate::contact::{memory_size, point_count};
use crate::convergence::FluxAverage;
use crate::dofs::DofMap;
use crate::increments::Control;
use crate::observe::{Energies, FrictionCall, Status, Totals};
use crate::plan::Start;
use crate::state::{PointState, State};
use slideline_model::{ContactPair, Model};
use std::borrow::Cow;

/// A committed increment, from which history can go on.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint<'a> {
    /// Step number from 1.
    pub step: usize,
    /// Increments committed in that step.
    pub increment: usize,
    /// Whether an observer stops the run here.
    pub stopping: bool,
    /// Counts of the run so far.
    pub totals: Totals,
    pub(crate) state: Cow<'a, State>,
    /// What the step began from.
    pub(crate) start: Start<'a>,
    /// Where the step goes on; `None`: it is done.
    pub(crate) control: Option<Control>,
}

impl Checkpoint<'_> {
    /// The same, to be kept for longer than the event that shows it.
    pub fn owned(&self) -> Checkpoint<'static> {
        Checkpoint {
            state: Cow::Owned(self.state.clone().into_owned()),
            start: self.start.owned(),
            ..*self
        }
    }

    /// Whether the step ends here.
    pub fn last_of_step(&self) -> bool {
        self.control.is_none()
    }

    /// Total time [T].
    pub fn total_time(&self) -> f64 {
        self.state.total_time
    }

    /// Energies since time 0.
    pub fn energy(&self) -> Energies {
        self.state.energy
    }

    /// Whether nothing of the model is left to do.
    pub fn finishes(&self, model: &Model) -> bool {
        self.control.is_none() && self.step >= model.steps.len()
    }

    /// Whether the state is one of this model: so many nodes, points and
    /// steps, and an increment that can be tried.
    pub fn fits(&self, model: &Model) -> bool {
        let slots = DofMap::new(model).len();
        let points = model.contact_pairs.iter().map(point_count).sum::<usize>();
        let memory = |pair: &ContactPair| point_count(pair) * memory_size(pair);
        let memory = model.contact_pairs.iter().map(memory).sum::<usize>();
        let state = &self.state;
        let vectors = [
            &state.displacement[..],
            &state.increment,
            &state.increment_before,
            &state.reaction,
            &state.load,
            &self.start.displacement,
            &self.start.load,
            &self.start.released,
        ];
        let Some(step) = self.step.checked_sub(1).and_then(|place| model.steps.get(place)) else {
            return false;
        };
        let ahead = self.control.is_none_or(|control| {
            let within = control.time >= 0.0 && control.time < step.procedure.period;
            within && control.dt.is_finite() && control.dt > 0.0
        });
        ahead
            && state.total_time.is_finite()
            && state.step_time.is_finite()
            && vectors.iter().all(|vector| vector.len() == slots)
            && vectors.iter().all(|vector| vector.iter().all(|value| value.is_finite()))
            && (state.points.len(), state.memory.len()) == (points, memory)
            && state.elements.len() == model.element_states()
            && state.elements.iter().all(|value| value.is_finite())
            && [0, slots].contains(&state.damping.len())
            && state.damping.iter().all(|value| value.is_finite())
    }

    /// Appends everything to `bytes`.
    pub fn pack(&self, bytes: &mut Packed) {
        let Totals { increments, cutbacks, iterations, dropped_points } = self.totals;
        for count in [self.step, self.increment, increments, cutbacks, iterations, dropped_points] {
            bytes.count(count);
        }
        let Start { displacement, load, released } = &self.start;
        [displacement, load, released].into_iter().for_each(|vector| bytes.list(vector));
        bytes.flag(self.control.is_some());
        if let Some(Control { time, dt, committed, attempts, quick }) = self.control {
            bytes.numbers(&[time, dt]);
            for count in [committed, attempts as usize, quick as usize] {
                bytes.count(count);
            }
        }
        pack_state(&self.state, bytes);
    }

    /// Reads what [`Checkpoint::pack`] has written; `None` where the bytes
    /// are something else.
    pub fn unpack(bytes: &mut Unpacking<'_>) -> Option<Checkpoint<'static>> {
        let (step, increment) = (bytes.count()?, bytes.count()?);
        let totals = Totals {
            increments: bytes.count()?,
            cutbacks: bytes.count()?,
            iterations: bytes.count()?,
            dropped_points: bytes.count()?,
        };
        let start = Start {
            displacement: Cow::Owned(bytes.list()?),
            load: Cow::Owned(bytes.list()?),
            released: Cow::Owned(bytes.list()?),
        };
        let control = if bytes.flag()? { Some(unpack_control(bytes)?) } else { None };
        let state = Cow::Owned(unpack_state(bytes)?);
        let stopping = false;
        Some(Checkpoint { step, increment, stopping, totals, state, start, control })
    }
}

fn unpack_control(bytes: &mut Unpacking<'_>) -> Option<Control> {
    let [time, dt] = bytes.numbers()?;
    let committed = bytes.count()?;
    // both are counted up, one at a time
    let small = |count: usize| u32::try_from(count).ok().filter(|&count| count < u32::MAX / 2);
    let attempts = small(bytes.count()?)?;
    let quick = small(bytes.count()?)?;
    Some(Control { time, dt, committed, attempts, quick })
}

/// Every field by name, so that a new one cannot be forgotten.
fn pack_state(state: &State, bytes: &mut Packed) {
    let State {
        total_time,
        step_time,
        displacement,
        increment,
        increment_before,
        increment_time,
        reaction,
        load,
        points,
        memory,
        elements,
        flux,
        damping,
        stabilised,
        energy,
        balance_origin,
        books,
    } = state;
    bytes.numbers(&[*total_time, *step_time]);
    bytes.numbers(increment_time);
    let motion = [displacement, increment, increment_before, reaction, load];
    for vector in motion.into_iter().chain([memory, elements, damping]) {
        bytes.list(vector);
    }
    bytes.flag(*stabilised);
    bytes.count(points.len());
    points.iter().for_each(|point| pack_point(point, bytes));
    flux.iter().for_each(|average| bytes.numbers(&average.parts()));
    let Energies {
        external_work,
        strain_energy,
        contact_energy,
        friction_dissipation,
        friction_elastic,
        dropped_friction,
        stabilisation,
        released_energy,
        balance,
    } = *energy;
    bytes.numbers(&[external_work, strain_energy, contact_energy, friction_dissipation]);
    bytes.numbers(&[friction_elastic, dropped_friction, stabilisation, released_energy, balance]);
    bytes.optional(*balance_origin);
    pack_books(books, bytes);
}

fn pack_books(books: &Books, bytes: &mut Packed) {
    let Books { turned_over, left, opening, opening_dissipation, .. } = *books;
    let Books { step, steps, worst, worst_at, worst_dt, .. } = *books;
    bytes.numbers(&[turned_over, left, opening, opening_dissipation]);
    bytes.numbers(&[step, steps, worst, worst_dt]);
    worst_at.iter().for_each(|&number| bytes.count(number));
}

fn unpack_books(bytes: &mut Unpacking<'_>) -> Option<Books> {
    let [turned_over, left, opening, opening_dissipation] = bytes.numbers()?;
    let [step, steps, worst, worst_dt] = bytes.numbers()?;
    Some(Books {
        turned_over,
        left,
        opening,
        opening_dissipation,
        step,
        steps,
        worst,
        worst_at: [bytes.count()?, bytes.count()?],
        worst_dt,
    })
}

fn unpack_state(bytes: &mut Unpacking<'_>) -> Option<State> {
    let [total_time, step_time] = bytes.numbers()?;
    let increment_time = bytes.numbers()?;
    let [displacement, increment, increment_before] = [bytes.list()?, bytes.list()?, bytes.list()?];
    let [reaction, load] = [bytes.list()?, bytes.list()?];
    let [memory, elements] = [bytes.list()?, bytes.list()?];
    let (damping, stabilised) = (bytes.list()?, bytes.flag()?);
    let points = (0..bytes.length(POINT)?).map(|_| unpack_point(bytes)).collect::<Option<_>>()?;
    let flux = [FluxAverage::of_parts(bytes.numbers()?), FluxAverage::of_parts(bytes.numbers()?)];
    let energy = Energies {
        external_work: bytes.number()?,
        strain_energy: bytes.number()?,
        contact_energy: bytes.number()?,
        friction_dissipation: bytes.number()?,
        friction_elastic: bytes.number()?,
        dropped_friction: bytes.number()?,
        stabilisation: bytes.number()?,
        released_energy: bytes.number()?,
        balance: bytes.number()?,
    };
    let balance_origin = bytes.optional()?;
    let books = unpack_books(bytes)?;
    Some(State {
        total_time,
        step_time,
        displacement,
        increment,
        increment_before,
        increment_time,
        reaction,
        load,
        points,
        memory,
        elements,
        flux,
        damping,
        stabilised,
        energy,
        balance_origin,
        books,
    })
}

/// Bytes that a point takes at least.
const POINT: usize = 100;

fn pack_point(point: &PointState, bytes: &mut Packed) {
    let PointState {
        closed,
        ever_closed,
        status,
        friction,
        pressure,
        traction,
        opening,
        along,
        elastic_slip,
        slip,
        dissipated,
        dropped_work,
        position,
        normal,
        area,
        xi,
    } = *point;
    bytes.flag(closed);
    bytes.flag(ever_closed);
    bytes.choice(match status {
        Status::Open => 0,
        Status::Stick => 1,
        Status::Slip => 2,
    });
    bytes.choice(match friction {
        FrictionCall::None => 0,
        FrictionCall::Called => 1,
        FrictionCall::Dropped => 2,
    });
    bytes.numbers(&[pressure, traction, opening]);
    bytes.optional(along);
    bytes.numbers(&[elastic_slip, slip, dissipated, dropped_work]);
    bytes.numbers(&position);
    bytes.numbers(&normal);
    bytes.numbers(&[area, xi]);
}

fn unpack_point(bytes: &mut Unpacking<'_>) -> Option<PointState> {
    Some(PointState {
        closed: bytes.flag()?,
        ever_closed: bytes.flag()?,
        status: match bytes.choice()? {
            0 => Status::Open,
            1 => Status::Stick,
            2 => Status::Slip,
            _ => return None,
        },
        friction: match bytes.choice()? {
            0 => FrictionCall::None,
            1 => FrictionCall::Called,
            2 => FrictionCall::Dropped,
            _ => return None,
        },
        pressure: bytes.number()?,
        traction: bytes.number()?,
        opening: bytes.number()?,
        along: bytes.optional()?,
        elastic_slip: bytes.number()?,
        slip: bytes.number()?,
        dissipated: bytes.number()?,
        dropped_work: bytes.number()?,
        position: bytes.numbers()?,
        normal: bytes.numbers()?,
        area: bytes.number()?,
        xi: bytes.number()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checkpoint() -> Checkpoint<'static> {
        let mut state = State::undeformed(6, 2, (1, 3));
        state.displacement = vec![0.1, -0.0, f64::MIN_POSITIVE, 1e300, 3.0, -7.5];
        state.elements = vec![0.0, -2.5, 1e-300];
        state.points[1] = PointState {
            closed: true,
            status: Status::Slip,
            friction: FrictionCall::Dropped,
            along: Some(-0.0),
            opening: f64::INFINITY,
            ..PointState::default()
        };
        state.flux[1] = FluxAverage::of_parts([1.5, 2.0, 0.5]);
        state.balance_origin = Some(0.3);
        state.energy.released_energy = 0.125;
        state.books = Books { turned_over: 2.0, worst_at: [2, 7], ..Books::default() };
        Checkpoint {
            step: 2,
            increment: 7,
            stopping: false,
            totals: Totals { increments: 9, cutbacks: 1, iterations: 55, dropped_points: 3 },
            state: Cow::Owned(state),
            start: Start {
                displacement: Cow::Owned(vec![0.5; 6]),
                load: Cow::Owned(vec![0.25; 6]),
                released: Cow::Owned(vec![0.125; 6]),
            },
            control: Some(Control { time: 0.3, dt: 0.1, committed: 7, attempts: 2, quick: 1 }),
        }
    }

    /// Requirement: bytes hold every bit, and every shorter text is refused.
    #[test]
    fn there_and_back() {
        let mut bytes = Packed::default();
        checkpoint().pack(&mut bytes);
        let mut read = Unpacking(&bytes.0);
        let back = Checkpoint::unpack(&mut read).unwrap();
        assert!(read.is_done());
        assert_eq!(back, checkpoint());
        let bits = |state: &State| -> Vec<u64> {
            state.displacement.iter().map(|value| value.to_bits()).collect()
        };
        assert_eq!(bits(&back.state), bits(&checkpoint().state));
        for length in 0..bytes.0.len() {
            assert!(Checkpoint::unpack(&mut Unpacking(&bytes.0[..length])).is_none(), "{length}");
        }
    }

    /// Requirement: no byte makes reading panic or take more memory than the
    /// text has.
    #[test]
    fn any_byte_is_survived() {
        let mut bytes = Packed::default();
        checkpoint().pack(&mut bytes);
        for place in 0..bytes.0.len() {
            for value in [0, 1, 0x7f, 0xff] {
                let mut other = bytes.0.clone();
                other[place] = value;
                let _ = Checkpoint::unpack(&mut Unpacking(&other));
            }
        }
    }
}
