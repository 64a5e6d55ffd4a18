//! What the elements of a block have in common.

use super::told::Told;
use crate::element::cell::Cell;
use crate::element::quadrature::Quadrature;
use crate::material::Material;
use crate::orientation::Orientations;

/// How strains follow displacements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kinematics {
    /// Nothing moves across the plane.
    PlaneStrain,
    /// No stress across the plane.
    PlaneStress,
    /// A ring about the second axis, the first coordinate its radius.
    Axisymmetric,
    /// Three dimensions.
    Space,
}

/// What is done about locking, or about too few points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formulation {
    /// Nothing.
    Plain,
    /// One change of volume for all points, that of the element: no locking of next to
    /// incompressible materials.
    MeanDilation,
    /// One that is linear in undeformed position: the same for quadratic elements.
    LinearDilation,
    /// Transposed incompatible modes, eliminated in the element: bending without locking.
    Incompatible,
    /// One point, held against its hourglass modes with the stiffness of elastic bending.
    Hourglass,
    /// The same with the small stiffness that CalculiX has, .032 E V sum (dN/dX)^2.
    SoftHourglass,
}

impl Formulation {
    /// Whether changes of volume are made of few fields.
    pub fn has_fields(self) -> bool {
        matches!(self, Self::MeanDilation | Self::LinearDilation)
    }

    /// Whether one point is held against hourglass modes.
    pub fn is_one_point(self) -> bool {
        matches!(self, Self::Hourglass | Self::SoftHourglass)
    }
}

/// How temperatures go from nodes to points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Interpolation {
    /// The mean of the nodes at all points.
    Mean,
    /// By the shape functions.
    Shapes,
    /// By the shape functions at the points of the reduced rule, and straight through those.
    #[default]
    Linear,
}

/// What the elements of a block have in common.
#[derive(Debug, Clone, PartialEq)]
pub struct Recipe {
    /// Reference cell.
    pub cell: &'static Cell,
    /// Where it is integrated.
    pub rule: &'static Quadrature,
    /// How strains follow displacements.
    pub kinematics: Kinematics,
    /// What is done about locking.
    pub formulation: Formulation,
    /// Material.
    pub material: Material,
    /// Thickness out of the plane [L]; of no meaning elsewhere.
    pub thickness: f64,
    /// Strains as results tell them.
    pub told: Told,
    /// Axes of the material; `None`: those of the model.
    pub orientation: Option<Orientations>,
    /// How temperatures go from nodes to points.
    pub temperatures: Interpolation,
}

/// Number of state variables of an element with that many points.
pub fn states(
    (cell, rule): (&Cell, &Quadrature),
    (kinematics, formulation): (Kinematics, Formulation),
    material: &Material,
) -> usize {
    let across = usize::from(kinematics == Kinematics::PlaneStress);
    let modes = if formulation == Formulation::Incompatible { cell.dimension.pow(2) } else { 0 };
    rule.points.len() * (material.states() + across) + modes
}
