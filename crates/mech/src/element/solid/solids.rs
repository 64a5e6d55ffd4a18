//! The elements of a block: what is known of them before any displacement.

use super::centre::Centre;
use super::fields::{self, Straight};
use super::heat;
use super::place::{self, Place, Tables};
use super::recipe::{Formulation, Kinematics, Recipe};
use crate::axes::Axes;
use crate::element::quadrature::{HEX_8, QUAD_4};

/// The solids of a block.
#[derive(Debug, Clone)]
pub struct Solids<const D: usize, const N: usize, const P: usize> {
    pub(super) recipe: Recipe,
    pub(super) tables: Box<Tables<D, N, P>>,
    /// What the temperature of every node counts at every point.
    pub(super) heat: Box<[[f64; N]; P]>,
    /// Means of the shape functions over the section of every ring of one point; none of others.
    pub(super) means: Vec<[f64; N]>,
    pub(super) elements: Vec<[[f64; D]; N]>,
    /// Their points before any displacement.
    pub(super) places: Vec<[Place<D, N>; P]>,
    /// Fields of their changes of volume beside the constant one; none where there is no other.
    pub(super) fields: Vec<Straight<D, P>>,
    /// Axes of the material at their points; none where they are those of the model.
    pub(super) axes: Vec<[Axes; P]>,
    /// Their centres, where they have incompatible modes.
    pub(super) centres: Vec<Centre<D, N>>,
}

impl<const D: usize, const N: usize, const P: usize> Solids<D, N, P> {
    /// The elements on the undeformed positions of their nodes [L]; `None` where cell and rule
    /// have other numbers.
    pub fn new(recipe: Recipe, elements: impl Iterator<Item = [[f64; D]; N]>) -> Option<Self> {
        let fits =
            recipe.cell.nodes == N && recipe.cell.dimension == D && recipe.rule.points.len() == P;
        if !fits {
            return None;
        }
        // the gradient at the centre of a plane quadrilateral is the mean one; of a ring, whose
        // volume grows with the radius, and of a hexahedron it is not
        let ring = recipe.kinematics == Kinematics::Axisymmetric;
        let fine = match (recipe.formulation.is_one_point(), D) {
            (true, 3) => Some(&HEX_8),
            (true, _) if ring => Some(&QUAD_4),
            _ => None,
        };
        let tables: Box<Tables<D, N, P>> = Box::new(Tables::new(recipe.cell, recipe.rule, fine));
        let elements: Vec<_> = elements.collect();
        let places = elements.iter().map(|nodes| {
            let mean = Place::mean(nodes, &tables.fine, &recipe);
            let at = |k: usize| Place::new(nodes, &tables.points[k], &recipe).0;
            std::array::from_fn(|point| mean.unwrap_or_else(|| at(point)))
        });
        let places: Vec<_> = places.collect();
        let linear = recipe.formulation == Formulation::LinearDilation;
        let each = elements.iter().zip(&places).filter(|_| linear);
        let fields = each.map(|(nodes, own)| fields::straight(nodes, &tables, own)).collect();
        let rings = elements.iter().filter(|_| ring && fine.is_some());
        let means = rings.map(|nodes| place::mean_shapes(nodes, &tables.fine)).collect();
        let with_modes = recipe.formulation == Formulation::Incompatible;
        let centres = elements.iter().filter(|_| with_modes);
        let centres = centres.map(|nodes| Centre::new(nodes, &tables.centre, &recipe)).collect();
        let heat = Box::new(heat::counts::<D, N, P>(&recipe));
        let axes = recipe.orientation.iter().flat_map(|all| {
            let each = elements.iter().enumerate();
            each.filter_map(|(k, nodes)| Some(place::axes(nodes, &tables, all.of(k)?)))
        });
        let axes = axes.collect();
        Some(Self { recipe, tables, heat, means, elements, places, fields, axes, centres })
    }

    /// Whether they go all round an axis.
    pub(super) fn is_ring(&self) -> bool {
        self.recipe.kinematics == Kinematics::Axisymmetric
    }

    /// Axes of the material at a point; `None`: those of the model.
    pub(super) fn axes(&self, [element, point]: [usize; 2]) -> Option<Axes> {
        self.axes.get(element).map(|own| own[point])
    }

    /// Number of state variables of a point.
    pub(super) fn point_states(&self) -> usize {
        let across = usize::from(self.recipe.kinematics == Kinematics::PlaneStress);
        self.recipe.material.states() + across
    }

    /// The state variables of a point.
    pub(super) fn of_point<'a>(&self, states: &'a [f64], point: usize) -> &'a [f64] {
        let width = self.point_states();
        states.get(width * point..width * (point + 1)).unwrap_or(&[])
    }
}
