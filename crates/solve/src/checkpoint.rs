//! Everything a run needs to go on, as a value and as bytes.
//!
//! ```text
//!   committed state + start of the step + increment control + counts
//!        |                                                     ^
//!        +--> Event::Checkpoint --> bytes --> file --> bytes --+--> resume
//!             (serde; the bytes are those of whoever writes the file)
//! ```
//!
//! A run that goes on from a checkpoint is the same, bit for bit, as one that
//! was never left: an increment depends on nothing but these values and the
//! model. [derived]

use crate::contact::{NearContact, contact_sizes};
use crate::dofs::DofMap;
use crate::heaviest::Heaviest;
use crate::increments::Control;
use crate::observe::reports::Totals;
use crate::observe::results::Energies;
use crate::overpulled::OverpulledBeams;
use crate::start::Start;
use crate::state::State;
use crate::structure::Reference;
use serde::{Deserialize, Serialize};
use slideline_mech::element::Temperature;
use slideline_model::Model;
use std::borrow::Cow;

/// No run counts so far.
const MOST: u64 = 1 << 48;

/// A committed increment, from which history can go on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint<'a> {
    /// Step number from 1.
    pub step: usize,
    /// Increments committed in that step.
    pub increment: usize,
    /// Whether an observer stops the run here.
    #[serde(skip)]
    pub stopping: bool,
    /// Counts of the run so far.
    pub totals: Totals,
    pub(crate) state: Cow<'a, State>,
    /// What the step began from.
    pub(crate) start: Start<'a>,
    /// Where the step goes on; `None`: it is done.
    pub(crate) control: Option<Control>,
    /// Pairs where they have carried most so far.
    pub(crate) heaviest: Cow<'a, [Heaviest]>,
    /// Beams of the step so far that are pulled beyond their shear stiffness.
    pub(crate) overpulled: OverpulledBeams,
    /// The contact that the pattern of the tangent holds.
    pub(crate) near: NearContact<'a>,
}

impl Checkpoint<'_> {
    /// The same, to be kept for longer than the event that shows it.
    pub fn owned(&self) -> Checkpoint<'static> {
        Checkpoint {
            state: Cow::Owned(self.state.clone().into_owned()),
            start: self.start.owned(),
            heaviest: Cow::Owned(self.heaviest.clone().into_owned()),
            near: self.near.owned(),
            ..*self
        }
    }

    /// The same, its vectors borrowed.
    pub fn borrowed(&self) -> Checkpoint<'_> {
        Checkpoint {
            state: Cow::Borrowed(&self.state),
            start: self.start.borrowed(),
            heaviest: Cow::Borrowed(&self.heaviest),
            near: self.near.borrowed(),
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

    /// Whether all counts are such that a run can reach: beyond that sums could
    /// overflow.
    pub fn is_sound(&self) -> bool {
        let Totals { increments, cutbacks, iterations, dropped_points } = self.totals;
        let counts = [self.step, self.increment, increments, cutbacks, iterations, dropped_points];
        let [step, increment] = self.state.books.worst_at;
        let control =
            self.control.map_or([0; 3], |Control { committed, attempts, quick, .. }| {
                [committed as u64, u64::from(attempts) << 17, u64::from(quick) << 17]
            });
        let counts = counts.into_iter().chain([step, increment]).map(|count| count as u64);
        counts.chain(control).all(|count| count < MOST)
    }

    /// Whether the state is one of this model: so many nodes, points and
    /// steps, and an increment that can be tried.
    pub fn fits(&self, model: &Model) -> bool {
        let dofs = DofMap::new(model).len();
        let [points, state_variables] = contact_sizes(model);
        let state = &self.state;
        let vectors = [
            &state.displacement[..],
            &state.increment,
            &state.increment_before,
            &state.reaction,
            &state.load,
            &self.start.displacement,
            &self.start.released,
        ];
        let Some(step) = self.step.checked_sub(1).and_then(|place| model.steps.get(place)) else {
            return false;
        };
        let nodes = model.nodes.len();
        let fit = |list: &[Temperature]| {
            [0, nodes].contains(&list.len())
                && list
                    .iter()
                    .all(|at| at.value.is_finite() && at.slopes.iter().all(|own| own.is_finite()))
        };
        let ahead = self.control.is_none_or(|control| {
            let within = control.time >= 0.0 && control.time < step.procedure.period;
            within && control.dt.is_finite() && control.dt > 0.0
        });
        ahead
            && state.total_time.is_finite()
            && state.step_time.is_finite()
            && vectors.iter().all(|vector| vector.len() == dofs)
            && vectors.iter().all(|vector| vector.iter().all(|value| value.is_finite()))
            && (state.points.len(), state.state_variables.len()) == (points, state_variables)
            && state.elements.len() == model.element_states()
            && state.elements.iter().all(|value| value.is_finite())
            && [&state.temperatures[..], &self.start.temperatures].into_iter().all(fit)
            && self.start.references.iter().all(Reference::is_sound)
            && self.start.references.is_sorted_by(|a, b| a.element < b.element)
            && [0, dofs].contains(&state.damping.len())
            && state.damping.iter().all(|value| value.is_finite())
            && self.heaviest.len() == model.contact_pairs.len()
            && self.heaviest.iter().all(Heaviest::is_sound)
            && self.overpulled.fit(model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::books::Books;
    use crate::contact::Candidates;
    use crate::observe::results::{FrictionCall, Status};
    use crate::state::PointState;
    use slideline_mech::contact::tangential::Tangential;

    fn checkpoint() -> Checkpoint<'static> {
        let mut state = State::undeformed(6, 2, (1, 3));
        state.displacement = vec![0.1, -0.0, f64::MIN_POSITIVE, 1e300, 3.0, -7.5];
        state.elements = vec![0.0, -2.5, 1e-300];
        state.points[1] = PointState {
            closed: true,
            status: Status::Slip,
            friction: FrictionCall::Dropped,
            along: Some(Tangential::along(-0.0)),
            opening: f64::INFINITY,
            ..PointState::default()
        };
        (state.balance_origin, state.by_secants) = (Some(0.3), true);
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
                released: Cow::Owned(vec![0.125; 6]),
                temperatures: Cow::Owned(vec![Temperature { value: 20.0, slopes: [0.5, 0.25] }; 2]),
                references: Cow::Owned(vec![Reference {
                    element: 4,
                    displacement: vec![0.25, -1.0],
                    turned: vec![[1.0, 0.0, 0.0, 0.0]],
                    temperatures: vec![Temperature { value: 3.0, slopes: [0.0; 2] }],
                }]),
            },
            control: Some(Control { time: 0.3, dt: 0.1, committed: 7, attempts: 2, quick: 1 }),
            heaviest: Cow::Owned(vec![Heaviest {
                force: 3.0,
                falls_away: 0.1,
                ..Heaviest::default()
            }]),
            overpulled: OverpulledBeams::default(),
            near: NearContact {
                candidates: Cow::Owned(vec![
                    Candidates::All,
                    Candidates::Nodes(3..7),
                    Candidates::Faces(vec![2, 300]),
                    Candidates::Met(vec![5]),
                ]),
                is_lenient: true,
            },
        }
    }

    /// Requirement: bytes hold every bit, and every shorter text is refused.
    #[test]
    fn there_and_back() {
        let bytes = postcard::to_stdvec(&checkpoint()).unwrap();
        let back: Checkpoint<'_> = postcard::from_bytes(&bytes).unwrap();
        assert_eq!(back, checkpoint());
        let bits = |state: &State| -> Vec<u64> {
            state.displacement.iter().map(|value| value.to_bits()).collect()
        };
        assert_eq!(bits(&back.state), bits(&checkpoint().state));
        for length in 0..bytes.len() {
            assert!(postcard::from_bytes::<Checkpoint<'_>>(&bytes[..length]).is_err(), "{length}");
        }
    }

    /// Requirement: no byte makes reading panic or take more state_variables than the
    /// text has.
    #[test]
    fn any_byte_is_survived() {
        let bytes = postcard::to_stdvec(&checkpoint()).unwrap();
        for place in 0..bytes.len() {
            for value in [0, 1, 0x7f, 0xff] {
                let mut other = bytes.clone();
                other[place] = value;
                let _ = postcard::from_bytes::<Checkpoint<'_>>(&other);
            }
        }
    }

    /// Requirement: a count that no run reaches is told, wherever it stands.
    #[test]
    fn counts_are_bounded() {
        assert!(checkpoint().is_sound());
        let large = usize::MAX / 2;
        let totals = Totals { iterations: large, ..checkpoint().totals };
        assert!(!Checkpoint { step: large, ..checkpoint() }.is_sound());
        assert!(!Checkpoint { totals, ..checkpoint() }.is_sound());
        let control = checkpoint().control.map(|own| Control { attempts: u32::MAX, ..own });
        assert!(!Checkpoint { control, ..checkpoint() }.is_sound());
    }
}
