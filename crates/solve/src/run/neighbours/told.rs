//! How frames follow a parameter, found when an observer asks.

use super::super::shown::{Numbers, Rows, frame};
use crate::balance::pair_rows;
use crate::evaluate::look_at;
use crate::heaviest::take_approaches;
use crate::newton::Scratch;
use crate::observe::{Frame, Near};
use crate::problem::Problem;
use crate::sensitivity::{PAIR, Sides, move_state};
use crate::state::State;
use std::cell::{OnceCell, RefCell};

/// Step along the rates of a state, in scales of the parameter, between frames that show it: its square is
/// truncation, rounding of strains grows with its inverse.
const STEP: f64 = 1e-4;

/// A state that is shown, and its evaluation.
pub struct Shown<'a> {
    pub weight: f64,
    pub plan: &'a Problem<'a>,
    pub state: &'a State,
    pub work: &'a Scratch,
}

impl Shown<'_> {
    fn fill(&self, closed: &[bool], rows: &mut Rows) {
        rows.fill(self.plan, (self.state, Some(&self.work.evaluation.kinematics)));
        let Rows { contact, pairs, sums, .. } = rows;
        pair_rows(self.plan, self.state, self.work, (contact, closed), (pairs, sums));
        take_approaches(self.state, pairs);
    }

    fn respond(&self, response: &dyn Fn(&Frame<'_>) -> f64, told: (&Numbers, &Rows)) -> f64 {
        self.weight * response(&frame(self.plan, self.state, told.0, told.1))
    }
}

/// States of neighbours.
pub struct OfNeighbours<'a> {
    pub each: Vec<Shown<'a>>,
    pub numbers: &'a Numbers,
    pub closed: &'a [bool],
    pub rows: OnceCell<Vec<Rows>>,
}

impl Near for OfNeighbours<'_> {
    fn sum(&self, response: &dyn Fn(&Frame<'_>) -> f64) -> f64 {
        let fill = |shown: &Shown<'_>| {
            let mut rows = Rows::default();
            shown.fill(self.closed, &mut rows);
            rows
        };
        let rows = self.rows.get_or_init(|| self.each.iter().map(fill).collect());
        let each = self.each.iter().zip(rows);
        each.map(|(shown, rows)| shown.respond(response, (self.numbers, rows))).sum()
    }
}

/// Room for frames along the rates of a state.
#[derive(Default)]
pub struct Shelf {
    states: [State; 2],
    pub(super) works: [Scratch; 2],
    /// Of both neighbours, and of both states along the rates.
    rows: [Rows; 4],
    is_filled: bool,
}

/// A state along its rates, and what neighbours show of it as it is.
pub struct AlongRates<'a> {
    pub plan: &'a Problem<'a>,
    pub state: &'a State,
    /// Its evaluation.
    pub work: &'a Scratch,
    pub rates: &'a [f64],
    /// The scale of the parameter.
    pub scale: f64,
    /// Neighbours, with what each counts.
    pub problems: &'a [Problem<'a>; 2],
    pub weights: Sides,
    pub numbers: &'a Numbers,
    pub closed: &'a [bool],
    shelf: RefCell<&'a mut Shelf>,
}

impl<'a> AlongRates<'a> {
    /// That of a state, with its evaluation and its rates by a parameter of that scale.
    pub fn of(
        (plan, state, work): (&'a Problem<'a>, &'a State, &'a Scratch),
        (rates, scale): (&'a [f64], f64),
        (problems, weights): (&'a [Problem<'a>; 2], Sides),
        (numbers, closed): (&'a Numbers, &'a [bool]),
        shelf: &'a mut Shelf,
    ) -> Self {
        shelf.is_filled = false;
        let shelf = RefCell::new(shelf);
        Self { plan, state, work, rates, scale, problems, weights, numbers, closed, shelf }
    }

    /// All that is shown, in the order of the rows.
    fn each<'b>(&'b self, states: &'b [State; 2], works: &'b [Scratch; 2]) -> [Shown<'b>; 4] {
        std::array::from_fn(|at| match at.checked_sub(2) {
            None => Shown {
                weight: self.weights[at],
                plan: &self.problems[at],
                state: self.state,
                work: self.work,
            },
            Some(k) => Shown {
                weight: 0.5 * PAIR[k] / (STEP * self.scale),
                plan: self.plan,
                state: &states[k],
                work: &works[k],
            },
        })
    }

    fn fill(&self, shelf: &mut Shelf) {
        let Shelf { states, works, rows, is_filled } = shelf;
        for ((state, work), side) in states.iter_mut().zip(&mut *works).zip(PAIR) {
            move_state(self.state, (self.rates, side * STEP * self.scale), state);
            work.evaluation.look.forget();
            look_at(self.plan, state, &mut work.evaluation);
            let into = &mut work.evaluation.kinematics;
            self.plan.contact.stand_as(&state.points, &state.displacement, into);
            let points = work.evaluation.kinematics.points();
            for (point, kinematics) in state.points.iter_mut().zip(points) {
                if kinematics.faces {
                    (point.position, point.normal) = (kinematics.position, kinematics.normal);
                }
            }
        }
        let each = self.each(states, works);
        each.iter().zip(rows).for_each(|(shown, rows)| shown.fill(self.closed, rows));
        *is_filled = true;
    }
}

impl Near for AlongRates<'_> {
    fn sum(&self, response: &dyn Fn(&Frame<'_>) -> f64) -> f64 {
        if !self.shelf.borrow().is_filled {
            self.fill(&mut self.shelf.borrow_mut());
        }
        let shelf = self.shelf.borrow();
        let each = self.each(&shelf.states, &shelf.works);
        let pairs = each.iter().zip(&shelf.rows);
        pairs.map(|(shown, rows)| shown.respond(response, (self.numbers, rows))).sum()
    }
}
