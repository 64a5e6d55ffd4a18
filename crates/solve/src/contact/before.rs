//! The last commit, as contact looks back at it.

use crate::state::{PointState, State};

/// Displacements and contact points of the last commit, empty where there is none, and the faces
/// and segments that hold points since.
#[derive(Clone, Copy, Debug)]
pub struct Before<'a> {
    /// Displacements, a dof each [L or 1].
    pub u: &'a [f64],
    /// Contact points.
    pub points: &'a [PointState],
    /// Face, or segment of the line, of its master on which every point stood in the last iteration; empty: as at the commit.
    pub faces: &'a [Option<usize>],
}

impl<'a> Before<'a> {
    /// No commit yet.
    pub const NOTHING: Self = Self { u: &[], points: &[], faces: &[] };

    /// That of a committed state.
    pub fn of(state: &'a State) -> Self {
        Self { u: &state.displacement, points: &state.points, faces: &[] }
    }

    /// The same, with points held by the faces of the last iteration.
    pub fn held_by(self, faces: &'a [Option<usize>]) -> Self {
        Self { faces, ..self }
    }

    /// The face or segment that holds a point: of the last iteration, or else of the last commit.
    pub fn face(&self, place: usize) -> Option<usize> {
        let committed = || self.points.get(place)?.stands_on();
        self.faces.get(place).copied().flatten().or_else(committed)
    }
}
