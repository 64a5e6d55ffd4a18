//! What a row of the element table says of an element type.

use super::section::Section;
use crate::dialect::Dialect;
use crate::node::Dof;
use slideline_mech::element::Kernel;
use slideline_mech::element::cell::Cell;
use slideline_mech::element::quadrature::Quadrature;
use slideline_mech::element::solid;

/// Makes the kernel of a block, in the room of one that is no longer needed; `None` for a section
/// that is not its own.
pub type MakeKernel = fn(&Undeformed<'_>, Option<Box<dyn Kernel>>) -> Option<Box<dyn Kernel>>;

/// An element type.
#[derive(Clone, Copy, Debug)]
pub struct ElementType {
    /// Its names in decks: of Abaqus, of CalculiX.
    pub names: [&'static str; 2],
    /// Reference cell: number of nodes, faces, what viewers are given.
    pub cell: &'static Cell,
    /// Dofs of every node.
    pub dofs: &'static [Dof],
    /// What it is in mechanics; it decides on the section.
    pub kinematics: Kinematics,
    /// Number of integration points.
    pub points: usize,
    /// Number of state variables of an element with that section.
    pub states: fn(&Section) -> usize,
    /// Results it offers, in the order in which its kernel writes them.
    pub fields: &'static [Field],
    /// Values at the nodes, node after node, from those at the integration points, point after
    /// point: so many components each.
    pub at_nodes: fn(points: &[f64], components: usize, nodes: &mut [f64]),
    /// Makes the kernel of a block; `None` for a section that is not its own. One that was
    /// made before may be taken apart for its room, and need not be.
    pub kernel: MakeKernel,
}

/// What an element is in mechanics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kinematics {
    /// A plane beam.
    Beam {
        /// Whether its sections lean over its axis by a shear strain.
        sheared: bool,
    },
    /// A beam in space.
    SpaceBeam,
    /// A bar that stretches and does not bend.
    Truss,
    /// A spring: it joins nothing to a body.
    Spring,
    /// A gap that may close: it joins nothing either.
    Gap,
    /// A solid.
    Solid {
        /// How its strains follow displacements.
        strains: solid::Kinematics,
        /// What it does about locking, as Abaqus and as CalculiX have it.
        formulation: [solid::Formulation; 2],
        /// Where it is integrated.
        rule: &'static Quadrature,
    },
    /// Something else.
    Other,
}

impl Kinematics {
    /// The card that gives its section; `None`: no card does.
    pub fn card(self) -> Option<&'static str> {
        match self {
            Self::Beam { .. } | Self::SpaceBeam => Some("*BEAM SECTION"),
            Self::Spring => Some("*SPRING"),
            Self::Gap => Some("*GAP"),
            Self::Solid { .. } | Self::Truss => Some("*SOLID SECTION"),
            Self::Other => None,
        }
    }
}

/// A named result of every element of a type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Name, as decks ask for it.
    pub name: &'static str,
    /// Names of its components.
    pub components: &'static [&'static str],
    /// Unit tag, such as `[F/L2]`.
    pub unit: &'static str,
    /// Where its values stand.
    pub location: Location,
}

/// Where values stand in an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// Once, at the centroid.
    Centroid,
    /// At every integration point.
    Points,
    /// At every node.
    Nodes,
}

/// The elements of a block before the first step.
#[derive(Clone, Copy, Debug)]
pub struct Undeformed<'a> {
    /// Their row of the table.
    pub kind: &'static ElementType,
    /// Their section.
    pub section: &'a Section,
    /// Whose reading counts where programs mean different mechanics.
    pub dialect: Dialect,
    /// Positions of the nodes [L], element by element.
    pub nodes: &'a [[f64; 3]],
    /// Their places among the elements of the block.
    pub members: &'a [usize],
}

impl Undeformed<'_> {
    /// Positions in the plane of the `N` nodes of each element [L].
    pub fn plane<const N: usize>(&self) -> impl Iterator<Item = [[f64; 2]; N]> {
        self.positions::<2, N>()
    }

    /// The first `D` coordinates of the `N` nodes of each element [L].
    pub fn positions<const D: usize, const N: usize>(&self) -> impl Iterator<Item = [[f64; D]; N]> {
        slideline_kernels::places(self.nodes)
    }
}

impl PartialEq for ElementType {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other) || self.names == other.names
    }
}

impl ElementType {
    /// Its name.
    pub fn name(&self) -> &'static str {
        self.names[0]
    }

    /// Whether it is a beam in the plane.
    pub fn is_beam(&self) -> bool {
        matches!(self.kinematics, Kinematics::Beam { .. })
    }

    /// Whether it is a beam in space.
    pub fn is_space_beam(&self) -> bool {
        self.kinematics == Kinematics::SpaceBeam
    }

    /// Whether it is a truss.
    pub fn is_truss(&self) -> bool {
        self.kinematics == Kinematics::Truss
    }

    /// Whether its nodes belong to one body: those of a spring or a gap do not.
    pub fn joins(&self) -> bool {
        !matches!(self.kinematics, Kinematics::Spring | Kinematics::Gap)
    }

    /// Whether it goes all round an axis.
    pub fn is_ring(&self) -> bool {
        let ring = solid::Kinematics::Axisymmetric;
        matches!(self.kinematics, Kinematics::Solid { strains, .. } if strains == ring)
    }

    /// Whether it moves in space, not in a plane alone.
    pub fn is_spatial(&self) -> bool {
        self.dofs.contains(&Dof::U3)
    }

    /// Number of values of a field of one element.
    pub fn values(&self, field: &Field) -> usize {
        let places = match field.location {
            Location::Centroid => 1,
            Location::Points => self.points,
            Location::Nodes => self.cell.nodes,
        };
        places * field.components.len()
    }

    /// A field with where its values begin among those of an element.
    pub fn field(&self, name: &str) -> Option<(&'static Field, usize)> {
        let mut first = 0;
        for field in self.fields {
            if field.name == name {
                return Some((field, first));
            }
            first += self.values(field);
        }
        None
    }

    /// Number of values of all fields of one element.
    pub fn all_values(&self) -> usize {
        self.fields.iter().map(|field| self.values(field)).sum()
    }
}

/// The mean of the integration points at every node.
pub fn mean_at_nodes(points: &[f64], components: usize, nodes: &mut [f64]) {
    let width = components.max(1);
    let count = (points.len() / width).max(1) as f64;
    for node in nodes.chunks_exact_mut(width) {
        for (component, mean) in node.iter_mut().enumerate() {
            *mean = points.iter().skip(component).step_by(width).sum::<f64>() / count;
        }
    }
}

/// A result whose components are not named yet.
pub(super) const fn at(location: Location, name: &'static str, unit: &'static str) -> Field {
    Field { name, components: &[], unit, location }
}

/// The same with these components.
pub(super) const fn of(field: Field, components: &'static [&'static str]) -> Field {
    Field { components, ..field }
}

/// Dofs of what is moved in the plane.
pub(super) const MOVING: &[Dof] = &[Dof::U1, Dof::U2];

/// Dofs of what is moved in space.
pub(super) const IN_SPACE: &[Dof] = &[Dof::U1, Dof::U2, Dof::U3];
