//! Rates of the unknowns corrected until neighbours on four places keep their equations.
//!
//! ```text
//!   rates x = 0
//!   [ neighbours at x -> R', c' -> border answers with dx -> x + dx ]   until dx is nothing
//!   neighbours at x -> states, frames -> derivatives
//! ```
//!
//! docs/theory.md section 13.

use super::increment::{Found, Increment, Linear};
use super::room::Room;
use crate::commit::commit;
use crate::evaluate::zero;
use crate::newton::Scratch;
use crate::problem::Problem;
use crate::sensitivity::{OFFSETS, Weights, bend, is_same_branch, leaves_hard_branch};
use crate::state::State;

/// The most corrections of the rates.
const CORRECTIONS: usize = 20;
/// Part of the rates that the last correction may have, and part of the rates of forces that may
/// be left without balance [1]; beyond, the rates are corrected again.
const SETTLED: f64 = 3e-9;
/// The same of the correction where rounding forbids more.
const ROUNDED: f64 = 1e-6;
/// Part of a correction that the next one should not exceed [1]; where it does, it is of rounding.
const SLOW: f64 = 0.3;

impl Increment<'_> {
    /// Corrects the rates until the neighbours keep their equations as well as the base does, and
    /// commits the neighbours.
    pub fn settle(
        &self,
        (problems, weights, h): (&[Problem<'_>; 4], Weights, f64),
        linear: &mut Linear<'_>,
        (known, scale): (&[f64], f64),
        room: &mut Room,
    ) -> Found {
        self.guess(known, room);
        room.sides.iter_mut().for_each(Scratch::forget_places);
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
            let held = &defects[..border.multipliers()];
            left = left.max(part(held, &rates.pressures, pressed / scale));
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
            true => bend(&room.after, (self.new, self.model), (h, scale), room.least_force)
                .max(room.bend_of_forces(self.plan, linear.base, (h, scale))),
            false => 0.0,
        };
        if bend.is_finite() { Found::Branch { bend } } else { Found::Beyond }
    }

    /// First rates: those of the state before.
    fn guess(&self, known: &[f64], room: &mut Room) {
        let plan = self.plan;
        let Room { rates, residual, defects, .. } = room;
        let rate = |&dof: &usize| known.get(dof).copied().unwrap_or(0.0);
        rates.unknowns.clear();
        rates.unknowns.extend(plan.constraints.dof_of_equation.iter().map(rate));
        rates.still(self.new.points.len());
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
                && !leaves_hard_branch(&problems[k], &room.before[k], points, |place| {
                    room.sides[k].stands_held(&problems[k], &room.before[k], place)
                })
        })
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
