//! Surfaces: faces in space, and what points slide on: analytic surfaces, chains of nodes, faces, the
//! slave surface itself.
//!
//! ```text
//!     .--.
//!    (    )--  analytic      o--o--o  chain      o--o--o  faces
//!     '--'                                       |  |  |
//! ```

use crate::node::NodeIndex;
use slideline_diag::Span;
use slideline_mech::element::cell::{Cell, QUAD4, QUAD8, TRI3, TRI6};
use slideline_mech::surface::mesh::MeshFace;
pub use slideline_mech::surface::swept::Sweep;

/// A face of a surface in space.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactFace {
    /// Label of the element that it belongs to.
    pub label: u64,
    /// Its nodes, corners first, counter-clockwise as seen from outside.
    pub nodes: Vec<NodeIndex>,
    /// Where it was named.
    pub origin: Span,
}

impl ContactFace {
    /// The reference cell of the face; `None` for a number of nodes that no face has.
    pub fn cell(&self) -> Option<&'static Cell> {
        match self.nodes.len() {
            3 => Some(&TRI3),
            4 => Some(&QUAD4),
            6 => Some(&TRI6),
            8 => Some(&QUAD8),
            _ => None,
        }
    }

    /// The face as one of a mesh, over the nodes of the model; `None` as for [`ContactFace::cell`].
    pub fn of_mesh(&self) -> Option<MeshFace> {
        Some(MeshFace { cell: self.cell()?, nodes: self.nodes.clone() })
    }
}

/// The surface that points slide on.
#[derive(Clone, Debug, PartialEq)]
pub enum Master {
    /// Analytic surface of a rigid body (`*RIGID SURFACE`).
    RigidSurface(RigidSurface),
    /// Chain of nodes (`*SLIDE LINE`).
    SlideLine(SlideLine),
    /// Faces of solids or of rigid meshes in space (`*SURFACE`).
    Faces(MasterFaces),
    /// The slave surface itself, of faces of solids in the plane.
    Itself(OwnSurface),
}

impl Master {
    /// Nodes of a master that deforms; none of a rigid surface.
    pub fn deforming_nodes(&self) -> Vec<NodeIndex> {
        match self {
            Self::RigidSurface(_) => Vec::new(),
            Self::SlideLine(line) => line.nodes.clone(),
            Self::Faces(faces) => faces.nodes(),
            Self::Itself(surface) => surface.nodes().collect(),
        }
    }
}

/// A point of a profile, in the plane of the profile [L].
pub type ProfilePoint = [f64; 2];

/// Line, arcs and parabolas fixed to a rigid body.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidSurface {
    /// The body's reference node.
    pub reference: NodeIndex,
    /// First point, undeformed [L].
    pub start: ProfilePoint,
    /// Segments, each from the end of the one before; the outward normal
    /// stands 90 degrees counter-clockwise of travel.
    pub segments: Vec<SurfaceSegment>,
    /// Part of a slave face, or of an end segment that is shorter, by which open ends are prolonged
    /// for the nodes of solids [1].
    pub extension: f64,
    /// The card.
    pub origin: Span,
}

/// One segment of an analytic rigid surface, undeformed coordinates [L].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceSegment {
    /// Straight.
    Line {
        /// End point.
        end: ProfilePoint,
    },
    /// Circular, less than 180 degrees.
    Circle {
        /// End point.
        end: ProfilePoint,
        /// Centre.
        centre: ProfilePoint,
    },
    /// Parabolic.
    Parabola {
        /// A point of the parabola between its ends.
        middle: ProfilePoint,
        /// End point.
        end: ProfilePoint,
    },
}

impl SurfaceSegment {
    /// Its end point [L].
    pub fn end(&self) -> ProfilePoint {
        match *self {
            Self::Line { end } | Self::Circle { end, .. } | Self::Parabola { end, .. } => end,
        }
    }
}

/// A chain of master nodes with smoothed corners.
#[derive(Clone, Debug, PartialEq)]
pub struct SlideLine {
    /// Nodes in order of travel; the outward normal stands 90 degrees
    /// counter-clockwise of it.
    pub nodes: Vec<NodeIndex>,
    /// Which of them are middle nodes of faces with three nodes, where that matters; empty: none.
    pub middles: Vec<bool>,
    /// `SMOOTH`: fraction of each segment taken by the corner's parabola [1]; `None`: it is not given, and
    /// the line is drawn through its nodes where it is round.
    pub smooth: Option<f64>,
    /// `EXTENSION ZONE`: prolongation of the end segments, as a fraction of
    /// their length [1].
    pub extension: f64,
    /// The card.
    pub origin: Span,
}

impl SlideLine {
    /// Whether it comes back to its first node.
    pub fn is_ring(&self) -> bool {
        self.nodes.len() > 2 && self.nodes.first() == self.nodes.last()
    }

    /// Forgets the prolongation of what goes all round: nothing lies beyond its ends.
    pub fn join_ends(&mut self) {
        if self.is_ring() {
            self.extension = 0.0;
        }
    }
}

/// A surface that meets itself.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnSurface {
    /// Its stretches of neighbouring nodes; no node is in two.
    pub runs: Vec<SurfaceRun>,
    /// `SMOOTH`: fraction of each face taken by the corner's parabola [1].
    pub smooth: f64,
    /// `EXTENSION ZONE`: prolongation of open ends, as a fraction of their faces [1].
    pub extension: f64,
    /// The card.
    pub origin: Span,
}

/// Neighbouring nodes of a surface, each once.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceRun {
    /// In order of travel; the outside stands 90 degrees counter-clockwise of it.
    pub nodes: Vec<NodeIndex>,
    /// Whether the last node is joined to the first.
    pub is_closed: bool,
}

impl OwnSurface {
    /// Its nodes, run after run.
    pub fn nodes(&self) -> impl Iterator<Item = NodeIndex> + '_ {
        self.runs.iter().flat_map(|run| run.nodes.iter().copied())
    }
}

/// Faces that points slide on, in space.
#[derive(Clone, Debug, PartialEq)]
pub struct MasterFaces {
    /// The faces.
    pub faces: Vec<ContactFace>,
    /// Whether faces that are chords of something round are smoothed by the normals at their
    /// nodes.
    pub smooth: bool,
    /// Prolongation of the open ends of the surface, as a fraction of their faces [1].
    pub extension: f64,
    /// The analytical surface on a rigid body that it is; each of the faces then has the four
    /// markers of the body.
    pub swept: Option<SweptSurface>,
    /// Whether the slaves are its own nodes: it meets itself.
    pub meets_itself: bool,
    /// The card.
    pub origin: Span,
}

/// An analytical surface in space (`TYPE=CYLINDER`, `TYPE=REVOLUTION`).
#[derive(Clone, Debug, PartialEq)]
pub struct SweptSurface {
    /// How its profile sweeps it.
    pub sweep: Sweep,
    /// The body's reference node.
    pub reference: NodeIndex,
    /// First point of the profile, in the frame of the markers [L].
    pub start: ProfilePoint,
    /// Segments, each from the end of the one before; the outward normal stands 90 degrees
    /// counter-clockwise of travel.
    pub segments: Vec<SurfaceSegment>,
    /// Distance of the markers from the first one [L].
    pub length: f64,
}

impl MasterFaces {
    /// The first node of its first face.
    pub fn first_node(&self) -> Option<NodeIndex> {
        self.faces.first()?.nodes.first().copied()
    }

    /// Its faces as those of a mesh, over the nodes of the model.
    pub fn mesh_faces(&self) -> Vec<MeshFace> {
        self.faces.iter().filter_map(ContactFace::of_mesh).collect()
    }

    /// Its nodes in order of first appearance, each once.
    pub fn nodes(&self) -> Vec<NodeIndex> {
        let mut seen = std::collections::HashSet::new();
        let all = self.faces.iter().flat_map(|face| face.nodes.iter().copied());
        all.filter(|&node| seen.insert(node)).collect()
    }
}
