//! The element table: everything that others need to know of an element type, in one row.
//!
//! A row outside this crate is as good as one of these: a block that names it is read, solved and
//! written like any other.

use super::solids::SOLIDS;
use super::{Section, kernels};
use crate::{Dialect, Dof};
use slideline_mech::element::Kernel;
use slideline_mech::element::cell::{Cell, LINE2, LINE3, POINT};
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
    /// Values at the nodes from those at the integration points, one component.
    pub at_nodes: fn(points: &[f64], nodes: &mut [f64]),
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
}

impl Undeformed<'_> {
    /// Positions in the plane of the `N` nodes of each element [L].
    pub fn plane<const N: usize>(&self) -> impl Iterator<Item = [[f64; 2]; N]> {
        self.positions::<2, N>()
    }

    /// The first `D` coordinates of the `N` nodes of each element [L].
    pub fn positions<const D: usize, const N: usize>(&self) -> impl Iterator<Item = [[f64; D]; N]> {
        let elements = self.nodes.as_chunks::<N>().0.iter();
        elements.map(|nodes| nodes.map(|node| std::array::from_fn(|axis| node[axis])))
    }
}

impl PartialEq for ElementType {
    fn eq(&self, other: &Self) -> bool {
        self.names == other.names
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

    /// Whether its nodes belong to one body: those of a spring do not.
    pub fn joins(&self) -> bool {
        !matches!(self.kinematics, Kinematics::Spring)
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

/// The row of that name in decks.
pub fn element_type(name: &str) -> Option<&'static ElementType> {
    TYPES.into_iter().find(|row| row.names.contains(&name))
}

/// The mean of the integration points at every node.
pub fn mean_at_nodes(points: &[f64], nodes: &mut [f64]) {
    nodes.fill(points.iter().sum::<f64>() / points.len().max(1) as f64);
}

/// Rows of lines and points.
const LINES: [&ElementType; 16] = [
    &types::B21,
    &types::B22,
    &types::B23,
    &types::B31,
    &types::B31H,
    &types::B31R,
    &types::B32,
    &types::B32H,
    &types::B32R,
    &types::T2D2,
    &types::T2D3,
    &types::T3D2,
    &types::T3D3,
    &types::SPRING1,
    &types::SPRING2,
    &types::SPRINGA,
];

/// All rows.
pub static TYPES: [&ElementType; LINES.len() + SOLIDS.len()] = {
    let mut all: [&ElementType; LINES.len() + SOLIDS.len()] =
        [&types::B21; LINES.len() + SOLIDS.len()];
    let mut row = 0;
    while row < all.len() {
        all[row] = if row < LINES.len() { LINES[row] } else { SOLIDS[row - LINES.len()] };
        row += 1;
    }
    all
};

/// The most nodes that a row has.
pub const MOST_NODES: usize = {
    let (mut most, mut row) = (0, 0);
    while row < TYPES.len() {
        if TYPES[row].cell.nodes > most {
            most = TYPES[row].cell.nodes;
        }
        row += 1;
    }
    most
};

pub(super) const fn at(location: Location, name: &'static str, unit: &'static str) -> Field {
    Field { name, components: &[], unit, location }
}

pub(super) const fn of(field: Field, components: &'static [&'static str]) -> Field {
    Field { components, ..field }
}

/// Section forces and strains of a beam, at its middle.
const BEAM_FIELDS: &[Field] = &[
    of(at(Location::Centroid, "SF", "[F]"), &["SF1", "SF2"]),
    of(at(Location::Centroid, "SM", "[F L]"), &["SM1"]),
    of(at(Location::Centroid, "SE", "[1]"), &["SE1", "SE2"]),
    of(at(Location::Centroid, "SK", "[1/L]"), &["SK1"]),
];

/// Stress along a truss, its strain and plastic strain, at its integration points.
const TRUSS_FIELDS: &[Field] = &[
    of(at(Location::Points, "S", "[F/L2]"), &["S11"]),
    of(at(Location::Points, "E", "[1]"), &["E11"]),
    of(at(Location::Points, "PEEQ", "[1]"), &["PEEQ"]),
];

/// State variables of a truss of that many points.
fn bar_states(section: &Section, points: usize) -> usize {
    match section {
        Section::Solid(section) => points * section.material.uniaxial_states(),
        _ => 0,
    }
}

const TURNING: &[Dof] = &[Dof::U1, Dof::U2, Dof::UR3];
pub(super) const MOVING: &[Dof] = &[Dof::U1, Dof::U2];
const IN_SPACE: &[Dof] = &[Dof::U1, Dof::U2, Dof::U3];

/// The rows of the table.
pub mod types {
    pub use super::super::solids::types::*;
    pub use super::super::space_beams::types::*;
    use super::*;

    /// Two-node shear-flexible plane beam.
    pub static B21: ElementType = ElementType {
        names: ["B21"; 2],
        cell: &LINE2,
        dofs: TURNING,
        kinematics: Kinematics::Beam { sheared: true },
        points: 1,
        states: |_| 0,
        fields: BEAM_FIELDS,
        at_nodes: mean_at_nodes,
        kernel: kernels::b21,
    };

    /// Three-node shear-flexible plane beam: end, middle, end.
    pub static B22: ElementType =
        ElementType { names: ["B22"; 2], cell: &LINE3, points: 2, kernel: kernels::b22, ..B21 };

    /// Two-node shear-rigid plane beam.
    pub static B23: ElementType = ElementType {
        names: ["B23"; 2],
        kinematics: Kinematics::Beam { sheared: false },
        kernel: kernels::b23,
        ..B21
    };

    /// Two-node truss in the plane.
    pub static T2D2: ElementType = ElementType {
        names: ["T2D2"; 2],
        cell: &LINE2,
        dofs: MOVING,
        kinematics: Kinematics::Truss,
        points: 1,
        states: |section| bar_states(section, 1),
        fields: TRUSS_FIELDS,
        at_nodes: mean_at_nodes,
        kernel: kernels::truss::<2, 2, 1>,
    };

    /// Three-node truss in the plane: end, middle, end.
    pub static T2D3: ElementType = ElementType {
        names: ["T2D3"; 2],
        cell: &LINE3,
        points: 2,
        states: |section| bar_states(section, 2),
        kernel: kernels::truss::<2, 3, 2>,
        ..T2D2
    };

    /// Two-node truss in space.
    pub static T3D2: ElementType = ElementType {
        names: ["T3D2"; 2],
        dofs: IN_SPACE,
        kernel: kernels::truss::<3, 2, 1>,
        ..T2D2
    };

    /// Three-node truss in space: end, middle, end.
    pub static T3D3: ElementType = ElementType {
        names: ["T3D3"; 2],
        dofs: IN_SPACE,
        kernel: kernels::truss::<3, 3, 2>,
        ..T2D3
    };

    /// Spring between a dof and the ground.
    pub static SPRING1: ElementType = ElementType {
        names: ["SPRING1"; 2],
        cell: &POINT,
        dofs: MOVING,
        kinematics: Kinematics::Spring,
        points: 0,
        states: |_| 0,
        fields: &[],
        at_nodes: mean_at_nodes,
        kernel: kernels::spring1,
    };

    /// Spring between dofs of two nodes.
    pub static SPRING2: ElementType =
        ElementType { names: ["SPRING2"; 2], cell: &LINE2, kernel: kernels::spring2, ..SPRING1 };

    /// Spring between two nodes, along the line that joins them.
    pub static SPRINGA: ElementType =
        ElementType { names: ["SPRINGA"; 2], cell: &LINE2, kernel: kernels::springa, ..SPRING1 };
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: every row agrees with its kernel: variables are its dofs, results its fields;
    /// and no two rows have the same name.
    #[test]
    fn rows_agree_with_their_kernels() {
        use crate::{BeamSection, ElementBlock, ShearRule, SolidSection, SpringSection, SpringWay};
        use slideline_mech::element::SpringLaw;
        use slideline_mech::element::Strains;
        use slideline_mech::material::{LargeStrain, Material};
        let elastic = slideline_mech::material::Elastic { modulus: 1.0, poisson: 0.3 };
        let shear = ShearRule::default();
        let shape = slideline_mech::section::Shape::Circle(1.0);
        let first_axis = BeamSection::FIRST_AXIS;
        let (poisson, heat) = (0.0, None);
        let beam = BeamSection { shape, poisson, material: elastic, heat, shear, first_axis };
        let material = Material::Elastic(elastic, LargeStrain::Logarithmic);
        let spring = |way| Section::Spring(SpringSection { law: SpringLaw::Linear(1.0), way });
        let sections = [
            Section::Beam(beam),
            spring(SpringWay::Dof(Dof::U2)),
            spring(SpringWay::Line { in_space: false }),
            Section::Solid(SolidSection { thickness: 1.0, material, orientation: None }),
        ];
        for row in TYPES {
            let mut nodes = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.5, 1.0, 0.0]];
            if !row.cell.places.is_empty() {
                nodes = row.cell.places.iter().map(|[x, y, z]| [x + 3.0, *y, *z]).collect();
            }
            let nodes = &nodes[..row.cell.nodes];
            let made: Vec<(&Section, Box<dyn Kernel>)> = sections
                .iter()
                .filter_map(|section| {
                    let dialect = Dialect::Abaqus;
                    let kernel =
                        (row.kernel)(&Undeformed { kind: row, section, dialect, nodes }, None);
                    Some((section, kernel?))
                })
                .collect();
            assert_eq!(made.len(), 1, "{} takes one of these sections", row.name());
            let (section, kernel) = &made[0];
            let block = ElementBlock::new(row, "", (*section).clone(), Default::default());
            let variables = block.dofs().len() * row.cell.nodes;
            assert_eq!((kernel.count(), kernel.variables()), (1, variables));
            let state = vec![0.0; (row.states)(section)];
            let mut results = vec![f64::NAN; row.all_values()];
            let q = vec![0.01; kernel.variables()];
            kernel.results(0, &q, &state, &Strains::Linear.into(), &mut results);
            assert!(results.iter().all(|value| value.is_finite()), "{}", row.name());
            assert!(TYPES.into_iter().filter(|other| *other == row).count() == 1);
            assert_eq!(element_type(row.name()), Some(row));
        }
    }
}
