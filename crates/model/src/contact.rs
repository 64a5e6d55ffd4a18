//! Contact pairs: which points meet which master, under which laws.

use crate::friction::Friction;
use crate::left_out::LeftOut;
use crate::node::NodeIndex;
use crate::surface::{ContactFace, Master, RigidSurface};
use crate::vocabulary::Vocabulary;
use slideline_diag::Span;
use slideline_mech::axes::{Axes, PLAIN};
pub use slideline_mech::contact::gap::offset::Offset;
use slideline_mech::contact::normal::NormalLaw;
use slideline_mech::orientation::Orientation;
use slideline_mech::surface::mesh::MeshFace;

/// Points, a master, and what happens between them.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPair {
    /// Name: the contact element set, or the names of both surfaces, behind them # and a number if this is a piece of the master.
    pub name: String,
    /// Whether it is a piece of what the deck calls a pair.
    pub is_piece: bool,
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
    /// Whether a node has its share of all these faces, those that do not look at the master too: nodes
    /// as a surface in CalculiX' dialect.
    pub counts_sides: bool,
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
    /// Faces of both sides that do not meet one another.
    pub left_out: Vec<LeftOut>,
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
    /// What the deck calls it: its name without the number of a piece.
    pub fn title(&self) -> &str {
        let whole = self.name.rsplit_once('#').filter(|_| self.is_piece);
        whole.map_or(&self.name, |(title, _)| title)
    }

    /// Whether a card that names a pair so means this one.
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || self.title() == name
    }

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

    /// Its master where nodes of the slave meet it.
    pub fn met_at_nodes(&self) -> Option<&Master> {
        (self.formulation == Formulation::NodeToSurface).then_some(&self.master)
    }

    /// Its faces as those of a mesh, over the nodes of the model.
    pub fn mesh_faces(&self) -> Vec<MeshFace> {
        self.faces.iter().filter_map(ContactFace::of_mesh).collect()
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
