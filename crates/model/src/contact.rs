//! Contact pairs: which points meet which master, under which laws.

use crate::friction::Friction;
use crate::node::NodeIndex;
use crate::vocabulary::Vocabulary;
use slideline_diag::Span;
use slideline_mech::axes::{Axes, PLAIN};
pub use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::element::cell::{Cell, QUAD4, QUAD8, TRI3, TRI6};
use slideline_mech::orientation::Orientation;
use slideline_mech::surface::mesh::MeshFace;
pub use slideline_mech::surface::swept::Sweep;

/// Points, a master, and what happens between them.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPair {
    /// Name: the contact element set, or the names of both surfaces.
    pub name: String,
    /// Where contact is sampled.
    pub formulation: Formulation,
    /// The words of the cards that made it.
    pub vocabulary: Vocabulary,
    /// Contact elements; their nodes are the slave nodes and their undeformed
    /// lengths the tributary areas.
    pub elements: Vec<ContactElement>,
    /// Whether these are faces of solids, the material on the left of each.
    pub of_solids: bool,
    /// In space, the faces that the slave nodes belong to; their shares are the
    /// tributary areas.
    pub faces: Vec<ContactFace>,
    /// The nodes of `faces` that are slaves; empty: all of them.
    pub slaves: Vec<NodeIndex>,
    /// Slave nodes at which the surface turns sharply: the faces that meet there are apart, with a
    /// contact point each ([`Formulation::Mortar`]).
    pub corners: Vec<NodeIndex>,
    /// The slave surface where it is the profile of a rigid body, whose reference node is the one of
    /// `slaves`.
    pub profile: Option<RigidSurface>,
    /// The surface that is slid upon.
    pub master: Master,
    /// Laws and width.
    pub interaction: Interaction,
    /// How far their surfaces stand off the lines of beams; none: contact is of the lines.
    pub offset: Offset,
    /// Slave nodes that begin on the master.
    pub adjust: Adjust,
    /// Axes of the slave surface and of the master, where they are given: those of two coefficients
    /// of friction.
    pub axes: [Option<Orientation>; 2],
    /// The card that made the pair.
    pub origin: Span,
}

/// `ADJUST`: slave nodes that are moved onto the master before the first step, without strain.
#[derive(Clone, Debug, PartialEq, Default)]
pub enum Adjust {
    /// None: what overlaps is resolved with strain.
    #[default]
    Nothing,
    /// Those that overlap the master, and those that are no further from it than this [L].
    Within(f64),
    /// These.
    Nodes(Vec<NodeIndex>),
    /// `*CLEARANCE`: all of them begin at this gap [L], negative for an overclosure.
    Clearance(f64),
}

impl ContactPair {
    /// Axes of space at a place of the slave surface; those of the model where none are given.
    pub fn axes_of_slave(&self, at: [f64; 3]) -> Axes {
        self.axes[0].map_or(PLAIN, |own| own.at(&[], at))
    }

    /// The same of the master.
    pub fn axes_of_master(&self, at: [f64; 3]) -> Axes {
        self.axes[1].map_or(PLAIN, |own| own.at(&[], at))
    }

    /// Slave nodes in order of first appearance, each once.
    pub fn slave_nodes(&self) -> Vec<NodeIndex> {
        let of_faces = self.faces.iter().map(|f| f.nodes.len()).sum::<usize>();
        let most = 2 * self.elements.len() + of_faces + self.slaves.len();
        let mut seen = std::collections::HashSet::with_capacity(most);
        let mut nodes = Vec::with_capacity(most);
        nodes.extend(self.slave_places().filter(|&node| seen.insert(node)));
        nodes
    }

    /// Nodes of the contact elements and faces, as often as these name them; where the slaves are
    /// listed, these. Contact that is spread over faces in space has its points at the corners of
    /// these.
    pub fn slave_places(&self) -> impl Iterator<Item = NodeIndex> + '_ {
        let ends = self.elements.iter().flat_map(|element| element.nodes);
        let is_spread = self.formulation == Formulation::Mortar;
        let of_face = move |face: &'_ ContactFace| match face.cell() {
            Some(cell) if is_spread => cell.faces.len(),
            _ => face.nodes.len(),
        };
        let faces = if self.slaves.is_empty() { &self.faces[..] } else { &[] };
        ends.chain(faces.iter().flat_map(move |face| face.nodes[..of_face(face)].iter().copied()))
            .chain(self.slaves.iter().copied())
    }

    /// Its analytical surfaces of the plane: the slave's profile, the master.
    pub fn rigid_surfaces(&self) -> impl Iterator<Item = &RigidSurface> {
        let master = match &self.master {
            Master::RigidSurface(surface) => Some(surface),
            Master::SlideLine(_) | Master::Faces(_) | Master::Itself(_) => None,
        };
        self.profile.iter().chain(master)
    }

    /// Whether its slave surface is its master too.
    pub fn meets_itself(&self) -> bool {
        match &self.master {
            Master::Itself(_) => true,
            Master::Faces(faces) => faces.meets_itself,
            Master::RigidSurface(_) | Master::SlideLine(_) => false,
        }
    }

    /// Its faces as those of a mesh, over the nodes of the model.
    pub fn mesh_faces(&self) -> Vec<MeshFace> {
        let of_mesh =
            |face: &ContactFace| Some(MeshFace { cell: face.cell()?, nodes: face.nodes.clone() });
        self.faces.iter().filter_map(of_mesh).collect()
    }
}

/// Where contact is sampled along the slave surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Formulation {
    /// At the slave nodes, each with its tributary area (IRS and ISL elements,
    /// `TYPE=NODE TO SURFACE`).
    #[default]
    NodeToSurface,
    /// Along the slave elements: beams whose surface is smooth, built from
    /// positions and rotations of their nodes; or along the profile of a rigid
    /// body; against an analytic rigid surface (`TYPE=SURFACE TO SURFACE`).
    SurfaceToSurface,
    /// Over the faces of solids, weighted with functions of the slave nodes, in space of their
    /// corners (`TYPE=SURFACE TO SURFACE`).
    Mortar,
}

/// ISL21 or IRS21: a stretch of slave surface between two slave nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactElement {
    /// Its number in the deck.
    pub label: u64,
    /// Its slave nodes.
    pub nodes: [NodeIndex; 2],
    /// What each of them takes of its length.
    pub lumping: Lumping,
    /// Where it was defined.
    pub origin: Span,
}

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
}

/// How the length of a contact element falls to its two nodes.
///
/// ```text
///   o-------o      halves
///   o---m---o      a three-node beam: 1/6, 4/6, 1/6 of it, in two contact elements
/// ```
///
/// These are the weights with which a uniform pressure loads the nodes of a line whose shape is
/// linear, or quadratic (Simpson's rule). [semantics: areas]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Lumping {
    /// One half each.
    #[default]
    Halves,
    /// From an end of a three-node beam to its middle node.
    ToMiddle,
    /// From the middle node of a three-node beam to an end.
    FromMiddle,
}

impl Lumping {
    /// Shares of the two nodes [1].
    pub fn shares(self) -> [f64; 2] {
        match self {
            Self::Halves => [0.5, 0.5],
            Self::ToMiddle => [1.0 / 3.0, 2.0 / 3.0],
            Self::FromMiddle => [2.0 / 3.0, 1.0 / 3.0],
        }
    }

    /// Those of the two halves of the element on a mesh of half the width.
    pub fn halved(self) -> [Self; 2] {
        match self {
            Self::Halves => [Self::Halves; 2],
            Self::ToMiddle | Self::FromMiddle => [Self::ToMiddle, Self::FromMiddle],
        }
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
    /// `SMOOTH`: fraction of each segment taken by the corner's parabola [1].
    pub smooth: f64,
    /// `EXTENSION ZONE`: prolongation of the end segments, as a fraction of
    /// their length [1].
    pub extension: f64,
    /// The card.
    pub origin: Span,
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
    /// Whether faces that meet at less than 45 degrees are smoothed by the normals at their
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

    /// Its nodes in order of first appearance, each once.
    pub fn nodes(&self) -> Vec<NodeIndex> {
        let mut seen = std::collections::HashSet::new();
        let all = self.faces.iter().flat_map(|face| face.nodes.iter().copied());
        all.filter(|&node| seen.insert(node)).collect()
    }
}

/// `*INTERFACE` with its laws.
#[derive(Clone, Debug, PartialEq)]
pub struct Interaction {
    /// Out-of-plane width [L].
    pub width: f64,
    /// Overclosure to pressure.
    pub normal: NormalLaw,
    /// `NO SEPARATION`: what has closed stays closed.
    pub no_separation: bool,
    /// Slip to shear traction.
    pub friction: Friction,
    /// The `*INTERFACE` card.
    pub origin: Span,
    /// The card of the normal law, where there is one.
    pub normal_origin: Option<Span>,
    /// The `*FRICTION` card, where there is one.
    pub friction_origin: Option<Span>,
}

impl Interaction {
    /// Whether there is any friction.
    pub fn has_friction(&self) -> bool {
        self.friction.acts()
    }
}
