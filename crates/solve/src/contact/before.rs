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
    /// How every point stood in the last iteration; empty: as at the commit.
    pub standing: &'a [Stood],
}

/// How a point stood in the last iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stood {
    /// Face, or segment of the line, of its master, which holds it.
    pub face: Option<usize>,
    /// Its gap before anything is allowed; infinite: it faced nothing, or is not asked for [L].
    pub gap: f64,
}

impl Stood {
    /// Nowhere.
    pub const NOWHERE: Self = Self { face: None, gap: f64::INFINITY };

    /// That of a point of a state.
    pub fn of(point: &PointState) -> Self {
        Self { face: point.stands_on(), gap: point.raw_gap() }
    }
}

impl<'a> Before<'a> {
    /// No commit yet.
    pub const NOTHING: Self = Self { u: &[], points: &[], standing: &[] };

    /// That of a committed state.
    pub fn of(state: &'a State) -> Self {
        Self { u: &state.displacement, points: &state.points, standing: &[] }
    }

    /// The same, with points as they stood in the last iteration.
    pub fn held_by(self, standing: &'a [Stood]) -> Self {
        Self { standing, ..self }
    }

    /// The gap of a point before anything is allowed, at the last commit and in the last iteration: the lesser [L].
    pub fn least_gap(&self, place: usize) -> f64 {
        let committed = self.points.get(place).map_or(f64::INFINITY, PointState::raw_gap);
        self.standing.get(place).map_or(committed, |own| committed.min(own.gap))
    }

    /// The face or segment that holds a point: of the last iteration, or else of the last commit.
    pub fn face(&self, place: usize) -> Option<usize> {
        let committed = || self.points.get(place)?.stands_on();
        self.standing.get(place).and_then(|own| own.face).or_else(committed)
    }
}
