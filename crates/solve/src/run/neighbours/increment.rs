//! An increment that is differentiated, and what answers all right sides.

use super::super::shown::Numbers;
use crate::newton::Scratch;
use crate::problem::Problem;
use crate::sensitivity::{Border, PAIR, Sides, Touched};
use crate::state::State;
use crate::target::Target;
use slideline_linalg::Solver;
use slideline_model::Model;

/// An increment that was committed.
pub struct Increment<'a> {
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
pub struct Linear<'a> {
    pub border: Border,
    /// The converged trial, evaluated.
    pub base: &'a Scratch,
    /// Factors of its tangent.
    pub solver: &'a mut Solver,
}

/// What came of the neighbours.
pub enum Found {
    /// All stand on the branch of the base, and their answers bend by so much.
    Branch { bend: f64 },
    /// Some do not.
    Beyond,
    /// There is no answer.
    Nothing,
}

/// Two neighbours, with their step.
pub struct Pair<'a> {
    pub problems: &'a [Problem<'a>; 2],
    pub touched: &'a Touched,
    /// Rates of the state before.
    pub known: &'a [f64],
    pub h: f64,
}

impl Pair<'_> {
    /// What each counts.
    pub fn weights(&self) -> Sides {
        PAIR.map(|side| 0.5 * side / self.h)
    }

    pub fn steps(&self) -> Sides {
        PAIR.map(|side| side * self.h)
    }
}
