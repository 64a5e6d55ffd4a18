//! Overclosures that a step allows at its start and takes away.
//!
//! ```text
//!   v |\                    h - v stands for the overclosure h: what overlaps at the
//!     |  \                  start is pressed apart over the step, not at once
//!     |____\___ time
//! ```
//!
//! docs/theory.md eqs (5.40) and (5.41).

use super::before::Before;
use super::pairs::{Allowance, Contact};
use super::positions::MasterPositions;
use crate::state::State;
use slideline_model::{Allowed, Model, Step};

impl Allowance {
    /// Part of what is allowed at a time of a step of that length [1].
    fn factor(&self, time: f64, period: f64) -> f64 {
        match &self.amplitude {
            Some(amplitude) => amplitude.at(time),
            None => 1.0 - (time / period).min(1.0),
        }
    }
}

impl Contact {
    /// Takes the interferences of a step of a model with so many dofs.
    pub(super) fn take_interferences(&mut self, (model, dofs): (&Model, usize), step: &Step) {
        if step.interferences.is_empty() {
            return;
        }
        let overlap = self.first_overlap(dofs);
        for own in &step.interferences {
            let allowed = |place: usize| match own.allowed {
                Allowed::Initial => overlap[place].max(0.0),
                Allowed::Value(value) => value,
            };
            let of_pair = |&place: &usize| self.points[place].pair == own.pair;
            let places = (0..self.points.len()).filter(of_pair);
            let points = places.map(|place| (place, allowed(place))).collect();
            let amplitude = own.amplitude.and_then(|place| model.amplitudes.get(place)).cloned();
            self.allowances.push(Allowance { points, amplitude });
        }
        self.allow((0.0, 0.0), step.procedure.period);
    }

    /// The overclosures of the undeformed model [L].
    fn first_overlap(&self, dofs: usize) -> Vec<f64> {
        let mut kinematics = self.nowhere();
        let at = (&vec![0.0; dofs][..], Before::NOTHING);
        self.locate(at, &[], &mut MasterPositions::default(), &mut kinematics);
        kinematics.points().iter().map(|point| point.overclosure).collect()
    }

    /// Allows what belongs to the end of an increment between two times of a step [T].
    pub(super) fn allow(&mut self, (before, now): (f64, f64), period: f64) {
        for (time, into) in [(before, &mut self.allowed_before), (now, &mut self.allowed)] {
            into.clear();
            into.resize(self.points.len(), 0.0);
            for allowance in &self.allowances {
                let factor = allowance.factor(time, period);
                allowance.points.iter().for_each(|&(place, whole)| into[place] += factor * whole);
            }
        }
    }

    /// The overclosure that is allowed at a point [L].
    pub(super) fn allowed_at(&self, place: usize) -> f64 {
        self.allowed.get(place).copied().unwrap_or(0.0)
    }

    /// Work that the parts are pressed apart with as less and less overclosure is allowed, by the
    /// trapezoidal rule [F L].
    pub fn interference_work(&self, committed: &State, trial: &State) -> f64 {
        let force = |state: &State, place: usize| {
            state.points.get(place).map_or(0.0, |now| now.area * now.pressure)
        };
        let taken = self.allowed_before.iter().zip(&self.allowed).map(|(then, now)| then - now);
        let mean = |place| 0.5 * (force(committed, place) + force(trial, place));
        taken.enumerate().map(|(place, taken)| mean(place) * taken).sum()
    }
}
