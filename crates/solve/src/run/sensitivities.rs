//! Increments and beginnings of steps, differentiated.
//!
//! ```text
//!   state before --open--> beginning --increments--> ...      each with its derivatives
//!   neighbours:   the same functions at p + kh and s + kh ds/dp
//! ```
//!
//! docs/theory.md section 13.

use super::analysis::{Analysis, Left, Room};
use super::neighbours::Increment;
use super::options::Options;
use super::shown::Numbers;
use crate::commit::locate_points;
use crate::contact::MasterPositions;
use crate::newton::Scratch;
use crate::observe::{Event, Observer, Stop};
use crate::problem::Problem;
use crate::sensitivity::{Varied, combine_starts, combine_states, move_start, move_state};
use crate::start::Start;
use crate::state::State;
use crate::target::Target;
use slideline_model::Model;
use std::ops::ControlFlow;

/// Nobody watches the neighbours.
struct Nobody;

impl Observer for Nobody {
    fn event(&mut self, _: Event<'_>) -> ControlFlow<Stop> {
        ControlFlow::Continue(())
    }
}

impl Analysis<'_> {
    /// Keeps the state before a step, where the run is differentiated.
    pub(super) fn note_before(&mut self) {
        if self.varied.is_some() {
            self.before = Some(Box::new((self.committed.clone(), self.start.owned())));
        }
    }

    /// Differentiates the beginning of a step. A neighbour that cannot begin it ends the
    /// derivative, not the run.
    pub(super) fn differentiate_beginning(&mut self, number: usize) {
        let (Some(varied), Some(before)) = (self.varied.take(), self.before.take()) else {
            return;
        };
        let mut room = Room::default();
        for course in 0..varied.courses.len() {
            if !varied.courses[course].is_lost
                && self.begin_course((varied, course), (number, &mut room), &before).is_none()
            {
                varied.courses[course].is_lost = true;
            }
        }
        self.varied = Some(varied);
    }

    /// Derivatives of state and start by a parameter; `None`: there are none.
    fn begin_course(
        &self,
        (varied, course): (&mut Varied, usize),
        (number, room): (usize, &mut Room),
        (state, start): &(State, Start<'static>),
    ) -> Option<()> {
        let place = varied.courses[course].first(1);
        if !varied.courses[course].begins_simply() {
            varied.level(course, place, self.model).ok()?;
        }
        let (mut states, mut starts) = (Vec::new(), Vec::new());
        let (of_state, of_start) = {
            let own = &mut varied.courses[course];
            (std::mem::take(&mut own.state), std::mem::take(&mut own.start))
        };
        let (level, weights) = varied.courses[course].of_beginning(place);
        for ((model, values), offset) in level.near.iter().zip(level.offsets) {
            move_state(state, (&of_state, offset * level.h), &mut room.committed);
            let mut start = move_start(start, (&of_start, offset * level.h));
            let mut nobody = Nobody;
            let plan = (self.plan, values);
            let options = (&Options::default(), self.means);
            let mut own = Analysis::new(model, plan, options, (&mut *room, &mut nobody));
            own.open_step(number, &mut start).ok()?;
            own.locate(number);
            states.push(std::mem::take(&mut room.committed));
            starts.push(start);
        }
        let own = &mut varied.courses[course];
        combine_states(weights.iter().copied().zip(&mut states), &mut own.state);
        combine_starts(weights.iter().copied().zip(&mut starts), &mut own.start);
        own.begin_step();
        Some(())
    }

    /// Where contact stands at the beginning of a step.
    fn locate(&mut self, number: usize) {
        let Model { steps, .. } = self.model;
        let contact = &self.values.contact;
        let contact = contact.of_step((self.model, self.plan.dofs.len()), number - 1);
        let before = number.checked_sub(2).map(|before| &steps[before].presence);
        let mut kinematics = contact.nowhere();
        let places = (&mut MasterPositions::default(), &mut kinematics);
        locate_points(&contact, before, self.committed, places);
    }

    /// Differentiates the increment that was committed last, and tells the observer.
    pub(super) fn differentiate(
        &mut self,
        (plan, target): (&Problem<'_>, &Target),
        numbers: &Numbers,
        work: &mut Scratch,
    ) -> Result<(), Left> {
        let Some(varied) = self.varied.take() else { return Ok(()) };
        let increment = Increment {
            plan,
            target,
            numbers,
            // after the commit the state before it stands where the trial was
            old: self.trial,
            new: self.committed,
            closed: &self.rows.closed,
            model: self.model,
        };
        let told = increment.differentiate(varied, (work, self.neighbours), self.observer);
        self.varied = Some(varied);
        match told {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(stop) => Err(Left::Stopped(stop)),
        }
    }
}
