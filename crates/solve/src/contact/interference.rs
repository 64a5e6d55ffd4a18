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
use super::master::MasterSurface;
use super::pairs::{Allowance, Contact, Course, SlavePoint};
use super::positions::MasterPositions;
use super::segment::{SEGMENT_POINTS, SlaveSegment};
use crate::state::{PointState, State};
use slideline_mech::contact::pair::Body;
use slideline_model::{Allowed, Interference, Model};

impl Allowance {
    /// Part of what is allowed at a time of a step of that length [1].
    fn factor(&self, time: f64, period: f64) -> f64 {
        match &self.course {
            Course::Straight => 1.0 - (time / period).min(1.0),
            Course::Curve(amplitude) => amplitude.at(time),
            Course::Left(part) if time <= 0.0 => *part,
            Course::Left(_) => 0.0,
        }
    }
}

/// The interferences of a step, and those of the step before of which something is left where this one
/// says nothing of their pair.
pub(super) fn allowed_in(model: &Model, step: usize) -> Vec<(&Interference, Course)> {
    let amplitude = |own: &Interference| model.amplitudes.get(own.amplitude?);
    let here = &model.steps[step].interferences;
    let course = |own| amplitude(own).cloned().map_or(Course::Straight, Course::Curve);
    let own = here.iter().map(|own| (own, course(own)));
    let before = step.checked_sub(1).map(|before| &model.steps[before]);
    let left = before.into_iter().flat_map(|before| {
        let alone =
            before.interferences.iter().filter(|own| here.iter().all(|new| new.pair != own.pair));
        alone.filter_map(|own| {
            let part = amplitude(own)?.at(before.procedure.period);
            (part != 0.0).then_some((own, Course::Left(part)))
        })
    });
    own.chain(left).collect()
}

impl Contact {
    /// Takes the interferences of a step of a model with so many dofs, and what the step before leaves.
    pub(super) fn take_interferences(&mut self, (model, dofs): (&Model, usize), step: usize) {
        let interferences = allowed_in(model, step);
        if interferences.is_empty() {
            return;
        }
        let overlap = self.first_overlap(dofs);
        for (own, course) in interferences {
            let allowed = |place: usize| match own.allowed {
                Allowed::Initial => overlap[place].max(0.0),
                Allowed::Value(value) => value,
            };
            let has_own =
                |point: &SlavePoint| point.pair == own.pair && !point.is_integration_point();
            let places = (0..self.points.len()).filter(|&place| has_own(&self.points[place]));
            let points = places.map(|place| (place, allowed(place))).collect();
            let (pair, allowed, before, now) = (own.pair, own.allowed, 0.0, 0.0);
            self.allowances.push(Allowance { pair, allowed, points, before, now, course });
        }
        self.allow((0.0, 0.0), model.steps[step].procedure.period);
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
        for allowance in &mut self.allowances {
            allowance.before = allowance.factor(before, period);
            allowance.now = allowance.factor(now, period);
        }
    }

    /// The overclosure that is allowed at a place of an element along which contact is integrated: a
    /// part of what the line overlaps by there before anything moves, or of a value [L].
    pub(super) fn allowed_along(&self, segment: &SlaveSegment, xi: f64) -> f64 {
        self.part_along(segment, xi, |own| own.now)
    }

    fn part_along(&self, segment: &SlaveSegment, xi: f64, part: impl Fn(&Allowance) -> f64) -> f64 {
        let own = self.allowances.iter().filter(|own| own.pair == segment.pair);
        let whole = |own: &Allowance| match own.allowed {
            Allowed::Initial => self.overlap_at_rest(segment, xi).max(0.0),
            Allowed::Value(value) => value,
        };
        own.map(|own| part(own) * whole(own)).sum()
    }

    /// By how much a place of an element overlaps its master before anything moves [L].
    fn overlap_at_rest(&self, segment: &SlaveSegment, xi: f64) -> f64 {
        let MasterSurface::Body { reference, surface, .. } = &self.masters[segment.pair] else {
            return 0.0;
        };
        let body = Body { reference: *reference, dofs: [0.0; 3] };
        let of_line = surface.overclosure(&body, segment.line.reference(xi));
        of_line.map_or(0.0, |of_line| of_line + segment.offset.both())
    }

    /// The overclosure that is allowed at a point of a node, by the step and by what an edge may do
    /// unheld [L].
    pub(super) fn allowed_of_node(&self, place: usize, before: Before<'_>) -> f64 {
        self.allowed_at(place) + self.edge_allowance(place, before.points)
    }

    /// The overclosure that is allowed at a point [L].
    pub(super) fn allowed_at(&self, place: usize) -> f64 {
        self.allowed.get(place).copied().unwrap_or(0.0)
    }

    /// Work that the parts are pressed apart with as less and less overclosure is allowed, by the
    /// trapezoidal rule [F L].
    pub fn interference_work(&self, committed: &State, trial: &State) -> f64 {
        self.work_at_points(committed, trial)
            + self.work_along(committed, trial)
            + self.work_at_edges(committed, trial)
    }

    /// That of points which stay where they are on the slave.
    fn work_at_points(&self, committed: &State, trial: &State) -> f64 {
        let force = |state: &State, place: usize| {
            state.points.get(place).map_or(0.0, |now| now.area * now.pressure)
        };
        let taken = self.allowed_before.iter().zip(&self.allowed).map(|(then, now)| then - now);
        let mean = |place| 0.5 * (force(committed, place) + force(trial, place));
        taken.enumerate().map(|(place, taken)| mean(place) * taken).sum()
    }

    /// That of contact which is integrated along elements.
    fn work_along(&self, committed: &State, trial: &State) -> f64 {
        if self.allowances.is_empty() {
            return 0.0;
        }
        let taken = |segment: &SlaveSegment, point: &PointState| {
            let way = self.part_along(segment, point.xi, |own| own.before - own.now);
            point.area * point.pressure * way
        };
        let of_state = |segment: &SlaveSegment, state: &State| {
            let own = state.points.get(segment.first..segment.first + SEGMENT_POINTS);
            own.into_iter().flatten().map(|point| taken(segment, point)).sum::<f64>()
        };
        let both = |own: &SlaveSegment| of_state(own, committed) + of_state(own, trial);
        0.5 * self.segments.iter().map(both).sum::<f64>()
    }
}
