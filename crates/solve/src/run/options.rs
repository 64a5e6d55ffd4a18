//! How to run.

use crate::linear_systems::LinearSystems;
use crate::users::UserFrictions;
use slideline_mech::contact::enforcement::Enforcement;

/// How to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Threads for the evaluation of elements; results do not depend on it.
    pub threads: usize,
    /// Friction laws of the embedding program.
    pub user_frictions: UserFrictions,
    /// Which tangents are held against differences.
    pub check_tangent: TangentCheck,
    /// How contact is solved; `None`: as its size asks for.
    pub enforcement: Option<Enforcement>,
    /// What makes the linear systems.
    pub linear_systems: LinearSystems,
}

/// Which tangents are held against differences of the residual.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum TangentCheck {
    /// None.
    #[default]
    Never,
    /// Those of every converged increment.
    Every,
    /// That of the increment with this number in every step.
    Increment(usize),
}

impl TangentCheck {
    /// Whether that of the increment with a number is.
    pub(super) fn is_due(self, increment: usize) -> bool {
        match self {
            Self::Never => false,
            Self::Every => true,
            Self::Increment(number) => number == increment,
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            threads: 1,
            user_frictions: UserFrictions::default(),
            check_tangent: TangentCheck::Never,
            enforcement: None,
            linear_systems: LinearSystems::default(),
        }
    }
}
