//! Elements as `*ELEMENT` gives them.

use slideline_diag::Span;
use slideline_model::{ElementType, TYPES};

/// What `*ELEMENT` may define.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ElementKind {
    /// A row of the element table.
    Structural(&'static ElementType),
    /// A type without mechanics of its own.
    Bare(&'static Bare),
    Isl21,
    Irs21,
    /// One that a static step does not feel, or that only names a node: its place in [`INERT`].
    Inert(usize),
}

/// Names and numbers of nodes of elements without stiffness.
const INERT: [(&str, usize); 7] = [
    ("MASS", 1),
    ("ROTARYI", 1),
    ("DASHPOT1", 1),
    ("DASHPOT2", 2),
    ("DASHPOTA", 2),
    ("DCOUP2D", 1),
    ("DCOUP3D", 1),
];

/// A mesh of a rigid body: it names nodes and faces alone.
#[derive(Debug, PartialEq)]
pub(crate) struct Bare {
    pub name: &'static str,
    pub nodes: usize,
    pub spatial: bool,
}

const fn rigid(name: &'static str, nodes: usize) -> Bare {
    Bare { name, nodes, spatial: nodes > 2 }
}

/// All meshes of rigid bodies.
static BARE: [Bare; 4] = [rigid("R2D2", 2), rigid("RAX2", 2), rigid("R3D3", 3), rigid("R3D4", 4)];

impl ElementKind {
    /// All there are.
    pub fn all() -> impl Iterator<Item = Self> {
        let inert = (0..INERT.len()).map(Self::Inert);
        let rows = TYPES.into_iter().map(Self::Structural);
        let bare = BARE.iter().map(Self::Bare);
        rows.chain(bare).chain([Self::Isl21, Self::Irs21]).chain(inert)
    }

    pub fn node_count(self) -> usize {
        match self {
            Self::Structural(row) => row.cell.nodes,
            Self::Bare(bare) => bare.nodes,
            Self::Isl21 => 2,
            Self::Irs21 => 3,
            Self::Inert(place) => INERT[place].1,
        }
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Structural(row) => row.name(),
            Self::Bare(bare) => bare.name,
            Self::Isl21 => "ISL21",
            Self::Irs21 => "IRS21",
            Self::Inert(place) => INERT[place].0,
        }
    }

    /// Whether a deck may call it so.
    pub fn is_called(self, name: &str) -> bool {
        match self {
            Self::Structural(row) => row.names.contains(&name),
            _ => self.name() == name,
        }
    }

    /// The card that gives it a section.
    pub fn card(self) -> Option<&'static str> {
        match self {
            Self::Structural(row) => row.kinematics.card(),
            _ => None,
        }
    }

    pub fn is_beam(self) -> bool {
        matches!(self, Self::Structural(row) if row.is_beam())
    }

    /// Whether it is a gap that may close.
    pub fn is_gap(self) -> bool {
        self.card() == Some("*GAP")
    }

    /// Whether a static step does not feel it: a mass, a damper.
    pub fn is_dynamic(self) -> bool {
        matches!(self, Self::Inert(_)) && !self.is_reference()
    }

    /// Whether it has the mass of a point.
    pub fn is_mass(self) -> bool {
        self.name() == "MASS"
    }

    /// Whether it is a beam in space.
    pub fn is_space_beam(self) -> bool {
        matches!(self, Self::Structural(row) if row.is_space_beam())
    }

    /// Whether it names the reference node of a `*DISTRIBUTING COUPLING`.
    pub fn is_reference(self) -> bool {
        self.name().starts_with("DCOUP")
    }

    /// Whether it is a line between its first and its last node.
    pub fn is_line(self) -> bool {
        matches!(self, Self::Structural(row)
            if row.joins() && row.cell.nodes > 1 && row.cell.faces.is_empty())
    }

    /// Whether it moves in space.
    pub fn is_spatial(self) -> bool {
        match self {
            Self::Structural(row) => row.is_spatial(),
            Self::Bare(bare) => bare.spatial,
            _ => false,
        }
    }

    /// The type without mechanics that it is.
    pub fn bare(self) -> Option<&'static Bare> {
        match self {
            Self::Bare(bare) => Some(bare),
            _ => None,
        }
    }

    pub fn is_contact(self) -> bool {
        matches!(self, Self::Isl21 | Self::Irs21)
    }
}

/// The most nodes that an element has.
pub(crate) const MOST_NODES: usize =
    if slideline_model::MOST_NODES > 3 { slideline_model::MOST_NODES } else { 3 };

/// An element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element {
    pub label: u64,
    pub kind: ElementKind,
    /// Its nodes first, then zeros; behind those of a beam in space the node that axis 1 of its
    /// section points to, if there is one.
    pub nodes: [u64; MOST_NODES],
    pub origin: Span,
}

impl Element {
    /// Labels of its nodes.
    pub fn nodes(&self) -> &[u64] {
        &self.nodes[..self.kind.node_count()]
    }

    /// The label of the node that axis 1 of its section points to, seen from its first node.
    pub fn pointed_at(&self) -> Option<u64> {
        let behind = self.nodes.get(self.kind.node_count()).copied();
        behind.filter(|&label| label != 0 && self.kind.is_space_beam())
    }
}
