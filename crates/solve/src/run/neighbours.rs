//! A converged increment differentiated by its neighbours.
//!
//! ```text
//!   rates x = 0
//!   [ neighbours at x -> R', c' -> border answers with dx -> x + dx ]   until dx is nothing
//!   neighbours at x -> states, frames -> derivatives
//! ```
//!
//! docs/theory.md section 13.

mod room;

use super::shown::{Numbers, Rows, frame};
use crate::balance::pair_rows;
use crate::commit::commit;
use crate::evaluate::zero;
use crate::newton::Scratch;
use crate::observe::{Event, Frame, Observer, Sensitivity, Stop};
use crate::problem::Problem;
use crate::sensitivity::{
    Border, Level, OFFSETS, Side, Surroundings, Tries, Try, Varied, Weights, bend, combine_states,
    is_same_branch, leaves_hard_branch, move_state,
};
use crate::state::{PointState, State};
use crate::tangent;
use crate::target::Target;
use slideline_linalg::{SolveError, Solver};
use slideline_mech::contact::tangential::Tangential;
use slideline_model::Model;
use std::ops::ControlFlow;

pub(super) use room::Room;

/// The most corrections of the rates.
const CORRECTIONS: usize = 20;
/// Part of the rates that the last correction may have, and part of the rates of forces that may
/// be left without balance [1]; beyond, the rates are corrected again.
const SETTLED: f64 = 3e-9;
/// The same of the correction where rounding forbids more.
const ROUNDED: f64 = 1e-6;
/// Part of a correction that the next one should not exceed [1]; where it does, it is of rounding.
const SLOW: f64 = 0.3;

/// An increment that was committed.
pub(super) struct Increment<'a> {
    pub plan: &'a Problem<'a>,
    pub target: &'a Target,
    pub numbers: &'a Numbers,
    /// The states before and after it.
    pub old: &'a State,
    pub new: &'a State,
    /// Which contact rows were closed before.
    pub closed: &'a [bool],
    pub model: &'a Model,
}

/// What answers all right sides.
struct Linear<'a> {
    border: Border,
    /// The converged trial, evaluated.
    base: &'a Scratch,
    /// Factors of its tangent.
    solver: &'a mut Solver,
}

/// What came of the neighbours.
enum Found {
    /// All stand on the branch of the base, and their answers bend by so much.
    Branch { bend: f64 },
    /// Some do not.
    Beyond,
    /// There is no answer.
    Nothing,
}

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
        base.evaluate_committed(self.plan, self.old, self.target, self.new);
        let told = self.courses(varied, (&base, work, room), observer);
        room.base = base;
        told
    }

    fn courses(
        &self,
        varied: &mut Varied,
        (base, work, room): (&Scratch, &mut Scratch, &mut Room),
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop> {
        let Ok((border, solver)) = self.linearise(base, work, &mut room.least_force) else {
            varied.courses.iter_mut().for_each(|own| own.is_lost = true);
            return ControlFlow::Continue(());
        };
        let mut linear = Linear { border, base, solver };
        self.leave_alone(base, &mut room.alone);
        for course in 0..varied.courses.len() {
            if varied.courses[course].is_lost {
                continue;
            }
            self.course((varied, course), &mut linear, room, observer)?;
        }
        ControlFlow::Continue(())
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
        work: &'w mut Scratch,
        least_force: &mut f64,
    ) -> Result<(Border, &'w mut Solver), SolveError> {
        let (plan, committed) = (self.plan, self.old);
        let trial = base.trial(committed, self.target.dt);
        let place = tangent::Place { plan, committed, trial, evaluation: &base.evaluation };
        let mut values = tangent::assembled(&place);
        *least_force = room::least_force(plan, &values, self.new);
        let mut border = Border::of(&place);
        border.lend(plan, &mut values);
        let equations = plan.constraints.equations();
        let solver = work.factor_converged(plan, &values)?;
        border.couple(equations, solver)?;
        Ok((border, solver))
    }

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
            let around = self.surroundings(level, known, room);
            let problems = around.each_ref().map(|own| own.problem(self.plan, self.target.step));
            match self.settle((&problems, weights, level.h), linear, (known, scale), room) {
                Found::Branch { bend } if tries.accepts(tried, bend) => {}
                Found::Beyond if is_last => {}
                _ => continue,
            }
            let forgets = self.plan.contact.laws.iter().all(|own| !own.has_friction())
                && self.new.elements.is_empty();
            let one_sided = side != Side::Both || was_one_sided && !forgets;
            self.tell((&problems, weights), (course, one_sided), room, observer)?;
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
    fn surroundings<'b>(
        &self,
        level: &'b Level,
        state: &[f64],
        room: &mut Room,
    ) -> [Surroundings<'b>; 4] {
        std::array::from_fn(|k| {
            move_state(self.old, (state, OFFSETS[k] * level.h), &mut room.before[k]);
            level.surroundings(k, (self.plan, self.old.step_time, self.target))
        })
    }

    /// Corrects the rates until the neighbours keep their equations as well as the base does, and
    /// commits the neighbours.
    fn settle(
        &self,
        (problems, weights, h): (&[Problem<'_>; 4], Weights, f64),
        linear: &mut Linear<'_>,
        (known, scale): (&[f64], f64),
        room: &mut Room,
    ) -> Found {
        self.guess(known, room);
        let [mut left, mut unbalanced] = [f64::INFINITY; 2];
        let points = self.old.points.iter().chain(&self.new.points);
        let pressed = points.fold(0.0, |most: f64, own| most.max(own.pressure));
        let moved = largest(&self.old.displacement).max(largest(&self.new.displacement));
        let mut is_first = room.alone.contains(&true);
        for _ in 0..CORRECTIONS {
            if !self.evaluate((problems, weights, h), linear, (room, is_first)) {
                return Found::Nothing;
            }
            let before = (left, unbalanced);
            unbalanced = room.unbalanced(self.plan, h);
            let Room { residual, defects, rates, .. } = &mut *room;
            let Linear { border, solver, .. } = &mut *linear;
            if border.solve(solver, (&mut *residual, &mut *defects)).is_err() {
                return Found::Nothing;
            }
            left = part(residual, &rates.unknowns, moved / scale);
            left = left.max(part(defects, &rates.pressures, pressed / scale));
            let rounded = (ROUNDED.min(left), unbalanced);
            let is_settled = |own: f64, before: f64, rounded: f64| {
                own <= SETTLED || own <= rounded && own > SLOW * before
            };
            if is_settled(left, before.0, rounded.0)
                && is_settled(unbalanced, before.1, rounded.1)
                && !is_first
            {
                break;
            }
            is_first = false;
            rates.unknowns.iter_mut().zip(residual).for_each(|(rate, more)| *rate += *more);
            border.give(defects, &mut rates.pressures, &mut rates.tractions);
        }
        if left > ROUNDED || left.is_nan() {
            return Found::Nothing;
        }
        for (k, _) in weights.each() {
            let (before, after) = (&room.before[k], &mut room.after[k]);
            after.copy_from(before);
            commit(&problems[k], before, self.target, &room.sides[k], after);
        }
        if !self.is_on_branch((problems, weights), room) {
            return Found::Beyond;
        }
        let is_both = weights.base == 0.0;
        let bend = match is_both {
            true => bend(&room.after, self.new, (h, scale), room.least_force)
                .max(room.bend_of_forces(self.plan, linear.base, (h, scale))),
            false => 0.0,
        };
        if bend.is_finite() { Found::Branch { bend } } else { Found::Beyond }
    }

    /// First rates: those of the state before.
    fn guess(&self, known: &[f64], room: &mut Room) {
        let (plan, points) = (self.plan, self.new.points.len());
        let Room { rates, residual, defects, .. } = room;
        let rate = |&dof: &usize| known.get(dof).copied().unwrap_or(0.0);
        rates.unknowns.clear();
        rates.unknowns.extend(plan.constraints.dof_of_equation.iter().map(rate));
        rates.pressures.clear();
        rates.pressures.resize(points, 0.0);
        rates.tractions.clear();
        rates.tractions.resize(points, Tangential::ZERO);
        residual.clear();
        defects.clear();
    }

    /// Evaluates the neighbours, in the first round without the points that are left alone; what
    /// their equations leave over.
    fn evaluate(
        &self,
        (problems, weights, h): (&[Problem<'_>; 4], Weights, f64),
        linear: &Linear<'_>,
        (room, is_first): (&mut Room, bool),
    ) -> bool {
        let (border, base) = (&linear.border, linear.base);
        let Room { sides, before, rates, residual, defects, alone, forces, .. } = room;
        let alone = if is_first { &alone[..] } else { &[] };
        zero(defects, border.len());
        forces.iter_mut().for_each(|list| zero(list, self.plan.dofs.len()));
        let [left, touching] = forces;
        let mut add = |weight: f64, of: &Scratch, from: &State| {
            let each = left.iter_mut().zip(&mut *touching).zip(&of.evaluation.contact);
            for (dof, ((left, touching), contact)) in each.enumerate() {
                *left += weight * of.evaluation.unbalanced(dof);
                *touching += weight * contact;
            }
            border.add_defects(weight, (from, &of.evaluation.points), defects);
        };
        for (k, weight) in weights.each() {
            let near = (base, &*rates, OFFSETS[k] * h, alone);
            sides[k].evaluate_near(&problems[k], &before[k], self.target, near);
            let evaluation = &sides[k].evaluation;
            if evaluation.failed.is_some() || evaluation.fault.is_some() {
                return false;
            }
            add(weight, &sides[k], &before[k]);
        }
        if weights.base != 0.0 {
            add(weights.base, base, self.old);
        }
        residual.clear();
        residual.extend(self.plan.constraints.dof_of_equation.iter().map(|&dof| left[dof]));
        residual.iter().chain(&*defects).all(|value| value.is_finite())
    }

    /// Whether the neighbours stand on the branch of the base.
    fn is_on_branch(&self, (problems, weights): (&[Problem<'_>; 4], Weights), room: &Room) -> bool {
        let mut each = weights.each();
        each.all(|(k, _)| {
            let (points, own) = (&room.after[k].points, &self.new.points);
            own.iter().zip(points).all(|(one, other)| is_same_branch(one, other))
                && !leaves_hard_branch(&problems[k], &room.before[k], points)
        })
    }

    /// Tells how frames follow the parameter.
    fn tell(
        &self,
        (problems, weights): (&[Problem<'_>; 4], Weights),
        (parameter, one_sided): (usize, bool),
        room: &mut Room,
        observer: &mut dyn Observer,
    ) -> ControlFlow<Stop> {
        let Room { sides, after, rows, .. } = room;
        let mut own = Rows::default();
        let fill = |plan: &Problem<'_>, state: &State, work: &Scratch, rows: &mut Rows| {
            rows.fill(plan, state);
            let Rows { contact, pairs, sums, .. } = rows;
            pair_rows(plan, state, work, (contact, self.closed), (pairs, sums));
        };
        for (k, _) in weights.each() {
            fill(&problems[k], &after[k], &sides[k], &mut rows[k]);
        }
        let mut frames: Vec<(f64, Frame<'_>)> = Vec::with_capacity(4);
        for (k, weight) in weights.each() {
            frames.push((weight, frame(&problems[k], &after[k], self.numbers, &rows[k])));
        }
        if weights.base != 0.0 {
            own.fill(self.plan, self.new);
            frames.push((weights.base, frame(self.plan, self.new, self.numbers, &own)));
        }
        let told = Sensitivity { parameter, one_sided, frames: &frames };
        observer.event(Event::Sensitivity(&told))
    }
}

/// The largest change in largest rates, or in what counts as one.
fn part(change: &[f64], of: &[f64], least: f64) -> f64 {
    let change = largest(change);
    if change == 0.0 { 0.0 } else { change / largest(of).max(least).max(f64::MIN_POSITIVE) }
}

fn largest(list: &[f64]) -> f64 {
    list.iter().fold(0.0, |most: f64, own| most.max(own.abs()))
}
