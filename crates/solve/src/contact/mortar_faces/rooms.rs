//! Room for contact that is spread over faces in space, used again and again.

use super::super::coverage::Release;
use super::place::FaceRoom;
use slideline_mech::contact::pair::Footing;
use slideline_mech::contact::pair::mortar_faces::{Place, Standing, SweepRoom, Swept};
use slideline_mech::contact::tangential::Tangential;
use slideline_mech::vector::Vector;

/// Where faces of a pair stand now and stood at the last commit, with scratch.
#[derive(Clone, Debug, Default)]
pub struct FaceMortarRooms {
    /// Now.
    pub now: FaceRoom,
    /// At the last commit.
    pub before: FaceRoom,
    /// What points were let go by then.
    pub(super) releases: Vec<Option<Release>>,
    /// The displacements that `before` was placed at; empty: none yet.
    pub(super) placed_at: Vec<f64>,
    /// Derivatives of the integrals of every overlap by its nodes.
    pub(super) gradients: Vec<Place<f64>>,
    /// How points stand, what their slips ask for, and where the derivatives of faces begin.
    pub(super) standings: Vec<Standings>,
    pub(super) asked: Vec<Asked>,
    pub(super) begins: Vec<usize>,
    pub(super) columns: Vec<usize>,
    pub(super) unknowns: Vec<usize>,
}

/// How a point stands.
#[derive(Clone, Copy, Debug)]
pub struct Standings {
    /// Now; `None` where its faces have collapsed.
    pub now: Option<Standing>,
    /// At the last commit.
    pub then: Option<Footing>,
}

/// What slip asks of a point: directions at the last commit, area, and the way that was carried along
/// them over that area.
#[derive(Clone, Copy, Debug, Default)]
pub struct Asked {
    /// Directions [1].
    pub directions: [Vector; 2],
    /// Area [L2].
    pub area: f64,
    /// Ways [L].
    pub ways: Tangential,
}

impl FaceMortarRooms {
    /// Forgets where the faces stood.
    pub fn forget(&mut self) {
        self.placed_at.clear();
        self.releases.clear();
    }
}

/// Scratch of a tangent.
#[derive(Clone, Debug, Default)]
pub struct FaceScratch {
    pub(super) sweep: SweepRoom,
    pub(super) swept: Swept,
    /// Dofs of the nodes of both sides of an overlap.
    pub(super) dofs: Vec<usize>,
    /// Derivative of the area by the columns [L].
    pub(super) by_area: Vec<f64>,
    /// Drags along the axes by the columns, and the turn of the traction likewise.
    pub(super) drags: [Vec<f64>; 3],
    pub(super) turns: [Vec<f64>; 3],
    pub(super) pulled: Vec<Place<f64>>,
}
