//! A converged increment differentiated.
//!
//! ```text
//!   tangent of the converged trial, factored once
//!   each parameter:  by the tangent         where that tells all           [by_tangent]
//!                    else by four neighbours with rates that are corrected [settle]
//! ```
//!
//! docs/theory.md section 13.

mod by_tangent;
mod increment;
mod points;
mod room;
mod settle;
mod told;

use crate::contact::MovingPoints;
use crate::newton::{Scratch, WholeTangent};
use crate::observe::{Event, Near, Observer, Sensitivity, Stop};
use crate::sensitivity::{
    Border, Level, Side, Surroundings, Tries, Try, Varied, Weights, combine_states, move_state,
};
use crate::state::PointState;
use crate::tangent::{self, Kept};
use increment::{Found, Linear, Pair};
use slideline_linalg::{SolveError, Solver};
use std::cell::OnceCell;
use std::ops::ControlFlow;
use told::{AlongRates, OfNeighbours, Shown};

pub(super) use increment::Increment;
pub(super) use room::Room;

impl Increment<'_> {
    /// Differentiates by all parameters and tells of each.
    pub fn differentiate(
        &self,
        varied: &mut Varied,
        (work, room): (&mut Scratch, &mut Room),
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop> {
        room.fit(self.plan, self.target.step);
        let mut base = std::mem::take(&mut room.base);
        let changed = base.change_with(self.plan, work, self.new);
        if !changed {
            base.evaluate_committed(self.plan, self.old, self.target, self.new);
        }
        let (mut kept, mut whole) =
            (std::mem::take(&mut room.kept), std::mem::take(&mut room.whole));
        let of_tangent = (&mut kept, &mut whole);
        let told = self.courses(varied, (&base, work, room), of_tangent, observer);
        if changed {
            std::mem::swap(&mut base.evaluation, &mut work.evaluation);
        }
        (room.base, room.kept, room.whole) = (base, kept, whole);
        told
    }

    fn courses(
        &self,
        varied: &mut Varied,
        (base, work, room): (&Scratch, &mut Scratch, &mut Room),
        (kept, whole): (&mut Kept, &mut WholeTangent),
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop> {
        let Room { least_force, moving, .. } = &mut *room;
        let is_told = self.is_told_by_tangent(base) && self.moves_along(base, moving);
        if !is_told {
            moving.clear();
        }
        let of_tangent = (least_force, &mut *kept, &*moving);
        let Ok((border, solver)) = self.linearise(base, (work, whole), of_tangent) else {
            varied.courses.iter_mut().for_each(|own| own.is_lost = true);
            return ControlFlow::Continue(());
        };
        let mut linear = Linear { border, base, solver };
        self.leave_alone(base, &mut room.alone);
        for course in 0..varied.courses.len() {
            if varied.courses[course].is_lost {
                continue;
            }
            let of = (&mut *varied, course);
            if is_told && self.course_by_pairs(of, (&mut linear, &*kept), room, observer)? {
                continue;
            }
            self.course((varied, course), &mut linear, room, observer)?;
        }
        ControlFlow::Continue(())
    }

    /// Differentiates by a parameter with the tangent and the first pair over which nothing bends;
    /// whether one told.
    fn course_by_pairs(
        &self,
        (varied, course): (&mut Varied, usize),
        (linear, kept): (&mut Linear<'_>, &Kept),
        room: &mut Room,
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop, bool> {
        for place in varied.courses[course].pairs(self.target.increment) {
            let is_asked = place == 0 || self.plan.contact.slips_by_rates();
            if !is_asked || !varied.has_pair(course, place, self.model) {
                break;
            }
            let of = (&mut *varied, course, place);
            if self.course_by_tangent(of, (&mut *linear, kept), room, observer)? {
                varied.courses[course].note_pair(place);
                return ControlFlow::Continue(true);
            }
        }
        ControlFlow::Continue(false)
    }

    /// Open points that bear on nothing: they are looked at once the rates are known.
    fn leave_alone(&self, base: &Scratch, alone: &mut Vec<bool>) {
        let points = base.evaluation.points.iter().enumerate();
        let is_open = |own: &PointState| !own.closed && own.pressure == 0.0;
        alone.clear();
        alone.extend(points.map(|(at, own)| is_open(own) && self.plan.contact.may_be_left(at)));
    }

    /// Factors the tangent of the converged trial, its laws in it.
    fn linearise<'w>(
        &self,
        base: &Scratch,
        (work, whole): (&'w mut Scratch, &'w mut WholeTangent),
        (least_force, kept, moving): (&mut f64, &mut Kept, &MovingPoints),
    ) -> Result<(Border, &'w mut Solver), SolveError> {
        let (plan, committed) = (self.plan, self.old);
        let trial = base.trial(committed, self.target.dt);
        let place = tangent::Place { plan, committed, trial, evaluation: &base.evaluation };
        let mut values = tangent::assembled(&place, kept);
        *least_force = room::least_force(plan, &values, self.new);
        let mut border = Border::of(&place, moving);
        border.lend(plan, &mut values);
        let equations = plan.constraints.equations();
        let solver = work.factor_converged(plan, &values, whole)?;
        border.couple(equations, solver)?;
        Ok((border, solver))
    }

    /// Differentiates by a parameter with the tangent and a pair; whether it told.
    fn course_by_tangent(
        &self,
        (varied, course, place): (&mut Varied, usize, usize),
        (linear, kept): (&mut Linear<'_>, &Kept),
        room: &mut Room,
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop, bool> {
        let own = &mut varied.courses[course];
        let one_sided = own.one_sided && !self.forgets();
        let scale = own.parameter.scale;
        let mut rates = std::mem::take(&mut room.rates_of_state);
        let mut told = false;
        if let Some((level, touched, known)) = own.beside(place, self.plan.start) {
            let around: [Surroundings<'_>; 2] = self.surroundings(level, known, room);
            let problems = around.each_ref().map(|own| own.problem(self.plan, self.target.step));
            let pair = Pair { problems: &problems, touched, known, h: level.h };
            told = self.by_tangent(&pair, (linear, kept), room, &mut rates).is_some();
            if told {
                let near = AlongRates::of(
                    (self.plan, self.new, linear.base),
                    (&rates, scale),
                    (&problems, pair.weights()),
                    (self.numbers, self.closed),
                    &mut room.shelf,
                );
                self.tell((course, one_sided), &near, observer)?;
            }
        }
        if told {
            own.one_sided = one_sided;
            std::mem::swap(&mut own.state, &mut rates);
        }
        room.rates_of_state = rates;
        ControlFlow::Continue(told)
    }

    /// Whether what follows owes nothing to the branches that were taken so far.
    fn forgets(&self) -> bool {
        let frictionless = self.plan.contact.laws.iter().all(|own| !own.has_friction());
        frictionless && !self.model.remembers()
    }

    /// Differentiates by a parameter with four neighbours: where contact is spread over faces or
    /// along rigid profiles, lies in space, is stabilised or has laws from outside; where elements have
    /// histories, kinks or laws from outside; where the parameter moves places; about kinks.
    fn course(
        &self,
        (varied, course): (&mut Varied, usize),
        linear: &mut Linear<'_>,
        room: &mut Room,
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop> {
        let mut tries = Tries::from(varied.courses[course].first(self.target.increment));
        while let Some(tried) = tries.next() {
            let Try { place, side, is_last, .. } = tried;
            if varied.level(course, place, self.model).is_err() {
                continue;
            }
            let own = &mut varied.courses[course];
            let (scale, was_one_sided) = (own.parameter.scale, own.one_sided);
            let (level, known) = own.parts(place, self.plan.start);
            let weights = Weights::of(side, level.h);
            let around: [Surroundings<'_>; 4] = self.surroundings(level, known, room);
            let problems = around.each_ref().map(|own| own.problem(self.plan, self.target.step));
            match self.settle((&problems, weights, level.h), linear, (known, scale), room) {
                Found::Branch { bend } if tries.accepts(tried, bend) => {}
                Found::Beyond if is_last => {}
                _ => continue,
            }
            let one_sided = side != Side::Both || was_one_sided && !self.forgets();
            let all = weights.each().map(|(k, weight)| {
                let (state, work) = (&room.after[k], &room.sides[k]);
                Shown { weight, plan: &problems[k], state, work }
            });
            let (weight, work) = (weights.base, linear.base);
            let base = Shown { weight, plan: self.plan, state: self.new, work };
            let each = all.chain((weight != 0.0).then_some(base)).collect();
            let (numbers, closed) = (self.numbers, self.closed);
            let near = OfNeighbours { each, numbers, closed, rows: OnceCell::new() };
            self.tell((course, one_sided), &near, observer)?;
            let base = (weights.base != 0.0).then(|| self.new.clone());
            let mut base = base.into_iter().collect::<Vec<_>>();
            let near = weights.near.into_iter().zip(&mut room.after);
            let all = near.filter(|(w, _)| *w != 0.0);
            let all = all.chain(base.iter_mut().map(|own| (weights.base, own)));
            combine_states(all, &mut own.state);
            own.one_sided = one_sided;
            if side == Side::Both {
                own.note(place);
            }
            return ControlFlow::Continue(());
        }
        // what follows would begin from a derivative that is none
        varied.courses[course].is_lost = true;
        ControlFlow::Continue(())
    }

    /// Moves the state to the neighbours.
    fn surroundings<'b, const N: usize>(
        &self,
        level: &'b Level,
        state: &[f64],
        room: &mut Room,
    ) -> [Surroundings<'b>; N] {
        std::array::from_fn(|k| {
            move_state(self.old, (state, level.offsets[k] * level.h), &mut room.before[k]);
            level.surroundings(k, (self.plan, self.old.step_time, self.target))
        })
    }

    /// Tells how frames follow a parameter.
    fn tell(
        &self,
        (parameter, one_sided): (usize, bool),
        near: &dyn Near,
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop> {
        let numbers = (self.numbers.step, self.numbers.increment, self.new.total_time);
        observer.event(Event::Sensitivity(&Sensitivity { parameter, one_sided, numbers, near }))
    }
}
