//! Room for contact that is spread over faces, used again and again.

use super::super::coverage::Release;
use super::place::MortarRoom;
use slideline_mech::contact::pair::mortar::{Curve, FaceTangent, Place, SweepRoom};

/// Where faces of a pair stand now and stood at the last commit, with scratch.
#[derive(Clone, Debug, Default)]
pub struct MortarRooms {
    /// Now.
    pub now: MortarRoom,
    /// At the last commit.
    pub before: MortarRoom,
    /// What points were let go by then.
    pub(super) releases: Vec<Option<Release>>,
    /// The displacements that `before` was placed at; empty: none yet.
    pub(super) placed_at: Vec<f64>,
    pub(super) pulled: Vec<Place<f64>>,
    pub(super) columns: Vec<usize>,
    pub(super) unknowns: Vec<usize>,
    /// Curves that a face faces now, where they stood then.
    pub(super) carried: Vec<Curve<f64>>,
}

impl MortarRooms {
    /// Forgets where the faces stood.
    pub fn forget(&mut self) {
        self.placed_at.clear();
        self.releases.clear();
    }
}

/// Scratch of a tangent.
#[derive(Clone, Debug, Default)]
pub struct MortarScratch {
    pub(super) sweep: SweepRoom,
    pub(super) of_face: FaceTangent,
    /// Places with the columns that they follow, and how.
    pub(super) entries: Vec<(usize, usize, [f64; 3])>,
    /// Derivative of the area by the columns [L].
    pub(super) by_area: Vec<f64>,
    pub(super) pulled: Vec<Place<f64>>,
}
