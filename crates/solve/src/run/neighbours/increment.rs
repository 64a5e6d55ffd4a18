//! An increment that is differentiated, and what answers all right sides.

use super::super::shown::Numbers;
use crate::newton::Scratch;
use crate::problem::Problem;
use crate::sensitivity::Border;
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
