//! The last commit, as contact looks back at it.

use crate::state::{PointState, State};

/// Displacements and contact points of the last commit; empty where there is none.
#[derive(Clone, Copy, Debug)]
pub struct Before<'a> {
    /// Displacements, a dof each [L or 1].
    pub u: &'a [f64],
    /// Contact points.
    pub points: &'a [PointState],
}

impl<'a> Before<'a> {
    /// No commit yet.
    pub const NOTHING: Self = Self { u: &[], points: &[] };

    /// That of a committed state.
    pub fn of(state: &'a State) -> Self {
        Self { u: &state.displacement, points: &state.points }
    }
}
